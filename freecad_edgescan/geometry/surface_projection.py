# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closest points of a B-spline surface, for millions of points at once.

1. A KD-tree of samples, dense enough that the nearest sample lies on the right sheet.
2. Newton's method on the squared distance, patch by patch (Piegl and Tiller, The NURBS Book, 1997,
   section 6.1): each parameter by itself where the squared distance is not convex, along the rim
   where the way leads out of the surface, over the seam where the surface is closed. A step that
   does not come nearer is shortened.
3. Points whose foot is near a sharp bend of the surface are also projected onto the bend itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from freecad_edgescan.geometry.bspline_curve import BSplineCurve
from freecad_edgescan.geometry.polynomial_patches import PolynomialPatches
from freecad_edgescan.geometry.rational import divided

__all__ = ["SurfaceProjection"]

Array = NDArray[np.float64]

_SAMPLES = 40_000
_PER_PATCH = (4, 40)  # least and most samples of a patch in one direction
_SWEEPS = 40
_ENOUGH = 1e-6  # step in shares of a patch; the error after it is about its square
_LONGEST = 0.5  # step in shares of a patch
_CREASE = 0.1  # of a patch: feet no farther from a sharp bend are tried on it
_CONVEX = 1e-3  # least bend of the squared distance, relative to that of a plane
_ORDERS = ((0, 0), (0, 1), (1, 0), (0, 2), (1, 1), (2, 0))


