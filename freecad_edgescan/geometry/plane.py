# SPDX-License-Identifier: LGPL-2.1-or-later
"""Planes and their least-squares fit."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from freecad_edgescan.geometry.weighting import sigmas_of

__all__ = ["Plane", "fit_plane"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Plane:
    """A plane through `point` (3,), mm, square to the unit vector `normal` (3,)."""

    point: Array
    normal: Array

    def residuals(self, points: ArrayLike) -> Array:
        """Vectors (m, 3) from the plane to the points, mm."""
        away = np.asarray(points, dtype=float) - self.point
        return (away @ self.normal)[..., None] * self.normal


def fit_plane(points: ArrayLike, sigma: ArrayLike | None = None) -> Plane:
    """Weighted total least-squares plane through points.

    Parameters
    ----------
    points : (m, 3) array
        mm, at least three.
    sigma : (m,) array or number, optional
        Standard deviation of each point across the plane, mm; 1 when not given.

    Raises
    ------
    ValueError: fewer than three points.
    """
    x = np.asarray(points, dtype=float)
    if x.ndim != 2 or x.shape[1] != 3 or len(x) < 3:
        raise ValueError(f"A plane needs three or more points (m, 3), not an array {x.shape}.")
    weight = 1.0 / sigmas_of(x, sigma) ** 2
    point = np.average(x, axis=0, weights=weight)
    normal = np.linalg.svd(np.sqrt(weight)[:, None] * (x - point), full_matrices=True)[2][2]
    return Plane(point, normal)
