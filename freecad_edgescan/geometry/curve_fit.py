# SPDX-License-Identifier: LGPL-2.1-or-later
"""Weighted least-squares B-spline through points, in as few poles as their sigma asks for.

1. Chord-length parameters of the points without their zigzag; a curve of one span (closed: of
   a few).
2. Spans whose misfit is larger than the points' sigma are halved until there are none, or until
   more poles no longer tell more than their number costs (Bayesian information criterion).
3. Knots whose absence the points would not notice are taken out again.
4. Parameters are corrected to the closest points of the curve in between and at the end, so that
   only the misfit across the curve counts.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import chdtri

from freecad_edgescan.geometry.bspline_curve import BSplineCurve
from freecad_edgescan.geometry.pole_system import PoleSystem
from freecad_edgescan.geometry.weighted_points import WeightedPoints

__all__ = ["fit_curve"]

Array = NDArray[np.float64]

_POINTS_PER_POLE = 3
_LOCAL_MISFIT = 2.0
"""Root mean square of residual/sigma within one span that asks for another pole there."""
_CHANCE = 0.01
"""Probability at which a span's misfit still counts as chance."""
_UNNOTICED = float(chdtri(2, 1e-3))
"""Growth of chi-square by which a knot's absence is still within chance."""
_TIGHTER = (0.8, 0.5, 0.2)
"""Shares of a tolerance to aim at where the whole was missed."""
_FREE_ALONG = 0.02
"""Weight along the curve, relative to across, once the parameters are good."""


def fit_curve(
    points: ArrayLike,
    sigma: ArrayLike,
    covariance: ArrayLike | None = None,
    tangents: ArrayLike | None = None,
    closed: bool = False,
    tolerance: float | None = None,
    degree: int = 3,
) -> BSplineCurve:
    """B-spline curve along points in order, no closer to them than their sigma justifies.

    Parameters
    ----------
    points : (m, 3) array
        In order along the curve, mm; repeated points are allowed.
    sigma : (m,) array or number
        Standard deviation of each point in each direction across the curve, mm. Zero means far
        more precise than the others; infinity means that the point says nothing.
    covariance : (m, 3, 3) array, optional
        Covariance of each point, mm²; used across the curve instead of sigma.
    tangents : (m, 3) array, optional
        Directions of the curve at the points, where they are known.
    closed : bool
        Whether the curve leads from the last point back to the first; it is then periodic.
    tolerance : float, optional
        Largest distance of a point from the curve, mm, to be reached instead of the sigma.
    degree : int
        Degree; it is lowered when there are not enough different points.

    Returns
    -------
    BSplineCurve from the first to the last point, with parameters close to the arc length.

    Raises
    ------
    ValueError: fewer than two different points (closed: three), or wrong sigmas.
    """
    data = WeightedPoints.prepare(points, sigma, covariance, tangents, closed)
    fit = _fitted(data, degree, tolerance)
    if tolerance is not None:
        # The last parameters are better, and may bring a point just beyond the tolerance again.
        for tighter in _TIGHTER:
            if fit.deviation.max() <= tolerance:
                break
            fit = _fitted(data, degree, tighter * tolerance)
    return fit.curve


def _fitted(data: WeightedPoints, degree: int, tolerance: float | None) -> _Fit:
    """Poles added where they are missing, removed where they are not, and parameters mended."""
    data, fit = _refined(data, _grown(data, degree, tolerance), 1, along=1.0)
    fit = _thinned(data, fit, tolerance)
    return _refined(data, fit, 3, along=_FREE_ALONG)[1]


@dataclass(frozen=True, eq=False)
class _Fit:
    """A curve, the equations it solves, and how far the points are from it."""

    curve: BSplineCurve
    system: PoleSystem
    chi_square: Array
    deviation: Array

    @property
    def information(self) -> float:
        """Bayesian information criterion, lower is better; two numbers a point and a pole."""
        count = 2 * len(self.chi_square)
        mean = max(float(self.chi_square.sum()) / count, 1e-300)
        return float(count * np.log(mean) + 2 * len(self.curve.poles) * np.log(count))

    @property
    def breaks(self) -> Array:
        return self.curve.distinct_knots_and_multiplicities()[0]


def _solved(data: WeightedPoints, breaks: Array, degree: int, along: float = 1.0) -> _Fit:
    """The curve with these distinct knots; `along` is the weight of misfit along the curve."""
    across, size = data.across()
    size = along * size
    if not data.closed:
        size[[0, -1]] = np.maximum(size[[0, -1]] / along, np.median(size) / along)
    t = data.tangents
    weights = across + size[:, None, None] * t[:, :, None] * t[:, None, :]
    counts = np.ones(len(breaks), dtype=np.intp)
    if not data.closed:
        counts[[0, -1]] = degree + 1
    poles = np.zeros((counts.sum() - (1 if data.closed else degree + 1), 3))
    blank = BSplineCurve.from_distinct_knots(poles, breaks, counts, degree, data.closed)
    system = PoleSystem(blank.knots, degree, data.closed, data.parameters, data.points, weights)
    curve = replace(blank, poles=system.poles)
    away = data.points - curve.evaluate(data.parameters)
    tangent = t if data.tangents_are_known else curve.tangent(data.parameters)
    away -= np.sum(away * tangent, axis=1, keepdims=True) * tangent
    chi_square = np.einsum("mx,mxy,my->m", away, across, away)
    return _Fit(curve, system, chi_square, np.linalg.norm(away, axis=1))


