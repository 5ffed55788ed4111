# SPDX-License-Identifier: LGPL-2.1-or-later
"""A network of scanned edges as native edges that end exactly in their corners and share them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import FreeCAD  # noqa: F401 (before Part, which ends the process otherwise)
import numpy as np
import Part
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from ..scanning import EdgeNetwork, ScannedEdge, Stop
from .native_curve import curve_shape, vector
from .native_edge import edge_shape

__all__ = ["network_edges", "network_shape", "network_wires"]

Array = NDArray[np.float64]

_LEAST = 1e-6  # mm, between the ends of an edge


def network_edges(network: EdgeNetwork) -> list[Any]:
    """The native edge of each edge of a network: lines, arcs, circles and B-splines.

    Where an edge ends in a corner it ends there exactly.

    Raises
    ------
    ValueError: something else than an EdgeNetwork.
    """
    if not isinstance(network, EdgeNetwork):
        raise ValueError(
            f"{getattr(network, 'Label', network)!r} is no EdgeNetwork, as find_edges(cloud) "
            "answers; of a network in a document take its Shape, and make_edge_wire(doc, network) "
            "for wires."
        )
    edges = []
    for edge, ends in zip(network.edges, network.ends, strict=True):
        corners = [None if isinstance(end, Stop) else network.corners[end] for end in ends]
        edges.append(_between(edge, corners[0], corners[1]))
    return edges


def network_shape(network: EdgeNetwork) -> Any:
    """A compound of the native edges; where edges meet they share one vertex.

    Raises
    ------
    ValueError: something else than an EdgeNetwork.
    """
    compound = Part.Compound(network_edges(network))
    vertices = compound.Vertexes
    for vertex in vertices:
        # Whether it begins an edge or ends it; the other one that takes its place does that, too.
        vertex.Orientation = "Forward"
    if not vertices:
        return compound
    places = np.array([tuple(vertex.Point) for vertex in vertices])
    firsts = [vertices[min(near)] for near in cKDTree(places).query_ball_point(places, _LEAST)]
    instead = [
        (vertex, first)
        for vertex, first in zip(vertices, firsts, strict=True)
        if not vertex.isSame(first)
    ]
    return compound.replaceShape(instead) if instead else compound


def network_wires(network: EdgeNetwork) -> list[Any]:
    """Wires of edges that follow each other through corners where just two of them meet.

    Raises
    ------
    ValueError: something else than an EdgeNetwork, such as its object in a document.
    """
    edges = network_edges(network)
    return [Part.Wire([edges[number] for number in chain]) for chain in network.chains()]


def _between(edge: ScannedEdge, start: Array | None, end: Array | None) -> Any:
    if edge.closed or (start is None and end is None):
        return edge_shape(edge)
    if edge.line is not None:
        first, last = _ends(edge, start, end)
        if np.linalg.norm(last - first) > _LEAST:
            return Part.LineSegment(vector(first), vector(last)).toShape()
    if edge.circle is not None:
        first, last = _ends(edge, start, end)
        middle = edge.points[len(edge) // 2]
        middle = middle - edge.circle.residuals(middle[None])[0]
        return Part.Arc(vector(first), vector(middle), vector(last)).toShape()
    curve = edge.curve()
    poles = np.array(curve.poles)
    poles[0] = poles[0] if start is None else start
    poles[-1] = poles[-1] if end is None else end
    return curve_shape(replace(curve, poles=poles))


def _ends(edge: ScannedEdge, start: Array | None, end: Array | None) -> tuple[Array, Array]:
    """Corners, and where there is none the primitive's own end."""
    native = edge_shape(edge)
    own = [np.array(vertex.Point) for vertex in native.Vertexes]
    points = edge.vertex_to_vertex
    if len(own) == 2 and np.linalg.norm(own[0] - points[0]) > np.linalg.norm(own[1] - points[0]):
        own.reverse()
    return (own[0] if start is None else start), (own[-1] if end is None else end)
