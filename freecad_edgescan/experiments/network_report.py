# SPDX-License-Identifier: LGPL-2.1-or-later
"""How well the edges and corners of a known part are found in its whole cloud, without a click."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial import cKDTree

from ..cloud import TrueEdge
from ..scanning import EdgeNetwork
from .edge_report import root_mean_square

__all__ = ["ROOM", "NetworkReport", "labels_report", "network_report"]

Array = NDArray[np.float64]

ROOM = 5.0  # pitches to the next edge, that an edge needs to be counted as sought
_NEAR = 1.0  # pitches from an edge within which it is found
_NEAR_CORNER = 0.5  # pitches from a vertex
_STEP = 0.2  # pitches between the places that stand for an edge
_MEETING = 3  # sought edges that make a vertex one that is sought


@dataclass(frozen=True)
class NetworkReport:
    """What was found of a known part; shares in 0 … 1.

    Attributes
    ----------
    what : who looked for edges
    recall : share of the sought edges' length within one pitch of what was found
    precision : share of what was found within one pitch of a true edge, by length or by points
    rms : mm, distance of what lies within one pitch of a true edge from it
    corner_recall : share of the true vertices where three sought edges meet, found within half a
        pitch; nan when there is none
    corner_precision : share of the found corners within half a pitch of a true vertex
    corners : number of the sought vertices, and of the found corners
    length : mm, of the sought edges, and of what was found
    seconds : that it took
    points : of the cloud
    """

    what: str
    recall: float
    precision: float
    rms: float
    corner_recall: float
    corner_precision: float
    corners: tuple[int, int]
    length: tuple[float, float]
    seconds: float
    points: int

    HEADER = (
        "                      recall  precision     rms  corners   corners   seconds   points\n"
        "                           %          %      mm    found %    true %            per second"
    )

    def text(self) -> str:
        """One line of a table under HEADER."""
        return (
            f"{self.what:<20}  {_percent(self.recall)}     {_percent(self.precision)}  "
            f"{self.rms:6.4f}     {_percent(self.corner_recall)}    "
            f"{_percent(self.corner_precision)}  {self.seconds:8.1f}  "
            f"{self.points / max(self.seconds, 1e-9):9.0f}"
        )


def network_report(
    network: EdgeNetwork,
    sought: Sequence[TrueEdge],
    pitch: float,
    seconds: float,
    others: Sequence[TrueEdge] = (),
    what: str = "find_edges",
) -> NetworkReport:
    """Compare a network with the true edges of its part.

    Parameters
    ----------
    network : what was found
    sought : true edges that are to be found, where they have five pitches of room
    pitch : of the cloud, mm
    seconds : that the search took
    others : further true edges, on which what is found is not wrong
    """
    every = [*sought, *others]
    lines = [
        _places(edge.points if edge.closed else edge.vertex_to_vertex, edge.closed, _STEP * pitch)
        for edge in network.edges
    ]
    found, weight = _together(lines)
    points = np.vstack([np.zeros((0, 3)), *(edge.points for edge in network.edges)])
    distance = np.min(
        [np.full(len(points), np.inf), *(edge.distance(points) for edge in every)], axis=0
    )
    vertices, meeting = _vertices(every, sought, pitch)
    return NetworkReport(
        what,
        _recall(found, sought, pitch),
        _share(_near(found, _together(_sampled(every, pitch))[0], pitch), weight),
        root_mean_square(distance[distance <= _NEAR * pitch]),
        _share(_near(vertices[meeting], network.corners, _NEAR_CORNER * pitch)),
        _share(_near(network.corners, vertices, _NEAR_CORNER * pitch)),
        (int(np.count_nonzero(meeting)), len(network.corners)),
        (_sought_length(sought, pitch), float(weight.sum())),
        seconds,
        len(network.cloud),
    )


def labels_report(
    labelled: ArrayLike,
    sought: Sequence[TrueEdge],
    pitch: float,
    seconds: float,
    points: int,
    what: str,
) -> NetworkReport:
    """Compare labelled points (k, 3) with the true edges; what has no corners has none."""
    found = np.asarray(labelled, dtype=np.float64).reshape(-1, 3)
    distance = np.min(
        [np.full(len(found), np.inf), *(edge.distance(found) for edge in sought)], axis=0
    )
    return NetworkReport(
        what,
        _recall(found, sought, pitch),
        _share(distance <= _NEAR * pitch),
        root_mean_square(distance[distance <= _NEAR * pitch]),
        np.nan,
        np.nan,
        (0, 0),
        (_sought_length(sought, pitch), np.nan),
        seconds,
        points,
    )


def _percent(share: float) -> str:
    return f"{100.0 * share:6.1f}" if np.isfinite(share) else "     -"


def _recall(found: Array, sought: Sequence[TrueEdge], pitch: float) -> float:
    places, weight = _together(_sampled(sought, pitch))
    room = _room(sought, pitch)
    return _share(_near(places, found, pitch)[room], weight[room])


def _sought_length(sought: Sequence[TrueEdge], pitch: float) -> float:
    return float(_together(_sampled(sought, pitch))[1][_room(sought, pitch)].sum())


def _sampled(edges: Sequence[TrueEdge], pitch: float) -> list[tuple[Array, Array]]:
    return [_places(edge.points, edge.closed, _STEP * pitch) for edge in edges]


def _room(edges: Sequence[TrueEdge], pitch: float) -> NDArray[np.bool_]:
    """Whether the places of the edges have the room to be sought."""
    enough = [np.zeros(0, dtype=bool)]
    for edge, (places, _) in zip(edges, _sampled(edges, pitch), strict=True):
        enough.append(np.asarray(edge.room)[edge.nearest_sample(places)] >= ROOM * pitch)
    return np.concatenate(enough)


def _places(points: Array, closed: bool, step: float) -> tuple[Array, Array]:
    """Places along a polyline, and the length each stands for."""
    line = np.vstack([points, points[:1]]) if closed else np.asarray(points)
    at = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1)))
    count = max(2, int(at[-1] / step) + 1)
    middle = (np.arange(count) + 0.5) * at[-1] / count
    places = np.stack([np.interp(middle, at, line[:, k]) for k in range(3)], axis=1)
    return places, np.full(count, at[-1] / count)


def _together(lines: Sequence[tuple[Array, Array]]) -> tuple[Array, Array]:
    return (
        np.vstack([np.zeros((0, 3)), *(places for places, _ in lines)]),
        np.concatenate([np.zeros(0), *(weight for _, weight in lines)]),
    )


def _near(places: Array, others: Array, distance: float) -> NDArray[np.bool_]:
    """Which places have one of the others within a distance."""
    if not len(places) or not len(others):
        return np.zeros(len(places), dtype=bool)
    return np.asarray(cKDTree(others).query(places)[0] <= distance)


def _share(true: NDArray[np.bool_], weight: Array | None = None) -> float:
    weight = np.ones(len(true)) if weight is None else weight
    return float((true * weight).sum() / weight.sum()) if weight.sum() > 0.0 else float("nan")


def _vertices(
    every: Sequence[TrueEdge], sought: Sequence[TrueEdge], pitch: float
) -> tuple[Array, NDArray[np.bool_]]:
    """All ends of true edges, and at which of them three edges with room meet."""
    wanted = {id(edge) for edge in sought}
    ends = [(edge, edge.points[k]) for edge in every if not edge.closed for k in (0, -1)]
    if not ends:
        return np.zeros((0, 3)), np.zeros(0, dtype=bool)
    places = np.array([place for _, place in ends])
    roomy = np.array(
        [id(edge) in wanted and float(np.median(edge.room)) >= ROOM * pitch for edge, _ in ends]
    )
    groups = cKDTree(places).query_ball_point(places, 1e-3 * pitch)
    first = np.array([min(group) == number for number, group in enumerate(groups)])
    meeting = np.array([np.count_nonzero(roomy[group]) >= _MEETING for group in groups])
    return places[first], meeting[first]
