# SPDX-License-Identifier: LGPL-2.1-or-later
"""A circular arc as profile between two edges, through the cloud points of a slab between them.

1. A plane across the first rail meets the second one.
2. The cloud points of a slab on that plane, between the rails and away from their roundings, are
   taken into the plane.
3. A circle is fitted to them and corrected by the probe radius; the arc runs from the place
   nearest to the first rail to that nearest to the second.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import FreeCAD
import numpy as np
import Part
from numpy.typing import NDArray

from ..cloud import PointCloud
from ..geometry import Circle, fit_circle
from ..geometry.place_text import place_text
from .cloud_cache import point_cloud
from .given_numbers import positive_length, share_of_rail

__all__ = ["ArcProfile", "fit_arc_profile", "make_arc_profile"]

Array = NDArray[np.float64]

_FEWEST = 8
_SAMPLES = 4001  # along the second rail


@dataclass(frozen=True)
class ArcProfile:
    """An arc across a channel or ridge.

    Attributes
    ----------
    start, middle, end : (3,) points of the arc, mm
    circle : the arc's circle, after the probe radius was taken off
    deviation : standard deviation of the points from the circle, mm
    count : number of cloud points the circle was fitted to
    """

    start: Array
    middle: Array
    end: Array
    circle: Circle
    deviation: float
    count: int


def make_arc_profile(
    doc: Any,
    cloud: Any,
    rails: tuple[Any, Any],
    share: float,
    thickness: float | None = None,
    name: str = "Profile",
) -> Any:
    """Put a circular-arc profile between two edges into a document.

    Parameters
    ----------
    doc : App.Document
    cloud : Points::Feature
    rails : two objects whose Shape is one edge; the plane stands across the first one
    share : where, as a share of the first rail's length, 0 to 1
    thickness : of the slab, mm; None: six cloud pitches
    name : of the object

    Returns
    -------
    Part::Feature whose Shape is one arc.

    Raises
    ------
    ValueError: rails without an edge, a share outside 0 to 1, or too few points in the slab.
    """
    edges = []
    for rail in rails:
        shape = getattr(rail, "Shape", None)
        if shape is None or len(shape.Edges) != 1:
            raise ValueError(
                f"The rail {getattr(rail, 'Label', rail)!r} is not one edge; "
                "recompute the document, or choose a scanned edge."
            )
        edges.append(shape.Edges[0])
    arc = fit_arc_profile(point_cloud(cloud), (edges[0], edges[1]), share, thickness)
    obj = doc.addObject("Part::Feature", name)
    points = [FreeCAD.Vector(*point) for point in (arc.start, arc.middle, arc.end)]
    obj.Shape = Part.Arc(*points).toShape()
    return obj


def fit_arc_profile(
    cloud: PointCloud, rails: tuple[Any, Any], share: float, thickness: float | None = None
) -> ArcProfile:
    """Fit a circular arc between two edges; see `make_arc_profile`.

    Parameters
    ----------
    cloud : PointCloud
    rails : two Part.Edges
    share, thickness : as for `make_arc_profile`
    """
    share = share_of_rail(share)
    slab = 6.0 * cloud.pitch if thickness is None else positive_length("thickness", thickness)
    first, along = _place_on(rails[0], share)
    second = _crossing(rails[1], first, along)
    across = second - first
    width = float(np.linalg.norm(across))
    across /= width
    down = np.cross(along, across)
    plane = np.array([across, down])
    away = cloud.points - first
    flat = away[np.abs(away @ along) <= slab / 2.0] @ plane.T
    margin = 2.0 * cloud.probe_radius + 2.0 * cloud.pitch
    between = flat[(flat[:, 0] > 0.0) & (flat[:, 0] < width)]
    if len(between) and np.median(between[:, 1]) < 0.0:
        down, plane[1], between = -down, -plane[1], between * [1.0, -1.0]
    walls = between[between[:, 1] > margin]
    if len(walls) < _FEWEST:
        raise ValueError(
            f"Only {len(walls)} cloud points lie between the rails within {slab / 2.0:.3g} mm of "
            f"the plane at ({place_text(first)}); give a larger thickness, or "
            "another place."
        )
    fit = fit_circle(np.column_stack([walls, np.zeros(len(walls))]))
    centre = first + fit.circle.centre[:2] @ plane
    radius = fit.circle.radius + _outwards(cloud, centre, first + walls.mean(axis=0) @ plane)
    circle = Circle(centre, along, radius, across)
    ends = [place - centre for place in (first, second)]
    ends = [radius * end / np.linalg.norm(end) for end in ends]
    middle = radius * (down if fit.circle.centre[1] < walls[:, 1].max() else -down)
    return ArcProfile(
        centre + ends[0],
        centre + middle,
        centre + ends[1],
        circle,
        float(np.std(np.linalg.norm(walls - fit.circle.centre[:2], axis=1))),
        len(walls),
    )


def _outwards(cloud: PointCloud, centre: Array, on_arc: Array) -> float:
    """What makes the circle of probe centres the circle of the surface."""
    if cloud.probe_radius == 0.0:
        return 0.0
    if cloud.approach is None:
        raise ValueError(
            f"The cloud holds centres of a probe of {cloud.probe_radius:g} mm radius and does not "
            "say where it came from; set the cloud's Approach."
        )
    is_hollow = float((centre - on_arc) @ cloud.approach) < 0.0
    return cloud.probe_radius if is_hollow else -cloud.probe_radius


def _place_on(rail: Any, share: float) -> tuple[Array, Array]:
    """Point and unit tangent at a share of an edge's length."""
    parameter = rail.getParameterByLength(share * rail.Length)
    tangent = np.array(rail.tangentAt(parameter))
    return np.array(rail.valueAt(parameter)), tangent / np.linalg.norm(tangent)


def _crossing(rail: Any, point: Array, along: Array) -> Array:
    """Where an edge meets the plane through a point, nearest to that point."""
    places = np.array([tuple(place) for place in rail.discretize(_SAMPLES)])
    height = (places - point) @ along
    before = np.flatnonzero(height[:-1] * height[1:] <= 0.0)
    if not len(before):
        raise ValueError(
            f"The plane across the first rail at ({place_text(point)}) does not meet the "
            "second rail; "
            "choose a place where both run side by side."
        )
    step = height[before + 1] - height[before]
    fraction = -height[before] / np.where(step != 0.0, step, 1.0)
    crossings = places[before] + fraction[:, None] * (places[before + 1] - places[before])
    return np.asarray(crossings[np.argmin(np.linalg.norm(crossings - point, axis=1))])
