# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which of several polylines a person means who points at one: numbers only, no window."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .picking import Array, ViewRay

__all__ = ["LinePicker"]


class LinePicker:
    """Finds the polyline under the cursor.

    Parameters
    ----------
    lines : (k, 3) mm each
    """

    def __init__(self, lines: Sequence[Array] = ()) -> None:
        lines = [np.asarray(line, dtype=np.float64).reshape(-1, 3) for line in lines]
        counts = [max(len(line) - 1, 0) for line in lines]
        self._owner = np.repeat(np.arange(len(lines)), counts)
        none = np.zeros((0, 3))
        self._starts = np.vstack([none, *(line[:-1] for line in lines)])
        self._ways = np.vstack([none, *(np.diff(line, axis=0) for line in lines)])

    def under(self, ray: ViewRay) -> int | None:
        """Number of the polyline that passes nearest to the line of sight, within its pick radius.

        Of two that are as near the one in front is meant.
        """
        if not len(self._owner):
            return None
        away = self._starts - ray.origin
        flat = away - (away @ ray.direction)[:, None] * ray.direction
        along = self._ways - (self._ways @ ray.direction)[:, None] * ray.direction
        squared = np.einsum("ni,ni->n", along, along)
        share = -np.einsum("ni,ni->n", flat, along) / np.maximum(squared, 1e-24)
        share = np.clip(share, 0.0, 1.0)[:, None]
        distance = np.linalg.norm(flat + share * along, axis=1)
        depth = (away + share * self._ways) @ ray.direction
        off = distance / np.maximum(ray.radius + ray.slope * depth, 1e-12)
        seen = (off <= 1.0) & (depth >= 0.0)
        if not seen.any():
            return None
        span = max(float(np.ptp(depth[seen])), 1e-12)
        score = np.where(seen, off + 0.3 * (depth - depth[seen].min()) / span, np.inf)
        return int(self._owner[score.argmin()])
