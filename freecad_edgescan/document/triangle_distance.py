# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distance from a point to a triangle, for many pairs at once."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["triangle_distance"]

Array = NDArray[np.float64]


def triangle_distance(points: Array, triangles: Array) -> Array:
    """Exact distance of each point to its triangle.

    Parameters
    ----------
    points : (n, 3) array, mm
    triangles : (n, 3, 3) array of corners, mm

    Returns
    -------
    (n,) distances, mm: to the plane where the foot lies inside, else to the nearest side.
    """
    a, b, c = triangles[:, 0], triangles[:, 1], triangles[:, 2]
    normal = np.cross(b - a, c - a)
    size = np.linalg.norm(normal, axis=1)
    normal = normal / np.where(size > 0.0, size, 1.0)[:, None]
    inside = size > 0.0
    sides = np.full(len(points), np.inf)
    for start, end in ((a, b), (b, c), (c, a)):
        along, away = end - start, points - start
        inside &= np.einsum("ij,ij->i", np.cross(along, away), normal) >= 0.0
        square = np.einsum("ij,ij->i", along, along)
        share = np.einsum("ij,ij->i", away, along) / np.where(square > 0.0, square, 1.0)
        foot = away - np.clip(share, 0.0, 1.0)[:, None] * along
        sides = np.minimum(sides, np.linalg.norm(foot, axis=1))
    height = np.abs(np.einsum("ij,ij->i", points - a, normal))
    return np.where(inside, height, sides)
