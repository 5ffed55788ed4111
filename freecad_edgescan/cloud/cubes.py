# SPDX-License-Identifier: LGPL-2.1-or-later
"""One point of each cube of a grid: some points, roughly even, quickly."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["one_of_each_cube"]


def one_of_each_cube(points: NDArray[np.float64], side: float) -> NDArray[np.intp]:
    """Rows of the points (n, 3) nearest to the middles of the cubes that hold any, ascending."""
    place = (points - points.min(axis=0)) / side
    cell = np.floor(place)
    off = np.square(place - cell - 0.5).sum(axis=1)
    counts = cell.max(axis=0) + 1.0
    if counts.prod() > 2.0**62:  # hardly two points share a cube
        return np.arange(len(points))
    number = cell.astype(np.int64) @ np.array(
        [int(counts[1]) * int(counts[2]), int(counts[2]), 1], dtype=np.int64
    )
    order = np.lexsort((off, number))
    return np.sort(order[np.flatnonzero(np.diff(number[order], prepend=-1))])
