# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distance from points to a polyline: exact, and fast for many points.

1. The segments are cut into pieces no longer than their mean length; a KD-tree holds the pieces'
   middles.
2. The segments of the k nearest pieces are measured. A piece farther than the best distance plus
   half a piece cannot do better, which proves the answer; the points for which it is not proven
   are asked again with more pieces.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial import cKDTree

__all__ = ["distance_to_polyline"]

_CANDIDATES_AT_ONCE = 2_000_000


def distance_to_polyline(
    points: ArrayLike, polyline: ArrayLike, closed: bool = False
) -> tuple[NDArray[np.float64], NDArray[np.intp], NDArray[np.float64]]:
    """Distance of points to the nearest place of a polyline.

    Parameters
    ----------
    points : (n, d) array
        Points in mm.
    polyline : (m, d) array, m >= 1
        Vertices in order, mm; equal neighbours are allowed.
    closed : bool
        Whether a last segment leads from the last vertex to the first.

    Returns
    -------
    distance (n,) mm, index (n,) of the segment from vertex i to i + 1, and fraction (n,) in
    [0, 1] along that segment.

    Raises
    ------
    ValueError: no vertex, or different dimensions.
    """
    asked: NDArray[np.float64] = np.atleast_2d(np.asarray(points, dtype=float))
    vertices: NDArray[np.float64] = np.atleast_2d(np.asarray(polyline, dtype=float))
    if len(vertices) == 0 or vertices.shape[1] == 0:
        raise ValueError("The polyline has no vertex; give at least one.")
    if asked.size == 0:
        empty = np.zeros(0)
        return empty, np.zeros(0, dtype=np.intp), empty.copy()
    if asked.shape[1] != vertices.shape[1]:
        raise ValueError(
            f"The points have {asked.shape[1]} coordinates and the polyline "
            f"{vertices.shape[1]}; give both the same."
        )
    if closed or len(vertices) == 1:
        vertices = np.vstack([vertices, vertices[:1]])
    middles, owner, longest = _pieces(vertices)
    tree = cKDTree(middles)

    distance = np.empty(len(asked))
    index = np.empty(len(asked), dtype=np.intp)
    fraction = np.empty(len(asked))
    pending = np.arange(len(asked))
    count = min(4, len(middles))
    while len(pending):
        proven = np.empty(len(pending), dtype=bool)
        block = max(1, _CANDIDATES_AT_ONCE // count)
        for first in range(0, len(pending), block):
            part = slice(first, first + block)
            rows = pending[part]
            reach, nearest = tree.query(asked[rows], k=list(range(1, count + 1)))
            found = _nearest_segment(asked[rows], vertices, owner[nearest])
            distance[rows], index[rows], fraction[rows] = found
            proven[part] = reach[:, -1] - longest / 2 >= found[0]
        if count == len(middles):
            break
        pending = pending[~proven]
        count = min(4 * count, len(middles))
    return distance, index, fraction


def _pieces(
    vertices: NDArray[np.float64],
) -> tuple[NDArray[np.float64], NDArray[np.intp], float]:
    """Middles of the pieces, the segment each belongs to, and the longest piece's length."""
    step = np.diff(vertices, axis=0)
    length = np.linalg.norm(step, axis=1)
    mean = length.mean()
    pieces = np.ones(len(step), dtype=np.intp)
    if mean > 0.0:
        pieces = np.maximum(1, np.ceil(length / mean)).astype(np.intp)
    owner = np.repeat(np.arange(len(step)), pieces)
    rank = np.arange(len(owner)) - np.repeat(np.cumsum(pieces) - pieces, pieces)
    share = (rank + 0.5) / pieces[owner]
    return vertices[owner] + share[:, None] * step[owner], owner, float((length / pieces).max())


def _nearest_segment(
    points: NDArray[np.float64], vertices: NDArray[np.float64], candidates: NDArray[np.intp]
) -> tuple[NDArray[np.float64], NDArray[np.intp], NDArray[np.float64]]:
    """The nearest among the candidate segments (n, k) of each point."""
    start = vertices[candidates]
    step = vertices[candidates + 1] - start
    away = points[:, None, :] - start
    square = np.einsum("nkd,nkd->nk", step, step)
    along = np.einsum("nkd,nkd->nk", away, step)
    fraction = np.clip(along / np.where(square > 0.0, square, 1.0), 0.0, 1.0)
    distance = np.linalg.norm(away - fraction[..., None] * step, axis=2)
    best = np.argmin(distance, axis=1)
    rows = np.arange(len(points))
    return distance[rows, best], candidates[rows, best], fraction[rows, best]
