# SPDX-License-Identifier: LGPL-2.1-or-later
"""Circles in space and their geometric least-squares fit.

1. A weighted plane and, in it, the algebraic circle of Pratt give the start; Pratt's form stays
   good on short arcs.
2. Gauss-Newton on the true distances in six numbers that stay well-conditioned however large the
   radius is: offset, curvature and turn of the circle at the arc's middle, the plane's offset and
   its two tilts.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.linalg import eig
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from freecad_edgescan.geometry.frames import orthonormalise
from freecad_edgescan.geometry.weighting import sigmas_of

__all__ = ["Circle", "CircleFit", "fit_circle"]

Array = NDArray[np.float64]

_FLATTEST = 1e-5
"""Least curvature times extent that still counts as a circle."""


@dataclass(frozen=True, eq=False)
class Circle:
    """A circle: centre (3,) and radius in mm, unit axis (3,), and where its angle is zero.

    Angles run from the unit vector `reference` (3,) by the right-hand rule about the axis.
    """

    centre: Array
    axis: Array
    radius: float
    reference: Array

    def evaluate(self, angle: ArrayLike) -> Array:
        """Points at angles in rad, shape of `angle` plus (3,), mm."""
        angle = np.asarray(angle, dtype=float)[..., None]
        side = np.cross(self.axis, self.reference)
        return self.centre + self.radius * (np.cos(angle) * self.reference + np.sin(angle) * side)

    def angles(self, points: ArrayLike) -> Array:
        """Angles (m,) of points (m, 3) in order, without jumps between neighbours, rad."""
        away = np.asarray(points, dtype=float) - self.centre
        side = np.cross(self.axis, self.reference)
        return np.unwrap(np.arctan2(away @ side, away @ self.reference))

    def residuals(self, points: ArrayLike) -> Array:
        """Vectors (m, 3) from the circle to the points, mm."""
        away = np.asarray(points, dtype=float) - self.centre
        axial = (away @ self.axis)[..., None] * self.axis
        radial = away - axial
        length = np.linalg.norm(radial, axis=-1, keepdims=True)
        outward = np.where(length > 0.0, radial / np.where(length > 0, length, 1), self.reference)
        return away - self.radius * outward


@dataclass(frozen=True, eq=False)
class CircleFit:
    """A fitted circle with residual vectors (m, 3), mm, chi-square and degrees of freedom."""

    circle: Circle
    residuals: Array
    chi_square: float
    freedom: int


def fit_circle(points: ArrayLike, sigma: ArrayLike | None = None) -> CircleFit:
    """Weighted geometric least-squares circle through points in space.

    Parameters
    ----------
    points : (m, 3) array
        Points in mm, in order along the arc, m >= 3.
    sigma : (m,) array or number, optional
        Standard deviation of each point in each direction, mm; 1 when not given.

    Returns
    -------
    CircleFit whose circle starts (angle 0) at the first point and turns towards the next ones.

    Raises
    ------
    ValueError: fewer than three points, or points on a line.
    """
    x = np.asarray(points, dtype=float)
    if x.ndim != 2 or x.shape[1] != 3 or len(x) < 3:
        raise ValueError(f"A circle needs three or more points (m, 3), not an array {x.shape}.")
    deviation = sigmas_of(x, sigma)
    extent = float(np.linalg.norm(np.ptp(x, axis=0)))
    apex, frame, curvature = _algebraic_start(x, deviation, extent)
    scale = np.array([extent, 1.0 / extent, 1.0, extent, 1.0, 1.0])

    def moved(change: Array) -> tuple[Array, Array, float]:
        offset, bend, turn, lift, tilt1, tilt2 = change * scale
        turned = frame @ Rotation.from_rotvec([tilt1, tilt2, turn]).as_matrix().T
        return apex + frame.T @ [offset, 0.0, lift], turned, curvature + bend

    def misfit(change: Array) -> Array:
        origin, axes, bend = moved(change)
        inward, along, axial = ((x - origin) @ axes.T).T
        power = bend * (inward**2 + along**2) - 2.0 * inward
        radial = power / (1.0 + np.sqrt(np.maximum(1.0 + bend * power, 0.0)))
        return np.concatenate([radial / deviation, axial / deviation])

    solution = least_squares(misfit, np.zeros(6), method="lm", max_nfev=700)
    origin, axes, bend = moved(solution.x)
    if bend < 0.0:
        axes, bend = axes * [[-1.0], [-1.0], [1.0]], -bend
    if bend * extent < _FLATTEST:
        raise _on_a_line(len(x))
    circle = _started_at(x, origin + axes[0] / bend, axes[2], 1.0 / bend)
    residuals = circle.residuals(x)
    chi_square = float(np.sum(residuals**2 / deviation[:, None] ** 2))
    return CircleFit(circle, residuals, chi_square, 2 * len(x) - 6)


def _on_a_line(count: int) -> ValueError:
    return ValueError(
        f"The {count} points lie on a straight line (or are equal), so no circle is determined; "
        "fit a line, or give points of a longer arc."
    )


def _algebraic_start(x: Array, deviation: Array, extent: float) -> tuple[Array, Array, float]:
    """Point on the circle amid the points, frame (inward, along, axis) there, curvature."""
    weight = 1.0 / deviation**2
    weight /= weight.sum()
    centroid = weight @ x
    axes = np.linalg.svd((x - centroid) * np.sqrt(weight)[:, None], full_matrices=False)
    if extent == 0.0 or axes[1][1] < 1e-9 * axes[1][0]:
        raise _on_a_line(len(x))
    plane = axes[2] if np.linalg.det(axes[2]) > 0 else -axes[2]
    u, v = ((x - centroid) @ plane[:2].T).T / extent
    # Pratt 1987: least |A (u²+v²) + B u + C v + D|² under B² + C² - 4 A D = 1
    design = np.column_stack([u * u + v * v, u, v, np.ones_like(u)])
    moments = design.T @ (weight[:, None] * design)
    constraint = np.array([[0, 0, 0, -2], [0, 1, 0, 0], [0, 0, 1, 0], [-2, 0, 0, 0]], float)
    values, vectors = eig(np.linalg.solve(constraint, moments))
    norms = np.einsum("ik,ij,jk->k", vectors.real, constraint, vectors.real)
    usable = np.where((norms > 1e-300) & (values.real > -1e-12), values.real, np.inf)
    a, b, c, _ = vectors.real[:, int(np.argmin(usable))]
    if abs(a) <= 1e-12 * np.hypot(b, c):
        raise _on_a_line(len(x))
    middle = np.array([-b, -c]) / (2.0 * a)
    radius = float(np.sqrt(norms[int(np.argmin(usable))]) / (2.0 * abs(a)))
    away = np.linalg.norm(middle)
    inward = middle / away if away > 1e-6 * radius else np.array([1.0, 0.0])
    apex = centroid + extent * (middle - radius * inward) @ plane[:2]
    e1 = inward @ plane[:2]
    return apex, np.stack([e1, np.cross(plane[2], e1), plane[2]]), 1.0 / (radius * extent)


def _started_at(x: Array, centre: Array, axis: Array, radius: float) -> Circle:
    """The circle with angle zero at the first point and the axis so that the angle increases."""
    away = x - centre
    if np.sum(np.cross(away[:-1], away[1:]) @ axis) < 0.0:
        axis = -axis
    return Circle(centre, axis, radius, orthonormalise(axis, away[0]))
