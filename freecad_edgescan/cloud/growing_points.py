# SPDX-License-Identifier: LGPL-2.1-or-later
"""An array of points that grows where it is, instead of being put together from pieces at the end.

Pieces and their sum would be in memory at the same time: twice the cloud.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["GrowingPoints"]

Array = NDArray[np.float64]

_GROWTH = 1.25


class GrowingPoints:
    """Points in the order in which they are appended."""

    def __init__(self) -> None:
        self._rows = np.empty((0, 3))
        self._count = 0

    def __len__(self) -> int:
        return self._count

    def append(self, points: Array) -> None:
        """Copy points (k, 3) behind those there are."""
        end = self._count + len(points)
        if end > len(self._rows):
            self._resize(max(end, int(_GROWTH * len(self._rows))))
        self._rows[self._count : end] = points
        self._count = end

    def taken(self) -> Array:
        """All points, (n, 3), read-only; none are left here."""
        self._resize(self._count)
        rows, self._rows, self._count = self._rows, np.empty((0, 3)), 0
        rows.setflags(write=False)
        return rows

    def _resize(self, count: int) -> None:
        # nobody else has ever seen the array, so that it may move
        self._rows.resize((count, 3), refcheck=False)
