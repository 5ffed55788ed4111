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

from freecad_edgescan.geometry.plane import Plane
from freecad_edgescan.geometry.polyline import distance_to_polyline

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
        poles = self.poles
        if self.weights is not None:
            poles = np.column_stack([poles * self.weights[:, None], self.weights])
        if self.periodic:
            poles = poles[np.arange(len(poles) + self.degree) % len(poles)]
        return BSpline(self.knots, poles, self.degree, extrapolate=False)

    def _inside(self, u: ArrayLike) -> Array:
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
        inside = self._inside(u)
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
        if start is None:
            breaks = self._breaks[0]
            _, index, fraction = distance_to_polyline(asked, self.evaluate(breaks))
            u = breaks[index] + fraction * (breaks[index + 1] - breaks[index])
        else:
            u = self._inside(start)
        away = self.evaluate(u) - asked
        square = np.sum(away**2, axis=1)
        active: NDArray[np.intp] = np.arange(len(asked))
        first, last = self.parameter_range
        for _ in range(30):
            if not len(active):
                break
            step = self._newton_step(u[active], away[active])
            waiting = np.arange(len(active))
            for shrink in 0.25 ** np.arange(6):
                rows = active[waiting]
                trial = self._inside(u[rows] + shrink * step[waiting])
                moved = self.evaluate(trial) - asked[rows]
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

    def _newton_step(self, u: Array, away: Array) -> Array:
        """Step towards the foot of the perpendicular, never longer than a piece."""
        first, second = self.derivative(u, 1), self.derivative(u, 2)
        slope = np.sum(away * first, axis=1)
        square = np.sum(first**2, axis=1)
        bend = square + np.sum(away * second, axis=1)
        bend = np.where(bend > 1e-3 * square, bend, square)
        longest = np.diff(self._breaks[0]).max()
        return np.clip(-slope / np.where(bend > 0.0, bend, np.inf), -longest, longest)

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
