# SPDX-License-Identifier: LGPL-2.1-or-later
"""Knots where curves need them: spans whose least-squares errors are about equal.

A spline of degree p misses a smooth curve by about the p + 1st power of a span's length, so that a
span's share of the knots grows with the p + 1st root of its error (de Boor, A Practical Guide to
Splines, 1978, chapter XII).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..geometry.knot_vectors import clamped_knots
from .spline_poles import basis_values, poles_through

__all__ = ["even_error_knots"]

Array = NDArray[np.float64]

_ROUNDS = 8
_LEAST = 1e-3  # of the largest error: no span counts as less, so that none grows without bound
_EXACT = 1e-7  # of the curves' size: errors below are rounding


def even_error_knots(at: Array, samples: Array, count: int, degree: int) -> Array:
    """Clamped knots over [0, 1] for splines with a number of poles through sampled curves.

    Parameters
    ----------
    at : (m,) increasing parameters from 0 to 1, many more than poles
    samples : (m, d) points of one or more curves side by side
    count, degree : of the splines
    """
    breaks = np.linspace(0.0, 1.0, count - degree + 1)
    exact = max(_EXACT * float(np.ptp(samples, axis=0).max()), 1e-12)
    best, least = breaks, np.inf
    for _ in range(_ROUNDS):
        knots = clamped_knots(breaks, degree)
        fitted = basis_values(knots, degree, at) @ poles_through(knots, degree, at, samples)
        miss = np.maximum(np.linalg.norm(samples - fitted, axis=1), exact)
        if miss.max() < least:
            best, least = breaks, float(miss.max())
        span = np.clip(np.searchsorted(breaks, at, side="right") - 1, 0, len(breaks) - 2)
        error = np.zeros(len(breaks) - 1)
        np.maximum.at(error, span, miss)
        need = np.maximum(error, _LEAST * miss.max()) ** (1.0 / (degree + 1))
        reached = np.append(0.0, np.cumsum(need))
        even = np.linspace(0.0, reached[-1], len(breaks))
        breaks = (breaks + np.interp(even, reached, breaks)) / 2
    return clamped_knots(best, degree)
