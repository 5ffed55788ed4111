# SPDX-License-Identifier: LGPL-2.1-or-later
"""A wire of edges of a network that follow each other: what sweeps, lofts and sketches need.

Its edges are known by a point on each of them, so that it stays where it is when the network is
found again. The name of this module and of `EdgeWireProxy` are written into users' files.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
import Part

from ..geometry.plain_number import plain
from .computed_object import MESSAGE, ComputedProxy, Task, result
from .declared_properties import Declared
from .native_curve import curve_of, vector

__all__ = ["EdgeWireProxy", "make_edge_wire"]

_ON_EDGE = 0.1  # of the length of an edge from a point, within which the point means it

_PROPERTIES = (
    Declared("LinkGlobal", "Network", "Wire", "What holds the edges, such as an edge network"),
    Declared("VectorList", "Through", "Wire", "A point on each of the edges, in any order"),
    result("Integer", "EdgeCount", "Number of edges"),
    result("Length", "Length", "From its beginning to its end"),
    result("Bool", "Closed", "Whether it ends where it begins"),
    MESSAGE,
)


def make_edge_wire(doc: Any, network: Any, edges: Sequence[str] = (), name: str = "Wire") -> Any:
    """Make a wire of edges that follow each other.

    Parameters
    ----------
    doc : App.Document
    network : object whose Shape holds the edges, such as an edge network
    edges : their names in it, such as "Edge3", in any order; none: all of them

    Returns
    -------
    Part::FeaturePython whose Shape is one Part.Wire; `doc.recompute()` makes it.

    Raises
    ------
    ValueError: an object without edges, a name it does not have, or edges that do not follow each
        other; nothing is made.
    """
    shape = getattr(network, "Shape", None)
    label = getattr(network, "Label", network)
    if shape is None or not shape.Edges:
        raise ValueError(
            f"{label!r} has no edges; choose a network of edges, and recompute the document."
        )
    names = list(edges) or [f"Edge{number}" for number in range(1, len(shape.Edges) + 1)]
    chosen = []
    for own in names:
        number = int(own[4:]) if own.startswith("Edge") and own[4:].isdigit() else 0
        if not 1 <= number <= len(shape.Edges):
            raise ValueError(
                f"{label!r} has no {own!r}; its edges are Edge1 to Edge{len(shape.Edges)}."
            )
        chosen.append(shape.Edges[number - 1])
    _wire(chosen)
    obj = doc.addObject("Part::FeaturePython", name)
    EdgeWireProxy(obj)
    obj.Network = network
    obj.Through = [_middle(edge) for edge in chosen]
    return obj


class EdgeWireProxy(ComputedProxy):
    """What makes the object follow its network."""

    PROPERTIES = _PROPERTIES
    PLAIN = False

    def depends_on(self, obj: Any) -> Iterable[object]:
        """The curves of the edges that the points are on."""
        for edge in _edges(obj):
            yield curve_of(edge)

    def task(self, obj: Any) -> Task:
        """What joins the edges."""
        wire = _wire(_edges(obj))
        return lambda progress: wire

    def write(self, obj: Any, result: Any) -> None:
        """Write the wire."""
        result.Placement = obj.Placement.multiply(result.Placement)
        obj.Shape = result
        obj.EdgeCount, obj.Length, obj.Closed = len(result.Edges), result.Length, result.isClosed()
        count = len(result.Edges)
        obj.Message = f"{count} edge{'s' * (count != 1)} of {plain(result.Length, 4)} mm in all."


def _edges(obj: Any) -> list[Any]:
    """The edges that the points are on, each once.

    Raises
    ------
    ValueError: there is none for one of the points.
    """
    if obj.Network is None or not obj.Network.Shape.Edges:
        raise ValueError("The wire has no network of edges; choose one, or undo its deletion.")
    every = obj.Network.Shape.Edges
    rows = []
    for place in obj.Through:
        vertex = Part.Vertex(place)
        away = [float(edge.distToShape(vertex)[0]) for edge in every]
        best = int(np.argmin(away))
        if away[best] > _ON_EDGE * every[best].Length:
            raise ValueError(
                f"{obj.Network.Label!r} has no edge any more at {tuple(place)}; take the point "
                "out of Through, or keep that edge in the network."
            )
        rows.append(best)
    return [every[row] for row in dict.fromkeys(rows)]


def _wire(edges: list[Any]) -> Any:
    chains = Part.sortEdges(edges)
    if len(chains) != 1:
        raise ValueError(
            f"The {len(edges)} edges form {len(chains)} separate chains; choose edges that follow "
            "each other, from corner to corner."
        )
    return Part.Wire(chains[0])


def _middle(edge: Any) -> Any:
    """A point on an edge, half-way along."""
    return vector(edge.valueAt(edge.getParameterByLength(0.5 * edge.Length)))
