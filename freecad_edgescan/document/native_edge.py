# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scanned edge as one native edge of FreeCAD: line, circle or B-spline."""

from __future__ import annotations

from typing import Any

import numpy as np
import Part
from numpy.typing import ArrayLike

from ..geometry import Circle, Line
from ..scanning import ScanError, ScannedEdge
from .native_curve import curve_shape, vector

__all__ = ["edge_shape"]


def edge_shape(edge: ScannedEdge) -> Any:
    """Make the native edge of a scan.

    Parameters
    ----------
    edge : ScannedEdge

    Returns
    -------
    Part.Edge: a line, circle or arc where that explains the edge points as well, else a cubic
    B-spline; from vertex to vertex where these are known.

    Raises
    ------
    ScanError: fewer than two edge points.
    """
    if len(edge.points) < 2:
        raise ScanError(
            f"The edge has {len(edge.points)} edge points, too few for a curve. {edge.message}"
        )
    if edge.line is not None:
        return _segment(edge.line, edge.vertex_to_vertex)
    if edge.circle is not None:
        return _arc(edge.circle, edge)
    return curve_shape(edge.curve())


def _segment(line: Line, points: ArrayLike) -> Any:
    along, _ = line.closest(points)
    start, end = line.evaluate(np.array([along[0], along[-1]]))
    return Part.LineSegment(vector(start), vector(end)).toShape()


def _arc(circle: Circle, edge: ScannedEdge) -> Any:
    if edge.closed:
        return Part.Circle(vector(circle.centre), vector(circle.axis), circle.radius).toShape()
    angles = circle.angles(edge.vertex_to_vertex)
    first, last = float(angles[0]), float(angles[-1])
    places = circle.evaluate(np.array([first, (first + last) / 2.0, last]))
    return Part.Arc(*(vector(place) for place in places)).toShape()
