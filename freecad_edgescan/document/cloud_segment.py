# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of a cloud near a base surface, as a cloud of its own that follows both.

The name of this module and of `CloudSegmentProxy` are written into users' files.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from .bridge import origin_of
from .cloud_cache import cloud_checksum
from .computed_cloud import WRITTEN_POINTS, ComputedCloudProxy, write_points
from .computed_object import Task, result
from .declared_properties import Declared
from .given_numbers import positive_length
from .linked_geometry import linked_surface, require_cloud, require_shape
from .points_near_base import points_near_base

__all__ = ["CloudSegmentProxy", "make_cloud_segment"]

_PROPERTIES = (
    Declared("LinkGlobal", "Cloud", "Segment", "The cloud of which this is a part"),
    Declared("LinkGlobal", "Base", "Segment", "Surface near the points, such as a swept surface"),
    Declared("Distance", "Distance", "Segment", "Of the surface from the base surface, at most"),
    result("Length", "ProbeRadius", "Always 0: the points lie on the part's surface"),
    *WRITTEN_POINTS,
)


def make_cloud_segment(
    doc: Any, cloud: Any, base: Any, distance: float = 3.0, name: str = "CloudSegment"
) -> Any:
    """Make a cloud of the points near a base surface; `doc.recompute()` finds them.

    Parameters
    ----------
    doc : App.Document
    cloud : Points::Feature
    base : object whose Shape is one face
    distance : mm, from the base surface
    name : of the object

    Returns
    -------
    Points::FeaturePython. Its points lie on the part also when the cloud holds centres of a
    probe, and those where the probe rolled over the base surface's rim are left out.

    Raises
    ------
    ValueError: no cloud, a base without a shape, or a distance that is not positive.
    """
    require_cloud(cloud)
    require_shape("base surface", [base])
    distance = positive_length("distance", distance)
    obj = doc.addObject("Points::FeaturePython", name)
    CloudSegmentProxy(obj)
    obj.Cloud, obj.Base, obj.Distance = cloud, base, distance
    return obj


class CloudSegmentProxy(ComputedCloudProxy):
    """What makes the object cut its cloud."""

    PROPERTIES = _PROPERTIES

    def depends_on(self, obj: Any) -> Iterable[object]:
        """Cloud, base surface and distance."""
        yield linked_surface(obj.Base, "base surface")
        yield cloud_checksum(obj.Cloud)
        yield obj.Distance.Value

    def task(self, obj: Any) -> Task:
        """What finds the points (n, 3), document coordinates."""
        base = linked_surface(obj.Base, "base surface")
        near = points_near_base(obj.Cloud, obj.Distance.Value)
        return lambda progress: near(base, progress)

    def write(self, obj: Any, result: Any) -> None:
        """Write the points."""
        write_points(obj, result, "", origin_of(obj.Cloud))
