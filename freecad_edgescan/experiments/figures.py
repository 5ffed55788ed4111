# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures by matplotlib, which comes with FreeCAD but is not required."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import Any

__all__ = ["can_draw", "new_figure", "save_figure"]


def can_draw() -> bool:
    """Whether matplotlib is there."""
    return find_spec("matplotlib") is not None


def new_figure(path: str | Path, width: float, height: float) -> Any:
    """An empty matplotlib figure that needs no screen, in inches.

    Raises
    ------
    ValueError: matplotlib is missing.
    """
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError:
        raise ValueError(
            f"The picture {path} needs matplotlib (Debian: python3-matplotlib); "
            "install it or leave the picture out."
        ) from None
    figure = Figure(figsize=(width, height), dpi=110, layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def save_figure(figure: Any, path: str | Path) -> None:
    """Write a figure, without empty margins; the ending of the path chooses the format."""
    figure.savefig(path, bbox_inches="tight", pad_inches=0.08)
