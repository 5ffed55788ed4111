# SPDX-License-Identifier: LGPL-2.1-or-later
"""A virtual measuring machine that touches the points of a cloud (Schreve 3.3)."""

from __future__ import annotations

import numpy as np

from ..cloud.point_cloud import PointCloud

__all__ = ["PointCloudCmm"]


class PointCloudCmm:
    """Touches a cloud: the closest point (stand-in until the other kinds are here)."""

    def __init__(
        self, cloud: PointCloud, kind: str = "closest", pitch: float | None = None
    ) -> None:
        self.cloud, self.kind = cloud, kind
        self.pitch = cloud.pitch if pitch is None else float(pitch)
        self.probe_radius = cloud.probe_radius
        approach = (0.0, 0.0, -1.0) if cloud.approach is None else cloud.approach
        self.approach = np.asarray(approach, dtype=float)

    def move(self, start: np.ndarray, end: np.ndarray) -> np.ndarray | None:
        way = end - start
        length = float(np.sqrt(way @ way))
        if length < 1e-9:
            return None
        return self._first(start, way / length, 0.0, length)

    def touch(self, start, direction, prehit_distance, search_distance):
        low, high = 0.0, 2.0 * prehit_distance
        end = prehit_distance + search_distance
        while low < end:
            high = min(high, end)
            found = self._first(start, direction, low, high)
            if found is not None:
                return found
            low, high = high, high + max(8.0 * self.pitch, 2.0 * prehit_distance)
        return None

    def _first(self, start, direction, low, high):
        middle = start + direction * (0.5 * (low + high))
        index = self.cloud.tree.query_ball_point(
            middle, float(np.hypot(0.5 * (high - low), self.pitch)), return_sorted=False
        )
        if not index:
            return None
        points = self.cloud.points[index]
        offset = points - start
        along = offset @ direction
        aside = np.einsum("ni,ni->n", offset, offset) - along * along
        ok = np.flatnonzero((along > 0.0) & (along <= high) & (aside <= self.pitch**2))
        return points[ok[along[ok].argmin()]] if len(ok) else None
