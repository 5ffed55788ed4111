# SPDX-License-Identifier: LGPL-2.1-or-later
"""A half-pipe sunk into the plane z = 0, and the ball that touches it: exact in closed form.

The pipe is the envelope of spheres whose centres run along a smooth curve in the plane, its
*spine*, while their radius changes smoothly: the pipe's wall is the lower half. Hence

* its offset by R_p is the same kind of surface, with the radius r - R_p: the height of a ball that
  comes down and touches the wall is the lowest point of the largest such sphere above a place;
* the wall stands at right angles to the plane along both rims, also where the radius changes.

A rounding of radius q along a rim has its centres on the pipe of radius r + q, at the height -q.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import BSpline, make_interp_spline
from scipy.spatial import cKDTree

__all__ = ["HalfPipe", "Touch"]

Array = NDArray[np.float64]

DEGREE = 5  # four times continuous, so that the rims bend smoothly too
SAMPLE_STEP = 0.25  # mm, between the samples of a rim's interpolating spline
COARSE = (
    8  # one in so many samples gives starting values: 2 mm apart, Newton's method does the rest
)
METRIC = np.array([1.0, 1.0, -1.0])  # squared distance of a place to a sphere's rim: x² + y² - r²
SIDES = (1.0, -1.0)  # left and right of the spine


@dataclass(frozen=True)
class Touch:
    """Where a ball coming down over some places touches a pipe or its rims.

    Attributes
    ----------
    height : (n,) mm of the ball's centre; nan where it touches neither
    part : (n,) 0 neither, 1 the wall, 2 the left rim, 3 the right rim
    """

    height: Array
    part: NDArray[np.intp]


class HalfPipe:
    """A half-pipe along a quintic B-spline in (x, y, radius).

    Parameters
    ----------
    poles : (k, 3) array, k >= 6: x, y and radius, mm, of the spline's control points
    """

    def __init__(self, poles: ArrayLike) -> None:
        control: Array = np.array(poles, dtype=np.float64)
        inner = np.arange(len(control) - DEGREE + 1, dtype=np.float64)
        knots = np.concatenate([np.zeros(DEGREE), inner, np.full(DEGREE, inner[-1])])
        self.spine = BSpline(knots, control, DEGREE)

    @cached_property
    def parameters(self) -> Array:
        """Spine parameters about SAMPLE_STEP apart along the spine."""
        first, last = self.spine.t[0], self.spine.t[-1]
        fine = np.linspace(first, last, 4001)
        speed = np.hypot(*self.spine(fine, 1)[:, :2].T)
        length = np.concatenate([[0.0], np.cumsum((speed[1:] + speed[:-1]) / 2 * np.diff(fine))])
        count = int(np.ceil(length[-1] / SAMPLE_STEP)) + 1
        return np.asarray(np.interp(np.linspace(0.0, length[-1], count), length, fine))

    def rim(self, u: ArrayLike, side: float, rounding: float = 0.0) -> tuple[Array, Array, Array]:
        """A rim, or the curve of the centres of its rounding.

        Parameters
        ----------
        u : (m,) array
            Spine parameters.
        side : float
            1 for the rim left of the spine, -1 for the right one.
        rounding : float
            q, mm; the centres lie at the height -q.

        Returns
        -------
        points (m, 2) mm, unit tangents (m, 2) along growing u, unit normals (m, 2) out of the pipe.
        """
        place, slope = self.spine(u), self.spine(u, 1)
        radius = place[:, 2] + rounding
        speed = np.hypot(slope[:, 0], slope[:, 1])
        tangent = slope[:, :2] / speed[:, None]
        left = np.column_stack([-tangent[:, 1], tangent[:, 0]])
        back = radius * slope[:, 2] / speed
        aside = np.sqrt(radius**2 - back**2 - rounding**2)
        arm = -back[:, None] * tangent + side * aside[:, None] * left
        outwards = arm / np.hypot(arm[:, 0], arm[:, 1])[:, None]
        along = side * np.column_stack([outwards[:, 1], -outwards[:, 0]])
        return place[:, :2] + arm, along, outwards

    def touch(self, places: Array, ball: float, rounding: float = 0.0) -> Touch:
        """The ball that comes down over places and touches the wall or a rim.

        Parameters
        ----------
        places : (n, 2) array
            Where the ball's centre comes down, mm.
        ball : float
            Radius of the ball, mm.
        rounding : float
            Radius of the rims' rounding, mm.
        """
        height = np.full(len(places), np.nan)
        part = np.zeros(len(places), dtype=np.intp)
        widest = float(self.spine.c[:, 2].max())
        near, start = self._nearest_sample(places, widest + 2 * rounding + ball + 1.0)
        spheres = BSpline(self.spine.t, self.spine.c - np.array([0.0, 0.0, ball]), DEGREE)
        u = _foot(spheres, places[near], start)
        centre = spheres(u)
        away = places[near] - centre[:, :2]
        depth = np.sqrt(np.maximum(centre[:, 2] ** 2 - (away**2).sum(axis=1), 0.0))
        lowest = centre[:, 2] * rounding / (centre[:, 2] + ball + rounding)
        on_wall = (depth > 0.0) & (depth >= lowest)
        height[near[on_wall]] = -depth[on_wall]
        part[near[on_wall]] = 1

        slope = spheres(u, 1)
        left = slope[:, 0] * away[:, 1] - slope[:, 1] * away[:, 0] > 0.0
        for number, side in enumerate(SIDES):
            chosen = np.flatnonzero(~on_wall & (left == (side > 0.0)))
            row = near[chosen]
            curve = self._rim_curve(side, rounding)
            v = _foot(curve, places[row], u[chosen])
            arm = places[row] - curve(v)[:, :2]
            within = (arm * self.rim(v, side, rounding)[2]).sum(axis=1) < 0.0
            rise = np.maximum((ball + rounding) ** 2 - (arm**2).sum(axis=1), 0.0)
            height[row[within]] = np.sqrt(rise[within]) - rounding
            part[row[within]] = 2 + number
        return Touch(height, part)

    @cached_property
    def _tree(self) -> cKDTree:
        return cKDTree(self.spine(self.parameters[::COARSE])[:, :2])

    def _nearest_sample(self, places: Array, reach: float) -> tuple[NDArray[np.intp], Array]:
        """Places within reach of the spine, and the parameter of the sample nearest to each."""
        distance, index = self._tree.query(places, distance_upper_bound=reach)
        near = np.flatnonzero(np.isfinite(distance))
        return near, self.parameters[::COARSE][index[near]]

    def _rim_curve(self, side: float, rounding: float) -> BSpline:
        """Spline (x, y, 0) through dense exact points of a rim; off by less than 1e-9 mm."""
        points = self.rim(self.parameters, side, rounding)[0]
        flat = np.column_stack([points, np.zeros(len(points))])
        return make_interp_spline(self.parameters, flat, k=DEGREE)


def _foot(curve: BSpline, places: Array, start: Array) -> Array:
    """Parameters at which (x - cx)² + (y - cy)² - r² is stationary, by Newton's method."""
    first, last = curve.t[0], curve.t[-1]
    places3 = np.column_stack([places, np.zeros(len(places))])
    u = start.copy()
    active = np.arange(len(u))
    for _ in range(20):
        if len(active) == 0:
            break
        now = u[active]
        gap, slope = places3[active] - curve(now), curve(now, 1)
        value = (gap * slope) @ METRIC
        rate = (gap * curve(now, 2) - slope**2) @ METRIC
        step = np.clip(now - value / np.minimum(rate, -1e-9), first, last) - now
        u[active] = now + step
        active = active[np.abs(step) > 1e-11 * (last - first)]
    return u
