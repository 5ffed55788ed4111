# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of one section across a scanned edge: what was touched, and what came of it."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from ..scanning import ScannedEdge

__all__ = ["draw_section"]

_LARGER = 10  # the edge point's sigma is drawn so many times as large, or it would not be seen


def draw_section(edge: ScannedEdge, number: int, path: str | Path) -> None:
    """Draw points, removed points, fitted sides, and the edge point with its sigma.

    Parameters
    ----------
    edge : ScannedEdge
    number : of the edge point
    path : picture file; its ending (.png, .svg, .pdf) chooses the format

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
    line = edge.scan_lines[number]
    figure = Figure(figsize=(9, 7), dpi=110, layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    removed = np.asarray(line.removed, dtype=bool)
    for side in (0, 1):
        used = line.points[(line.side == side) & ~removed]
        axes.plot(*used.T, ".", ms=4, color=f"C{side}", label=f"points of side {side + 1}")
        axes.plot(*line.curves[side].T, "-", lw=1.2, color=f"C{side}")
    axes.plot(*line.points[removed].T, "x", ms=4, color="0.6", label="removed points")
    turn = np.linspace(0.0, 2.0 * np.pi, 73)
    sigma = float(edge.sigma[number])
    circle = line.edge_point + _LARGER * sigma * np.column_stack([np.cos(turn), np.sin(turn)])
    axes.plot(*line.edge_point, "k+", ms=10, label="edge point")
    axes.plot(*circle.T, "k-", lw=0.8, label=f"{_LARGER} sigma, sigma = {sigma:.4f} mm")
    axes.set(
        xlabel="across the edge, mm",
        ylabel="out of the wedge, mm",
        title=f"Section {number + 1} of {len(edge.points)}",
        aspect="equal",
    )
    axes.legend(loc="best", fontsize="small")
    figure.savefig(path)
