# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faces between the edges of a network, as parts of the cloud.

Neighbouring nodes belong to one face unless an edge runs between them, that is, unless they lie on
different sides of it, or one lies farther beside the other's plane, or is turned more against it,
than a smooth surface bends between them: so the two faces of a thin wall are two. An edge that ends
short of the next one at a corner parts its faces up to that corner, too.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from ...cloud.point_cloud import PointCloud
from ..scanned_edge import ScannedEdge
from .nodes import Nodes, spread_nodes
from .parting_lines import parting_lines

__all__ = ["Region", "labels_of", "regions_between"]

_SPACING, _POINTS = 1.6, 14  # pitches between nodes, and points of a node's neighbourhood
_LINKED = 3.2  # pitches between neighbours
_BESIDE = 6.0  # pitches from an edge, within which its sides are told apart, besides a rounding
_OFF_RIM = 0.7  # pitches from an edge, within which a node belongs to neither side
_TURN = 0.3  # rad, between neighbours on one face, or what noise makes it
_BENT = 0.1  # pitches, by which a face may leave the plane of a neighbourhood
_BY_CHANCE = 6.0  # standard deviations
_FEWEST = 60  # points of a region
_EDGES_NEAR = 4  # edge points of different edges that a node may be beside
_LOOKED_AT = 5  # nodes round a point, one of which it belongs to


@dataclass(frozen=True, eq=False)
class Region:
    """A face between edges.

    Attributes
    ----------
    mask : (n,) bool, which points of the cloud are on it
    edges : numbers of the edges that bound it
    """

    mask: np.ndarray
    edges: tuple[int, ...]

    def __len__(self) -> int:
        return int(np.count_nonzero(self.mask))


def regions_between(cloud: PointCloud, edges: Sequence[ScannedEdge]) -> tuple[Region, ...]:
    """Faces of a cloud, the largest first."""
    nodes = spread_nodes(cloud, _SPACING * cloud.pitch, _POINTS)
    beside = _Sides(edges, nodes.places, cloud.pitch)
    chance = 2.0 * cloud.noise / cloud.pitch * np.sqrt(np.pi) / _POINTS
    # Between two faces a neighbourhood is no plane, and its node belongs to neither.
    plane = (1.0 + _BY_CHANCE / np.sqrt(2.0 * _POINTS)) * cloud.noise + _BENT * cloud.pitch
    label = _faces(
        nodes,
        beside,
        beside.rim | (nodes.scatter > plane),
        _LINKED * cloud.pitch,
        max(_TURN, _BY_CHANCE * chance),
        _BY_CHANCE * cloud.noise / np.sqrt(_POINTS),
    )
    of_points = labels_of(cloud, nodes, label)
    sizes = np.bincount(of_points[of_points >= 0], minlength=label.max() + 1)
    bounds = beside.bounds(label)
    return tuple(
        Region(of_points == number, tuple(bounds.get(int(number), ())))
        for number in np.argsort(-sizes, kind="stable")
        if sizes[number] >= _FEWEST
    )


