# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of a cloud near a base surface, moved from the probe's centres onto the part."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..cloud import PartOfCloud, PointCloud, compensate_cloud
from ..cloud.progress import Progress, Stage
from ..geometry import BSplineSurface
from .segmentation import segment_cloud

__all__ = ["compensated_segment"]

Array = NDArray[np.float64]

_STEEPEST = np.pi / 3  # rad, most by which the cloud may be inclined to the base surface
_ROLLED = 3.0  # standard deviations of the noise, from the rim of the surface
_ROOM = 5.0  # pitches round the segment that compensation looks at


def compensated_segment(
    cloud: PointCloud,
    base: BSplineSurface,
    distance: float,
    compensated: PartOfCloud | None = None,
    progress: Progress | None = None,
) -> Array:
    """Points (n, 3) mm of the part's surface near a base surface.

    Points whose foot is on the base surface's rim are left out, those on other sides of its edges,
    and, of a cloud of probe centres, those on the far side of a thin wall.

    Parameters
    ----------
    cloud : PointCloud
    base : BSplineSurface
    distance : mm, from the base surface
    compensated : what `compensate_cloud` makes of the cloud, when it is there already
    progress : told the share that is done; where it answers False the points so far are the result

    Raises
    ------
    ValueError: no point is that near, or the cloud cannot be compensated.
    """
    corners = base.poles.reshape(-1, 3)
    reach = distance + cloud.probe_radius
    if compensated is None:
        room = 0.0 if cloud.probe_radius == 0.0 else 2 * cloud.probe_radius + _ROOM * cloud.pitch
        near = _within(cloud.points, corners, reach + room)
        if not near.any():
            return np.zeros((0, 3))
        cloud = PointCloud(cloud.points[near], cloud.probe_radius, cloud.approach)
        compensated = compensate_cloud(cloud, Stage(progress, 0.0, 0.5))
    rest = Stage(progress, 0.5, 1.0)
    rows = np.flatnonzero(segment_cloud(compensated, base, distance, _STEEPEST, rest))
    points = compensated.points[rows]
    u, v, _ = base.closest(points)
    # Where the ball began to roll over the rim, its direction is between those of both surfaces.
    inner = _off_the_rim(base, u, v, _ROLLED * cloud.noise if cloud.probe_radius else 0.0)
    if cloud.probe_radius > 0.0 and inner.any():
        outwards = cloud.points[compensated.kept][rows] - points
        facing = np.einsum("mi,mi->m", outwards, base.normal(u, v))
        inner &= facing * np.median(facing[inner]) > 0.0
    return np.asarray(points[inner])


def _within(points: Array, corners: Array, room: float) -> NDArray[np.bool_]:
    """Points in the box round some corners, or nearer to it than some room."""
    low, high = corners.min(axis=0) - room, corners.max(axis=0) + room
    return np.asarray(((points > low) & (points < high)).all(axis=1))


def _off_the_rim(base: BSplineSurface, u: Array, v: Array, room: float) -> NDArray[np.bool_]:
    """Whether feet (n,) are inside a surface's rim and farther from it than some room, (n,)."""
    feet, inner = base.evaluate(u, v), np.ones(len(u), dtype=bool)
    for axis, closed in enumerate(base.closed):
        for end in () if closed else base.parameter_range[axis]:
            at = [u, v]
            # What projects beyond the rim has its foot just there.
            inner &= at[axis] != end
            at[axis] = np.full(len(u), end)
            inner &= np.linalg.norm(base.evaluate(*at) - feet, axis=1) >= room
    return inner
