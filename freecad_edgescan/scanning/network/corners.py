# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corners of a network: the vertices in which several edges end, each estimated from all of them.

Every edge that ends at a third surface brings its own vertex. Those near each other are one
corner; it is their mean, weighted by what each knows, and what they differ by is its misclosure.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from ...cloud.point_cloud import PointCloud
from ..corner import largest_sigma
from ..scanned_edge import ScannedEdge
from .bends import bends_at

__all__ = ["Corners", "joined_corners", "unsure"]

_TOGETHER = 1.6  # pitches between two vertices of one corner, besides what a rounding makes unsure
_ROUNDING = 0.15  # of what a rounding takes away
_SIGMAS = 3.0
_FARTHEST = 8.0  # pitches from the end of an edge to its vertex, besides a rounding
_PASSING = 1.2  # pitches from a corner, at which an edge passes it
_OFF_LINE = 1.0  # pitches, of a corner from an edge drawn out, that has no vertex of its own
_DRAWN_OUT = 6  # edge points for that
_LARGEST_SIGMA = 0.5  # pitches
_KNOWN = 0.02  # pitches: no vertex is known better


@dataclass(frozen=True)
class Corners:
    """Corners and the ends of edges in them.

    Attributes
    ----------
    points : (k, 3) mm
    covariance : (k, 3, 3) mm²
    misclosure : (k,) mm, the farthest of its edges' own vertices from it
    of_ends : (m, 2) number of the corner in which each edge starts and ends, −1 for none
    passing : (k,) number of the edge that passes a corner without ending there, −1 for none
    bending : (m, 2) bool, ends at which an edge bends with its wall, which is no corner
    """

    points: np.ndarray
    covariance: np.ndarray
    misclosure: np.ndarray
    of_ends: np.ndarray
    passing: np.ndarray
    bending: np.ndarray


def joined_corners(edges: list[ScannedEdge], cloud: PointCloud) -> Corners:
    """The corners in which edges end together, or upon another edge.

    Parameters
    ----------
    cloud : that the edges were found in
    """
    pitch = cloud.pitch
    of_ends, bending = np.full((len(edges), 2), -1), np.zeros((len(edges), 2), dtype=bool)
    ends = [
        (number, k)
        for number, edge in enumerate(edges)
        for k in (0, 1)
        if not edge.closed and _believable(edge, k, pitch)
    ]
    if not ends:
        return _none(bending)
    points = np.array([edges[number].vertices[k][0] for number, k in ends])  # type: ignore[index]
    spread = np.array([edges[number].vertices[k][1] for number, k in ends])  # type: ignore[index]
    doubts = np.array([unsure(edges[number], pitch) for number, _ in ends])
    label = _grouped(points, spread, doubts, pitch)
    numbers = np.array(ends)
    found: list[tuple[np.ndarray, np.ndarray, float, int]] = []
    for group in range(int(label.max()) + 1):
        mine = np.flatnonzero(label == group)
        point, covariance = _mean(points[mine], spread[mine], pitch)
        others = _drawn_out_to(edges, point, numbers[mine], of_ends, pitch)
        passing = _passing(edges, point, {*numbers[mine, 0], *(j for j, _ in others)}, pitch)
        worst = float(largest_sigma(covariance[None])[0])
        if worst > _LARGEST_SIGMA * pitch + doubts[mine].max():
            continue
        # Two edges alone make a corner where each of them has found it by itself.
        if len(mine) + len(others) < 3 and len(mine) < 2 and passing < 0:
            continue
        if not others and passing < 0 and _are_one(cloud, edges, point, numbers[mine]):
            bending[tuple(numbers[mine].T)] = True
            continue
        misclosure = float(np.linalg.norm(points[mine] - point, axis=1).max())
        for number, k in [*numbers[mine].tolist(), *others]:
            of_ends[number, k] = len(found)
        found.append((point, covariance, misclosure, passing))
    if not found:
        return _none(bending)
    where, covariances, misclosures, passings = zip(*found, strict=True)
    return Corners(
        np.array(where),
        np.array(covariances),
        np.array(misclosures),
        of_ends,
        np.array(passings),
        bending,
    )


def _are_one(
    cloud: PointCloud, edges: list[ScannedEdge], point: np.ndarray, ends: np.ndarray
) -> bool:
    """Whether the ends (k, 2) of edges in a corner are those of two that are one bent edge.

    Under a rounding the third edge is one, too, and no bend is told from it.
    """
    if len(ends) != 2:
        return False
    both = [(edges[number], k) for number, k in ends.tolist()]
    sharp = all(unsure(edge, cloud.pitch) == 0.0 for edge, _ in both)
    return sharp and bends_at(cloud, point, both)


