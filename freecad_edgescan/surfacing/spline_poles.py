# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poles of a clamped spline through samples, with its ends held, and its basis at parameters."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import BSpline

__all__ = ["basis_values", "poles_through"]

Array = NDArray[np.float64]


def basis_values(knots: Array, degree: int, at: Array, order: int = 0) -> Array:
    """Values or derivatives (m, n) of all basis functions."""
    count = len(knots) - degree - 1
    return np.asarray(BSpline(knots, np.eye(count), degree)(at, nu=order))


def poles_through(knots: Array, degree: int, at: Array, samples: Array) -> Array:
    """Least-squares poles (n, d) of samples (m, d) at increasing parameters; the ends are kept."""
    basis = basis_values(knots, degree, at)
    poles = np.zeros((basis.shape[1], samples.shape[1]))
    poles[0], poles[-1] = samples[0], samples[-1]
    rest = samples - basis @ poles
    poles[1:-1] = np.linalg.lstsq(basis[:, 1:-1], rest, rcond=None)[0]
    return poles
