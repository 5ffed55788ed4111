# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surface a probing ball touched, from the centres of the ball, as a cloud that follows it.

The name of this module and of `CompensatedCloudProxy` are written into users' files.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from ..cloud import PartOfCloud, compensate_cloud
from .bridge import origin_of
from .cloud_cache import cloud_checksum, point_cloud, probe_radius_of
from .computed_cloud import WRITTEN_POINTS, ComputedCloudProxy, write_points
from .computed_object import Task, result
from .declared_properties import Declared
from .linked_geometry import require_cloud

__all__ = ["CompensatedCloudProxy", "make_compensated_cloud", "require_probe"]

_PROPERTIES = (
    Declared("LinkGlobal", "Cloud", "Compensated cloud", "The cloud of centres of a ball"),
    result("Length", "ProbeRadius", "Always 0: the points lie on the part's surface"),
    *WRITTEN_POINTS,
)


def make_compensated_cloud(doc: Any, cloud: Any, name: str = "CompensatedCloud") -> Any:
    """Make the cloud of touched points; `doc.recompute()` finds them.

    Parameters
    ----------
    doc : App.Document
    cloud : Points::Feature with a ProbeRadius above 0
    name : of the object

    Returns
    -------
    Points::FeaturePython.

    Raises
    ------
    ValueError: no cloud, or one without a probe radius.
    """
    require_cloud(cloud)
    require_probe(cloud)
    obj = doc.addObject("Points::FeaturePython", name)
    CompensatedCloudProxy(obj)
    obj.Cloud = cloud
    return obj


class CompensatedCloudProxy(ComputedCloudProxy):
    """What makes the object move the points onto the part."""

    PROPERTIES = _PROPERTIES

    def depends_on(self, obj: Any) -> Iterable[object]:
        """The cloud with its probe."""
        yield cloud_checksum(obj.Cloud)

    def task(self, obj: Any) -> Task:
        """What compensates the points."""
        require_probe(obj.Cloud)
        cloud = point_cloud(obj.Cloud)
        return lambda progress: compensate_cloud(cloud, progress)

    def write(self, obj: Any, result: PartOfCloud) -> None:
        """Write the points."""
        write_points(obj, result.points, result.message, origin_of(obj.Cloud))


def require_probe(cloud: Any) -> None:
    """Refuse a cloud whose points lie on the part already.

    Raises
    ------
    ValueError
    """
    if not probe_radius_of(cloud) > 0.0:
        raise ValueError(
            f"The cloud {cloud.Label!r} has the probe radius 0: its points lie on the part "
            "already. If they are centres of a ball, set its ProbeRadius first."
        )
