# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which edges of a network are wanted: by length, turn and sigma, and by hand.

An edge that was chosen by hand is known by a point on it: numbers of edges change when a cloud is
scanned again, places do not.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial import cKDTree

from .network import EdgeNetwork
from .scanned_edge import ScannedEdge

__all__ = ["EdgeChoice", "nearest_edges", "place_on", "turn_of"]

Array = NDArray[np.float64]

_ON_EDGE = 3.0  # pitches from an edge, within which a point means it


def _no_places() -> Array:
    return np.zeros((0, 3))


@dataclass(frozen=True, eq=False)
class EdgeChoice:
    """Which edges are kept; what is done by hand outweighs the rest.

    Parameters
    ----------
    min_angle : rad, of the turn between the two sides, the median along an edge
    min_length : mm
    max_sigma : mm, the median along an edge
    dropped : (k, 3) mm, a point on each edge that is left out by hand
    kept : (k, 3) mm, a point on each edge that is kept by hand, whatever its length, turn and sigma
    """

    min_angle: float = 0.0
    min_length: float = 0.0
    max_sigma: float = np.inf
    dropped: Array = field(default_factory=_no_places)
    kept: Array = field(default_factory=_no_places)

    def passes(self, edge: ScannedEdge) -> bool:
        """Whether an edge is long, sharp and well known enough."""
        return (
            edge.length >= self.min_length
            and turn_of(edge) >= self.min_angle
            and float(np.median(edge.sigma)) <= self.max_sigma
        )

    def mask(self, edges: Sequence[ScannedEdge], pitch: float) -> NDArray[np.bool_]:
        """Which edges are kept, (m,) bool.

        Parameters
        ----------
        pitch : of the cloud, mm
        """
        mask = np.array([self.passes(edge) for edge in edges], dtype=bool)
        mask[nearest_edges(edges, self.kept, pitch)] = True
        mask[nearest_edges(edges, self.dropped, pitch)] = False
        return mask

    def of(self, network: EdgeNetwork) -> EdgeNetwork:
        """The part of a network that is kept."""
        return network.part(self.mask(network.edges, network.cloud.pitch))

    def toggled(self, edges: Sequence[ScannedEdge], number: int, pitch: float) -> EdgeChoice:
        """The choice in which one edge is kept if it was not, and left out if it was kept.

        Parameters
        ----------
        edges : all that can be chosen from
        number : of the edge
        pitch : of the cloud, mm
        """
        was_kept = bool(self.mask(edges, pitch)[number])
        others = replace(
            self,
            dropped=_but(self.dropped, edges, number, pitch),
            kept=_but(self.kept, edges, number, pitch),
        )
        if bool(others.mask(edges, pitch)[number]) is not was_kept:
            return others
        place = place_on(edges[number])
        if was_kept:
            return replace(others, dropped=np.vstack([others.dropped, place]))
        return replace(others, kept=np.vstack([others.kept, place]))


def turn_of(edge: ScannedEdge) -> float:
    """Turn between the two sides of an edge, rad, the median along it."""
    return float(np.pi - np.median(edge.angle))


def place_on(edge: ScannedEdge) -> Array:
    """A point (3,) that tells an edge from others: the middle one of its edge points."""
    place: Array = edge.points[len(edge) // 2]
    return place


def nearest_edges(
    edges: Sequence[ScannedEdge], places: ArrayLike, pitch: float
) -> NDArray[np.intp]:
    """Numbers of the edges that places (k, 3) are on; a place on none of them has no number."""
    places = np.asarray(places, dtype=np.float64).reshape(-1, 3)
    if not len(places) or not len(edges):
        return np.zeros(0, dtype=np.intp)
    owner = np.repeat(np.arange(len(edges)), [2 * len(edge) - 1 for edge in edges])
    away, row = cKDTree(np.vstack([_dense(edge.points) for edge in edges])).query(places)
    return np.asarray(owner[row[away <= _ON_EDGE * pitch]], dtype=np.intp)


def _but(places: Array, edges: Sequence[ScannedEdge], number: int, pitch: float) -> Array:
    """Those of the places that do not mean one edge."""
    means = [number in nearest_edges(edges, place, pitch) for place in places]
    return places[~np.array(means, dtype=bool)] if len(places) else places


def _dense(points: Array) -> Array:
    """Points and the middles between them, (2m − 1, 3)."""
    dense = np.empty((2 * len(points) - 1, 3))
    dense[::2], dense[1::2] = points, 0.5 * (points[:-1] + points[1:])
    return dense
