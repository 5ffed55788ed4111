# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small piece of a surface: a plane, or a quadratic over it, and how well it is known."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

__all__ = ["LocalSurface", "fit_local_surface"]

_FEWEST = 15  # points of a surface
_MOST_OFF = 3.5  # standard deviations
_TRIMS = 3


@dataclass(frozen=True)
class LocalSurface:
    """height = c · (1, x, y, x²/2, xy, y²/2) over a plane, or the first three terms of it.

    Attributes
    ----------
    origin, axes : (3,) mm and (3, 3) unit vectors of x, y and the height
    coefficients, inverse : c, mm, and the inverse of its normal matrix
    variance : mm², of the points about the surface
    """

    origin: np.ndarray
    axes: np.ndarray
    coefficients: np.ndarray
    inverse: np.ndarray
    variance: float

    def height(self, point: np.ndarray) -> float:
        """Of a point above the surface, along the plane's normal."""
        x, y, n = self.axes @ (point - self.origin)
        return float(n - _terms(np.array([[x, y]]), len(self.coefficients))[0] @ self.coefficients)

    def normal(self, point: np.ndarray) -> np.ndarray:
        """Unit normal (3,) above or below a point."""
        x, y, _ = self.axes @ (point - self.origin)
        c = np.zeros(6)
        c[: len(self.coefficients)] = self.coefficients
        slope = np.array([c[1] + c[3] * x + c[4] * y, c[2] + c[4] * x + c[5] * y])
        normal = self.axes[2] - slope @ self.axes[:2]
        return np.asarray(normal / np.linalg.norm(normal))

    def uncertainty(self, point: np.ndarray) -> float:
        """Variance of the surface's height at a point, mm²."""
        terms = _terms((self.axes @ (point - self.origin))[None, :2], len(self.coefficients))[0]
        return float(self.variance * (terms @ self.inverse @ terms))


def _terms(xy: np.ndarray, count: int) -> np.ndarray:
    x, y = xy.T
    every = [np.ones_like(x), x, y, 0.5 * x**2, x * y, 0.5 * y**2]
    return np.stack(every[:count], axis=1)


def fit_local_surface(
    points: np.ndarray,
    normal: np.ndarray,
    origin: np.ndarray,
    radius: float,
    noise: float,
    pitch: float,
    most_scatter: float = np.inf,
) -> LocalSurface | None:
    """A plane, or a quadratic where that is clearly better, through what lies near a plane.

    Parameters
    ----------
    points : (n, 3) mm
    normal, origin : (3,) of a plane that lies near the surface
    radius : mm, round the origin, within which points are used
    noise, pitch : of the cloud, mm
    most_scatter : mm, by which points of one surface scatter at most; beyond its end the next one's
        may lie near it, and tilt it

    Returns
    -------
    the surface, or None where too few points lie on it
    """
    across = np.linalg.svd(normal[None])[2]
    axes = np.vstack([across[1:], normal])
    local = (points - origin) @ axes.T
    away = np.hypot(local[:, 0], local[:, 1])
    near = (away < radius) & (np.abs(local[:, 2]) < 4.0 * noise + 0.1 * pitch + 0.1 * away)
    best: tuple[float, LocalSurface] | None = None
    for count in (3, 6):
        used = near
        for _ in range(_TRIMS):
            if np.count_nonzero(used) < max(_FEWEST, 2 * count):
                break
            terms = _terms(local[:, :2], count)
            inverse = np.linalg.pinv(terms[used].T @ terms[used])
            c = inverse @ (terms[used].T @ local[used, 2])
            off = local[:, 2] - terms @ c
            freedom = np.count_nonzero(used) - count
            variance = float(np.square(off[used]).sum()) / freedom
            scatter = np.clip(np.sqrt(variance), 0.5 * noise, most_scatter)
            surface = LocalSurface(origin, axes, c, inverse, variance)
            # The better of two models by Schwarz' criterion, on points of the same kind.
            worth = freedom * np.log(max(variance, 1e-18)) + count * np.log(freedom)
            used = near & (np.abs(off) <= _MOST_OFF * scatter)
        else:
            if best is None or worth < best[0]:
                best = worth, surface
    return None if best is None else best[1]
