# SPDX-License-Identifier: LGPL-2.1-or-later
"""The radius of the rounding between two sides, from the points the sides left over.

In the wedge of angle θ a circle of radius ρ that touches both sides has its centre on the
bisector, ρ / sin(θ/2) from the edge. The one unknown ρ is found by Gauss–Newton on the distances
of the points between the two touching points, pooled over neighbouring sections.
"""

from __future__ import annotations

import numpy as np
from scipy.ndimage import convolve1d, median_filter, uniform_filter1d

from .corner import Corners
from .section import Frames, SectionPoints

_POOLED = 2
_NEIGHBOURS = 5  # sections on each side whose radii are compared
_ITERATIONS = 8
_ROUND = 2.0  # variances, mean square of points about a rounding; those of a chamfer have more
_EVIDENCE = 30.0  # chi-square by which a rounding must explain its points better than an edge


def gap_under_rounding(begins: np.ndarray | float, half: np.ndarray | float) -> np.ndarray:
    """How far the edge is from the top of a rounding that touches both sides, mm.

    Parameters
    ----------
    begins : distance from the edge at which it touches them, mm
    half : half the angle between the sides, rad
    """
    return np.asarray(begins * (1.0 - np.sin(half)) / np.maximum(np.cos(half), 1e-3))


def rounding_radius(
    frames: Frames,
    points: SectionPoints,
    corner: Corners,
    curvature: np.ndarray,
    begins: np.ndarray,
    noise: np.ndarray,
    cloud_pitch: float,
    closed: bool,
    circular: bool,
) -> tuple[np.ndarray, np.ndarray]:
    """Radius of the rounding in the cloud and its sigma, (m,) mm; nan where there is none.

    Parameters
    ----------
    corner : edge points of the cloud itself, sides not moved by the probe radius
    curvature : (m, 2) of the sides, 1/mm
    begins : (m, 2) distances from the edge where the sides begin, mm: no rounding is wider
    noise : (m,) mm
    circular : whether only what is a circle counts; else also what is roughly one, as a chamfer
    """
    mode = "wrap" if closed else "constant"
    sections = len(frames)
    half = corner.half_angle
    inward = corner.sides.sum(axis=1)
    inward /= np.maximum(np.linalg.norm(inward, axis=1, keepdims=True), 1e-12)
    aside = np.cross(frames.tangent, inward)
    # A point that lies in several slabs is one measurement.
    repeated = len(points.index) / max(len(np.unique(points.index)), 1)
    sine, cosine = np.sin(half), np.cos(half)
    largest = (1.3 * begins.max(axis=1) + 2.0 * cloud_pitch) * sine / cosine
    deepest = largest * (1.0 / sine - 1.0) + cloud_pitch
    # Most points lie farther from the edge than any rounding reaches.
    foot = np.einsum("mki,mi->mk", frames.sides, corner.point - frames.origin)
    widest = (np.maximum(largest, cloud_pitch) / sine + cloud_pitch)[:, None] + foot
    points = points[points.away < widest[points.owner, points.side]]
    owner = points.owner
    # Sides are straightened first, and the rounding with them: 1/ρ becomes 1/ρ + curvature.
    bow = 0.5 * curvature[owner, points.side] * (points.away - foot[owner, points.side]) ** 2
    at = (
        points.away[:, None] * frames.sides[owner, points.side]
        + (points.height - bow)[:, None] * frames.normals[owner, points.side]
        - (corner.point - frames.origin)[owner]
    )
    depth = np.einsum("ni,ni->n", at, inward[owner])
    width = np.einsum("ni,ni->n", at, aside[owner])

    def pool(values: np.ndarray) -> np.ndarray:
        summed = np.bincount(owner, weights=values, minlength=sections)
        reach = min(_POOLED, (sections - 1) // 2)
        if reach < 1:
            return summed
        return convolve1d(summed, np.ones(2 * reach + 1), mode=mode, cval=0.0)

    # The gap between the edge and the rounding's top gives the first radius.
    top = (np.abs(width) < cloud_pitch) & (np.abs(depth) < deepest[owner])
    gap = pool(depth * top) / np.maximum(pool(1.0 * top), 1.0)
    radius = np.maximum(gap, 0.0) / np.maximum(1.0 / sine - 1.0, 1e-3)
    information = np.zeros(sections)
    for _ in range(_ITERATIONS):
        own = radius[owner]
        arm = depth - own / sine[owner]
        distance = np.maximum(np.hypot(arm, width), 1e-12)
        residual = distance - own
        slope = -arm / distance / sine[owner] - 1.0
        used = (np.abs(width) < own * cosine[owner]) & (arm < 0)
        used &= np.abs(residual) < 4.0 * noise[owner] + 0.25 * own
        information = pool(slope**2 * used)
        step = pool(slope * residual * used) / np.maximum(information, 1e-12)
        radius = radius - np.clip(step, -0.5 * radius, radius + cloud_pitch)
        radius = np.clip(radius, 0.0, largest)
    own = radius[owner]
    arm = depth - own / sine[owner]
    residual = np.hypot(arm, width) - own
    used = (np.abs(width) < own * cosine[owner]) & (arm < 0)
    used &= np.abs(residual) < 4.0 * noise[owner] + 0.25 * own
    sharp = np.abs(depth * sine[owner] - np.abs(width) * cosine[owner])
    gained = pool((sharp**2 - residual**2) / np.maximum(noise[owner], 1e-12) ** 2 * used)
    count = pool(1.0 * used)
    misfit = pool((residual / np.maximum(noise[owner], 1e-12)) ** 2 * used)
    with np.errstate(divide="ignore", invalid="ignore"):
        sigma = noise / np.sqrt(information / repeated)
    # An edge point that is off along the bisector looks like another radius; neighbours share
    # most of that error.
    apex = np.sqrt(np.maximum(corner.covariance[:, 0, 0], 0.0))
    sigma = np.hypot(sigma, apex / np.maximum(1.0 / sine - 1.0, 1e-3))
    straight = radius
    radius = straight / np.maximum(1.0 - straight * curvature.mean(axis=1), 0.2)
    sigma = sigma / np.maximum(1.0 - straight * curvature.mean(axis=1), 0.2) ** 2
    sigma = np.hypot(sigma, _scatter(radius, mode))
    measurable = (radius > 2.0 * sigma) & (gained > _EVIDENCE) & (count >= 5)
    if circular:
        along = min(4 * _NEIGHBOURS + 1, sections)
        squares, number = (
            uniform_filter1d(part, along, mode="wrap" if closed else "nearest")
            for part in (misfit, count)
        )
        measurable &= squares <= _ROUND * number
    return np.where(measurable, radius, np.nan), np.where(measurable, sigma, np.nan)


def _scatter(radius: np.ndarray, mode: str) -> np.ndarray:
    """How much the radii of neighbouring sections differ beyond a steady change, (m,) mm.

    The sections' own errors of side and angle, which the radius magnifies, show in it.
    """
    mode = "wrap" if mode == "wrap" else "nearest"
    steady = median_filter(radius, size=min(2 * _NEIGHBOURS + 1, len(radius)), mode=mode)
    square = uniform_filter1d((radius - steady) ** 2, 4 * _NEIGHBOURS + 1, mode=mode)
    return np.sqrt(np.maximum(square, 0.0))
