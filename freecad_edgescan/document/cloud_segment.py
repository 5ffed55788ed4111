# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of a cloud near a base surface, or between edges, as a cloud of its own.

The name of this module and of `CloudSegmentProxy` are written into users' files.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..scanning import EdgeNetwork, Progress
from ..scanning.region_at import region_at
from .bridge import origin_of
from .cloud_cache import cloud_checksum, probe_radius_of
from .computed_cloud import WRITTEN_POINTS, ComputedCloudProxy, write_points
from .computed_object import Task, result
from .declared_properties import Declared
from .file_coordinates import refuse_file_coordinates
from .given_numbers import positive_length
from .linked_geometry import linked_surface, require_cloud, require_shape
from .native_curve import vector
from .points_near_base import points_near_base
from .scan_inputs import checked_point

__all__ = ["CloudSegmentProxy", "make_cloud_segment", "region_task"]

_PROPERTIES = (
    Declared("LinkGlobal", "Cloud", "Segment", "The cloud of which this is a part"),
    Declared("LinkGlobal", "Base", "Segment", "Surface near the points, or a network of edges"),
    Declared("Distance", "Distance", "Segment", "Of the surface from the base surface, at most"),
    Declared("Vector", "Inside", "Segment", "A place on the face between the network's edges"),
    result("Length", "ProbeRadius", "Always 0: the points lie on the part's surface"),
    *WRITTEN_POINTS,
)


def make_cloud_segment(
    doc: Any,
    cloud: Any,
    base: Any,
    distance: float = 3.0,
    name: str = "CloudSegment",
    *,
    inside: ArrayLike | None = None,
) -> Any:
    """Make a cloud of the points near a base surface, or of one face between edges.

    `doc.recompute()` finds them.

    Parameters
    ----------
    doc : App.Document
    cloud : Points::Feature
    base : object whose Shape is one face; or the network of the cloud's edges
    distance : mm, from the base surface
    name : of the object
    inside : (3,) document coordinates, mm; a place on the face between the network's edges

    Returns
    -------
    Points::FeaturePython. Its points lie on the part also when the cloud holds centres of a
    probe, and those where the probe rolled over the base surface's rim are left out.

    Raises
    ------
    ValueError: no cloud, a base without a shape, a distance that is not positive, or a place
        without the network that it goes with.
    """
    require_cloud(cloud)
    require_shape("base surface", [base])
    distance = positive_length("distance", distance)
    place = None if inside is None else checked_point("place inside", inside)
    refuse_file_coordinates(cloud, place)
    if (place is not None) is not _is_network(base):
        raise ValueError(
            "A place inside goes with a network of edges, and a network with a place inside: give "
            "both, or a surface."
        )
    if _is_network(base) and base.Cloud is not cloud:
        raise ValueError(
            f"The edges of {base.Label!r} are not those of {cloud.Label!r}; give the cloud in "
            "which they were found."
        )
    obj = doc.addObject("Points::FeaturePython", name)
    CloudSegmentProxy(obj)
    obj.Cloud, obj.Base, obj.Distance = cloud, base, distance
    if place is not None:
        obj.Inside = vector(place)
    return obj


class CloudSegmentProxy(ComputedCloudProxy):
    """What makes the object cut its cloud."""

    PROPERTIES = _PROPERTIES

    def depends_on(self, obj: Any) -> Iterable[object]:
        """Cloud, base surface and distance; or the network and the place between its edges."""
        if _is_network(obj.Base):
            yield from obj.Base.Proxy.depends_on(obj.Base)
            yield np.array(obj.Inside, dtype=np.float64)
            return
        yield linked_surface(obj.Base, "base surface")
        yield cloud_checksum(obj.Cloud)
        yield obj.Distance.Value

    def task(self, obj: Any) -> Task:
        """What finds the points (n, 3), document coordinates."""
        if _is_network(obj.Base):
            return region_task(obj.Base, obj.Inside)
        base = linked_surface(obj.Base, "base surface")
        near = points_near_base(obj.Cloud, obj.Distance.Value)
        return lambda progress: near(base, progress)

    def write(self, obj: Any, result: Any) -> None:
        """Write the points."""
        write_points(obj, result, "", origin_of(obj.Cloud))


def region_task(network: Any, inside: Any) -> Task:
    """What finds the points (n, 3) of the face at a place between the edges of a network object.

    Raises
    ------
    ValueError: the network cannot be found, or its cloud holds centres of a probe.
    """
    if probe_radius_of(network.Cloud) > 0.0:
        raise ValueError(
            f"{network.Cloud.Label!r} holds centres of a probe, which are not on the part's faces. "
            "Compensate the cloud, and find the edges of that one."
        )
    find, place = network.Proxy.task(network), np.array(inside, dtype=np.float64)

    def points(progress: Progress | None) -> np.ndarray:
        found: EdgeNetwork = find(progress)
        return found.cloud.points[region_at(found, place).mask]

    return points


def _is_network(base: Any) -> bool:
    return type(getattr(base, "Proxy", None)).__name__ == "EdgeNetworkProxy"
