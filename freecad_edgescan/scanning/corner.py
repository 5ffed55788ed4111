# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edge point of a section: where the two fitted sides, moved by the probe radius, meet.

A fitted side is a circle in the section; its signed distance is exact in closed form
(D = 2F / (|∇F| + √(|∇F|² + 2 c2 F)) for F = n − c0 − c1 s − c2 (s² + n²)/2), so that a parallel
curve at the probe's distance needs no feet and no second fit. The side's drift along the edge
widens the distance in the section by 1/cos of its slope.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..geometry.frames import cross, unit
from .section import Frames
from .side_fit import SideFits

_ITERATIONS = 12


@dataclass(frozen=True)
class Corners:
    """Edge points of m sections.

    Attributes
    ----------
    point : (m, 3) array, mm
    tangent : (m, 3) unit vectors, along the walk
    normals : (m, 2, 3) unit vectors at the two sides, on the side of the frames' normals
    sides : (m, 2, 3) unit vectors along the two sides, away from the edge
    covariance : (m, 2, 2) mm², in the axes of `across_axes`
    shared : (m, 2, 2) mm², the part of it that neighbouring sections have in common
    scatter : (m, axis, side) mm, the rest by the side whose points' scatter it comes from: this
        times its transpose
    shift : (m, 2) mm, from the frame's origin, along the frame's across axes
    found : (m,) whether the sides meet near the origin
    """

    point: np.ndarray
    tangent: np.ndarray
    normals: np.ndarray
    sides: np.ndarray
    covariance: np.ndarray
    shared: np.ndarray
    scatter: np.ndarray
    shift: np.ndarray
    found: np.ndarray

    @property
    def half_angle(self) -> np.ndarray:
        """Half the angle between the sides, (m,) rad."""
        cosine = np.einsum("mi,mi->m", self.sides[:, 0], self.sides[:, 1])
        return 0.5 * np.arccos(np.clip(cosine, -1.0, 1.0))


def across_axes(normals: np.ndarray) -> np.ndarray:
    """Axes across the edge, (…, 2, 3): n1 + n2 and n1 − n2, normalised."""
    axes = np.stack(
        [normals[..., 0, :] + normals[..., 1, :], normals[..., 0, :] - normals[..., 1, :]], axis=-2
    )
    return axes / np.maximum(np.linalg.norm(axes, axis=-1, keepdims=True), 1e-300)


def turned_covariance(covariance: np.ndarray, before: np.ndarray, after: np.ndarray) -> np.ndarray:
    """Covariance from the axes of one pair of normals (m, 2, 3) to those of another."""
    turn = np.einsum("mai,mbi->mab", across_axes(after), across_axes(before))
    return np.einsum("mab,mbc,mdc->mad", turn, covariance, turn)


def largest_sigma(covariance: np.ndarray) -> np.ndarray:
    """Standard deviation in the worst direction, (m,) mm, of (m, k, k) mm²."""
    if covariance.shape[-1] != 2:
        return np.sqrt(np.maximum(np.linalg.eigvalsh(covariance)[:, -1], 0.0))
    a, b, d = covariance[:, 0, 0], covariance[:, 0, 1], covariance[:, 1, 1]
    return np.sqrt(np.maximum(0.5 * (a + d) + np.hypot(0.5 * (a - d), b), 0.0))


@dataclass(frozen=True)
class Meeting:
    """Where the two moved sides of m sections meet; lengths in reaches, in the axes across.

    Attributes
    ----------
    axes : (m, 2, 3) across the edge
    along_side, along_normal : (m, side, axis) the frames' sides and normals in these
    shift : (m, 2) from the frame's origin
    gradient : (m, 2, 2) unit normal of each side there
    slope : (m, 2) of each side along the edge
    found : (m,) whether they meet near the origin
    """

    axes: np.ndarray
    along_side: np.ndarray
    along_normal: np.ndarray
    shift: np.ndarray
    gradient: np.ndarray
    slope: np.ndarray
    found: np.ndarray

    @staticmethod
    def of(frames: Frames, coefficients: np.ndarray, offset: np.ndarray) -> Meeting:
        """Intersect sides (m, 2, 4) that are moved along the frames' normals by offsets (m,)."""
        axes = across_axes(frames.normals)
        along_side = np.einsum("mki,mai->mka", frames.sides, axes)
        along_normal = np.einsum("mki,mai->mka", frames.normals, axes)
        shift, distance = np.zeros((len(frames), 2)), offset[:, None]
        for _ in range(_ITERATIONS):
            value, gradient, slope = _section_distance(
                coefficients, along_side, along_normal, shift
            )
            target = distance * np.sqrt(1.0 + slope**2)
            missing = value - target
            step = np.einsum("mab,mb->ma", inverse_2x2(gradient), missing)
            step = np.maximum(np.minimum(step, 0.5), -0.5)
            shift = np.maximum(np.minimum(shift - step, 3.0), -3.0)
            if np.max(np.abs(step), initial=0.0) < 1e-10:
                break
        value, gradient, slope = _section_distance(coefficients, along_side, along_normal, shift)
        found = np.all(np.abs(value - distance * np.sqrt(1.0 + slope**2)) < 1e-6, axis=1)
        return Meeting(axes, along_side, along_normal, shift, gradient, slope, found)

    def terms(self, at: np.ndarray) -> np.ndarray:
        """Terms (m, 2, 4) of the two sides at places (m, 2, 2) across the edge."""
        s = np.einsum("mka,mka->mk", self.along_side, at)
        n = np.einsum("mka,mka->mk", self.along_normal, at)
        return np.stack([np.ones_like(s), s, 0.5 * (s**2 + n**2), np.zeros_like(s)], axis=-1)


