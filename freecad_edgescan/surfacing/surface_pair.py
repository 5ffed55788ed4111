# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points that lie on two surfaces, by Newton's method in the four parameters."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..geometry import BSplineSurface
from ..geometry.frames import cross

__all__ = ["MET", "SurfacePair"]

Array = NDArray[np.float64]

_STEPS = 20
MET = 1e-2  # of the tolerance: no farther apart is a common point


@dataclass(frozen=True, eq=False)
class SurfacePair:
    """Two surfaces and the parameters (m, 4) u, v on the first and s, t on the second."""

    a: BSplineSurface
    b: BSplineSurface
    tolerance: float

    @cached_property
    def scale(self) -> Array:
        """Lengths (4,) of the parameters' ranges."""
        ranges = np.array([*self.a.parameter_range, *self.b.parameter_range])
        return np.asarray(ranges[:, 1] - ranges[:, 0])

    @cached_property
    def limits(self) -> Array:
        """First and last of the four parameters, (4, 2); none where a surface is closed."""
        ranges = np.array([*self.a.parameter_range, *self.b.parameter_range])
        ranges[[*self.a.closed, *self.b.closed]] = -np.inf, np.inf
        return ranges

    def inside(self, parameters: Array) -> Array:
        """Parameters (m, 4), those beyond a seam brought back into the range."""
        u, v, s, t = parameters.T
        return np.stack([*self.a.inside(u, v), *self.b.inside(s, t)], axis=1)

    def points(self, parameters: Array) -> Array:
        """Points (m, 3) on the first surface, mm."""
        return self.a.evaluate(parameters[:, 0], parameters[:, 1])

    def at(self, parameters: Array) -> tuple[Array, Array, Array]:
        """Points (m, 3) on the first surface, vectors (m, 3) to them from the second, slopes.

        The slopes (m, 3, 4) are the vectors' derivatives by the parameters.
        """
        u, v, s, t = parameters.T
        on_a, a_u, a_v = self.a.point_and_tangents(u, v)
        on_b, b_s, b_t = self.b.point_and_tangents(s, t)
        return on_a, on_a - on_b, np.stack([a_u, a_v, -b_s, -b_t], axis=-1)

    def directions(self, slopes: Array) -> tuple[Array, Array]:
        """Unit tangents (m, 3) of the intersection, and the sine (m,) of the surfaces' angle."""
        normals = [cross(slopes[..., i], slopes[..., i + 1]) for i in (0, 2)]
        one, other = (
            n / np.maximum(np.linalg.norm(n, axis=-1, keepdims=True), np.finfo(float).tiny)
            for n in normals
        )
        way = cross(one, other)
        sine = np.linalg.norm(way, axis=-1)
        return way / np.maximum(sine, np.finfo(float).tiny)[..., None], sine

    def refined(self, parameters: Array, fixed: NDArray[np.bool_]) -> Array:
        """Nearest common points: parameters (k, 4) of those that are found, in order.

        Parameters
        ----------
        parameters : (m, 4) to start from
        fixed : (m, 4) bool, parameters that must stay
        """
        x = parameters.copy()
        low, high = self.limits.T
        scale = self.scale
        active: NDArray[np.intp] = np.arange(len(x))
        for _ in range(_STEPS):
            _, gap, slopes = self.at(x[active])
            scaled = np.where(fixed[active][:, None, :], 0.0, slopes * scale)
            square = np.einsum("mik,mjk->mij", scaled, scaled)
            size = np.maximum(np.trace(square, axis1=1, axis2=2), np.finfo(float).tiny)
            square += 1e-12 * size[:, None, None] * np.eye(3)
            lift = np.linalg.solve(square, gap[..., None])[..., 0]
            step = np.clip(-np.einsum("mik,mi->mk", scaled, lift), -0.1, 0.1)
            x[active] = np.clip(x[active] + step * scale, low, high)
            active = active[np.abs(step).max(axis=1) > 1e-10]
            if not len(active):
                break
        miss = np.linalg.norm(self.at(x)[1], axis=1)
        return np.asarray(x[miss < MET * self.tolerance])
