# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points strewn along a curve, brought into order along it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components, dijkstra, minimum_spanning_tree
from scipy.spatial import cKDTree

from ..cloud.thinning import spaced_rows

__all__ = ["chain_order"]

Array = NDArray[np.float64]

_NEIGHBOURS = 8
_BRANCH = 4.0  # spacings from the way between two places; what is farther leads elsewhere


def chain_order(
    points: Array, near: Array, spacing: float, gap: float, towards: Array | None = None
) -> NDArray[np.intp]:
    """Rows of the points of one piece of an open curve, in order along it.

    Parameters
    ----------
    points : (n, 3) mm, scattered about the curve
    near : (3,) mm; the piece nearest to this place is taken, and begins at its end nearest to it
    spacing : mm, below which the order of points does not matter much
    gap : mm, beyond which points belong to different pieces
    towards : (3,) mm; only what lies on the way from there to here is taken, no branches of it
    """
    nodes = points[spaced_rows(points, spacing)]
    whole = _graph(nodes, gap)
    label = connected_components(whole, directed=False)[1]
    piece = np.flatnonzero(label == label[np.argmin(np.linalg.norm(nodes - near, axis=1))])
    nodes, graph = nodes[piece], minimum_spanning_tree(whole[piece][:, piece])
    if towards is None:
        one = _farthest(graph, 0)
        other = _farthest(graph, one)
        if np.linalg.norm(nodes[other] - near) < np.linalg.norm(nodes[one] - near):
            one = other
    else:
        one, other = (int(np.argmin(np.linalg.norm(nodes - x, axis=1))) for x in (near, towards))
        kept = _on_the_way(graph, one, other, _BRANCH * spacing)
        one = int(np.flatnonzero(kept == one)[0])
        nodes, graph = nodes[kept], graph[kept][:, kept]
    way = dijkstra(graph, directed=False, indices=one)
    order = np.argsort(way)
    nodes, way = nodes[order], way[order]
    along = np.gradient(nodes, axis=0) if len(nodes) > 1 else np.zeros_like(nodes)
    length = np.linalg.norm(along, axis=1, keepdims=True)
    along /= np.where(length > 0.0, length, 1.0)
    away, node = cKDTree(nodes).query(points)
    place = way[node] + np.einsum("ni,ni->n", points - nodes[node], along[node])
    rows = np.flatnonzero(away <= spacing * 1.001)
    return rows[np.argsort(place[rows], kind="stable")]


def _graph(nodes: Array, gap: float) -> coo_matrix:
    """Distances between neighbours that are no farther apart than a gap."""
    count = min(_NEIGHBOURS + 1, len(nodes))
    distance, other = cKDTree(nodes).query(nodes, k=range(1, count + 1))
    one = np.broadcast_to(np.arange(len(nodes))[:, None], other.shape)
    near = (distance <= gap) & (one != other)
    shape = (len(nodes), len(nodes))
    return coo_matrix((distance[near], (one[near], other[near])), shape=shape).tocsr()


def _on_the_way(graph: coo_matrix, one: int, other: int, reach: float) -> NDArray[np.intp]:
    """Nodes of a tree on its way between two of them, or on branches no farther from it, mm."""
    before = dijkstra(graph, directed=False, indices=one, return_predecessors=True)[1]
    way = [other]
    while way[-1] != one:
        way.append(int(before[way[-1]]))
    off = dijkstra(graph, directed=False, indices=way, min_only=True)
    return np.flatnonzero(off <= reach)


def _farthest(graph: coo_matrix, node: int) -> int:
    return int(np.argmax(dijkstra(graph, directed=False, indices=node)))
