# SPDX-License-Identifier: LGPL-2.1-or-later
"""B-spline surfaces in space: clamped in both directions, polynomial or rational.

A surface with nu × nv poles of degrees (p, q) has nu + p + 1 knots in u, the first and last p + 1
equal, and nv + q + 1 in v. Notation after Piegl and Tiller, The NURBS Book (1997), as in Schreve
eqs. 6.2.1.3 and 6.2.2.2.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np
from numpy.typing import ArrayLike, NDArray

from freecad_edgescan.geometry.blossom import poles_of_higher_degree, poles_over_knots
from freecad_edgescan.geometry.bspline_curve import BSplineCurve
from freecad_edgescan.geometry.frames import cross
from freecad_edgescan.geometry.knot_vectors import SAME, cut_knots
from freecad_edgescan.geometry.polynomial_patches import PolynomialPatches
from freecad_edgescan.geometry.rational import divided, orders_below
from freecad_edgescan.geometry.surface_check import DIRECTIONS, check_surface
from freecad_edgescan.geometry.surface_projection import SurfaceProjection

__all__ = ["BSplineSurface"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False, repr=False)
class BSplineSurface:
    """A B-spline surface.

    Parameters
    ----------
    poles : (nu, nv, 3) array
        Poles in mm.
    knots : two arrays, (nu + degree[0] + 1,) and (nv + degree[1] + 1,)
        Never decreasing; at both ends degree + 1 equal ones.
    degree : two int
        (3, 3) is bicubic.
    weights : (nu, nv) array of positive numbers, optional
        Makes the surface rational.

    Raises
    ------
    ValueError: numbers of poles, knots and weights that do not belong together.
    """

    poles: Array
    knots: tuple[Array, Array]
    degree: tuple[int, int] = (3, 3)
    weights: Array | None = None

    def __repr__(self) -> str:
        kind = "" if self.weights is None else ", rational"
        (nu, nv), (p, q) = self.poles.shape[:2], self.degree
        return f"BSplineSurface({nu} × {nv} poles, degree {p} × {q}{kind})"

    def __post_init__(self) -> None:
        u, v = self.knots
        p, q = self.degree
        object.__setattr__(self, "poles", np.array(self.poles, dtype=float))
        object.__setattr__(self, "knots", (np.array(u, dtype=float), np.array(v, dtype=float)))
        object.__setattr__(self, "degree", (int(p), int(q)))
        if self.weights is not None:
            object.__setattr__(self, "weights", np.array(self.weights, dtype=float))
        check_surface(self.poles, self.knots, self.degree, self.weights)

    @classmethod
    def from_distinct_knots(
        cls,
        poles: ArrayLike,
        knots: tuple[ArrayLike, ArrayLike],
        multiplicities: tuple[ArrayLike, ArrayLike],
        degree: tuple[int, int] = (3, 3),
        weights: ArrayLike | None = None,
    ) -> BSplineSurface:
        """The surface from each knot once with its multiplicity, as CAD kernels store it.

        Parameters
        ----------
        poles : (nu, nv, 3) array, mm
        knots : increasing, for u and v
        multiplicities : int, for u and v; they sum to nu + degree + 1 and nv + degree + 1
        degree : two int
        weights : (nu, nv) array, optional
        """
        u, v = (
            np.repeat(np.asarray(values, dtype=float), np.asarray(counts, dtype=np.intp))
            for values, counts in zip(knots, multiplicities, strict=True)
        )
        given = None if weights is None else np.asarray(weights, dtype=float)
        return cls(np.asarray(poles, dtype=float), (u, v), degree, given)

    def distinct_knots_and_multiplicities(
        self,
    ) -> tuple[tuple[Array, NDArray[np.intp]], tuple[Array, NDArray[np.intp]]]:
        """For u and for v each knot once and its multiplicity, as `Part.BSplineSurface` does."""
        u, v = (np.unique(knots, return_counts=True) for knots in self.knots)
        return u, v

    @property
    def parameter_range(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """First and last parameter in u and in v."""
        u, v = ((float(knots[0]), float(knots[-1])) for knots in self.knots)
        return u, v

    @cached_property
    def closed(self) -> tuple[bool, bool]:
        """Whether the surface ends where it begins, in u and in v."""
        poles = self._homogeneous
        size = float(np.ptp(self.poles.reshape(-1, 3), axis=0).max())
        u, v = (
            bool(np.abs(first - last).max() <= SAME * size)
            for first, last in ((poles[0], poles[-1]), (poles[:, 0], poles[:, -1]))
        )
        return u, v

    @cached_property
    def _homogeneous(self) -> Array:
        """Poles, of a rational surface (x w, y w, z w, w)."""
        if self.weights is None:
            return self.poles
        weights = self.weights[..., None]
        return np.concatenate([self.poles * weights, weights], axis=-1)

    @cached_property
    def patches(self) -> PolynomialPatches:
        """The polynomial patches, homogeneous when the surface is rational."""
        return PolynomialPatches(self._homogeneous, self.knots, self.degree)

    @cached_property
    def _projection(self) -> SurfaceProjection:
        return SurfaceProjection(self.patches, self.closed, self._creases())

    def _creases(self) -> list[tuple[int, float, BSplineCurve]]:
        """Axis, parameter and curve of every knot at which the surface has a sharp bend."""
        found = []
        for axis, (knots, degree) in enumerate(zip(self.knots, self.degree, strict=True)):
            distinct, counts = np.unique(knots[degree + 1 : -degree - 1], return_counts=True)
            along = np.linspace(*self.parameter_range[1 - axis], 50)
            before = SAME * (knots[-1] - knots[0])
            for at in distinct[counts >= degree]:
                pair = [
                    self.normal(x, along) if axis == 0 else self.normal(along, x)
                    for x in (at - before, at)
                ]
                if np.abs(pair[1] - pair[0]).max() > 1e-6:
                    curve = self.curve_at(u=at) if axis == 0 else self.curve_at(v=at)
                    found.append((axis, float(at), curve))
        return found

    def inside(self, u: ArrayLike, v: ArrayLike) -> tuple[Array, Array]:
        """Parameters brought into the range: wrapped where the surface is closed, else clipped."""
        result = []
        for x, (first, last), closed in zip((u, v), self.parameter_range, self.closed, strict=True):
            x = np.asarray(x, dtype=float)
            if closed:
                beyond = (x < first) | (x > last)
                x = np.where(beyond, first + np.mod(x - first, last - first), x)
            result.append(np.clip(x, first, last))
        return result[0], result[1]

    def evaluate(self, u: ArrayLike, v: ArrayLike) -> Array:
        """Points at parameters u and v, broadcast together: their shape plus (3,), mm.

        Parameters outside the range are wrapped where the surface is closed, else clipped.
        """
        return self.derivative(u, v, 0, 0)

    def derivative(self, u: ArrayLike, v: ArrayLike, du: int = 1, dv: int = 0) -> Array:
        """Derivative of orders du in u and dv in v: shape of the parameters plus (3,).

        At a knot where it jumps, that of the later piece.
        """
        return self._derivatives(u, v, du, dv)[-1]

    def tangents(self, u: ArrayLike, v: ArrayLike) -> tuple[Array, Array]:
        """First derivatives in u and in v, each of the parameters' shape plus (3,)."""
        return self.point_and_tangents(u, v)[1:]

    def point_and_tangents(self, u: ArrayLike, v: ArrayLike) -> tuple[Array, Array, Array]:
        """Points and first derivatives in u and in v, each of the parameters' shape plus (3,)."""
        point, along_v, along_u, _ = self._derivatives(u, v, 1, 1)
        return point, along_u, along_v

    def normal(self, u: ArrayLike, v: ArrayLike) -> Array:
        """Unit normals ∂S/∂u × ∂S/∂v: the parameters' shape plus (3,); zero where there is none."""
        normal = cross(*self.tangents(u, v))
        length = np.linalg.norm(normal, axis=-1, keepdims=True)
        return normal / np.where(length > 0.0, length, 1.0)

    def _derivatives(self, u: ArrayLike, v: ArrayLike, du: int, dv: int) -> list[Array]:
        u, v = np.broadcast_arrays(*self.inside(u, v))
        orders = orders_below(du, dv)
        values = divided(self.patches.evaluate(u.ravel(), v.ravel(), orders), orders)
        return [value.T.reshape(*u.shape, 3) for value in values]

    def closest(
        self, points: ArrayLike, start: tuple[ArrayLike, ArrayLike] | None = None
    ) -> tuple[Array, Array, Array]:
        """Parameters and distances of the surface's points closest to the given ones.

        Parameters
        ----------
        points : (m, 3) array
            Points in mm.
        start : (m,) and (m,) array, optional
            Parameters to start from; without them samples of the surface are searched, so that
            the nearest of several sheets is found.

        Returns
        -------
        u (m,) and v (m,) within the range and distances (m,) in mm.
        """
        asked: Array = np.atleast_2d(np.asarray(points, dtype=float))
        if asked.ndim != 2 or asked.shape[1] != 3:
            raise ValueError(f"Points are an (m, 3) array, not one of shape {asked.shape}.")
        if not np.all(np.isfinite(asked)):
            raise ValueError("A coordinate of the points is not a finite number; remove the point.")
        return self._projection.closest(asked, None if start is None else self.inside(*start))

    def _rewritten(
        self, axis: int, degree: int, rewrite: Callable[[Array], tuple[Array, Array]]
    ) -> BSplineSurface:
        """The surface with new knots and poles along an axis; `rewrite` takes poles (n, d)."""
        moved = np.moveaxis(self._homogeneous, axis, 0)
        own, flat = rewrite(moved.reshape(len(moved), -1))
        poles = np.moveaxis(flat.reshape(len(flat), *moved.shape[1:]), 0, axis)
        knots, degrees = list(self.knots), list(self.degree)
        knots[axis], degrees[axis] = own, degree
        weights = None if self.weights is None else poles[..., 3]
        if weights is not None:
            poles = poles[..., :3] / weights[..., None]
        return BSplineSurface(poles, (knots[0], knots[1]), (degrees[0], degrees[1]), weights)

    def _over(self, axis: int, knots: Array) -> BSplineSurface:
        """The same surface, or the part between the ends of other knots that hold its own."""
        old, p = self.knots[axis], self.degree[axis]
        return self._rewritten(
            axis, p, lambda poles: (knots, poles_over_knots(old, p, poles, knots))
        )

    def refined(self, u: ArrayLike = (), v: ArrayLike = ()) -> BSplineSurface:
        """The same surface with more knots: each of u and v is inserted once."""
        result = self
        for axis, added in enumerate((u, v)):
            added = np.atleast_1d(np.asarray(added, dtype=float))
            first, last = self.parameter_range[axis]
            wrong = added[~((added > first) & (added < last))]
            if len(wrong):
                raise ValueError(
                    f"A knot at {wrong[0]:g} cannot be inserted in {DIRECTIONS[axis]}; choose it "
                    f"between {first:g} and {last:g}."
                )
            result = result._over(axis, np.sort(np.append(self.knots[axis], added)))
        return result

    def elevated(self, degree: tuple[int, int]) -> BSplineSurface:
        """The same surface written with these higher degrees in u and v."""
        result = self
        for axis, wanted in enumerate(degree):
            if wanted < self.degree[axis]:
                raise ValueError(
                    f"The degree in {DIRECTIONS[axis]} is {self.degree[axis]} and cannot become "
                    f"{wanted} without changing the surface; fit a new one."
                )
            for p in range(self.degree[axis], wanted):
                raise_degree = partial(poles_of_higher_degree, result.knots[axis], p)
                result = result._rewritten(axis, p + 1, raise_degree)
        return result

    def restricted(
        self, u: tuple[float, float] | None = None, v: tuple[float, float] | None = None
    ) -> BSplineSurface:
        """The part of the surface between parameters in u, in v, or in both; they are kept."""
        result = self
        for axis, limits in enumerate((u, v)):
            if limits is None:
                continue
            first, last = self.parameter_range[axis]
            if not first <= limits[0] < limits[1] <= last:
                raise ValueError(
                    f"The part from {limits[0]:g} to {limits[1]:g} in {DIRECTIONS[axis]} is not "
                    f"one of the surface; choose limits in order between {first:g} and {last:g}."
                )
            result = result._over(axis, cut_knots(self.knots[axis], self.degree[axis], *limits))
        return result

    def split(self, axis: int, at: float) -> tuple[BSplineSurface, BSplineSurface]:
        """The parts before and after a parameter in u (axis 0) or v (axis 1)."""
        first, last = self.parameter_range[axis]
        before, after = (first, at), (at, last)
        if axis == 0:
            return self.restricted(u=before), self.restricted(u=after)
        return self.restricted(v=before), self.restricted(v=after)

    def reversed(self, axis: int) -> BSplineSurface:
        """The same surface run through backwards in u (axis 0) or v (axis 1); its normal turns."""
        knots = self.knots[axis]
        return self._rewritten(
            axis,
            self.degree[axis],
            lambda poles: ((knots[0] + knots[-1]) - knots[::-1], poles[::-1]),
        )

    def transposed(self) -> BSplineSurface:
        """The same surface with u and v exchanged; its normal turns."""
        weights = None if self.weights is None else self.weights.T
        return BSplineSurface(
            self.poles.transpose(1, 0, 2), self.knots[::-1], self.degree[::-1], weights
        )

    def curve_at(self, u: float | None = None, v: float | None = None) -> BSplineCurve:
        """The curve on the surface along v at a parameter u, or along u at a parameter v."""
        if (u is None) == (v is None):
            raise ValueError(f"Give u or v, and only one of them, not u={u} and v={v}.")
        axis = 0 if u is not None else 1
        first, last = self.parameter_range[axis]
        at = float(
            self.inside(first if u is None else u, 0.0)[0]
            if axis == 0
            else self.inside(0.0, first if v is None else v)[1]
        )
        p, knots = self.degree[axis], self.knots[axis]
        moved = np.moveaxis(self._homogeneous, axis, 0)
        whole: Sequence[Array] = cut_knots(knots, p, at, last), cut_knots(knots, p, first, at)
        piece = whole[0] if at < last else whole[1]
        poles = poles_over_knots(knots, p, moved.reshape(len(moved), -1), piece)
        poles = poles[0 if at < last else -1].reshape(moved.shape[1], -1)
        weights = None if self.weights is None else poles[:, 3]
        if weights is not None:
            poles = poles[:, :3] / weights[:, None]
        return BSplineCurve(poles, self.knots[1 - axis], self.degree[1 - axis], False, weights)
