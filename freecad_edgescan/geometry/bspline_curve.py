# SPDX-License-Identifier: LGPL-2.1-or-later
"""B-spline curves in space: clamped or periodic, polynomial or rational.

A clamped curve with n poles of degree p has n + p + 1 knots, the first and last p + 1 equal.
A periodic curve keeps its n poles without repetition; its n + 2 p + 1 knots are unwrapped: they
run on by p knots to both sides of the period [knots[p], knots[n + p]]. The parameter of a curve
is free; those of `fit_curve` are close to the arc length.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from math import comb

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import BSpline

from freecad_edgescan.geometry.blossom import poles_of_higher_degree, poles_over_knots
from freecad_edgescan.geometry.curve_projection import closest_on_curve
from freecad_edgescan.geometry.knot_vectors import cut_knots
from freecad_edgescan.geometry.plane import Plane

__all__ = ["BSplineCurve"]

Array = NDArray[np.float64]

_PIECES_PER_SPAN = 16
_NODES, _NODE_WEIGHTS = np.polynomial.legendre.leggauss(6)


@dataclass(frozen=True, eq=False, repr=False)
class BSplineCurve:
    """A B-spline curve.

    Parameters
    ----------
    poles : (n, 3) array
        Poles in mm; of a periodic curve without repetition.
    knots : (n + degree + 1,) array, or (n + 2 degree + 1,) when periodic
        Clamped, or unwrapped over the seam, never decreasing.
    degree : int
        3 is cubic.
    periodic : bool
        Whether the curve closes smoothly.
    weights : (n,) array of positive numbers, optional
        Makes the curve rational.

    Raises
    ------
    ValueError: numbers of poles, knots and weights that do not belong together.
    """

    poles: Array
    knots: Array
    degree: int = 3
    periodic: bool = False
    weights: Array | None = None

    def __repr__(self) -> str:
        kind = "periodic" if self.periodic else "open"
        return f"BSplineCurve({len(self.poles)} poles, degree {self.degree}, {kind})"

    def __post_init__(self) -> None:
        object.__setattr__(self, "poles", np.array(self.poles, dtype=float))
        object.__setattr__(self, "knots", np.array(self.knots, dtype=float))
        if self.weights is not None:
            object.__setattr__(self, "weights", np.array(self.weights, dtype=float))
        self._check()

    def _check(self) -> None:
        p = self.degree
        if p < 1:
            raise ValueError(f"The degree of a B-spline curve is 1 or more, not {p}.")
        if self.poles.ndim != 2 or self.poles.shape[1] != 3:
            raise ValueError(f"Poles are an (n, 3) array, not one of shape {self.poles.shape}.")
        n = len(self.poles)
        least = 2 if self.periodic else p + 1
        if n < least:
            raise ValueError(f"A curve of degree {p} needs at least {least} poles, not {n}.")
        expected = n + (2 * p if self.periodic else p) + 1
        if self.knots.shape != (expected,):
            raise ValueError(
                f"{n} poles of degree {p} need {expected} knots, not {self.knots.size}; "
                "repeat them by their multiplicity, or use BSplineCurve.from_distinct_knots."
            )
        first, last = self.parameter_range
        if not (np.all(np.diff(self.knots) >= 0.0) and first < last):
            raise ValueError("Knots must not decrease, and must span more than one value.")
        if self.weights is not None and not (
            self.weights.shape == (n,) and np.all(self.weights > 0.0)
        ):
            raise ValueError(f"Weights are {n} positive numbers, one for each pole.")

    @classmethod
    def from_distinct_knots(
        cls,
        poles: ArrayLike,
        knots: ArrayLike,
        multiplicities: ArrayLike,
        degree: int = 3,
        periodic: bool = False,
        weights: ArrayLike | None = None,
    ) -> BSplineCurve:
        """The curve from each knot once with its multiplicity, as CAD kernels store it.

        Parameters
        ----------
        poles : (n, 3) array
            Poles in mm; of a periodic curve without repetition.
        knots : (k,) array
            Increasing; of a periodic curve from one seam to the next, both included.
        multiplicities : (k,) array of int
            How often each knot counts; of a periodic curve first and last alike.
        degree : int
            Degree of the curve.
        periodic : bool
            Whether the curve is periodic.
        weights : (n,) array, optional
            Weights of a rational curve.
        """
        poles = np.asarray(poles, dtype=float)
        counts = np.asarray(multiplicities, dtype=np.intp)
        flat = np.repeat(np.asarray(knots, dtype=float), counts)
        if periodic:
            n = len(poles)
            if len(flat) != n + counts[0] or counts[0] != counts[-1]:
                raise ValueError(
                    f"A periodic curve of {n} poles needs multiplicities that sum to {n} without "
                    f"the last, which equals the first; got {counts.tolist()}."
                )
            turn, place = np.divmod(np.arange(n + 2 * degree + 1) - (degree + 1 - counts[0]), n)
            flat = flat[place] + turn * (flat[-1] - flat[0])
        return cls(poles, flat, degree, periodic, None if weights is None else np.asarray(weights))

    def distinct_knots_and_multiplicities(self) -> tuple[Array, NDArray[np.intp]]:
        """Each knot once with its multiplicity, as `Part.BSplineCurve` takes them.

        For `buildFromPolesMultsKnots(poles, multiplicities, knots, periodic, degree, weights)`.
        Clamped: multiplicities sum to n + degree + 1. Periodic: the knots run from one seam to
        the next, and the multiplicities without the last sum to n.
        """
        p = self.degree
        flat = self.knots
        if self.periodic:
            flat = flat[: len(self.poles) + p + 1]
            flat = flat[flat >= flat[p]]
            distinct, counts = np.unique(flat, return_counts=True)
            counts[-1] = counts[0] = len(self.poles) - counts[1:-1].sum()
            return distinct, counts
        return np.unique(flat, return_counts=True)

    @property
    def parameter_range(self) -> tuple[float, float]:
        """First and last parameter; of a periodic curve one period."""
        p = self.degree
        return float(self.knots[p]), float(self.knots[-p - 1])

    @cached_property
    def _spline(self) -> BSpline:
        """SciPy's spline of the poles, homogeneous (x w, y w, z w, w) when rational."""
        return BSpline(self.knots, self._homogeneous, self.degree, extrapolate=False)

    @cached_property
    def _homogeneous(self) -> Array:
        """Poles as many as the knots ask for, of a rational curve (x w, y w, z w, w)."""
        poles = self.poles
        if self.weights is not None:
            poles = np.column_stack([poles * self.weights[:, None], self.weights])
        if self.periodic:
            poles = poles[np.arange(len(poles) + self.degree) % len(poles)]
        return poles

    def inside(self, u: ArrayLike) -> Array:
        """Parameters brought into the range: wrapped when periodic, else clipped."""
        first, last = self.parameter_range
        u = np.asarray(u, dtype=float)
        if self.periodic:
            return np.minimum(first + np.mod(u - first, last - first), last)
        return np.clip(u, first, last)

    def evaluate(self, u: ArrayLike) -> Array:
        """Points at parameters u, shape of u plus (3,), mm; u outside is wrapped or clipped."""
        return self.derivative(u, 0)

    def derivative(self, u: ArrayLike, order: int = 1) -> Array:
        """Derivative by the parameter, shape of u plus (3,)."""
        inside = self.inside(u)
        if self.weights is None:
            return np.asarray(self._spline(inside, nu=order))
        homogeneous = [np.asarray(self._spline(inside, nu=k)) for k in range(order + 1)]
        result: list[Array] = []
        for k in range(order + 1):
            value = homogeneous[k][..., :3].copy()
            for i in range(1, k + 1):
                value -= comb(k, i) * homogeneous[i][..., 3:] * result[k - i]
            result.append(value / homogeneous[0][..., 3:])
        return result[order]

    def tangent(self, u: ArrayLike) -> Array:
        """Unit tangents, shape of u plus (3,)."""
        first = self.derivative(u, 1)
        length = np.linalg.norm(first, axis=-1, keepdims=True)
        return first / np.where(length > 0.0, length, 1.0)

    def curvature_vector(self, u: ArrayLike) -> Array:
        """Curvature times the direction to the centre of curvature, 1/mm."""
        first, second = self.derivative(u, 1), self.derivative(u, 2)
        square = np.sum(first**2, axis=-1, keepdims=True)
        square = np.where(square > 0.0, square, np.inf)
        along = np.sum(first * second, axis=-1, keepdims=True) / square
        return (second - along * first) / square

    def curvature(self, u: ArrayLike) -> Array:
        """Curvature, shape of u, 1/mm."""
        return np.linalg.norm(self.curvature_vector(u), axis=-1)

    @cached_property
    def _breaks(self) -> tuple[Array, Array]:
        """Parameters that cut every span into equal pieces, and the arc length up to each."""
        knots = self.distinct_knots_and_multiplicities()[0]
        share = np.arange(_PIECES_PER_SPAN) / _PIECES_PER_SPAN
        u = np.append((knots[:-1, None] + np.diff(knots)[:, None] * share).ravel(), knots[-1])
        return u, np.append(0.0, np.cumsum(self._arc(u[:-1], u[1:])))

    def _arc(self, start: Array, end: Array) -> Array:
        """Arc lengths between parameters of one piece, by Gauss's quadrature."""
        half = (end - start) / 2
        u = (start + end)[:, None] / 2 + half[:, None] * _NODES
        return half * (np.linalg.norm(self.derivative(u), axis=-1) @ _NODE_WEIGHTS)

    def length(self) -> float:
        """Arc length, mm."""
        return float(self._breaks[1][-1])

    def parameters_at_length(self, lengths: ArrayLike) -> Array:
        """Parameters (m,) at arc lengths (m,) from the start, mm; clipped to the curve."""
        breaks, reached = self._breaks
        wanted = np.clip(np.asarray(lengths, dtype=float), 0.0, reached[-1])
        piece = np.clip(np.searchsorted(reached, wanted, side="right") - 1, 0, len(breaks) - 2)
        u = np.interp(wanted, reached, breaks)
        for _ in range(4):
            missing = wanted - reached[piece] - self._arc(breaks[piece], u)
            speed = np.linalg.norm(self.derivative(u), axis=-1)
            u = u + missing / np.where(speed > 0.0, speed, np.inf)
            u = np.clip(u, breaks[piece], breaks[piece + 1])
        return u

    def sample(self, n: int) -> Array:
        """Points (n, 3) at equal steps of the parameter; a periodic one's end is left out."""
        return self.evaluate(np.linspace(*self.parameter_range, n, endpoint=not self.periodic))

    def sample_by_length(self, step: float) -> Array:
        """Points (m, 3) at equal arc lengths of at most `step` mm, without a periodic one's end."""
        if not step > 0.0:
            raise ValueError(f"The step along a curve is {step} mm; give a positive length.")
        count = max(1, int(np.ceil(self.length() / step * (1.0 - 1e-9))))
        lengths = np.linspace(0.0, self.length(), count + 1)
        return self.evaluate(self.parameters_at_length(lengths[:-1] if self.periodic else lengths))

    def closest(self, points: ArrayLike, start: ArrayLike | None = None) -> tuple[Array, Array]:
        """Parameters and distances of the curve's points closest to the given ones.

        Parameters
        ----------
        points : (m, 3) array
            Points in mm.
        start : (m,) array, optional
            Parameters to start from; without them a polyline of the curve is searched, so that
            the nearest of several branches is found.

        Returns
        -------
        parameters (m,) within the range and distances (m,) in mm.
        """
        asked: Array = np.atleast_2d(np.asarray(points, dtype=float))
        breaks = self._breaks[0]
        return closest_on_curve(self, breaks, asked, None if start is None else self.inside(start))

    def flattened(self, plane: Plane) -> BSplineCurve:
        """The curve's projection into a plane, over the same parameters."""
        return replace(self, poles=self.poles - plane.residuals(self.poles))

    def reversed(self) -> BSplineCurve:
        """The same curve run through from its end to its start, over the same parameters."""
        knots, counts = self.distinct_knots_and_multiplicities()
        place = np.arange(len(self.poles))[::-1]
        if self.periodic:
            place = (place + self.degree + 1 - counts[0]) % len(self.poles)
        return BSplineCurve.from_distinct_knots(
            self.poles[place],
            (knots[0] + knots[-1]) - knots[::-1],
            counts[::-1],
            self.degree,
            self.periodic,
            None if self.weights is None else self.weights[place],
        )

    def _clamped(self, homogeneous: Array, knots: Array, degree: int) -> BSplineCurve:
        """The open curve with these poles, which are homogeneous when this one is rational."""
        if self.weights is None:
            return BSplineCurve(homogeneous, knots, degree)
        weights = homogeneous[:, 3]
        return BSplineCurve(homogeneous[:, :3] / weights[:, None], knots, degree, False, weights)

    def over_knots(self, knots: Array) -> BSplineCurve:
        """The same curve, or the part between the ends of other knots that hold its own."""
        poles = poles_over_knots(self.knots, self.degree, self._homogeneous, knots)
        return self._clamped(poles, knots, self.degree)

    def restricted(self, first: float, last: float) -> BSplineCurve:
        """The part of the curve between two parameters, open and over the same parameters."""
        low, high = self.parameter_range
        if not low <= first < last <= high:
            raise ValueError(
                f"The part from {first:g} to {last:g} is not one of the curve; choose limits in "
                f"order between {low:g} and {high:g}."
            )
        return self.over_knots(cut_knots(self.knots, self.degree, first, last))

    def opened(self) -> BSplineCurve:
        """The same curve with clamped knots; a periodic one begins and ends at its seam."""
        return self.restricted(*self.parameter_range)

    def refined(self, u: ArrayLike) -> BSplineCurve:
        """The same curve, opened, with a knot inserted at each of the parameters u."""
        added = np.atleast_1d(np.asarray(u, dtype=float))
        first, last = self.parameter_range
        wrong = added[~((added > first) & (added < last))]
        if len(wrong):
            raise ValueError(
                f"A knot at {wrong[0]:g} cannot be inserted; choose it between {first:g} and "
                f"{last:g}."
            )
        knots = cut_knots(self.knots, self.degree, first, last)
        return self.over_knots(np.sort(np.append(knots, added)))

    def elevated(self, degree: int) -> BSplineCurve:
        """The same curve, opened, written with a higher degree."""
        if degree < self.degree:
            raise ValueError(
                f"A curve of degree {self.degree} cannot be written with degree {degree}; fit a "
                "new one."
            )
        curve = self.opened()
        knots, poles = curve.knots, curve._homogeneous
        for p in range(self.degree, degree):
            knots, poles = poles_of_higher_degree(knots, p, poles)
        return self._clamped(poles, knots, degree)

    def over_range(self, first: float, last: float) -> BSplineCurve:
        """The same curve with its parameters scaled to a new range."""
        if not first < last:
            raise ValueError(f"The range from {first:g} to {last:g} is not one; give first < last.")
        low, high = self.parameter_range
        knots = first + (self.knots - low) * ((last - first) / (high - low))
        # to the last bit, so that clamped ends stay equal
        knots[self.knots == low], knots[self.knots == high] = first, last
        return replace(self, knots=knots)
