# SPDX-License-Identifier: LGPL-2.1-or-later
"""Polynomial curves of low degree through a few scattered points of a plane."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np

__all__ = ["OffsetCurve", "PlaneCurve", "PolynomialCurve", "fit_polynomial", "meeting_parameters"]

_NEWTON_STEPS = 6
_CLOSE = 1e-6  # of a curve's length; the distance to the curve is stationary there
_SAMPLES = 48  # of each curve, where its meeting with the other one is looked for
_FARTHEST = 3.0  # of a curve's own length: how far it may be drawn out


class PlaneCurve(Protocol):
    """A curve of a plane that can be drawn out beyond its end at u = 1."""

    @property
    def degree(self) -> int:
        """1 when it is straight."""
        ...

    def at(self, u: np.ndarray | float) -> np.ndarray:
        """Points (…, 2) at parameters u (…)."""
        ...

    def derivative(self, u: np.ndarray | float) -> np.ndarray:
        """Derivatives (…, 2) by the parameter."""
        ...


@dataclass(frozen=True)
class PolynomialCurve:
    """A curve c0 + c1 u + c2 u² + …, on its points where u is in [0, 1].

    Attributes
    ----------
    coefficients : (degree + 1, d) array, mm, lowest power first
    inverse : (degree + 1, degree + 1) inverse of the normal matrix of the powers, for variances
    """

    coefficients: np.ndarray
    inverse: np.ndarray

    @property
    def degree(self) -> int:
        """Highest power of u."""
        return len(self.coefficients) - 1

    @cached_property
    def _slopes(self) -> np.ndarray:
        return self.coefficients[1:] * np.arange(1, self.degree + 1)[:, None]

    def at(self, u: np.ndarray | float) -> np.ndarray:
        """Points (…, d) at parameters u (…)."""
        return _horner(self.coefficients, u)

    def derivative(self, u: np.ndarray | float) -> np.ndarray:
        """Derivatives (…, d) by the parameter."""
        return _horner(self._slopes, u)

    def second_derivative(self, u: np.ndarray | float) -> np.ndarray:
        """Second derivatives (…, d) by the parameter."""
        if self.degree < 2:
            return 0.0 * _horner(self._slopes, u)
        return _horner(self._slopes[1:] * np.arange(1, self.degree)[:, None], u)

    def closest(self, points: np.ndarray, start: np.ndarray) -> np.ndarray:
        """Parameters (n,) of the curve's points closest to points (n, d), by Newton's method.

        The dissertation uses Brent's method (Schreve 4.3.3); a curve this short has one minimum
        near each point, which Newton's method finds from the point's own parameter.
        """
        if self.degree == 1:
            way = self.coefficients[1]
            return (points - self.coefficients[0]) @ way / (way @ way)
        u = start
        for _ in range(_NEWTON_STEPS):
            off, slope, bent = self.at(u) - points, self.derivative(u), self.second_derivative(u)
            gradient = (off * slope).sum(axis=1)
            steepness = (slope * slope).sum(axis=1)
            bend = (off * bent).sum(axis=1)
            # Where the bend would turn Newton's step round, Gauss' step is taken.
            step = gradient / np.where(bend > -0.5 * steepness, steepness + bend, steepness)
            u = u - step
            if np.abs(step).max() < _CLOSE:
                break
        return u

    def leverage(self, u: float) -> float:
        """Variance of the curve at u across itself, for points of unit variance."""
        powers = u ** np.arange(self.degree + 1)
        return float(powers @ self.inverse @ powers)


@dataclass(frozen=True)
class OffsetCurve:
    """The parallel of a plane curve: p + d·n, with n to the left of the direction of travel.

    It is no polynomial any more, but runs in the same direction as the curve, at the speed
    (1 − d κ) (Schreve eq. 4.5.3.3.1).

    Attributes
    ----------
    curve : in a plane
    distance : d, mm; negative to the right
    """

    curve: PolynomialCurve
    distance: float

    @property
    def degree(self) -> int:
        """Of the curve it is parallel to; the parallel of a line is a line."""
        return self.curve.degree

    def at(self, u: np.ndarray | float) -> np.ndarray:
        """Points (…, 2) at parameters u (…)."""
        way = self.curve.derivative(u)
        left = np.stack([-way[..., 1], way[..., 0]], axis=-1)
        return self.curve.at(u) + self.distance * left / np.linalg.norm(way, axis=-1)[..., None]

    def derivative(self, u: np.ndarray | float) -> np.ndarray:
        """Derivatives (…, 2) by the parameter."""
        way = self.curve.derivative(u)
        if self.degree == 1:
            return way
        bent = self.curve.second_derivative(u)
        curvature = (way[..., 0] * bent[..., 1] - way[..., 1] * bent[..., 0]) / (
            np.einsum("...i,...i->...", way, way) ** 1.5
        )
        return way * (1.0 - self.distance * curvature)[..., None]


def fit_polynomial(points: np.ndarray, degree: int) -> tuple[PolynomialCurve, np.ndarray]:
    """Least-squares curve through points in order, and their parameters.

    A line is the total least-squares line (Forbes), anything else a polynomial in the share of
    the chord length (Schreve eq. 4.3.4.1).

    Parameters
    ----------
    points : (n, 2) array, mm, n > degree
    degree : 1, 2 or 3

    Returns
    -------
    the curve, and (n,) parameters: 0 at the first point, 1 at the last
    """
    if degree == 1:
        return _fit_line(points)
    steps = np.diff(points, axis=0)
    lengths = np.sqrt(np.einsum("ni,ni->n", steps, steps))
    u = np.zeros(len(points))
    np.cumsum(lengths, out=u[1:])
    u /= u[-1]
    powers = u[:, None] ** np.arange(degree + 1)
    inverse = np.linalg.inv(powers.T @ powers)
    return PolynomialCurve(inverse @ (powers.T @ points), inverse), u


def _fit_line(points: np.ndarray) -> tuple[PolynomialCurve, np.ndarray]:
    centre = points.sum(axis=0) / len(points)
    offset = points - centre
    (xx, xy), (_, yy) = offset.T @ offset
    angle = 0.5 * np.arctan2(2.0 * xy, xx - yy)
    way = np.array([np.cos(angle), np.sin(angle)])
    if way @ (points[-1] - points[0]) < 0.0:
        way = -way
    along = offset @ way
    first, length = along[0], along[-1] - along[0]
    u = (along - first) / length
    curve = np.array([centre + first * way, length * way])
    middle, spread = u.sum() / len(u), u @ u
    scatter = spread - len(u) * middle**2
    inverse = np.array([[spread / len(u), -middle], [-middle, 1.0]]) / scatter
    return PolynomialCurve(curve, inverse), u


def meeting_parameters(first: PlaneCurve, second: PlaneCurve) -> tuple[float, float] | None:
    """Where two curves, drawn out beyond their ends at u = 1, meet first.

    Lines are intersected in closed form (Schreve eq. 4.3.5.1.1). Curves are intersected by
    Newton's method from the tangents' meeting point; when that leads elsewhere (a strongly bent
    curve crosses the other one twice, Schreve figure 4.8), their polylines tell where to begin.

    Returns
    -------
    the two parameters; None when the curves do not meet within three times their lengths.
    """
    ends = (1.0, 1.0)
    if first.degree == second.degree == 1:
        return _lines_meet(first, second, ends)
    start = _lines_meet(first, second, ends)
    if start is not None:
        met = _newton(first, second, start)
        # The first meeting is the one that can be reached without passing another.
        if met is not None and _plain(first, met[0]) and _plain(second, met[1]):
            return met
    start = _polylines_meet(first, second)
    return None if start is None else _newton(first, second, start)


def _plain(curve: PlaneCurve, u: float) -> bool:
    """Whether a curve turns by less than a quarter from its end to u, so that it meets once."""
    if not -0.5 < u < 1.0 + _FARTHEST:
        return False
    if curve.degree == 1:
        return True
    here, there = curve.derivative(1.0), curve.derivative(u)
    return float(here @ there) > 0.7 * float(np.sqrt((here @ here) * (there @ there)))


def _lines_meet(
    first: PlaneCurve, second: PlaneCurve, at: tuple[float, float]
) -> tuple[float, float] | None:
    """Meeting point of the tangents at two parameters."""
    (ax, ay), (bx, by) = first.derivative(at[0]), second.derivative(at[1])
    gx, gy = second.at(at[1]) - first.at(at[0])
    determinant = by * ax - bx * ay
    if abs(determinant) < 1e-9 * np.sqrt((ax**2 + ay**2) * (bx**2 + by**2)):
        return None
    return (
        at[0] + (gx * by - gy * bx) / determinant,
        at[1] + (gx * ay - gy * ax) / determinant,
    )


def _newton(
    first: PlaneCurve, second: PlaneCurve, start: tuple[float, float]
) -> tuple[float, float] | None:
    u = start
    for _ in range(20):
        ahead = _lines_meet(first, second, u)
        if ahead is None:
            return None
        step = [min(max(b - a, -0.5), 0.5) for a, b in zip(u, ahead, strict=True)]
        u = (u[0] + step[0], u[1] + step[1])
        if max(abs(step[0]), abs(step[1])) < 1e-10:
            return u if max(u) < 1.0 + _FARTHEST and min(u) > -1.0 else None
    return None


def _polylines_meet(first: PlaneCurve, second: PlaneCurve) -> tuple[float, float] | None:
    """Nearest crossing of the two drawn-out curves, as polylines; parameters between samples."""
    u = np.linspace(0.5, 1.0 + _FARTHEST, _SAMPLES)
    p, q = first.at(u), second.at(u)
    dp, dq = np.diff(p, axis=0)[:, None], np.diff(q, axis=0)[None]
    gap = q[None, :-1] - p[:-1, None]
    determinant = dp[..., 0] * dq[..., 1] - dp[..., 1] * dq[..., 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        a = (gap[..., 0] * dq[..., 1] - gap[..., 1] * dq[..., 0]) / determinant
        b = (gap[..., 0] * dp[..., 1] - gap[..., 1] * dp[..., 0]) / determinant
        crossing = (a >= 0.0) & (a < 1.0) & (b >= 0.0) & (b < 1.0)
    where = np.argwhere(crossing)
    if not len(where):
        return None
    i, j = where[np.argmin(where.sum(axis=1))]
    width = u[1] - u[0]
    return float(u[i] + a[i, j] * width), float(u[j] + b[i, j] * width)


def _horner(coefficients: np.ndarray, u: np.ndarray | float) -> np.ndarray:
    where = u if isinstance(u, float) else np.asarray(u, dtype=float)[..., None]
    value = coefficients[-1] + 0.0 * where
    for c in coefficients[-2::-1]:
        value = value * where + c
    return value
