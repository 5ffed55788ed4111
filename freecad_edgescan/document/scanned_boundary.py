# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric boundary: all edges round one face, as one object of native edges.

The name of this module and of `ScannedBoundaryProxy` are written into users' files.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
import Part
from numpy.typing import ArrayLike, NDArray

from ..scanning import ScannedEdge, scan_boundary
from ..scanning.automatic import MIN_ANGLE
from .bridge import origin_of
from .cloud_cache import cloud_checksum, point_cloud
from .computed_object import MESSAGE, ORIGIN, ComputedProxy, Task, result
from .computed_shape import write_shape
from .declared_properties import Declared
from .edge_points import EDGE_POINTS, write_edge_points
from .file_coordinates import refuse_file_coordinates
from .given_numbers import least_angle
from .linked_geometry import require_cloud
from .native_curve import vector
from .native_edge import edge_shape
from .scan_inputs import checked_point

__all__ = [
    "ScannedBoundaryProxy",
    "is_closed",
    "make_scanned_boundary",
]


_PROPERTIES = (
    Declared("LinkGlobal", "Cloud", "Boundary", "The cloud that is scanned"),
    Declared("Vector", "At", "Boundary", "A place near one of the edges"),
    Declared("Vector", "Inside", "Boundary", "A place on the face, beside that edge"),
    Declared("Angle", "MinAngle", "Boundary", "Least turn between two sides; 0: automatic"),
    result("Integer", "EdgeCount", "Number of edges"),
    result("Length", "Length", "Length of all edges"),
    result("Length", "MeanSigma", "Mean standard deviation of the edge points"),
    result("Length", "LargestSigma", "Largest standard deviation of an edge point"),
    result("StringList", "Stops", "Why the first edge begins and the last one ends"),
    MESSAGE,
    ORIGIN,
    *EDGE_POINTS,
)


def make_scanned_boundary(
    doc: Any, cloud: Any, at: ArrayLike, inside: ArrayLike, name: str = "ScannedBoundary"
) -> Any:
    """Make all edges round one face; `doc.recompute()` scans them.

    Parameters
    ----------
    doc : App.Document
    cloud : Points::Feature
    at : (3,) a place near one of the edges, document coordinates, mm
    inside : (3,) a place on the face
    name : of the object

    Returns
    -------
    Part::FeaturePython whose Shape holds one native edge for each, in order.

    Raises
    ------
    ValueError: no cloud, or places that are no three finite numbers.
    """
    require_cloud(cloud)
    places = _places(at, inside)
    refuse_file_coordinates(cloud, *places)
    obj = doc.addObject("Part::FeaturePython", name)
    ScannedBoundaryProxy(obj)
    obj.Cloud = cloud
    obj.At, obj.Inside = (vector(place) for place in places)
    return obj


class ScannedBoundaryProxy(ComputedProxy):
    """What makes the object scan."""

    PROPERTIES = _PROPERTIES

    def depends_on(self, obj: Any) -> Iterable[object]:
        """Cloud and places."""
        yield cloud_checksum(obj.Cloud)
        yield np.array([obj.At, obj.Inside], dtype=float)
        yield obj.MinAngle.Value

    def task(self, obj: Any) -> Task:
        """What scans the edges."""
        cloud, at, inside = point_cloud(obj.Cloud), *_places(tuple(obj.At), tuple(obj.Inside))
        angle = least_angle(np.radians(obj.MinAngle.Value)) if obj.MinAngle.Value else MIN_ANGLE
        return lambda progress: scan_boundary(cloud, at, inside, min_angle=angle, progress=progress)

    def write(self, obj: Any, result: Sequence[ScannedEdge]) -> None:
        """Write the edges in order."""
        shapes = [edge_shape(edge) for edge in result if len(edge.points) >= 2]
        shape = Part.Compound(shapes)
        sigma = np.concatenate([edge.sigma for edge in result])
        write_edge_points(obj, result)
        obj.EdgeCount, obj.Length = len(shapes), float(sum(own.Length for own in shapes))
        obj.MeanSigma, obj.LargestSigma = float(sigma.mean()), float(sigma.max())
        obj.Stops = [result[0].stops[0].name, result[-1].stops[1].name]
        if is_closed(result):
            one = len(result) == 1
            message = (
                f"{len(result)} edge{'' if one else 's'}, which close{'s' * one} round the face."
            )
        else:
            message = " ".join(dict.fromkeys(edge.message for edge in (result[0], result[-1])))
        write_shape(obj, shape, message, origin_of(obj.Cloud))


def _places(at: ArrayLike, inside: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    return checked_point("place near the edge", at), checked_point("place inside", inside)


def is_closed(edges: Sequence[ScannedEdge]) -> bool:
    """Whether edges in order end where they begin: one loop, or a vertex shared by the last."""
    first, last = edges[0].vertices[0], edges[-1].vertices[1]
    if edges[0].closed:
        return True
    return first is not None and last is not None and bool(np.allclose(first[0], last[0]))
