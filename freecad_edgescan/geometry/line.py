# SPDX-License-Identifier: LGPL-2.1-or-later
"""Straight lines in space and their least-squares fit."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from freecad_edgescan.geometry.weighting import sigmas_of

__all__ = ["Line", "LineFit", "fit_line"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Line:
    """A straight line through `point` (3,), mm, along the unit vector `direction` (3,)."""

    point: Array
    direction: Array

    def evaluate(self, t: ArrayLike) -> Array:
        """Points at the distances t from `point` along the line, shape of t plus (3,), mm."""
        return self.point + np.asarray(t, dtype=float)[..., None] * self.direction

    def closest(self, points: ArrayLike) -> tuple[Array, Array]:
        """Places along the line (m,) and distances (m,) of points (m, 3), mm."""
        along = (np.asarray(points, dtype=float) - self.point) @ self.direction
        return along, np.linalg.norm(self.residuals(points), axis=-1)

    def residuals(self, points: ArrayLike) -> Array:
        """Vectors (m, 3) from the line to the points, mm."""
        away = np.asarray(points, dtype=float) - self.point
        return away - (away @ self.direction)[..., None] * self.direction


@dataclass(frozen=True, eq=False)
class LineFit:
    """A fitted line with residual vectors (m, 3), mm, chi-square and degrees of freedom."""

    line: Line
    residuals: Array
    chi_square: float
    freedom: int


def fit_line(points: ArrayLike, sigma: ArrayLike | None = None) -> LineFit:
    """Weighted total least-squares line through points.

    Parameters
    ----------
    points : (m, 3) array
        Points in mm, at least two of them different.
    sigma : (m,) array or number, optional
        Standard deviation of each point in each direction, mm; 1 when not given.

    Returns
    -------
    LineFit whose line runs from the first towards the last point; its `point` is the weighted
    centroid.

    Raises
    ------
    ValueError: fewer than two different points.
    """
    x = np.asarray(points, dtype=float)
    if x.ndim != 2 or x.shape[1] != 3 or len(x) < 2:
        raise ValueError(f"A line needs two or more points (m, 3), not an array {x.shape}.")
    if np.all(x == x[0]):
        raise ValueError("All points are equal; a line needs two different ones.")
    deviation = sigmas_of(x, sigma)
    weight = 1.0 / deviation**2
    centre = weight @ x / weight.sum()
    direction = np.linalg.svd((x - centre) / deviation[:, None], full_matrices=False)[2][0]
    if direction @ (x[-1] - x[0]) < 0.0:
        direction = -direction
    line = Line(centre, direction)
    residuals = line.residuals(x)
    chi_square = float(weight @ np.sum(residuals**2, axis=1))
    return LineFit(line, residuals, chi_square, 2 * len(x) - 4)
