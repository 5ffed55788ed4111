# SPDX-License-Identifier: LGPL-2.1-or-later
"""An even sample of points, so that crowded places have no more say than others."""

from __future__ import annotations

import numpy as np


def one_per_cell(points: np.ndarray, cell: float) -> np.ndarray:
    """One point of each occupied cell of a grid, (k, 3); cell is the grid's spacing, mm."""
    if len(points) == 0:
        return points
    keys = np.floor((points - points.min(axis=0)) / cell).astype(np.int64)
    _, first = np.unique(keys @ np.array([1, 1_000, 1_000_000]), return_index=True)
    return points[first]
