# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface points from the centres of a probing ball.

1. Quadrics through neighbourhoods all over the cloud give the local normals. A point takes the
   nearest quadric that the points around follow and that holds the point itself, so that normals
   beside an edge are those of the point's own side. A point that belongs to none is left out.
2. Each point moves by the probe's radius along its normal, away from the air.
3. The part is nowhere inside the ball. Centres of a ball that rolled over a rim would, with the
   normal of the side beside it, leave points that are; and those that follow the ball's own bend
   all end on the rim itself. Both are left out.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from ..geometry.plain_number import plain
from .air_side import air_signs
from .local_normals import AT_ONCE, cloud_quadrics, normals_held, scatter_of
from .local_quadrics import LocalQuadrics
from .part_of_cloud import PartOfCloud
from .point_cloud import FEWEST_POINTS, PointCloud, require_surface
from .progress import Progress, Stage

__all__ = ["compensate_cloud"]

Array = NDArray[np.float64]

_INSIDE = 5.0  # of the noise: how far a surface point may seem inside the ball
_INSIDE_SHARE = 0.04  # likewise, of the probe's radius
_SHARP = 0.7  # of the ball's curvature: where the cloud bends more, the ball rolled over a rim


def compensate_cloud(cloud: PointCloud, progress: Progress | None = None) -> PartOfCloud:
    """The points of the surface that a ball touched, from the ball's centres.

    Parameters
    ----------
    cloud : PointCloud
        With a probe radius. Without one its points are on the surface already, and all are kept.
    progress : object with ``update(fraction, so_far) -> bool``, optional
        Told the share that is done; when it answers False the points compensated so far are the
        result, and its message says so.

    Returns
    -------
    PartOfCloud with the probe radius 0. Its ``kept`` (n,) bool tells which points of the cloud it
    holds, in their order: those where the surface is smooth, not those of the probe rolling over a
    rim nor those that are off the surface.

    Raises
    ------
    ValueError: a cloud that has no surface; no approach, and no rim that tells where the air is; a
        probe radius that nothing in the cloud agrees with; cancelled before any point was done.
    """
    radius = cloud.probe_radius
    everything = np.ones(len(cloud), dtype=bool)
    if radius == 0.0:
        return PartOfCloud(cloud.points, everything, 0.0, cloud.approach)
    if len(cloud) < FEWEST_POINTS:
        require_surface(cloud)
    pitch, noise = cloud.pitch, cloud.noise
    if not np.isfinite(pitch):
        require_surface(cloud)
    stages = Stage(progress, 0.0, 0.7), Stage(progress, 0.7, 0.9), Stage(progress, 0.9, 1.0)
    quadrics = cloud_quadrics(cloud, _reach(pitch, noise, radius), progress=stages[0])
    good = quadrics.smooth(pitch, noise)
    signs = air_signs(quadrics, good, radius, cloud.approach)
    normals = _normals(cloud, quadrics, good, signs, stages[1])
    kept = np.isfinite(normals[:, 0])
    surface = cloud.points[kept] - radius * normals[kept]
    clear = _outside_the_ball(
        surface, cloud.tree, radius - max(_INSIDE * noise, _INSIDE_SHARE * radius), stages[2]
    )
    kept[kept] = clear
    cancelled = any(stage.cancelled for stage in stages)
    if cancelled and not kept.any():
        raise ValueError("Compensation was stopped before any point was done; let it run longer.")
    if not kept.any():
        raise ValueError(
            f"No point of the cloud is left when it is compensated for a ball of {radius:g} mm "
            f"radius: the cloud (pitch {plain(pitch, 3)} mm) is nowhere smooth enough. Check the "
            "probe radius, or scan more densely."
        )
    others = "are of the probe rolling over a rim, or off the surface"
    if cancelled:
        others = "were not looked at, for it was stopped, or " + others
    return PartOfCloud(
        surface[clear],
        kept,
        0.0,
        cloud.approach,
        f"{np.count_nonzero(kept)} of {len(cloud)} points were compensated; the others {others}.",
    )


def _reach(pitch: float, noise: float, radius: float) -> float:
    """Reach of a neighbourhood, mm.

    Large enough that an error of the normal moves no point by a thirtieth of the noise, and that
    the bend of the ball itself is seen to a tenth.
    """
    for_normal = np.sqrt(6.5 * pitch * np.sqrt(noise * radius))
    for_bend = np.cbrt(27.0 * noise * pitch * radius)
    return float(max(for_normal, for_bend))


def _normals(
    cloud: PointCloud,
    quadrics: LocalQuadrics,
    good: NDArray[np.bool_],
    signs: NDArray[np.int8],
    progress: Progress,
) -> Array:
    """Unit normals (n, 3) into the air, nan where no quadric holds the point."""
    usable = good & (signs != 0)
    # seen from the air, a rim bends away
    low, high = quadrics.bends()
    away = np.where(signs > 0, -low, high)
    usable &= away * cloud.probe_radius < _SHARP
    normals, holders = normals_held(
        quadrics, usable, cloud.points, scatter_of(cloud.pitch, cloud.noise), progress
    )
    return signs[holders, None] * normals


def _outside_the_ball(
    surface: Array, centres: cKDTree, radius: float, progress: Progress
) -> NDArray[np.bool_]:
    """Which points no centre is nearer to than a radius."""
    clear = np.zeros(len(surface), dtype=bool)
    for start in range(0, len(surface), AT_ONCE):
        rows = slice(start, start + AT_ONCE)
        near, _ = centres.query(surface[rows], distance_upper_bound=radius, workers=-1)
        clear[rows] = np.isinf(near)
        if not progress.update(min(start + AT_ONCE, len(surface)) / len(surface), None):
            break
    return clear
