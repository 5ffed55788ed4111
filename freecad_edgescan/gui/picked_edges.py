# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of a network that are selected one by one, which stand for the wires they form."""

from __future__ import annotations

from typing import Any

import FreeCADGui
import Part

from .recorded_step import object_line
from .selected import is_edge_network

__all__ = ["wire_lines"]


def wire_lines(doc: Any, network: Any, joined: bool) -> list[str]:
    """Lines that make wires of the selected edges of a network; none when it is selected as such.

    Parameters
    ----------
    network : a selected object; of one that is no network no edges are taken
    joined : one wire for each chain of edges; False: one for each edge
    """
    if not is_edge_network(network):
        return []
    (chosen,) = (
        item for item in FreeCADGui.Selection.getSelectionEx(doc.Name) if item.Object is network
    )
    names = [name for name in chosen.SubElementNames if name.startswith("Edge")]
    groups = _chains(network.Shape, names) if joined else [[name] for name in names]
    return [f"document.make_edge_wire(doc, {object_line(network)}, {group!r})" for group in groups]


def _chains(shape: Any, names: list[str]) -> list[list[str]]:
    """Names of edges that follow each other, each chain in the order of selecting."""
    edges = {name: shape.getElement(name) for name in names}
    chains = Part.sortEdges(list(edges.values())) if edges else []
    return [
        [name for name in names if any(edge.isSame(edges[name]) for edge in chain)]
        for chain in sorted(chains, key=lambda chain: _first(chain, edges))
    ]


def _first(chain: list[Any], edges: dict[str, Any]) -> int:
    """When the first edge of a chain was selected."""
    return min(
        number
        for number, edge in enumerate(edges.values())
        if any(edge.isSame(own) for own in chain)
    )
