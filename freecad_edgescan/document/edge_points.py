# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edge points of an object that holds several edges: all of them one after the other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..scanning import ScannedEdge
from .declared_properties import Declared, Role
from .native_curve import vector

__all__ = ["EDGE_POINTS", "write_edge_points"]


def _list(kind: str, name: str, tooltip: str) -> Declared:
    return Declared(kind, name, "Edge points", tooltip, Role.HIDDEN_RESULT)


EDGE_POINTS = (
    _list("VectorList", "Points", "Edge points of all edges, document coordinates"),
    _list("FloatList", "Sigma", "Standard deviation of the edge points, mm"),
    _list("IntegerList", "EdgeNumbers", "Which edge each of them belongs to, from 1"),
    _list("VectorList", "Tangents", "Unit tangents at the edge points"),
    _list("FloatList", "PointAngles", "Angle between the two sides at the edge points, rad"),
    _list("FloatList", "FilletRadii", "Radius of the rounding at the edge points, mm, or nan"),
    _list("FloatList", "FilletSigmas", "Standard deviation of the radii, mm, or nan"),
    _list(
        "BoolList",
        "Supported",
        "False where the point rests on its neighbours: a gap, or too little of a side is smooth",
    ),
)


def write_edge_points(obj: Any, edges: Sequence[ScannedEdge]) -> None:
    """Write what is known of every point of some edges into their object."""
    obj.Points = [vector(point) for edge in edges for point in edge.points]
    obj.Tangents = [vector(tangent) for edge in edges for tangent in edge.tangents]
    for name, of_edge in (
        ("Sigma", "sigma"),
        ("PointAngles", "angle"),
        ("FilletRadii", "fillet_radius"),
        ("FilletSigmas", "fillet_sigma"),
    ):
        values = [np.asarray(getattr(edge, of_edge), dtype=float) for edge in edges]
        setattr(obj, name, np.concatenate(values).tolist())
    obj.Supported = [bool(held) for edge in edges for held in edge.supported]
    obj.EdgeNumbers = [
        number for number, edge in enumerate(edges, start=1) for _ in range(len(edge))
    ]
