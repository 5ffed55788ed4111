# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric network: all edges of a cloud as one object.

The name of this module and of `EdgeNetworkProxy` are written into users' files.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..scanning import EdgeNetwork, Progress, Stop
from ..scanning.automatic import MIN_ANGLE
from ..scanning.edge_choice import EdgeChoice
from .bridge import origin_of
from .cloud_cache import cloud_checksum, point_cloud
from .computed_object import MESSAGE, ORIGIN, ComputedProxy, Task, result
from .computed_shape import write_shape
from .declared_properties import Declared
from .edge_network_shape import network_shape
from .edge_points import EDGE_POINTS, write_edge_points
from .given_numbers import least_angle, length_or_zero, whole_number
from .linked_geometry import require_cloud
from .native_curve import vector
from .network_search import NetworkSearch

__all__ = [
    "EdgeNetworkProxy",
    "change_edge_network",
    "choice_of",
    "make_edge_network",
]


_PROPERTIES = (
    Declared("LinkGlobal", "Cloud", "Network", "The cloud whose edges are sought"),
    Declared("Angle", "MinAngle", "Network", "Least turn between the two sides of an edge"),
    Declared("Distance", "MinLength", "Network", "Of an edge; 0: eight times the cloud's pitch"),
    Declared(
        "Distance", "MaxSigma", "Network", "Edges known worse than that are left out; 0: none"
    ),
    Declared("VectorList", "Dropped", "Network", "A point on each edge that is left out by hand"),
    Declared("VectorList", "Kept", "Network", "A point on each edge that is kept all the same"),
    Declared(
        "Integer", "MostEdges", "Network", "The search ends when it has found so many; 0: all"
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
    *EDGE_POINTS,
)


def make_edge_network(
    doc: Any,
    cloud: Any,
    min_angle: float = MIN_ANGLE,
    min_length: float = 0.0,
    max_sigma: float = 0.0,
    name: str = "EdgeNetwork",
    *,
    dropped: ArrayLike = (),
    kept: ArrayLike = (),
    most_edges: int = 0,
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
    dropped : (k, 3) document coordinates, mm; a point on each edge that is left out besides
    kept : (k, 3) a point on each edge that is kept whatever its length, turn and sigma
    most_edges : the search ends when it has found so many; 0: it finds all

    Returns
    -------
    Part::FeaturePython. Its Shape is a compound of native edges that share their vertices.

    Raises
    ------
    ValueError: something that is no point cloud, or numbers that cannot work; nothing is made.
    """
    require_cloud(cloud)
    choice = _checked(min_angle, min_length, max_sigma, dropped, kept)
    most = whole_number("number of edges at most", most_edges, 0)
    obj = doc.addObject("Part::FeaturePython", name)
    EdgeNetworkProxy(obj)
    obj.Cloud = cloud
    _write_inputs(obj, choice, most)
    return obj


def change_edge_network(
    network: Any,
    min_angle: float = MIN_ANGLE,
    min_length: float = 0.0,
    max_sigma: float = 0.0,
    *,
    dropped: ArrayLike = (),
    kept: ArrayLike = (),
    most_edges: int = 0,
) -> None:
    """Choose edges of a network anew; `doc.recompute()` takes them.

    Parameters
    ----------
    network : made by `make_edge_network`
    others : as there

    Raises
    ------
    ValueError: something that is no network, or numbers that cannot work; nothing is changed.
    """
    if type(getattr(network, "Proxy", None)).__name__ != "EdgeNetworkProxy":
        raise ValueError(
            f"{getattr(network, 'Label', network)!r} is no network of edges; "
            "make one with make_edge_network(doc, cloud)."
        )
    choice = _checked(min_angle, min_length, max_sigma, dropped, kept)
    _write_inputs(network, choice, whole_number("number of edges at most", most_edges, 0))


def choice_of(network: Any) -> EdgeChoice:
    """Which of the edges found a network object keeps.

    Raises
    ------
    ValueError: its properties hold numbers that cannot work.
    """
    return _checked(
        np.radians(network.MinAngle.Value),
        network.MinLength.Value,
        network.MaxSigma.Value,
        _places(network.Dropped),
        _places(network.Kept),
    )


class EdgeNetworkProxy(ComputedProxy):
    """What makes the object look for edges."""

    PROPERTIES = _PROPERTIES

    def depends_on(self, obj: Any) -> Iterable[object]:
        """The cloud, and which edges are wanted."""
        yield cloud_checksum(obj.Cloud)
        yield from (obj.MinAngle.Value, obj.MinLength.Value, obj.MaxSigma.Value)
        yield from (_places(obj.Dropped), _places(obj.Kept), obj.MostEdges)

    def task(self, obj: Any) -> Task:
        """What finds the edges, and takes those that are wanted."""
        cloud, choice = point_cloud(obj.Cloud), choice_of(obj)
        most = whole_number("number of edges at most", obj.MostEdges, 0)

        def find(progress: Progress | None) -> EdgeNetwork:
            search = NetworkSearch.wide_enough(choice, cloud.pitch, most)
            found = search(cloud, progress)
            if not len(found):
                raise ValueError(found.message)
            network = choice.of(found)
            if not len(network):
                raise ValueError(
                    f"None of the {len(found)} edges found is kept: they are shorter, turn less or "
                    "have a larger sigma than wanted, or were dropped by hand. Ask for less."
                )
            return network

        return find

    def write(self, obj: Any, result: EdgeNetwork) -> None:
        """Write the edges and their corners."""
        write_shape(obj, network_shape(result), result.message, origin_of(obj.Cloud))
        obj.EdgeCount, obj.CornerCount = len(result), len(result.corners)
        obj.TotalLength = result.length
        obj.Corners = [vector(corner) for corner in result.corners]
        obj.Misclosures = result.corner_misclosure.tolist()
        obj.Sigmas = [float(np.median(edge.sigma)) for edge in result.edges]
        obj.Angles = [float(np.degrees(np.median(edge.angle))) for edge in result.edges]
        obj.Ends = [f"{_named(start)} to {_named(end)}" for start, end in result.ends]
        write_edge_points(obj, result.edges)


def _named(end: int | Stop) -> str:
    return end.name if isinstance(end, Stop) else f"corner {end + 1}"


def _write_inputs(obj: Any, choice: EdgeChoice, most: int) -> None:
    obj.MinAngle = float(np.degrees(choice.min_angle))
    obj.MinLength = choice.min_length
    obj.MaxSigma = choice.max_sigma if np.isfinite(choice.max_sigma) else 0.0
    obj.Dropped = [vector(place) for place in choice.dropped]
    obj.Kept = [vector(place) for place in choice.kept]
    obj.MostEdges = most


def _checked(
    min_angle: float, min_length: float, max_sigma: float, dropped: ArrayLike, kept: ArrayLike
) -> EdgeChoice:
    return EdgeChoice(
        least_angle(min_angle),
        length_or_zero("least length", min_length),
        length_or_zero("largest sigma", max_sigma) or np.inf,
        _checked_places("dropped", dropped),
        _checked_places("kept", kept),
    )


def _checked_places(what: str, places: ArrayLike) -> np.ndarray:
    rows = np.asarray(places, dtype=np.float64)
    if rows.size == 0:
        return np.zeros((0, 3))
    if rows.ndim != 2 or rows.shape[1] != 3 or not np.isfinite(rows).all():
        raise ValueError(
            f"The places of {what} edges are {rows.tolist()}; give a list of points, three finite "
            "coordinates in mm each."
        )
    return rows


def _places(vectors: Any) -> np.ndarray:
    return np.array([tuple(place) for place in vectors], dtype=np.float64).reshape(-1, 3)
