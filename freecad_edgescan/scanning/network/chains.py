# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections that follow each other along one edge, put in order.

Two sections follow each other when one arc of a circle leads from one to the other along both of
their tangents, and their sides agree. Each is joined with the nearest such section ahead and
behind, where that one is joined with it, too.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from ...geometry.frames import turned_along
from ..section import Frames

__all__ = ["Chain", "chains_of", "follow"]

_NEAREST, _FARTHEST = 0.5, 9.0  # pitches from one section to the next
_STEEPEST = np.cos(np.radians(40.0))  # of a tangent against the chord
_OFF_ARC = 0.45  # of a tangent from that of the arc
_SAME_SIDES = np.cos(np.radians(35.0))


@dataclass(frozen=True)
class Chain:
    """Sections of one edge in order.

    Attributes
    ----------
    rows : (k,) numbers of the sections
    forward : (k,) bool, whether a section's tangent points along the chain
    closed : whether the last one is followed by the first
    """

    rows: np.ndarray
    forward: np.ndarray
    closed: bool

    def __len__(self) -> int:
        return len(self.rows)


def follow(
    frames: Frames, one: np.ndarray, other: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Whether pairs of sections may follow each other along an edge.

    Returns
    -------
    (n,) bool, and whether the other one lies ahead of the one and the one ahead of the other, by
    their own tangents, (n,) bool each
    """
    chord = frames.origin[other] - frames.origin[one]
    chord = chord / np.maximum(np.linalg.norm(chord, axis=1, keepdims=True), 1e-12)
    ahead = np.einsum("ni,ni->n", chord, frames.tangent[one])
    behind = np.einsum("ni,ni->n", chord, frames.tangent[other])
    leaving = frames.tangent[one] * np.sign(ahead)[:, None]
    arriving = frames.tangent[other] * np.sign(behind)[:, None]
    arc = 2.0 * np.abs(ahead)[:, None] * chord - leaving
    fits = np.linalg.norm(arriving - arc, axis=1) < _OFF_ARC
    fits &= np.minimum(np.abs(ahead), np.abs(behind)) > _STEEPEST
    sides = turned_along(frames.sides[one], leaving, arriving)
    straight = np.einsum("nki,nki->nk", sides, frames.sides[other]).min(axis=1)
    crossed = np.einsum("nki,nki->nk", sides, frames.sides[other][:, ::-1]).min(axis=1)
    fits &= np.maximum(straight, crossed) > _SAME_SIDES
    return fits, ahead > 0.0, behind < 0.0


def chains_of(frames: Frames, pitch: float, fewest: int) -> list[Chain]:
    """Chains of at least so many sections, the longest first.

    Parameters
    ----------
    frames : m sections in any order, no two of them at the same place
    pitch : of the cloud, mm
    """
    count = len(frames)
    if count < 2:
        return []
    tree = cKDTree(frames.origin, balanced_tree=False)
    one, other = tree.query_pairs(_FARTHEST * pitch, output_type="ndarray").T
    distance = np.linalg.norm(frames.origin[other] - frames.origin[one], axis=1)
    fits, ahead, behind = follow(frames, one, other)
    fits &= distance > _NEAREST * pitch
    one, other, distance = one[fits], other[fits], distance[fits]
    # A section's two ways are 2·row (backwards) and 2·row + 1 (along its tangent).
    leave = np.concatenate([2 * one + ahead[fits], 2 * other + behind[fits]])
    enter = np.concatenate([2 * other + behind[fits], 2 * one + ahead[fits]])
    order = np.lexsort((np.concatenate([distance, distance]), leave))
    first = order[np.unique(leave[order], return_index=True)[1]]
    next_way = np.full(2 * count, -1)
    next_way[leave[first]] = enter[first]
    mutual = next_way >= 0
    mutual[mutual] = next_way[next_way[mutual]] == np.flatnonzero(mutual)
    next_way[~mutual] = -1
    chains = [chain for chain in _walked(next_way) if len(chain) >= fewest]
    return sorted(chains, key=len, reverse=True)


def _walked(next_way: np.ndarray) -> list[Chain]:
    """Chains that follow the links from way to way.

    Whoever leaves a section one way has entered it the other way.
    """
    links, chains = next_way.tolist(), []
    seen = [False] * (len(links) // 2)

    def onward(way: int) -> list[int]:
        """Ways out of the sections from a way out of one on, up to an end or back to the start."""
        ways, start = [way], way >> 1
        while (entered := links[ways[-1]]) >= 0 and entered >> 1 != start:
            seen[entered >> 1] = True
            ways.append(entered ^ 1)
        return ways

    for row in range(len(seen)):
        if seen[row]:
            continue
        seen[row] = True
        ahead = onward(2 * row + 1)
        closed = links[ahead[-1]] >= 0
        behind = [] if closed else [way ^ 1 for way in onward(2 * row)[:0:-1]]
        ways = np.array([*behind, *ahead])
        chains.append(Chain(ways >> 1, (ways & 1).astype(bool), closed))
    return chains
