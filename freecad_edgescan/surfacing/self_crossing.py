# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a surface passes through itself, found in a net of triangles over it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

__all__ = ["self_crossing"]

Array = NDArray[np.float64]

_APART = 2  # cells between parts of the net that may cross; nearer ones only bend
_INSIDE = 1e-6  # of a side: parts that only touch do not cross


def self_crossing(grid: Array) -> tuple[int, int] | None:
    """Row and column of a cell of a grid of points (m, n, 3) that another cell passes through.

    None when the surface through the grid does not cross itself. Parts that touch, as at the seam
    of a closed surface, do not cross.
    """
    corners, cells = _triangles(grid)
    ends, beginnings = _sides(grid)
    centre, middle = corners.mean(axis=1), ends.mean(axis=1)
    reach = np.linalg.norm(corners - centre[:, None], axis=2).max()
    reach += np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).max() / 2
    near = cKDTree(middle).sparse_distance_matrix(cKDTree(centre), reach, output_type="ndarray")
    side, triangle = near["i"], near["j"]
    apart = np.abs(cells[triangle] - beginnings[side]).max(axis=1) > _APART
    side, triangle = side[apart], triangle[apart]
    crossed = np.flatnonzero(_pierces(ends[side], corners[triangle]))
    if not len(crossed):
        return None
    row, column = cells[triangle[crossed[0]]]
    return int(row), int(column)


def _triangles(grid: Array) -> tuple[Array, NDArray[np.intp]]:
    """Corners (k, 3, 3) of two triangles of each cell, and the cells' rows and columns (k, 2)."""
    a, b, c, d = grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]
    corners = np.concatenate(
        [np.stack(three, axis=2).reshape(-1, 3, 3) for three in ([a, b, c], [a, c, d])]
    )
    cells = np.moveaxis(np.indices(a.shape[:2]), 0, -1).reshape(-1, 2)
    return corners, np.concatenate([cells, cells])


def _sides(grid: Array) -> tuple[Array, NDArray[np.intp]]:
    """Ends (k, 2, 3) of all sides of the triangles, and the rows and columns they begin at."""
    ends, beginnings = [], []
    place = np.moveaxis(np.indices(grid.shape[:2]), 0, -1)
    for begin, end in (
        (np.s_[:-1, :], np.s_[1:, :]),
        (np.s_[:, :-1], np.s_[:, 1:]),
        (np.s_[:-1, :-1], np.s_[1:, 1:]),
    ):
        ends.append(np.stack([grid[begin], grid[end]], axis=2).reshape(-1, 2, 3))
        beginnings.append(place[begin].reshape(-1, 2))
    return np.concatenate(ends), np.concatenate(beginnings)


def _pierces(sides: Array, triangles: Array) -> NDArray[np.bool_]:
    """Which sides (k, 2, 3) pass through the inside of their triangles (k, 3, 3).

    Möller and Trumbore 1997, Fast, minimum storage ray-triangle intersection.
    """
    start, way = sides[:, 0], sides[:, 1] - sides[:, 0]
    first, second = triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    across = np.cross(way, second)
    volume = np.einsum("ki,ki->k", first, across)
    size = np.linalg.norm(way, axis=1) * np.linalg.norm(np.cross(first, second), axis=1)
    flat = np.abs(volume) <= 1e-9 * size
    inverse = 1.0 / np.where(flat, 1.0, volume)
    offset = start - triangles[:, 0]
    s = np.einsum("ki,ki->k", offset, across) * inverse
    turned = np.cross(offset, first)
    t = np.einsum("ki,ki->k", way, turned) * inverse
    along = np.einsum("ki,ki->k", second, turned) * inverse
    inside = (s > _INSIDE) & (t > _INSIDE) & (s + t < 1.0 - _INSIDE)
    return np.asarray(inside & (along > _INSIDE) & (along < 1.0 - _INSIDE) & ~flat)
