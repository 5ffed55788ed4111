# SPDX-License-Identifier: LGPL-2.1-or-later
"""The best of many sections that stand at the same place of the same edge."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from ...cloud.first_come import first_come
from ..section import Frames

__all__ = ["best_apart", "same_place"]

_SAME_WAY = np.cos(np.radians(35.0))


def best_apart(frames: Frames, doubt: np.ndarray, along: float, aside: float) -> np.ndarray:
    """Rows of the sections that are kept when each one in turn, the least doubtful first, is taken.

    Unless one at the same place was taken before.

    Parameters
    ----------
    doubt : (m,) how doubtful each section is
    along, aside : how far two sections of one place are apart at most, mm
    """
    count = len(frames)
    if count == 0:
        return np.zeros(0, dtype=np.intp)
    rank = np.empty(count, dtype=np.intp)
    rank[np.argsort(doubt, kind="stable")] = np.arange(count)
    return np.flatnonzero(first_come(rank, *same_place(frames, along, aside)))


def same_place(frames: Frames, along: float, aside: float) -> tuple[np.ndarray, np.ndarray]:
    """Pairs of sections that stand at the same place and look the same way."""
    tree = cKDTree(frames.origin, balanced_tree=False)
    pairs = tree.query_pairs(max(along, aside), output_type="ndarray")
    one, other = pairs[:, 0], pairs[:, 1]
    ways = np.einsum("ni,ni->n", frames.tangent[one], frames.tangent[other])
    tangent = frames.tangent[one] + np.where(ways < 0.0, -1.0, 1.0)[:, None] * frames.tangent[other]
    tangent /= np.maximum(np.linalg.norm(tangent, axis=1, keepdims=True), 1e-12)
    offset = frames.origin[other] - frames.origin[one]
    ahead = np.einsum("ni,ni->n", offset, tangent)
    off = np.linalg.norm(offset - ahead[:, None] * tangent, axis=1)
    same = (np.abs(ways) > _SAME_WAY) & (np.abs(ahead) <= along) & (off <= aside)
    return one[same], other[same]
