# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric network: all edges of a cloud as one object.

The name of this module and of `EdgeNetworkProxy` are written into users' files.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from ..scanning import EdgeNetwork, Progress, find_edges
from ..scanning.automatic import MIN_ANGLE
from .bridge import origin_of
from .cloud_cache import cloud_checksum, point_cloud
from .computed_object import MESSAGE, ORIGIN, ComputedProxy, Task, result
from .computed_shape import write_shape
from .declared_properties import Declared
from .edge_network_shape import network_shape
from .given_numbers import least_angle, length_or_zero
from .linked_geometry import require_cloud
from .native_curve import vector

__all__ = ["EdgeNetworkProxy", "make_edge_network"]

_PROPERTIES = (
    Declared("LinkGlobal", "Cloud", "Network", "The cloud whose edges are sought"),
    Declared("Angle", "MinAngle", "Network", "Least turn between the two sides of an edge"),
    Declared("Distance", "MinLength", "Network", "Of an edge; 0: eight times the cloud's pitch"),
    Declared(
        "Distance", "MaxSigma", "Network", "Edges known worse than that are left out; 0: none"
    ),
    result("Integer", "EdgeCount", "Number of edges"),
    result("Integer", "CornerCount", "Number of corners in which edges meet"),
    result("Length", "TotalLength", "Of all edges"),
    result("VectorList", "Corners", "Where edges meet"),
    result("FloatList", "Misclosures", "How far the edges' own vertices are from each corner, mm"),
    result("FloatList", "Sigmas", "Median standard deviation of each edge, mm"),
    result("FloatList", "Angles", "Median angle between the two sides of each edge, degrees"),
    result("StringList", "Ends", "Of each edge: the corners it ends in, or why it ends"),
    MESSAGE,
    ORIGIN,
)


def make_edge_network(
    doc: Any,
    cloud: Any,
    min_angle: float = MIN_ANGLE,
    min_length: float = 0.0,
    max_sigma: float = 0.0,
    name: str = "EdgeNetwork",
) -> Any:
    """Make the network of all edges of a cloud; `doc.recompute()` finds them.

    Parameters
    ----------
    doc : App.Document
    cloud : Points::Feature in it
    min_angle : least turn between the two sides of an edge, rad
    min_length : of an edge, mm; 0: eight times the cloud's pitch
    max_sigma : mm; edges whose median standard deviation is larger are left out; 0: none is
    name : of the object

    Returns
    -------
    Part::FeaturePython. Its Shape is a compound of native edges that share their vertices.

    Raises
    ------
    ValueError: something that is no point cloud, or numbers that cannot work; nothing is made.
    """
    require_cloud(cloud)
    min_angle = least_angle(min_angle)
    min_length = length_or_zero("least length", min_length)
    max_sigma = length_or_zero("largest sigma", max_sigma)
    obj = doc.addObject("Part::FeaturePython", name)
    EdgeNetworkProxy(obj)
    obj.Cloud = cloud
    obj.MinAngle = float(np.degrees(min_angle))
    obj.MinLength, obj.MaxSigma = min_length, max_sigma
    return obj


class EdgeNetworkProxy(ComputedProxy):
    """What makes the object look for edges."""

    PROPERTIES = _PROPERTIES

    def depends_on(self, obj: Any) -> Iterable[object]:
        """The cloud, and which edges are wanted."""
        yield cloud_checksum(obj.Cloud)
        yield from (obj.MinAngle.Value, obj.MinLength.Value, obj.MaxSigma.Value)

    def task(self, obj: Any) -> Task:
        """What finds the edges."""
        cloud, angle = point_cloud(obj.Cloud), least_angle(np.radians(obj.MinAngle.Value))
        shortest = length_or_zero("least length", obj.MinLength.Value) or None
        worst = length_or_zero("largest sigma", obj.MaxSigma.Value)

        def find(progress: Progress | None) -> EdgeNetwork:
            network = find_edges(cloud, angle, shortest, progress)
            network = network.filtered(max_sigma=worst) if worst else network
            if not len(network):
                raise ValueError(network.message)
            return network

        return find

    def write(self, obj: Any, result: EdgeNetwork) -> None:
        """Write the edges and their corners."""
        shape = network_shape(result)
        write_shape(obj, shape, result.message, origin_of(obj.Cloud))
        obj.EdgeCount, obj.CornerCount = len(result), len(result.corners)
        obj.TotalLength = result.length
        obj.Corners = [vector(corner) for corner in result.corners]
        obj.Misclosures = result.corner_misclosure.tolist()
        obj.Sigmas = [float(np.median(edge.sigma)) for edge in result.edges]
        obj.Angles = [float(np.degrees(np.median(edge.angle))) for edge in result.edges]
        obj.Ends = [f"{start} to {end}" for start, end in result.ends]
