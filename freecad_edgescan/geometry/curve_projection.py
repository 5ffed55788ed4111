# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closest points of a B-spline curve: the nearest place of a polyline, then Newton's method."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from freecad_edgescan.geometry.polyline import distance_to_polyline

if TYPE_CHECKING:
    from freecad_edgescan.geometry.bspline_curve import BSplineCurve

__all__ = ["closest_on_curve"]

Array = NDArray[np.float64]


def closest_on_curve(
    curve: BSplineCurve, breaks: Array, points: Array, start: Array | None
) -> tuple[Array, Array]:
    """Parameters (m,) and distances (m,); see `BSplineCurve.closest`.

    Parameters
    ----------
    breaks : parameters that cut the curve into short pieces
    points : (m, 3) array, mm
    start : (m,) array of parameters, or None to search the polyline through the breaks
    """
    if start is None:
        _, index, fraction = distance_to_polyline(points, curve.evaluate(breaks))
        u = breaks[index] + fraction * (breaks[index + 1] - breaks[index])
    else:
        u = start
    away = curve.evaluate(u) - points
    square = np.sum(away**2, axis=1)
    active: NDArray[np.intp] = np.arange(len(points))
    first, last = curve.parameter_range
    longest = float(np.diff(breaks).max())
    for _ in range(30):
        if not len(active):
            break
        step = np.clip(_newton_step(curve, u[active], away[active]), -longest, longest)
        waiting = np.arange(len(active))
        for shrink in 0.25 ** np.arange(6):
            rows = active[waiting]
            trial = curve.inside(u[rows] + shrink * step[waiting])
            moved = curve.evaluate(trial) - points[rows]
            reached = np.sum(moved**2, axis=1)
            nearer = reached < square[rows]
            rows = rows[nearer]
            u[rows], away[rows], square[rows] = trial[nearer], moved[nearer], reached[nearer]
            waiting = waiting[~nearer]
            if not len(waiting):
                break
        going = np.abs(step) > 1e-12 * (last - first)
        going[waiting] = False
        active = active[going]
    return u, np.sqrt(square)


def _newton_step(curve: BSplineCurve, u: Array, away: Array) -> Array:
    """Step towards the foot of the perpendicular."""
    first, second = curve.derivative(u, 1), curve.derivative(u, 2)
    slope = np.sum(away * first, axis=1)
    square = np.sum(first**2, axis=1)
    bend = square + np.sum(away * second, axis=1)
    bend = np.where(bend > 1e-3 * square, bend, square)
    return -slope / np.where(bend > 0.0, bend, np.inf)
