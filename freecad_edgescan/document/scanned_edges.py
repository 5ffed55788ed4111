# SPDX-License-Identifier: LGPL-2.1-or-later
"""Several scanned edges in a group, each of which can be edited by itself."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from numpy.typing import ArrayLike

from .linked_geometry import require_cloud
from .scanned_edge import make_scanned_edge

__all__ = ["make_scanned_edges"]


def make_scanned_edges(doc: Any, cloud: Any, at: Sequence[ArrayLike], name: str = "Edges") -> Any:
    """Make scanned edges in a group; `doc.recompute()` scans them.

    Parameters
    ----------
    doc : App.Document
    cloud : Points::Feature in it
    at : (3,) each, document coordinates, mm; a point near each edge, which is followed
        both ways until it ends
    name : of the group

    Returns
    -------
    App::DocumentObjectGroup

    Raises
    ------
    ValueError: something that is no point cloud, or places that are no points; nothing is made.
    """
    require_cloud(cloud)
    places = list(at)
    if not places:
        raise ValueError("No place was given; give a point near each of the edges.")
    edges: list[Any] = []
    try:
        for place in places:
            edges.append(make_scanned_edge(doc, cloud, at=place))
    except ValueError:
        for edge in edges:
            doc.removeObject(edge.Name)
        raise
    group = doc.addObject("App::DocumentObjectGroup", name)
    group.Group = edges
    return group
