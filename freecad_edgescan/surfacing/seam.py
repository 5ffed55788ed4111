# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fits that go on over the seam of a closed surface, so that it is as smooth as anywhere.

The closed direction is unrolled by some spans beyond both ends, where points and base surface come
again. What was solved there is rolled up: poles that are one and the same become equal, so that the
surface is a periodic spline, cut open at its seam.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..geometry import BSplineSurface
from ..geometry.knot_vectors import clamped_knots

__all__ = ["Unrolled"]

Array = NDArray[np.float64]
Pair = tuple[Array, Array]

_SPANS = 6  # beyond either end; what the ends say hardly reaches farther


@dataclass(frozen=True, eq=False)
class Unrolled:
    """The parameters of a base surface, unrolled where it is closed.

    Attributes
    ----------
    base : whose parameters these are
    knots, degree : of the surface to be fitted, over the base's range
    """

    base: BSplineSurface
    knots: Pair
    degree: tuple[int, int]

    def _over(self, axis: int) -> int:
        """Spans beyond either end."""
        return max(_SPANS, self.degree[axis]) if self.base.closed[axis] else 0

    @property
    def wide_knots(self) -> Pair:
        """Clamped knots over the unrolled range."""
        u, v = (self._wide(axis) for axis in (0, 1))
        return u, v

    def _wide(self, axis: int) -> Array:
        over = self._over(axis)
        if not over:
            return self.knots[axis]
        breaks = np.unique(self.knots[axis])
        spans, period = len(breaks) - 1, breaks[-1] - breaks[0]
        turns = -(-over // spans)
        tiled = [breaks[:-1] + turn * period for turn in range(-turns, turns + 1)]
        every = np.append(np.concatenate(tiled), breaks[-1] + turns * period)
        first = turns * spans - over
        return clamped_knots(every[first : first + spans + 2 * over + 1], self.degree[axis])

    def shape(self) -> Callable[[Array, Array], Array]:
        """The base surface over the unrolled range."""

        def evaluate(u: Array, v: Array) -> Array:
            return self.base.evaluate(self._rolled(u, 0), self._rolled(v, 1))

        return evaluate

    def _rolled(self, x: Array, axis: int) -> Array:
        if not self.base.closed[axis]:
            return x
        first, last = self.base.parameter_range[axis]
        return np.where((x < first) | (x > last), first + (x - first) % (last - first), x)

    def repeated(self, u: Array, v: Array) -> tuple[NDArray[np.intp] | slice, Array, Array]:
        """Rows of the points with parameters u (m,), v (m,), and their unrolled parameters."""
        if not any(self.base.closed):
            return slice(None), u, v
        rows, places = np.arange(len(u)), [u, v]
        for axis, knots in enumerate(self.wide_knots):
            if not self._over(axis):
                continue
            first, last = self.base.parameter_range[axis]
            period = last - first
            low, high = (int(x // period) for x in (knots[0] - first, knots[-1] - first))
            turns = np.arange(low, high + 1) * period
            every = places[axis] + turns[:, None]
            turn, row = np.nonzero((every >= knots[0]) & (every <= knots[-1]))
            places = [own[row] for own in places]
            places[axis] = every[turn, row]
            rows = rows[row]
        return rows, places[0], places[1]

    def rolled_up(self, poles: Array) -> BSplineSurface:
        """The surface over the base's range from poles (nu, nv, 3) over the unrolled one."""
        poles = poles.copy()
        for axis in (0, 1):
            over = self._over(axis)
            if over:
                own = np.moveaxis(poles, axis, 0)  # a view
                spans = len(np.unique(self.knots[axis])) - 1
                inner = np.arange(over, over + spans + self.degree[axis])
                for number in range(spans):
                    same = inner[number::spans]
                    own[same] = own[same].mean(axis=0)
        surface = BSplineSurface(poles, self.wide_knots, self.degree)
        limits = [
            own if closed else None
            for own, closed in zip(self.base.parameter_range, self.base.closed, strict=True)
        ]
        return surface.restricted(*limits) if any(self.base.closed) else surface

    def inner(self, patches: NDArray) -> NDArray:
        """Of values for the unrolled patches those of the base's range."""
        rows, columns = (
            slice(self._over(axis), count - self._over(axis))
            for axis, count in enumerate(patches.shape)
        )
        return patches[rows, columns]