def _refined(
    data: WeightedPoints, fit: _Fit, times: int, along: float
) -> tuple[WeightedPoints, _Fit]:
    """Parameters moved to the closest points of the curve, and the poles solved anew."""
    for _ in range(times):
        u = fit.curve.closest(data.points, data.parameters)[0]
        if not data.closed:
            u[[0, -1]] = data.parameters[[0, -1]]
        tangents = data.tangents if data.tangents_are_known else fit.curve.tangent(u)
        data = replace(data, parameters=u, tangents=tangents)
        fit = _solved(data, fit.breaks, fit.curve.degree, along)
    return data, fit


def _misfitting_spans(
    data: WeightedPoints, fit: _Fit, tolerance: float | None
) -> NDArray[np.bool_]:
    """Which spans do not follow their points; none when the fit is good enough."""
    span = np.searchsorted(fit.breaks, data.parameters, side="right") - 1
    span = np.clip(span, 0, len(fit.breaks) - 2)
    if tolerance is not None:
        wrong = np.zeros(len(fit.breaks) - 1, dtype=bool)
        wrong[span[fit.deviation > tolerance]] = True
        return wrong
    size = len(fit.breaks) - 1
    freedom = 2.0 * np.maximum(np.bincount(span, minlength=size), 1)
    mean = np.bincount(span, fit.chi_square, minlength=size) / freedom
    by_chance = chdtri(freedom, _CHANCE) / freedom
    total, most = float(fit.chi_square.sum()), 2.0 * len(fit.chi_square)
    if total > chdtri(most, _CHANCE):
        return mean > 1.0
    if total > most:
        return mean > by_chance
    return mean > np.maximum(_LOCAL_MISFIT**2, by_chance)


def _grown(data: WeightedPoints, degree: int, tolerance: float | None) -> _Fit:
    """The first curve that follows its points, or else the one that tells most per pole."""
    different = np.unique(data.parameters)
    degree = min(degree, len(different) - 1)
    spans = max(degree + 1, min(4, len(different))) if data.closed else 1
    breaks = np.linspace(0.0, data.period, spans + 1, dtype=np.float64)
    tried = []
    while True:
        fit = _solved(data, breaks, degree)
        tried.append(fit)
        wrong = _misfitting_spans(data, fit, tolerance)
        if not wrong.any():
            return fit
        # A tolerance is to be kept; noise is not to be followed.
        per_pole = _POINTS_PER_POLE if tolerance is None else 1
        added = _middles(different, breaks, wrong, per_pole)
        if not len(added):
            break
        breaks = np.sort(np.append(breaks, added))
    if tolerance is not None:
        return min(tried, key=lambda fit: float(fit.deviation.max()))
    return min(tried, key=lambda fit: fit.information)


def _middles(parameters: Array, breaks: Array, wrong: NDArray[np.bool_], per_pole: int) -> Array:
    """Knots that halve the wrong spans between their points, where both halves keep enough."""
    edge = np.searchsorted(parameters, breaks)
    edge[-1] = len(parameters)
    first, count = edge[:-1], np.diff(edge)
    wrong = wrong & (count >= 2 * per_pole)
    middle = (first + count // 2)[wrong]
    return (parameters[middle - 1] + parameters[middle]) / 2


def _thinned(data: WeightedPoints, fit: _Fit, tolerance: float | None) -> _Fit:
    """The fit without the knots that its points do not ask for."""
    was_good = not _misfitting_spans(data, fit, tolerance).any()
    share = 1.0
    while True:
        freedom = max(2 * len(data.points) - 2 * len(fit.curve.poles), 1)
        scale = max(1.0, float(fit.chi_square.sum()) / freedom)
        cost = fit.system.significance
        if data.closed and len(fit.breaks) - 1 <= max(fit.curve.degree + 1, 4):
            return fit
        order = np.argsort(cost)
        if tolerance is None:
            order = order[cost[order] < scale * _UNNOTICED]
        chosen = _not_adjacent(order[: max(1, int(share * len(order)))])
        if not len(chosen):
            return fit
        breaks = np.delete(fit.breaks, chosen + 1)
        trial = _solved(data, breaks, fit.curve.degree)
        if was_good:
            accepted = not _misfitting_spans(data, trial, tolerance).any()
        elif tolerance is not None:
            accepted = trial.deviation.max() <= fit.deviation.max()
        else:
            accepted = trial.information <= fit.information
        if accepted:
            fit = trial
        elif len(chosen) == 1:
            return fit
        else:
            share = len(chosen) / len(order) / 3


def _not_adjacent(order: NDArray[np.intp]) -> NDArray[np.intp]:
    """The best first, leaving out neighbours of those already taken."""
    taken: set[int] = set()
    for place in map(int, order):
        if place - 1 not in taken and place + 1 not in taken:
            taken.add(place)
    return np.array(sorted(taken), dtype=np.intp)