def corners(frames: Frames, fits: SideFits, offset: np.ndarray | float = 0.0) -> Corners:
    """Intersect the two sides of each section.

    Parameters
    ----------
    frames, fits : the sections and the fitted sides
    offset : distance to move the sides along the frames' normals, mm; (m,) or one number
    """
    reach = fits.reach
    distance = np.broadcast_to(np.asarray(offset, dtype=float) / reach, (len(frames),))
    met = Meeting.of(frames, fits.coefficients, distance)
    point = frames.origin + np.einsum("ma,mai->mi", met.shift, met.axes) * reach
    flat = np.einsum("mka,mai->mki", met.gradient, met.axes)
    normals = unit(flat - met.slope[..., None] * frames.tangent[:, None])
    tangent = cross(normals[:, 0], normals[:, 1])
    tangent *= np.sign(np.einsum("mi,mi->m", tangent, frames.tangent))[:, None]
    size = np.linalg.norm(tangent, axis=-1, keepdims=True)
    tangent = np.where(size > 1e-6, tangent / np.maximum(size, 1e-300), frames.tangent)
    sides = cross(normals, tangent[:, None])
    sides *= np.where(np.einsum("mki,mki->mk", sides, frames.sides) < 0, -1.0, 1.0)[..., None]
    foot = met.shift[:, None] - met.gradient * distance[:, None, None]
    inverse = reach * inverse_2x2(met.gradient)
    of_sides, in_common = fits.position_covariance(met.terms(foot))
    covariance, shared = (
        inverse @ part @ np.swapaxes(inverse, 1, 2) for part in (of_sides, in_common)
    )
    scatter = inverse @ root_2x2(of_sides - in_common)
    shift = met.shift * reach
    return Corners(point, tangent, normals, sides, covariance, shared, scatter, shift, met.found)


def _section_distance(
    c: np.ndarray, along_side: np.ndarray, along_normal: np.ndarray, at: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Signed distance to both sides, its unit gradient, and the slope along the edge."""
    s = np.einsum("mka,ma->mk", along_side, at)
    n = np.einsum("mka,ma->mk", along_normal, at)
    value = n - c[..., 0] - c[..., 1] * s - 0.5 * c[..., 2] * (s**2 + n**2)
    by_s, by_n = -(c[..., 1] + c[..., 2] * s), 1.0 - c[..., 2] * n
    size = np.maximum(np.hypot(by_s, by_n), 1e-9)
    root = np.sqrt(np.maximum(size**2 + 2.0 * c[..., 2] * value, 1e-12))
    distance = 2.0 * value / (size + root)
    gradient = (by_s[..., None] * along_side + by_n[..., None] * along_normal) / size[..., None]
    return distance, gradient, c[..., 3] / root


def inverse_2x2(matrix: np.ndarray) -> np.ndarray:
    """Inverses of matrices (m, 2, 2), bounded where two sides are nearly parallel."""
    a, b, c, d = matrix[:, 0, 0], matrix[:, 0, 1], matrix[:, 1, 0], matrix[:, 1, 1]
    determinant = a * d - b * c
    inverse = np.empty_like(matrix)
    inverse[:, 0, 0], inverse[:, 0, 1], inverse[:, 1, 0], inverse[:, 1, 1] = d, -b, -c, a
    return inverse / np.where(np.abs(determinant) < 1e-6, 1e-6, determinant)[:, None, None]


def root_2x2(covariance: np.ndarray) -> np.ndarray:
    """Symmetric matrices (m, 2, 2) whose square is the covariance (Cayley and Hamilton).

    Symmetric ones are alike where covariances are; those of Cholesky or of eigenvectors need not.
    """
    determinant = np.prod(np.diagonal(covariance, axis1=1, axis2=2), axis=1)
    determinant = np.sqrt(np.maximum(determinant - covariance[:, 0, 1] ** 2, 0.0))
    size = np.sqrt(np.maximum(np.trace(covariance, axis1=1, axis2=2) + 2.0 * determinant, 1e-300))
    return (covariance + determinant[:, None, None] * np.eye(2)) / size[:, None, None]