class _Sides:
    """On which side of which edges the nodes beside them are."""

    def __init__(self, edges: Sequence[ScannedEdge], places: np.ndarray, pitch: float) -> None:
        count = len(places)
        self.edge = np.full((count, _EDGES_NEAR), -1)
        self.side = np.full((count, _EDGES_NEAR), -1)
        tree = cKDTree(places)
        self.rim = np.zeros(count, dtype=bool)
        filled = np.zeros(count, dtype=np.int64)
        lines = parting_lines(edges, pitch)
        for number, (edge, line) in enumerate(zip(edges, lines, strict=True)):
            rounded = float(np.median(edge.overhang)) if len(edge.overhang) else 0.0
            reach = _BESIDE * pitch + 2.0 * max(rounded - pitch, 0.0)
            balls = tree.query_ball_point(line.points, reach)
            rows = np.unique(np.concatenate([np.asarray(ball, np.int64) for ball in balls]))
            near = cKDTree(line.points).query(places[rows])[1]
            offset = places[rows] - line.points[near]
            ahead = np.einsum("ni,ni->n", offset, line.tangents[near])
            # Beyond its ends an edge parts nothing.
            inner = np.abs(ahead) < 2.0 * pitch
            away = np.einsum("nki,ni->nk", line.sides[near], offset)
            clear = np.abs(away[:, 0] - away[:, 1]) > _OFF_RIM * pitch
            self.rim[rows[inner & ~clear]] = True
            wanted = inner & clear & (filled[rows] < _EDGES_NEAR)
            rows, away = rows[wanted], away[wanted]
            self.edge[rows, filled[rows]] = number
            self.side[rows, filled[rows]] = away.argmax(axis=1)
            filled[rows] += 1

    def parted(self, one: np.ndarray, other: np.ndarray) -> np.ndarray:
        """Whether an edge runs between pairs of nodes, (n,) bool."""
        parted = np.zeros(len(one), dtype=bool)
        for a in range(_EDGES_NEAR):
            for b in range(_EDGES_NEAR):
                same = (self.edge[one, a] >= 0) & (self.edge[one, a] == self.edge[other, b])
                parted |= same & (self.side[one, a] != self.side[other, b])
        return parted

    def bounds(self, label: np.ndarray) -> dict[int, list[int]]:
        """The edges round each face: those of which it holds most of one side's nodes."""
        node, place = np.nonzero(self.edge >= 0)
        key = 2 * self.edge[node, place] + self.side[node, place]
        found: dict[int, list[int]] = {}
        for value in np.unique(key):
            faces = label[node[key == value]]
            numbers, counts = np.unique(faces[faces >= 0], return_counts=True)
            for face in numbers[counts >= 0.15 * max(counts.sum(), 1)].tolist():
                edges = found.setdefault(face, [])
                if int(value) // 2 not in edges:
                    edges.append(int(value) // 2)
        return found


def _faces(
    nodes: Nodes, beside: _Sides, apart: np.ndarray, linked: float, turn: float, scatter: float
) -> np.ndarray:
    """Number of the face of each node, (k,).

    Parameters
    ----------
    apart : (k,) bool, nodes that belong to no face
    linked : how far neighbours are apart at most, mm
    turn : by which their normals differ at most, rad
    scatter : of a node along its normal, at most, mm
    """
    count = len(nodes)
    pairs = cKDTree(nodes.places).query_pairs(linked, output_type="ndarray")
    pairs = pairs[~np.any(apart[pairs], axis=1)]
    one, other = pairs[:, 0], pairs[:, 1]
    way = nodes.places[other] - nodes.places[one]
    # A surface that has turned by an angle on an arc has left its tangent by half of it.
    level = scatter + np.sin(0.5 * turn) * np.linalg.norm(way, axis=1)
    smooth = np.abs(np.einsum("ni,ni->n", nodes.normals[one], nodes.normals[other])) > np.cos(turn)
    for row in (one, other):
        smooth &= np.abs(np.einsum("ni,ni->n", way, nodes.normals[row])) < level
    together = smooth & ~beside.parted(one, other)
    graph = coo_matrix(
        (np.ones(np.count_nonzero(together)), (one[together], other[together])),
        shape=(count, count),
    )
    return np.asarray(connected_components(graph, directed=False)[1])


def labels_of(cloud: PointCloud, nodes: Nodes, label: np.ndarray) -> np.ndarray:
    """The face (n,) of every point: of the nodes round it that whose plane it is nearest to."""
    sizes = np.bincount(label)
    good = sizes[label] >= 4
    if not good.any():
        return np.full(len(cloud), -1)
    places, normals, own = nodes.places[good], nodes.normals[good], label[good]
    tree = cKDTree(places, balanced_tree=False)
    result = np.empty(len(cloud), dtype=np.int64)
    count = min(_LOOKED_AT, len(places))
    for begin in range(0, len(cloud), 200_000):
        points = cloud.points[begin : begin + 200_000]
        away, near = tree.query(points, k=range(1, count + 1), workers=-1)
        height = np.abs(np.einsum("nki,nki->nk", points[:, None] - places[near], normals[near]))
        best = (height + 0.1 * away).argmin(axis=1)
        chosen = near[np.arange(len(points)), best]
        far = away[:, 0] > 3.0 * cloud.pitch
        result[begin : begin + 200_000] = np.where(far, -1, own[chosen])
    return result