class SurfaceProjection:
    """Searches the points of a surface that are closest to others.

    Parameters
    ----------
    patches : of the surface, homogeneous when it is rational
    closed : whether the surface ends where it begins, in u and in v
    creases : axis, parameter and curve of every sharp bend along a knot
    """

    def __init__(
        self,
        patches: PolynomialPatches,
        closed: tuple[bool, bool],
        creases: Sequence[tuple[int, float, BSplineCurve]] = (),
    ) -> None:
        self._patches, self._closed, self._creases = patches, closed, creases
        self._first = np.array([breaks[0] for breaks in patches.breaks])
        self._last = np.array([breaks[-1] for breaks in patches.breaks])

    @cached_property
    def _samples(self) -> tuple[cKDTree, Array]:
        """Tree of the samples, and their parameters (k, 2)."""
        patches = self._patches
        count = int(np.sqrt(_SAMPLES / (patches.shape[0] * patches.shape[1])))
        count = int(np.clip(count, *_PER_PATCH))
        share = np.arange(count) / count
        u, v = (
            np.append((breaks[:-1, None] + np.diff(breaks)[:, None] * share).ravel(), breaks[-1])
            for breaks in patches.breaks
        )
        grid = np.stack(np.meshgrid(u, v, indexing="ij"), axis=-1).reshape(-1, 2)
        points = divided(patches.evaluate(grid[:, 0], grid[:, 1], [(0, 0)]), [(0, 0)])[0]
        return cKDTree(points.T, balanced_tree=False), grid

    def closest(
        self, points: Array, start: tuple[Array, Array] | None = None
    ) -> tuple[Array, Array, Array]:
        """Parameters u (m,), v (m,) and distances (m,); see `BSplineSurface.closest`."""
        if start is None:
            tree, grid = self._samples
            best = grid[tree.query(points)[1]]
        else:
            best = np.stack(np.broadcast_arrays(*start), axis=1).astype(float)
            best = np.broadcast_to(best, (len(points), 2)).copy()
        square = np.full(len(points), np.inf)
        active: NDArray[np.intp] = np.arange(len(points))
        step, size = np.zeros_like(best), np.zeros(len(points))
        trial = best
        for _ in range(_SWEEPS):
            x = points[active]
            reached, ahead, relative = self._newton(x, trial)
            nearer = reached <= square[active]
            rows = active[nearer]
            best[rows], square[rows] = trial[nearer], reached[nearer]
            step = np.where(nearer[:, None], ahead, 0.25 * step)
            size = np.where(nearer, relative, 0.25 * size)
            going = size > _ENOUGH
            last = active[~going & nearer]  # a last step, too small to be checked
            best[last] = self._within(best[last] + step[~going & nearer])
            active, step, size = active[going], step[going], size[going]
            if not len(active):
                break
            trial = self._within(best[active] + step)
        found = divided(self._patches.evaluate(best[:, 0], best[:, 1], [(0, 0)]), [(0, 0)])[0]
        distance = np.linalg.norm(points - found.T, axis=1)
        for crease in self._creases:
            self._onto(crease, points, best, distance)
        return best[:, 0], best[:, 1], distance

    def _onto(
        self, crease: tuple[int, float, BSplineCurve], points: Array, best: Array, distance: Array
    ) -> None:
        """Feet near a crease are moved onto it where that is nearer."""
        axis, at, curve = crease
        near = _CREASE * float(np.diff(self._patches.breaks[axis]).max())
        rows = np.flatnonzero(np.abs(best[:, axis] - at) < near)
        if not len(rows):
            return
        along, off = curve.closest(points[rows], start=best[rows, 1 - axis])
        nearer = off < distance[rows]
        rows = rows[nearer]
        best[rows, axis], best[rows, 1 - axis], distance[rows] = at, along[nearer], off[nearer]

    def _within(self, uv: Array) -> Array:
        """Parameters over the seam come back on its other side, those over a rim to the rim."""
        for axis in (0, 1):
            if self._closed[axis]:
                first, last = self._first[axis], self._last[axis]
                x = uv[:, axis]
                beyond = (x < first) | (x > last)
                uv[beyond, axis] = first + np.mod(x[beyond] - first, last - first)
        return np.clip(uv, self._first, self._last, out=uv)

    def _newton(self, points: Array, uv: Array) -> tuple[Array, Array, Array]:
        """Squared distances, steps (m, 2), and the steps' size in shares of a patch."""
        patches = self._patches
        table = patches.table(*_ORDERS)
        square, relative = np.empty(len(uv)), np.empty(len(uv))
        step = np.empty_like(uv)
        spans = [np.diff(breaks) for breaks in patches.breaks]
        for number, rows in patches.groups(patches.patch_of(uv[:, 0], uv[:, 1])):
            here = uv[rows].T
            values = table[number] @ patches.powers(number, here[0], here[1])
            values = divided(values.reshape(len(_ORDERS), -1, len(rows)), _ORDERS)
            away = values[0] - points[rows].T
            row, column = divmod(number, patches.shape[1])
            span = np.array([[spans[0][row]], [spans[1][column]]])
            share = self._step(away, values[1:], here, span)
            square[rows] = _dot(away, away)
            step[rows] = (share * span).T
            relative[rows] = np.abs(share).max(axis=0)
        return square, step, relative

    def _step(self, away: Array, values: Array, uv: Array, span: Array) -> Array:
        """Step (2, m) towards the foot of the perpendicular, in shares of a patch."""
        along_v, along_u, vv, uv_, uu = values
        u, v = span
        slope_u, slope_v = u * _dot(along_u, away), v * _dot(along_v, away)
        metric = (
            u * u * _dot(along_u, along_u),
            u * v * _dot(along_u, along_v),
            v * v * _dot(along_v, along_v),
        )
        hessian = (
            metric[0] + u * u * _dot(uu, away),
            metric[1] + u * v * _dot(uv_, away),
            metric[2] + v * v * _dot(vv, away),
        )
        # alone: how each direction bends by itself, made positive
        alone = [
            np.where(own > _CONVEX * flat, own, np.maximum(np.abs(own), flat))
            for own, flat in ((hessian[0], metric[0]), (hessian[2], metric[2]))
        ]
        convex = (
            (hessian[0] > _CONVEX * metric[0])
            & (hessian[2] > _CONVEX * metric[2])
            & (_determinant(*hessian) > _CONVEX * _determinant(*metric))
        )
        slope = np.stack([slope_u, slope_v])
        out = ((uv <= self._first[:, None]) & (slope > 0.0)) | (
            (uv >= self._last[:, None]) & (slope < 0.0)
        )
        out &= ~np.array(self._closed)[:, None]
        on_rim = out[0] | out[1]
        mixed = np.where(convex, hessian[1], 0.0)
        spare = np.where(convex | on_rim, 0.0, np.abs(hessian[1]))
        first, second = alone[0] + spare, alone[1] + spare
        determinant = _determinant(first, mixed, second)
        together = convex & ~on_rim & (determinant > 0.0)
        step = -slope / np.maximum([first, second], np.finfo(float).tiny)
        newton = np.stack(
            [mixed * slope_v - second * slope_u, mixed * slope_u - first * slope_v]
        ) / np.where(together, determinant, 1.0)
        step = np.where(together, newton, step)
        step[out] = 0.0
        longest = np.maximum(np.abs(step).max(axis=0) / _LONGEST, 1.0)
        return np.asarray(step / longest)


def _dot(one: Array, other: Array) -> Array:
    """Scalar products (m,) of vectors (3, m)."""
    return np.asarray(one[0] * other[0] + one[1] * other[1] + one[2] * other[2])


def _determinant(a: Array, b: Array, c: Array) -> Array:
    return a * c - b * b
