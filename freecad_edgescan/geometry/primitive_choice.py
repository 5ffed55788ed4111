# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a line, a circle or a plane explains points of a curve as well as their sigma allows.

A primitive is taken when nothing speaks against it: chi-square is within chance, and so are the
mean residuals of stretches along it, which see a systematic misfit long before chi-square does.
Residuals of neighbouring edge points are alike, because neighbours share points of the cloud. How
much is read from the differences between neighbours, which a systematic misfit leaves alone.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import chdtri, ndtri

from freecad_edgescan.geometry.circle import Circle, fit_circle
from freecad_edgescan.geometry.line import Line, fit_line
from freecad_edgescan.geometry.plane import Plane, fit_plane
from freecad_edgescan.geometry.weighting import sigmas_of

__all__ = ["common_plane", "simplest_curve"]

Array = NDArray[np.float64]

_CHANCE = 0.002
"""Probability at which each of the two tests refuses a primitive that is true."""
_LARGEST_RMS = 1.25
_LARGEST_UNDERSTATEMENT = 1.5
"""Sigma may be this much too small, as long as the residuals have no system."""
_SHORTEST_ARC = 0.03
"""rad; below it a radius is not a statement about the part."""
_STRETCHES = (2, 4, 8)
_FEWEST_FOR_A_CIRCLE = 6


def simplest_curve(
    points: ArrayLike, sigma: ArrayLike, closed: bool = False
) -> Line | Circle | None:
    """The line, or else the circle, that explains the points; None where neither does.

    Parameters
    ----------
    points : (m, 3) array
        In order along the curve, mm.
    sigma : (m,) array or number
        Standard deviation of each point in each direction across the curve, mm.
    closed : bool
        Whether the curve is closed, which a line is not.

    Returns
    -------
    Line from the first towards the last point, Circle with angle zero at the first point and
    growing along the points, or None. An arc that a line explains as well is a line.
    """
    x = np.asarray(points, dtype=float)
    deviation = sigmas_of(x, sigma)
    x, deviation = x[np.isfinite(deviation)], deviation[np.isfinite(deviation)]
    if not closed and len(x) > 1 and np.any(x != x[0]):
        line = fit_line(x, deviation)
        if _explains(line.residuals, deviation, line.freedom, closed):
            return line.line
    if len(x) < _FEWEST_FOR_A_CIRCLE:
        return None
    try:
        fit = fit_circle(x, deviation)
    except ValueError:
        return None
    swept = np.ptp(fit.circle.angles(x))
    if _SHORTEST_ARC < swept < 2.05 * np.pi and _explains(
        fit.residuals, deviation, fit.freedom, closed
    ):
        return fit.circle
    return None


def common_plane(points: ArrayLike, covariance: ArrayLike, closed: bool = False) -> Plane | None:
    """The plane in which all points of a curve lie, or None.

    Parameters
    ----------
    points : (m, 3) array
        In order along the curve, mm.
    covariance : (m, 3, 3) array
        Of each point, mm².
    closed : bool
        Whether the curve is closed.
    """
    x, spread = np.asarray(points, dtype=float), np.asarray(covariance, dtype=float)
    if len(x) < 3:
        return None
    plane = fit_plane(x)
    for _ in range(2):
        across = np.einsum("i,mij,j->m", plane.normal, spread, plane.normal)
        if not np.all(np.isfinite(across)):
            return None
        deviation = sigmas_of(x, np.sqrt(np.maximum(across, 0.0)))
        plane = fit_plane(x, deviation)
    # The tests are made for residuals in two directions across a curve; here there is one.
    both = np.sqrt(2.0) * plane.residuals(x)
    return plane if _explains(both, deviation, 2 * (len(x) - 3), closed) else None


def _explains(residuals: Array, deviation: Array, freedom: int, closed: bool) -> bool:
    """Whether residual vectors (m, 3) across a curve are what their deviations make by chance."""
    if freedom <= 0:
        return True
    scaled = residuals / deviation[:, None]
    roughness = _roughness(residuals, deviation, closed)
    likeness = max(0.0, 1.0 - roughness)
    alike = (1.0 + likeness) / max(1.0 - likeness, 1.0 / len(scaled))
    scale = min(max(1.0, roughness), _LARGEST_UNDERSTATEMENT**2)
    independent = max(freedom / alike, 1.0)
    by_chance = chdtri(independent, _CHANCE) / independent
    mean = float(np.sum(scaled**2)) / freedom / scale
    if mean > max(_LARGEST_RMS**2, by_chance):
        return False
    return _without_system(residuals, deviation, scale * alike)


def _roughness(residuals: Array, deviation: Array, closed: bool) -> float:
    """Variance of the differences between neighbours, relative to that of independent points."""
    after = np.roll(np.arange(len(residuals)), -1)[: None if closed else -1]
    before = np.arange(len(after))
    variance = deviation[before] ** 2 + deviation[after] ** 2
    square = np.sum((residuals[after] - residuals[before]) ** 2, axis=1) / (2.0 * variance)
    return float(square.mean())


def _without_system(residuals: Array, deviation: Array, inflation: float) -> bool:
    """Whether the mean residual of every stretch along the curve is zero within chance."""
    weight = 1.0 / deviation**2
    counts = [count for count in _STRETCHES if len(residuals) >= 4 * count]
    limit = -float(ndtri(_CHANCE / 2.0 / max(1, 2 * sum(counts))))
    for count in counts:
        first = np.linspace(0, len(residuals), count + 1).astype(np.intp)[:-1]
        total = np.add.reduceat(weight, first)
        pull = np.add.reduceat(weight[:, None] * residuals, first, axis=0)
        together = np.minimum(inflation, np.diff(np.append(first, len(residuals))))
        size = np.linalg.norm(pull, axis=1) / np.sqrt(total * together)
        if size.max() > np.hypot(limit, 1.0):
            return False
    return True
