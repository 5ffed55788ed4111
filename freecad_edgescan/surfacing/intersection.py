# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves in which two surfaces meet: every branch, in order.

Schreve 6.5.1: subdivision finds all places where the surfaces may meet (`overlap`), Newton's method
makes common points of them (`surface_pair`), and tracing puts these in order (`tracing`). Seams of
closed surfaces are no limits; branches that end in a pole of a sphere go on beyond it.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import make_interp_spline

from ..geometry import BSplineCurve, BSplineSurface, distance_to_polyline
from ..geometry.place_text import place_text
from ..geometry.plain_number import plain
from .overlap import OverlappingPatches, overlapping_patches
from .surface_pair import SurfacePair
from .tracing import Branch, trace_branch

__all__ = ["SurfaceIntersection", "intersect_surfaces"]

Array = NDArray[np.float64]

_PATCHES_ACROSS = 50  # of the common box; no step is longer than one of them
_TOUCHING = 1e-3  # rad, below which surfaces touch rather than cross


@dataclass(frozen=True, eq=False)
class SurfaceIntersection:
    """One curve in which two surfaces meet.

    Attributes
    ----------
    points : (m, 3) in order, mm; a closed curve's last point is its first
    on_a, on_b : (m, 2) parameters of the points on the first and second surface
    closed : whether the curve returns to its start
    """

    points: Array
    on_a: Array = field(repr=False)
    on_b: Array = field(repr=False)
    closed: bool

    @property
    def length(self) -> float:
        """Length of the polyline, mm."""
        return float(np.linalg.norm(np.diff(self.points, axis=0), axis=1).sum())

    def curve(self) -> BSplineCurve:
        """The cubic through the points; periodic when the curve is closed."""
        chord = np.linalg.norm(np.diff(self.points, axis=0), axis=1)
        at = np.append(0.0, np.cumsum(chord))
        degree = min(3, len(at) - 1)
        if self.closed and degree == 3:
            spline = make_interp_spline(at, self.points, 3, bc_type="periodic")
            return BSplineCurve(spline.c[: len(at) - 1], spline.t, 3, periodic=True)
        spline = make_interp_spline(at, self.points, degree)
        return BSplineCurve(spline.c, spline.t, degree)


def intersect_surfaces(
    a: BSplineSurface, b: BSplineSurface, tolerance: float = 1e-3
) -> list[SurfaceIntersection]:
    """All curves in which two surfaces meet, the longest first.

    Parameters
    ----------
    a, b : the surfaces
    tolerance : float
        Largest height of a curve over the chord between two of its points, mm. The points
        themselves lie on both surfaces within a hundredth of it.

    Returns
    -------
    list of SurfaceIntersection, empty when the surfaces do not meet. Where they only touch there
    is no curve.

    Raises
    ------
    ValueError: a tolerance that is not positive, or surfaces that coincide over an area.
    """
    if not 0.0 < tolerance < np.inf:
        raise ValueError(f"The tolerance is {tolerance} mm; give a positive length.")
    common = _common_box(a, b)
    if common is None:
        return []
    longest = max(common / _PATCHES_ACROSS, tolerance)
    pair = SurfacePair(a, b, tolerance)
    seeds, touching = _seeds(pair, overlapping_patches(a, b, longest, tolerance))
    branches: list[Branch] = []
    while len(seeds):
        branch = trace_branch(pair, seeds[0], longest)
        seeds = seeds[1:]
        if len(branch.points) > 1:
            branches.append(branch)
            seeds, touching = (
                own[distance_to_polyline(pair.points(own), branch.points)[0] > 4.0 * tolerance]
                for own in (seeds, touching)
            )
    _refuse_touching(pair.points(touching), 2.0 * longest)
    joined = _joined(branches, tolerance)
    curves = [
        SurfaceIntersection(one.points, one.parameters[:, :2], one.parameters[:, 2:], one.closed)
        for one in joined
    ]
    # what is shorter comes of a single point in which the surfaces touch
    curves = [curve for curve in curves if curve.length > 4.0 * tolerance]
    return sorted(curves, key=lambda curve: -curve.length)