def _none(bending: np.ndarray) -> Corners:
    return Corners(
        np.zeros((0, 3)),
        np.zeros((0, 3, 3)),
        np.zeros(0),
        np.full(bending.shape, -1),
        np.zeros(0, dtype=np.int64),
        bending,
    )


def _rounded(edge: ScannedEdge) -> float:
    """What a rounding takes away of an edge, mm."""
    return float(np.median(edge.overhang)) if len(edge.overhang) else 0.0


def _believable(edge: ScannedEdge, k: int, pitch: float) -> bool:
    vertex = edge.vertices[k]
    if vertex is None:
        return False
    off = float(np.linalg.norm(vertex[0] - edge.points[-k]))
    return off < _FARTHEST * pitch + 3.0 * _rounded(edge)


def unsure(edge: ScannedEdge, pitch: float) -> float:
    """How far an edge or its vertex may be off besides its covariance, under a rounding, mm."""
    return _ROUNDING * max(_rounded(edge) - pitch, 0.0)


def _grouped(
    points: np.ndarray, spread: np.ndarray, doubts: np.ndarray, pitch: float
) -> np.ndarray:
    """Number of the group of each vertex, (n,)."""
    sigma = np.minimum(largest_sigma(spread), 0.5 * pitch)
    widest = _TOGETHER * pitch + 2.0 * (doubts.max() + _SIGMAS * sigma.max())
    one, other = cKDTree(points).query_pairs(widest, output_type="ndarray").T
    off = np.linalg.norm(points[one] - points[other], axis=1)
    near = off <= (
        _TOGETHER * pitch
        + doubts[one]
        + doubts[other]
        + _SIGMAS * np.hypot(sigma[one], sigma[other])
    )
    count = len(points)
    graph = coo_matrix((np.ones(near.sum()), (one[near], other[near])), shape=(count, count))
    return np.asarray(connected_components(graph, directed=False)[1])


def _mean(points: np.ndarray, spread: np.ndarray, pitch: float) -> tuple[np.ndarray, np.ndarray]:
    """Weighted mean of a corner's vertices and its covariance.

    They share surfaces. How much they depend on each other is not known; the mean of their
    covariances, weighted like them, holds however much that is (covariance intersection: Julier
    and Uhlmann 1997), and what they differ by beyond it is added.
    """
    least = (_KNOWN * pitch) ** 2 * np.eye(3)
    information = np.linalg.inv(spread + least)
    total = np.linalg.inv(information.sum(axis=0))
    point = total @ np.einsum("nij,nj->i", information, points)
    covariance = len(points) * total
    off = points - point
    excess = np.einsum("ni,nij,nj->n", off, information, off).sum() / (3.0 * len(points))
    return point, covariance * max(1.0, float(excess))


def _drawn_out_to(
    edges: list[ScannedEdge],
    point: np.ndarray,
    known: np.ndarray,
    of_ends: np.ndarray,
    pitch: float,
) -> list[tuple[int, int]]:
    """Ends of other edges that run into a corner, though they found no vertex themselves."""
    own = {tuple(pair) for pair in known.tolist()}
    found = []
    for number, edge in enumerate(edges):
        if edge.closed:
            continue
        for k in (0, 1):
            if (number, k) in own or of_ends[number, k] >= 0:
                continue
            offset = point - edge.points[-k]
            far = _FARTHEST * pitch + 3.0 * _rounded(edge)
            if float(offset @ offset) > far**2:
                continue
            few = edge.points[-_DRAWN_OUT:] if k else edge.points[_DRAWN_OUT - 1 :: -1]
            way = few[-1] - few[0]
            way = way / max(float(np.linalg.norm(way)), 1e-12)
            ahead = float(offset @ way)
            aside = float(np.linalg.norm(offset - ahead * way))
            if ahead > -2.0 * pitch and aside < _OFF_LINE * pitch + unsure(edge, pitch):
                found.append((number, k))
    return found


def _passing(edges: list[ScannedEdge], point: np.ndarray, ending: set[int], pitch: float) -> int:
    """Number of an edge that passes a corner between its ends, −1 for none."""
    for number, edge in enumerate(edges):
        if number in ending or len(edge) < 3:
            continue
        near = int(np.linalg.norm(edge.points - point, axis=1).argmin())
        if not edge.closed and near in (0, len(edge) - 1):
            continue
        offset = point - edge.points[near]
        aside = offset - (offset @ edge.tangents[near]) * edge.tangents[near]
        if np.linalg.norm(aside) < _PASSING * pitch and np.linalg.norm(offset) < 3.0 * pitch:
            return number
    return -1
