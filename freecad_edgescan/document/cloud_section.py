# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric section: the profile of a cloud across a rail, as one native edge.

The name of this module and of `CloudSectionProxy` are written into users' files.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import Part

from ..cloud import PointCloud, compensate_cloud
from ..geometry import BSplineCurve, Circle
from ..geometry.place_text import place_text
from ..scanning import Progress
from ..surfacing import CrossSection, cross_section
from .bridge import origin_of
from .cloud_cache import cloud_checksum, point_cloud
from .computed_object import MESSAGE, ORIGIN, ComputedProxy, Task, result
from .computed_shape import write_shape
from .declared_properties import Declared
from .given_numbers import length_or_zero, share_of_rail
from .linked_geometry import linked_curve, require_cloud, require_shape
from .native_curve import curve_shape, vector

__all__ = ["CloudSectionProxy", "make_cloud_section"]

AUTOMATIC = "automatic"
KINDS = (AUTOMATIC, "line", "arc", "spline")

_PITCHES = 40.0  # reach of a section that is not told how far to go
_ROOM = 20.0  # pitches round it that compensation looks at

_PROPERTIES = (
    Declared("LinkGlobal", "Cloud", "Section", "The cloud that is cut"),
    Declared("LinkGlobal", "Rail", "Section", "The edge across which it is cut"),
    Declared(
        "LinkGlobal", "Towards", "Section", "Another rail: the profile runs from rail to rail"
    ),
    Declared("Float", "Share", "Section", "Where: share of the rail's length, 0 to 1"),
    Declared(
        "Distance", "Reach", "Section", "How far from the rail the section goes; 0: automatic"
    ),
    Declared("Distance", "Thickness", "Section", "Of the slab of points; 0: automatic"),
    Declared("Enumeration", "Kind", "Section", "What is fitted to the points", choices=KINDS),
    result("String", "KindUsed", "What was fitted: line, arc or spline"),
    result("Length", "Radius", "Radius of an arc; 0: it is none"),
    result("Length", "Average", "Mean absolute deviation of the points from the profile"),
    result("Length", "Maximum", "Largest absolute deviation of a point from the profile"),
    result("Integer", "PointCount", "Number of points of the section"),
    MESSAGE,
    ORIGIN,
)


def make_cloud_section(
    doc: Any,
    cloud: Any,
    rail: Any,
    share: float = 0.5,
    towards: Any = None,
    kind: str = AUTOMATIC,
    reach: float = 0.0,
    thickness: float = 0.0,
    name: str = "CloudSection",
) -> Any:
    """Make the profile of a cloud across a rail; `doc.recompute()` measures it.

    Parameters
    ----------
    doc : App.Document
    cloud : Points::Feature; of centres of a probe the touched points are taken
    rail : object whose edges form a curve, such as a scanned edge
    share : where, as a share of the rail's length, 0 to 1
    towards : another rail, at which the profile ends; None: it goes to both sides of the rail
    kind : "line", "arc", "spline", or "automatic": the simplest that explains the points
    reach : mm, how far from the rail; 0: to the other rail, or 40 cloud pitches
    thickness : mm, of the slab whose points are taken; 0: automatic
    name : of the object

    Returns
    -------
    Part::FeaturePython whose Shape is one line, arc or B-spline.

    Raises
    ------
    ValueError: no cloud, rails without a shape, an unknown kind, or numbers that cannot work.
    """
    require_cloud(cloud)
    require_shape("rail", [rail] if towards is None else [rail, towards])
    if kind not in KINDS:
        raise ValueError(f"There is no profile of the kind {kind!r}; choose {', '.join(KINDS)}.")
    share, reach = share_of_rail(share), length_or_zero("reach", reach)
    thickness = length_or_zero("thickness", thickness)
    obj = doc.addObject("Part::FeaturePython", name)
    CloudSectionProxy(obj)
    obj.Cloud, obj.Rail, obj.Towards = cloud, rail, towards
    obj.Share, obj.Kind = share, str(kind)
    obj.Reach, obj.Thickness = reach, thickness
    return obj


class CloudSectionProxy(ComputedProxy):
    """What makes the object cut and fit."""

    PROPERTIES = _PROPERTIES

    def depends_on(self, obj: Any) -> Iterable[object]:
        """Cloud, rails, place, and what is fitted."""
        yield cloud_checksum(obj.Cloud)
        yield linked_curve(obj.Rail, "rail")
        yield None if obj.Towards is None else linked_curve(obj.Towards, "rail")
        yield from (obj.Share, obj.Kind, obj.Reach.Value, obj.Thickness.Value)

    def task(self, obj: Any) -> Task:
        """What cuts the cloud and fits the profile."""
        cloud = point_cloud(obj.Cloud)
        rail = linked_curve(obj.Rail, "rail")
        towards = None if obj.Towards is None else linked_curve(obj.Towards, "rail")
        share, reach = share_of_rail(obj.Share), length_or_zero("reach", obj.Reach.Value)
        thickness = length_or_zero("thickness", obj.Thickness.Value)
        kind = None if obj.Kind == AUTOMATIC else obj.Kind

        def cut(progress: Progress | None) -> CrossSection:
            points = _surface_points(cloud, rail, towards, share, reach, progress)
            return cross_section(
                points, rail, share, towards, reach or None, thickness or None, kind
            )

        return cut

    def write(self, obj: Any, result: CrossSection) -> None:
        """Write the profile."""
        section = result
        shape = _edge(section)
        write_shape(obj, shape, section.message, origin_of(obj.Cloud))
        obj.KindUsed = str(section.kind.value)
        circle = section.primitive
        obj.Radius = float(circle.radius) if isinstance(circle, Circle) else 0.0
        obj.Average, obj.Maximum = section.average, section.maximum
        obj.PointCount = len(section.points)


def _surface_points(
    cloud: PointCloud,
    rail: BSplineCurve,
    towards: BSplineCurve | None,
    share: float,
    reach: float,
    progress: Progress | None,
) -> PointCloud:
    """The points of the part near the section; of centres of a probe only those are compensated."""
    if cloud.probe_radius == 0.0:
        return cloud
    at = rail.parameters_at_length(np.array([share * rail.length()]))
    place = rail.evaluate(at)
    width = 0.0 if towards is None else 1.5 * float(towards.closest(place)[1][0])
    radius = max(reach, width, _PITCHES * cloud.pitch) + _ROOM * cloud.pitch
    rows = cloud.tree.query_ball_point(place[0], radius + 2.0 * cloud.probe_radius)
    if not len(rows):
        where = place_text(place[0])
        raise ValueError(f"The cloud has no point near ({where}); choose another place.")
    near = PointCloud(cloud.points[rows], cloud.probe_radius, cloud.approach)
    return compensate_cloud(near, progress)


def _edge(section: CrossSection) -> Any:
    """The native edge of a profile."""
    first, last = section.curve.parameter_range
    if section.kind == "spline":
        return curve_shape(section.curve)
    places = section.curve.evaluate(np.array([first, (first + last) / 2.0, last]))
    start, middle, end = (vector(place) for place in places)
    if section.kind == "line":
        return Part.LineSegment(start, end).toShape()
    return Part.Arc(start, middle, end).toShape()
