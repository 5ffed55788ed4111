# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which strips of a cloud belong to an edge already, so that no edge is found twice."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from ..section import Frames

__all__ = ["NOBODY", "Strips"]

NOBODY = -1
_ASIDE = 1.3  # pitches beside an edge
_ALONG = 6.0  # pitches between two places of a strip, at most
_SAME_WAY = np.cos(np.radians(35.0))
_LOOKED_AT = 4  # places round one that is asked about


class Strips:
    """Places on edges, each with its owner; an owner's places can be taken, and given up.

    Parameters
    ----------
    pitch : of the cloud, mm
    """

    def __init__(self, pitch: float) -> None:
        self._pitch = pitch
        self._places: dict[int, tuple[np.ndarray, np.ndarray]] = {}
        self._tree: cKDTree | None = None
        self._tangents, self._owners = np.zeros((0, 3)), np.zeros(0, dtype=np.int64)

    def take(self, owner: int, places: np.ndarray, tangents: np.ndarray) -> None:
        """Give places (k, 3) mm with their unit tangents to an owner, instead of its others."""
        self._places[owner] = places, tangents
        self._tree = None

    def give_up(self, owner: int) -> None:
        """Take all places from an owner."""
        self._places.pop(owner, None)
        self._tree = None

    def holders(
        self, places: np.ndarray, tangents: np.ndarray, but: int = NOBODY, along: float = _ALONG
    ) -> np.ndarray:
        """Who owns the strip at places (n, 3) along tangents, (n,); NOBODY where nobody does.

        Parameters
        ----------
        but : an owner who does not count
        along : how far along an edge from a place that is taken, pitches
        """
        tree = self._indexed()
        found = np.full(len(places), NOBODY)
        if tree is None or not len(places):
            return found
        count = min(_LOOKED_AT, len(self._owners))
        away, near = tree.query(
            places, k=range(1, count + 1), distance_upper_bound=_ALONG * self._pitch
        )
        there = np.isfinite(away)
        near = np.where(there, near, 0)
        offset = places[:, None] - tree.data[near]
        own = self._tangents[near]
        ahead = np.einsum("nki,nki->nk", offset, own)
        off = np.linalg.norm(offset - ahead[..., None] * own, axis=2)
        held = there & (self._owners[near] != but) & (off <= _ASIDE * self._pitch)
        held &= np.abs(ahead) <= along * self._pitch
        held &= np.abs(np.einsum("nki,ni->nk", own, tangents)) > _SAME_WAY
        first = held.argmax(axis=1)
        return np.where(held.any(axis=1), self._owners[near[np.arange(len(near)), first]], NOBODY)

    def of_frames(self, frames: Frames, but: int = NOBODY) -> np.ndarray:
        """Who owns the strip at some sections, (m,)."""
        return self.holders(frames.origin, frames.tangent, but)

    def _indexed(self) -> cKDTree | None:
        if self._tree is None and self._places:
            places, tangents = zip(*self._places.values(), strict=True)
            self._tangents = np.concatenate(tangents)
            self._owners = np.repeat(list(self._places), [len(part) for part in places])
            self._tree = cKDTree(np.concatenate(places))
        return self._tree
