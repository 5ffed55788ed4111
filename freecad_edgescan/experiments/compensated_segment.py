# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of a cloud near a base surface, moved from the probe's centres onto the part."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..cloud import PartOfCloud, PointCloud, compensate_cloud
from ..geometry import BSplineSurface

__all__ = ["compensated_segment"]

Array = NDArray[np.float64]

_FACING = 0.5  # least cosine of the angle between the normals of a point and of its foot
_ROOM = 5.0  # pitches round the segment that compensation looks at


def compensated_segment(
    cloud: PointCloud,
    base: BSplineSurface,
    distance: float,
    compensated: PartOfCloud | None = None,
) -> Array:
    """Points (n, 3) mm of the part's surface near a base surface.

    Points whose foot is on the base surface's rim are left out, and, of a cloud of probe centres,
    those that face elsewhere: on the surface beyond the rim, or on the far side of a thin wall.

    Parameters
    ----------
    cloud : PointCloud
    base : BSplineSurface
    distance : mm, from the base surface
    compensated : what `compensate_cloud` makes of the cloud, when it is there already
    """
    corners = base.poles.reshape(-1, 3)
    reach = distance + cloud.probe_radius
    if compensated is None:
        room = 0.0 if cloud.probe_radius == 0.0 else 2 * cloud.probe_radius + _ROOM * cloud.pitch
        rows = _within(cloud.points, corners, reach + room)
        if not rows.any():
            return np.zeros((0, 3))
        cloud = PointCloud(cloud.points[rows], cloud.probe_radius, cloud.approach)
        compensated = compensate_cloud(cloud)
    rows = _within(compensated.points, corners, distance)
    points = compensated.points[rows]
    if not len(points):
        return points
    u, v, off = base.closest(points)
    inner = off < distance
    for x, (first, last) in zip((u, v), base.parameter_range, strict=True):
        inner &= (x > first) & (x < last)
    if cloud.probe_radius > 0.0 and inner.any():
        outwards = cloud.points[compensated.kept][rows] - points
        facing = np.einsum("mi,mi->m", outwards, base.normal(u, v))
        inner &= facing * np.sign(np.median(facing[inner])) > _FACING * cloud.probe_radius
    return points[inner]


def _within(points: Array, corners: Array, room: float) -> NDArray[np.bool_]:
    """Points in the box round some corners, or nearer to it than some room."""
    low, high = corners.min(axis=0) - room, corners.max(axis=0) + room
    return np.asarray(((points > low) & (points < high)).all(axis=1))
