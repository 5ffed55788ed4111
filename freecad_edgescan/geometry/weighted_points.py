# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points along a curve with what is known of their errors, and first parameters for them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.linalg import solveh_banded

from freecad_edgescan.geometry.frames import orthonormalise
from freecad_edgescan.geometry.weighting import sigmas_of

__all__ = ["WeightedPoints"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class WeightedPoints:
    """Points with their parameters and what is known of their errors."""

    points: Array
    parameters: Array
    period: float
    covariance: Array
    tangents: Array
    tangents_are_known: bool
    closed: bool

    @classmethod
    def prepare(
        cls,
        points: ArrayLike,
        sigma: ArrayLike,
        covariance: ArrayLike | None,
        tangents: ArrayLike | None,
        closed: bool,
    ) -> WeightedPoints:
        """Checked points with first parameters; the arguments are those of `fit_curve`."""
        x = np.asarray(points, dtype=float)
        if x.ndim != 2 or x.shape[1] != 3 or not np.isfinite(x).all():
            raise ValueError(f"Points are a finite (m, 3) array, not one of shape {x.shape}.")
        deviation = sigmas_of(x, sigma)
        finite = np.isfinite(deviation)
        if not finite.any():
            raise ValueError("No point has a finite sigma; give at least some of them.")
        deviation[~finite] = 1e6 * deviation[finite].max()
        spread = deviation[:, None, None] ** 2 * np.eye(3)
        if covariance is not None:
            given = np.asarray(covariance, dtype=float)
            if given.shape != spread.shape:
                raise ValueError(
                    f"{len(x)} points need covariances ({len(x)}, 3, 3), not {given.shape}."
                )
            usable = np.isfinite(given).all(axis=(1, 2)) & finite
            floor = 1e-3 * float(np.median(deviation))
            spread[usable] = given[usable] + floor**2 * np.eye(3)
        keep = np.full(len(x), True)
        if closed and len(x) > 1 and np.array_equal(x[0], x[-1]):
            keep[-1] = False
        x, spread = x[keep], spread[keep]
        different, least = len(np.unique(x, axis=0)), 3 if closed else 2
        if different < least:
            raise ValueError(
                f"{different} different points are not enough for "
                f"{'a closed' if closed else 'an open'} curve; give at least {least}."
            )
        calm = _calmed(x, deviation[keep], closed)
        chords = np.linalg.norm(np.roll(calm, -1, axis=0) - calm, axis=1)
        parameters = np.append(0.0, np.cumsum(chords[:-1]))
        if tangents is not None:
            along = _unit(np.asarray(tangents, dtype=float)[keep])
        else:
            ahead = calm[np.r_[1 : len(x), 0 if closed else -1]]
            behind = calm[np.r_[-1 if closed else 0, 0 : len(x) - 1]]
            along = _unit(ahead - behind)
        period = float(parameters[-1] + chords[-1]) if closed else float(parameters[-1])
        return cls(x, parameters, period, spread, along, tangents is not None, closed)

    def across(self) -> tuple[Array, Array]:
        """Inverse covariance across the curve (m, 3, 3), and its mean size (m,)."""
        first = orthonormalise(self.tangents, np.zeros(3))
        axes = np.stack([first, np.cross(self.tangents, first)], axis=1)
        inverse = np.linalg.inv(axes @ self.covariance @ np.swapaxes(axes, 1, 2))
        size = np.trace(inverse, axis1=1, axis2=2) / 2
        return np.swapaxes(axes, 1, 2) @ inverse @ axes, size


def _calmed(points: Array, deviation: Array, closed: bool) -> Array:
    """Points without the zigzag of those whose sigma is larger than the step between points.

    The least |p - q|²/sigma² + |second difference of q|²/(half a step)².
    """
    m = len(points)
    if m < 5:
        return points
    weight = 1.0 / deviation**2
    blocks = np.linspace(0, m, min(m, 21)).astype(np.intp)[:-1]
    means = (
        np.add.reduceat(points * weight[:, None], blocks) / np.add.reduceat(weight, blocks)[:, None]
    )
    step = np.linalg.norm(np.diff(means, axis=0), axis=1).sum() / m
    padded = (m - 1) // 2 if closed else 0
    around = np.arange(-padded, m + padded) % m
    stiff = 4.0 / max(float(step), 1e-6 * float(deviation.min())) ** 2
    second = np.zeros((3, len(around)))
    for offset, first in zip((0, 1, 2), (1.0, -2.0, 1.0), strict=True):
        for other, value in zip((0, 1, 2), (1.0, -2.0, 1.0), strict=True):
            if other >= offset:
                second[other - offset, offset : offset + len(around) - 2] += first * value
    band = stiff * second
    band[0] += weight[around]
    right = weight[around, None] * points[around]
    calm: Array = solveh_banded(band, right, lower=True)
    return calm[padded : padded + m]


def _unit(vectors: Array) -> Array:
    """Vectors scaled to length one; where there is none, the x axis."""
    length = np.linalg.norm(vectors, axis=1, keepdims=True)
    return np.where(length > 0.0, vectors / np.where(length > 0.0, length, 1.0), np.eye(3)[0])
