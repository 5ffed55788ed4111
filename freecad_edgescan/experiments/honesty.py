# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far edge points are off, in the standard deviations that the scan states for them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..scanning import ScannedEdge
from ..scanning.corner import across_axes

__all__ = ["TRUE_95", "TRUE_MEDIAN", "mahalanobis", "median_and_95", "true_share"]

Array = NDArray[np.float64]

# Of Mahalanobis distances in the two directions across an edge, where covariances are true.
TRUE_MEDIAN = float(np.sqrt(2.0 * np.log(2.0)))  # 1.18
TRUE_95 = float(np.sqrt(2.0 * np.log(20.0)))  # 2.45


def mahalanobis(edge: ScannedEdge, residuals: Callable[[Array], Array]) -> Array:
    """Mahalanobis distance (m,) of each edge point from where the true edge is.

    Parameters
    ----------
    edge : ScannedEdge; ``edge.unsmoothed`` for the sections by themselves
    residuals : answers the vectors (m, 3) from the true edge to points (m, 3), mm
    """
    seen = np.einsum("mai,mi->ma", across_axes(edge.normals), residuals(edge.points))
    square = np.einsum("ma,mab,mb->m", seen, np.linalg.pinv(edge.covariance), seen)
    return np.asarray(np.sqrt(np.maximum(square, 0.0)), dtype=np.float64)


def median_and_95(distances: ArrayLike) -> tuple[float, float]:
    """What half and 95 % of some distances are below; nan of none."""
    known = np.asarray(distances, dtype=np.float64)
    middle, most = np.percentile(known if known.size else [np.nan], [50, 95])
    return float(middle), float(most)


def true_share(distance: ArrayLike) -> Array:
    """Share of edge points nearer than a Mahalanobis distance where covariances are true.

    1 − exp(−d²/2), the chi distribution with two degrees of freedom (Rayleigh's).
    """
    return np.asarray(-np.expm1(-0.5 * np.square(distance)), dtype=np.float64)
