# SPDX-License-Identifier: LGPL-2.1-or-later
"""One branch of the intersection of two surfaces, traced from a point on it.

A step along the cross product of the normals, then Newton's method back to both surfaces in the
plane across the step (Barnhill and Kersey 1990, A marching method for parametric surface/surface
intersection). The step is as long as the height of the curve over its chord allows. Where one
parameter reaches its limit, it is held there and the branch ends.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .surface_pair import MET, SurfacePair

__all__ = ["Branch", "trace_branch"]

Array = NDArray[np.float64]

_MOST = 100_000
_TURN = 0.3  # rad, largest between two points
_NEWTON = 12
_STILL = 1e-10  # of the parameters' ranges: no change


@dataclass(frozen=True, eq=False)
class Branch:
    """Points (m, 3) in order, mm, their parameters (m, 4), and whether the last is the first."""

    points: Array
    parameters: Array
    closed: bool


@dataclass(frozen=True, eq=False)
class _Place:
    parameters: Array
    point: Array
    way: Array
    slopes: Array


def trace_branch(pair: SurfacePair, start: Array, longest: float) -> Branch:
    """The branch through a common point.

    Parameters
    ----------
    pair : the surfaces
    start : (4,) parameters of the point
    longest : largest step, mm
    """
    point, _, slopes = pair.at(start[None])
    first = _place(pair, start, point[0], slopes[0], None)
    forward, closed = _walk(pair, first, 1.0, longest)
    if closed:
        return _branch(pair, [first, *forward, first], True)
    backward, _ = _walk(pair, first, -1.0, longest)
    return _branch(pair, [*backward[::-1], first, *forward], False)


def _branch(pair: SurfacePair, places: list[_Place], closed: bool) -> Branch:
    parameters = pair.inside(np.array([place.parameters for place in places]))
    points = np.array([place.point for place in places])
    return Branch(points, parameters, closed)


def _place(
    pair: SurfacePair, parameters: Array, point: Array, slopes: Array, before: Array | None
) -> _Place:
    """A common point and the direction there, as near as can be to the direction before."""
    ways, sines = pair.directions(slopes[None])
    way, sine = ways[0], float(sines[0])
    if before is not None:
        way = way if way @ before >= 0.0 else -way
        if sine < 1e-6:  # the surfaces touch: straight on
            way = before
    return _Place(parameters, point, way, slopes)


def _walk(
    pair: SurfacePair, first: _Place, sign: float, longest: float
) -> tuple[list[_Place], bool]:
    """Places after the first in one direction, and whether they lead back to it."""
    here = _Place(first.parameters, first.point, sign * first.way, first.slopes)
    start = here
    places: list[_Place] = []
    step = 0.1 * longest
    shortest = 1e-6 * longest
    while len(places) < _MOST:
        there, at_limit = _stepped(pair, here, step)
        if there is None:
            step /= 2
            if step < shortest:
                break
            continue
        length = float(np.linalg.norm(there.point - here.point))
        turn = float(np.arccos(np.clip(here.way @ there.way, -1.0, 1.0)))
        height = length * turn / 8
        if (height > pair.tolerance or turn > _TURN) and step > 1e3 * shortest:
            step *= float(np.clip(0.9 * np.sqrt(pair.tolerance / max(height, 1e-300)), 0.2, 0.7))
            continue
        if len(places) > 1 and _passes(start, here, there, pair.tolerance):
            return places, True
        if length > shortest:
            places.append(there)
        here = there
        if at_limit:
            break
        growth = 0.9 * np.sqrt(pair.tolerance / max(height, 1e-300))
        step = min(longest, step * float(np.clip(growth, 0.5, 2.0)))
    return places, False


def _stepped(pair: SurfacePair, here: _Place, step: float) -> tuple[_Place | None, bool]:
    """The place a step ahead, or None; and whether it is at a limit of the parameters."""
    low, high = pair.limits.T
    rate = np.zeros(4)
    for first, sign in ((0, 1.0), (2, -1.0)):
        columns = sign * here.slopes[:, first : first + 2]
        rate[first : first + 2] = np.linalg.lstsq(columns, here.way, rcond=None)[0]
    rate[np.abs(step * rate) < 1e-9 * pair.scale] = 0.0  # along a rim
    ahead = here.parameters + step * rate
    room = np.where(rate > 0.0, high - here.parameters, low - here.parameters)
    with np.errstate(divide="ignore", invalid="ignore"):
        share = np.where(rate != 0.0, room / (step * rate), np.inf)
    limit = int(np.argmin(share))
    if share[limit] > 1.0:
        return _corrected(pair, here, ahead, None), False
    # a second limit is met at the corner itself
    ahead = np.clip(here.parameters + share[limit] * step * rate, low, high)
    ahead[limit] = high[limit] if rate[limit] > 0.0 else low[limit]
    return _corrected(pair, here, ahead, limit), True


def _corrected(pair: SurfacePair, here: _Place, ahead: Array, fixed: int | None) -> _Place | None:
    """The common point nearest ahead: across the step, or with one parameter fixed."""
    (low, high), scale = pair.limits.T, pair.scale
    x = ahead
    aim = pair.points(x[None])[0]
    for _ in range(_NEWTON):
        points, gaps, slopes = pair.at(x[None])
        point, rows, right = points[0], slopes[0], gaps[0]
        if fixed is None:
            across = np.append(here.way @ rows[:, :2], [0.0, 0.0])
            rows = np.vstack([rows, across])
            right = np.append(right, here.way @ (point - aim))
        else:
            rows = np.where(np.arange(4) == fixed, 0.0, rows)
        change = -np.linalg.lstsq(rows * scale, right, rcond=1e-12)[0]
        if np.abs(change).max() < _STILL:
            break
        x = np.clip(x + change * scale, low, high)
    reach = np.linalg.norm(aim - here.point)
    if np.linalg.norm(gaps[0]) > MET * pair.tolerance or (
        np.linalg.norm(point - aim) > 0.5 * reach + pair.tolerance
    ):
        return None
    return _place(pair, x, point, slopes[0], here.way)


def _passes(start: _Place, here: _Place, there: _Place, tolerance: float) -> bool:
    """Whether the start lies on the way from here to there."""
    chord = there.point - here.point
    square = chord @ chord
    share = (start.point - here.point) @ chord / max(square, 1e-300)
    if not 0.0 < share <= 1.0 or start.way @ there.way < 0.5:
        return False
    off = np.linalg.norm(start.point - here.point - share * chord)
    return bool(off <= max(4.0 * tolerance, 0.05 * np.sqrt(square)))
