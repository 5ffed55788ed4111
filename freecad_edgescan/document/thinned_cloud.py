# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fewer points of a cloud, evenly spread, as a cloud of its own that follows it.

The name of this module and of `ThinnedCloudProxy` are written into users' files.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from ..cloud import PartOfCloud, thin_cloud
from .bridge import origin_of
from .cloud_cache import cloud_checksum, point_cloud
from .computed_cloud import WRITTEN_POINTS, ComputedCloudProxy, write_points
from .computed_object import Task, result
from .declared_properties import Declared
from .given_numbers import positive_length
from .linked_geometry import require_cloud

__all__ = ["ThinnedCloudProxy", "make_thinned_cloud"]

_PROPERTIES = (
    Declared("LinkGlobal", "Cloud", "Thinned cloud", "The cloud of which this is a part"),
    Declared(
        "Distance",
        "Pitch",
        "Thinned cloud",
        "1 / √(points per mm²) of what remains, where the cloud is denser",
    ),
    result("Length", "ProbeRadius", "Radius of the ball whose centres the points are"),
    result("Vector", "Approach", "Direction the probe came along; (0, 0, 0): not known"),
    *WRITTEN_POINTS,
)


def make_thinned_cloud(doc: Any, cloud: Any, pitch: float, name: str = "ThinnedCloud") -> Any:
    """Make a thinner cloud; `doc.recompute()` thins it.

    Parameters
    ----------
    doc : App.Document
    cloud : Points::Feature
    pitch : mm, 1 / √(points per mm²) of what remains
    name : of the object

    Returns
    -------
    Points::FeaturePython.

    Raises
    ------
    ValueError: no cloud, or a pitch that is not positive.
    """
    require_cloud(cloud)
    pitch = positive_length("pitch", pitch)
    obj = doc.addObject("Points::FeaturePython", name)
    ThinnedCloudProxy(obj)
    obj.Cloud, obj.Pitch = cloud, pitch
    return obj


class ThinnedCloudProxy(ComputedCloudProxy):
    """What makes the object thin its cloud."""

    PROPERTIES = _PROPERTIES

    def depends_on(self, obj: Any) -> Iterable[object]:
        """Cloud and pitch."""
        yield cloud_checksum(obj.Cloud)
        yield obj.Pitch.Value

    def task(self, obj: Any) -> Task:
        """What thins the cloud."""
        cloud, pitch = point_cloud(obj.Cloud), positive_length("pitch", obj.Pitch.Value)
        return lambda progress: thin_cloud(cloud, pitch, progress)

    def write(self, obj: Any, result: PartOfCloud) -> None:
        """Write points and probe."""
        approach = result.approach
        obj.ProbeRadius = result.probe_radius
        obj.Approach = (0.0, 0.0, 0.0) if approach is None else tuple(approach.tolist())
        write_points(obj, result.points, result.message, origin_of(obj.Cloud))
