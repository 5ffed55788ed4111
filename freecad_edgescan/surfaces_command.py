# SPDX-License-Identifier: LGPL-2.1-or-later
"""``edgescan surfaces``: published surfaces beside ours, and how fast surfaces are fitted."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from freecad_edgescan.experiments.surface_speed import measure_surface_speed
from freecad_edgescan.experiments.surface_tables import surface_tables
from freecad_edgescan.geometry import BSplineSurface
from freecad_edgescan.terminal_progress import TerminalProgress, exit_code, tell

__all__ = ["measure_surfaces"]


def measure_surfaces() -> int:
    """Measure, print; answer the exit code."""
    with TerminalProgress("surfaces") as progress:
        text = surface_tables(progress)
        speed = measure_surface_speed(progress, _freecads_projection())
    print(text)
    if speed is not None:
        print(f"\n{speed.text()}")
    return exit_code(progress)


def _freecads_projection() -> Callable[[BSplineSurface], Callable[[Any], object]] | None:
    """What projects one point by FreeCAD's own surface, or None without FreeCAD."""
    try:
        from freecad_edgescan.document.native_curve import vector
        from freecad_edgescan.document.native_surface import native_surface
    except ImportError:
        tell("FreeCAD did not load; its projection is not measured.")
        return None

    def projection(surface: BSplineSurface) -> Callable[[np.ndarray], object]:
        native = native_surface(surface)
        return lambda point: native.parameter(vector(point))

    return projection