def _common_box(a: BSplineSurface, b: BSplineSurface) -> float | None:
    """Diagonal of the box that both surfaces' boxes share, mm; of the smaller one when flat."""
    boxes = [(own.poles.min(axis=(0, 1)), own.poles.max(axis=(0, 1))) for own in (a, b)]
    low = np.maximum(boxes[0][0], boxes[1][0])
    high = np.minimum(boxes[0][1], boxes[1][1])
    sizes = [float(np.linalg.norm(last - first)) for first, last in boxes]
    if np.any(low > high + 1e-9 * max(sizes)):
        return None
    return max(float(np.linalg.norm(high - low)), 0.1 * min(sizes))


def _seeds(pair: SurfacePair, near: OverlappingPatches) -> tuple[Array, Array]:
    """Common points (k, 4) found from the patches, and those (k, 4) where the surfaces touch.

    Those at limits of the parameters come first.
    """
    ranges = np.concatenate([near.on_a, near.on_b], axis=1).reshape(-1, 4, 2)
    middle = ranges.mean(axis=2)
    starts, fixed = [], []
    for place in range(4):
        for side in (0, 1):
            limit = pair.limits[place, side]
            rows = middle[ranges[:, place, side] == limit].copy()
            rows[:, place] = limit
            starts.append(rows)
            fixed.append(np.broadcast_to(np.arange(4) == place, rows.shape))
    starts.append(middle)
    fixed.append(np.zeros(middle.shape, dtype=bool))
    found = pair.refined(np.concatenate(starts), np.concatenate(fixed))
    found = found[_first_of_equal(pair.points(found), pair.tolerance)]
    sine = pair.directions(pair.at(found)[2])[1]
    return found[sine > _TOUCHING], found[sine <= _TOUCHING]


def _first_of_equal(points: Array, tolerance: float) -> NDArray[np.intp]:
    """Places of points that differ by more than about the tolerance from all before."""
    cells = np.round(points / tolerance).astype(np.int64)
    return np.sort(np.unique(cells, axis=0, return_index=True)[1])


def _refuse_touching(points: Array, size: float) -> None:
    """Surfaces that touch in more than a point have no curve that could be computed there."""
    extent = np.ptp(points, axis=0).max() if len(points) else 0.0
    if extent > size:
        where = place_text(points[len(points) // 2])
        raise ValueError(
            f"The surfaces touch or coincide over {plain(extent, 3)} mm, near ({where}), without "
            "crossing; no curve of intersection is determined there. Move or turn one of them a "
            "little, or cut the common part off."
        )


def _joined(branches: list[Branch], tolerance: float) -> list[Branch]:
    """Branches put together where one ends as another begins, as at the pole of a sphere."""
    result = [branch for branch in branches if branch.closed]
    rest = [branch for branch in branches if not branch.closed]
    while rest:
        whole = rest.pop()
        grown = True
        while grown and rest:
            grown = False
            for place, other in enumerate(rest):
                combined = _end_to_start(whole, other, tolerance)
                if combined is not None:
                    whole, grown = combined, True
                    rest.pop(place)
                    break
        gap = np.linalg.norm(whole.points[0] - whole.points[-1])
        closes = gap <= 4.0 * tolerance and len(whole.points) > 3
        if closes and _ways_agree(whole.points[[-2, -1]], whole.points[[0, 1]]):
            points = whole.points.copy()
            points[-1] = points[0]
            whole = Branch(points, whole.parameters, True)
        result.append(whole)
    return result


def _end_to_start(one: Branch, other: Branch, tolerance: float) -> Branch | None:
    """Two branches as one when an end of each is the same point and they go on straight."""
    for first in (one, _turned(one)):
        for second in (other, _turned(other)):
            if np.linalg.norm(first.points[-1] - second.points[0]) > 4.0 * tolerance:
                continue
            if _ways_agree(first.points[-2:], second.points[:2]):
                return Branch(
                    np.concatenate([first.points, second.points[1:]]),
                    np.concatenate([first.parameters, second.parameters[1:]]),
                    False,
                )
    return None


def _turned(branch: Branch) -> Branch:
    return Branch(branch.points[::-1], branch.parameters[::-1], branch.closed)


def _ways_agree(before: Array, after: Array) -> bool:
    """Whether two segments lead in about the same direction."""
    one, other = before[1] - before[0], after[1] - after[0]
    return bool(one @ other > 0.8 * np.linalg.norm(one) * np.linalg.norm(other))
