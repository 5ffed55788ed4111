# SPDX-License-Identifier: LGPL-2.1-or-later
"""The planes that most points near a place share, by the directions of their normals."""

from __future__ import annotations

import numpy as np

from ..cloud.point_cloud import PointCloud

__all__ = ["normals_of", "shared_planes"]

_NEIGHBOURS, _MOST_NEIGHBOURS = 16, 128
_NARROW = 0.25  # width of a neighbourhood by its length, below which it is a piece of a line
_SAME_DIRECTION = np.radians(14.0)  # at most; less where flatter edges are wanted


def shared_planes(
    points: np.ndarray, normals: np.ndarray, weight: np.ndarray, min_angle: float
) -> list[tuple[np.ndarray, np.ndarray]]:
    """Up to three planes, each the normal and the centre of points that share a direction."""
    alike = np.abs(normals @ normals.T)
    same = np.cos(min(_SAME_DIRECTION, 0.45 * min_angle))
    left = np.ones(len(points), dtype=bool)
    planes = []
    for _ in range(3):
        score = (alike > same) @ (weight * left)
        score[~left] = 0.0
        leader = int(np.argmax(score))
        members = left & (alike[leader] > same)
        if members.sum() < 5 or score[leader] < 0.03 * weight.sum():
            break
        scatter = np.einsum("n,ni,nj->ij", weight[members], normals[members], normals[members])
        normal = np.linalg.eigh(scatter)[1][:, -1]
        height = points[members] @ normal
        level = _weighted_median(height, weight[members])
        centre = np.average(points[members], axis=0, weights=weight[members])
        planes.append((normal, centre + (level - centre @ normal) * normal))
        left &= np.abs(normals @ normal) < np.cos(0.7 * min_angle)
        if left.sum() < 5:
            break
    return planes


def normals_of(cloud: PointCloud, points: np.ndarray) -> np.ndarray:
    """Normals of the least-squares planes through each point's neighbours, (n, 3), any sign.

    Of a scanner's lines, the nearest neighbours may all lie on one, and through a line there are
    planes of all directions. Neighbourhoods grow until they hold points of several.
    """
    normals = np.empty((len(points), 3))
    narrow, neighbours = np.arange(len(points)), _NEIGHBOURS
    while len(narrow):
        _, nearest = cloud.tree.query(points[narrow], k=min(neighbours, len(cloud)))
        spread = cloud.points[nearest]
        spread = spread - spread.mean(axis=1, keepdims=True)
        moments, axes = np.linalg.eigh(np.einsum("nki,nkj->nij", spread, spread))
        normals[narrow] = axes[:, :, 0]
        if neighbours >= min(_MOST_NEIGHBOURS, len(cloud)):
            break
        narrow = narrow[moments[:, 1] < _NARROW**2 * moments[:, 2]]
        neighbours *= 2
    return normals


def _weighted_median(values: np.ndarray, weights: np.ndarray) -> float:
    order = np.argsort(values)
    half = np.searchsorted(np.cumsum(weights[order]), 0.5 * weights.sum())
    return float(values[order[min(half, len(order) - 1)]])
