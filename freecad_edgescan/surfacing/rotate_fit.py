# SPDX-License-Identifier: LGPL-2.1-or-later
"""Least squares for the rails and profiles of the rotate model, by Gauss and Newton's method.

The unknowns are the poles of the rails over one common parameter, so that facing points stay
paired, and the inner poles of the profiles in the coordinates of their frames, whose ends lie on
the rails. Only distances along the surface's normals count. They do not say where on the surface a
rail lies: there the rails are tied to those of the base, firmly at their ends, loosely along
themselves, so that facing points find each other.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..geometry import BSplineCurve
from .rail_frame import two_rail_frame
from .spline_poles import basis_values, poles_through
from .swept_surface import Pairing, SweepModel, SweptSurface

__all__ = ["RotateFit"]

Array = NDArray[np.float64]

_DEGREE = 3
_HELD = 1e-5  # weight that holds what no distance depends on, relative to the points'
_IN_PLANE = [0, 2]  # coordinates in which a profile changes; along the rails it stays
_TIES = 100  # places at which either rail is tied
_ALONG, _ACROSS = 2e-5, 0.03  # weights of all ties of a rail, relative to all points
_SMALL = 1e-6  # of the rails' distance: step of the derivatives of the frame


class RotateFit:
    """Rails and profiles over given knots, first those of a base sweep, then fitted ones."""

    def __init__(self, base: SweptSurface, along: Array, across: Array) -> None:
        self._along, self._across, self._base = along, across, base
        share = np.linspace(0.0, 1.0, 20 * (len(along) + len(across)))
        self._rails = np.stack(
            [poles_through(along, _DEGREE, share, base.evaluate(share, v)) for v in (0.0, 1.0)]
        )
        local = base.local_profiles(share)
        self._profiles = np.stack([poles_through(across, _DEGREE, share, own) for own in local])
        self._profiles[:, 0], self._profiles[:, -1] = 0.0, [1.0, 0.0, 0.0]
        self._ties = np.linspace(0.0, 1.0, _TIES)
        self._tied_to = basis_values(along, _DEGREE, self._ties) @ self._rails
        self.sweep = self._as_sweep()

    def improve(self, points: Array, u: Array, v: Array, normals: Array) -> None:
        """One step towards smaller distances along the normals."""
        rails = basis_values(self._along, _DEGREE, u)
        speeds = basis_values(self._along, _DEGREE, u, order=1)
        across = basis_values(self._across, _DEGREE, v)[:, 1:-1]
        shares = self._base.profile_shares(u)
        profile = np.einsum(
            "mk,mj,kji->mi", shares, basis_values(self._across, _DEGREE, v), self._profiles
        )
        first, second = rails @ self._rails[0], rails @ self._rails[1]
        onwards = speeds @ (self._rails[0] + self._rails[1])
        moved = _moved(first, second, onwards, profile)
        away = np.einsum("mi,mi->m", normals, points - moved)
        slopes = _slopes(first, second, onwards, profile, normals)
        columns = [
            np.einsum("mn,mi->mni", rails, slopes[k]) + np.einsum("mn,mi->mni", speeds, slopes[2])
            for k in (0, 1)
        ]
        frame = np.einsum("mij,mi->mj", two_rail_frame(first, second, onwards), normals)
        frame = frame[:, _IN_PLANE]
        columns += [
            np.einsum("m,mj,mi->mji", shares[:, k], across, frame)
            for k in range(len(self._profiles))
        ]
        jacobian = np.concatenate([own.reshape(len(u), -1) for own in columns], axis=1)
        # profiles count in shares of the rails' distance; here all are mm
        scale = np.ones(jacobian.shape[1])
        scale[2 * self._rails[0].size :] = 1.0 / np.linalg.norm(second - first, axis=1).mean()
        jacobian *= scale
        tied, apart = self._tied(np.sqrt(len(u) / _TIES))
        size = self._rails.size
        matrix, right = jacobian.T @ jacobian, jacobian.T @ away
        matrix[:size, :size] += tied.T @ tied
        right[:size] += tied.T @ apart
        matrix[np.diag_indices_from(matrix)] += _HELD * np.trace(matrix) / len(matrix)
        self._last = (self._rails, self._profiles, scale * np.linalg.solve(matrix, right))
        self.shorten(1.0)

    def shorten(self, share: float) -> None:
        """Go only a share of the last step."""
        rails, profiles, step = self._last
        moves, changes = np.split(share * step, [rails.size])
        self._rails = rails + moves.reshape(rails.shape)
        self._profiles = profiles.copy()
        self._profiles[:, 1:-1, _IN_PLANE] += changes.reshape(len(profiles), -1, len(_IN_PLANE))
        self.sweep = self._as_sweep()

    def _tied(self, weight: float) -> tuple[Array, Array]:
        """Rows (k, 6 n) for the rails' poles, and how far (k,) the rails are from the base's."""
        basis = basis_values(self._along, _DEGREE, self._ties)
        speeds = basis_values(self._along, _DEGREE, self._ties, order=1)
        points, ways = basis @ self._rails, speeds @ self._rails
        frames = two_rail_frame(points[0], points[1], ways[0] + ways[1])
        shares = self._base.profile_shares(self._ties)
        firm = np.full(_TIES, np.sqrt(_ALONG))
        firm[[0, -1]] = np.sqrt(_TIES)
        rows, apart = [], []
        for k, first in ((0, 0), (1, -2)):
            rim = shares @ (self._profiles[:, first + 1] - self._profiles[:, first])
            across = np.einsum("mij,mj->mi", frames, rim)
            for way, hold in ((ways[k], firm), (across, np.full(_TIES, np.sqrt(_ACROSS)))):
                unit = way / np.linalg.norm(way, axis=1, keepdims=True)
                unit = weight * hold[:, None] * unit
                own = np.zeros((_TIES, *self._rails.shape))
                own[:, k] = basis[:, :, None] * unit[:, None, :]
                rows.append(own.reshape(_TIES, -1))
                apart.append(np.einsum("mi,mi->m", unit, self._tied_to[k] - points[k]))
        return np.concatenate(rows), np.concatenate(apart)

    def _as_sweep(self) -> SweptSurface:
        rails = [BSplineCurve(poles, self._along) for poles in self._rails]
        stations = self._base.stations
        origins = rails[0].evaluate(stations)
        onwards = rails[0].derivative(stations) + rails[1].derivative(stations)
        frames = two_rail_frame(origins, rails[1].evaluate(stations), onwards)
        poles = origins[:, None] + np.einsum("kij,knj->kni", frames, self._profiles)
        profiles = tuple(BSplineCurve(own, self._across) for own in poles)
        return SweptSurface((rails[0], rails[1]), profiles, SweepModel.ROTATE, Pairing.PARAMETER)


def _moved(first: Array, second: Array, onwards: Array, profile: Array) -> Array:
    """Points of the surface from points and directions of the rails and the local profile."""
    return first + np.einsum("mij,mj->mi", two_rail_frame(first, second, onwards), profile)


def _slopes(
    first: Array, second: Array, onwards: Array, profile: Array, normals: Array
) -> tuple[Array, Array, Array]:
    """Derivatives (m, 3) of the normal distance by either rail's point and by their direction."""
    given = [first, second, onwards, profile]
    sizes = [float(np.linalg.norm(second - first, axis=1).mean())] * 2
    sizes.append(float(np.linalg.norm(onwards, axis=1).mean()))
    result = []
    for place, size in enumerate(sizes):
        slope = np.empty_like(first)
        for axis in range(3):
            shift = _SMALL * size * np.eye(3)[axis]
            high, low = (
                _moved(*(x + sign * shift if i == place else x for i, x in enumerate(given)))
                for sign in (1.0, -1.0)
            )
            slope[:, axis] = np.einsum("mi,mi->m", normals, high - low) / (2.0 * _SMALL * size)
        result.append(slope)
    return result[0], result[1], result[2]
