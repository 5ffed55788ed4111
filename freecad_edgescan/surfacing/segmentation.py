# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of a cloud that belongs to a base surface (Schreve 6.7).

Bradley and Chan 2001, A complementary sensor approach to reverse engineering: all points within a
distance of the base surface. Few points need their closest point for that: those outside the
surface's box are away, those within the distance of one of many samples of the surface are near,
and those farther than that by more than the samples' spacing are away too.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from ..cloud import PointCloud
from ..cloud.local_normals import local_normals
from ..cloud.progress import Progress, Stage
from ..geometry import BSplineSurface
from ..geometry.plain_number import plain

__all__ = ["segment_cloud"]

Array = NDArray[np.float64]

_SPACING = 0.15  # of the distance, between samples
_MOST_SAMPLES = 400_000
_PER_PATCH = (4, 400)  # least and most samples of a patch in one direction
_AT_ONCE = 200_000  # points


def segment_cloud(
    cloud: PointCloud,
    base: BSplineSurface,
    distance: float = 3.0,
    angle: float | None = None,
    progress: Progress | None = None,
) -> NDArray[np.bool_]:
    """Which points of a cloud lie within a distance of a base surface.

    Parameters
    ----------
    cloud : PointCloud
    base : BSplineSurface
        For a cloud of probe centres the distance must allow for the probe's radius.
    distance : float
        mm, from the surface or its rim.
    angle : float, optional
        rad, in (0, π/2]: also by how much the cloud's own surface may be inclined to the base
        surface. Beside an edge it keeps the points of the other side out, which are as near. Points
        where the cloud is not smooth, as on the edge itself, are then left out too.
    progress : object with ``update(fraction, so_far) -> bool``, optional
        Told the share that is done and the mask so far; when it answers False that is the result.

    Returns
    -------
    (n,) bool

    Raises
    ------
    ValueError: a distance or angle that is none, or no point within the distance.
    """
    if not 0.0 < distance < np.inf:
        raise ValueError(f"The distance is {distance} mm; give a positive length.")
    if angle is not None and not 0.0 < angle <= np.pi / 2:
        raise ValueError(f"The angle is {angle} rad; give one above 0 and up to π/2 (not degrees).")
    mask = np.zeros(len(cloud), dtype=bool)
    near = Stage(progress, 0.0, 1.0 if angle is None else 0.2)
    _mark_near(mask, cloud.points, base, float(distance), near)
    if not mask.any() and not near.cancelled:
        nearest = float(base.closest(cloud.points[:: max(1, len(cloud) // 2000)])[2].min())
        raise ValueError(
            f"No point of the cloud is within {distance:g} mm of the base surface; the nearest is "
            f"about {plain(nearest, 3)} mm away. Check the base surface, or give a larger distance."
        )
    if angle is not None and mask.any():
        _unmark_inclined(mask, cloud, base, angle, progress)
    return mask


def _mark_near(
    mask: NDArray[np.bool_], points: Array, base: BSplineSurface, distance: float, progress: Stage
) -> None:
    """Set the mask (n,) of the points within a distance of the surface, until cancelled."""
    poles = base.poles.reshape(-1, 3)  # the surface lies within their box
    low, high = poles.min(axis=0) - distance, poles.max(axis=0) + distance
    rows = np.flatnonzero(((points >= low) & (points <= high)).all(axis=1))
    if not len(rows):
        return
    samples, gap = _samples(base, _SPACING * distance)
    tree = cKDTree(samples, balanced_tree=False)
    for start in range(0, len(rows), _AT_ONCE):
        some = rows[start : start + _AT_ONCE]
        near, _ = tree.query(points[some], distance_upper_bound=distance + gap, workers=-1)
        unsure = np.flatnonzero((near > distance) & np.isfinite(near))
        near[unsure] = base.closest(points[some[unsure]])[2] if len(unsure) else 0.0
        mask[some[near <= distance]] = True
        if not progress.update((start + len(some)) / len(rows), mask):
            break


def _unmark_inclined(
    mask: NDArray[np.bool_],
    cloud: PointCloud,
    base: BSplineSurface,
    angle: float,
    progress: Progress | None,
) -> None:
    """Take out of the mask (n,) where the cloud's surface is inclined to the base, or not known."""
    rows = np.flatnonzero(mask)
    normals = local_normals(cloud, mask, Stage(progress, 0.2, 0.7))
    known = np.isfinite(normals[:, 0])
    rows, normals = rows[known], normals[known]
    mask[:] = False
    last = Stage(progress, 0.7, 1.0)
    for start in range(0, len(rows), _AT_ONCE):
        some = rows[start : start + _AT_ONCE]
        u, v, _ = base.closest(cloud.points[some])
        own = normals[start : start + len(some)]
        cosine = np.einsum("mi,mi->m", own, base.normal(u, v))
        mask[some] = np.abs(cosine) >= np.cos(angle)
        if not last.update((start + len(some)) / len(rows), mask):
            break


def _samples(base: BSplineSurface, spacing: float) -> tuple[Array, float]:
    """Samples (k, 3) of a surface, and how far one of its points may be from them, mm."""
    breaks = base.patches.breaks
    coarse = [np.unique(np.concatenate([_steps(own, 4), own])) for own in breaks]
    grid = base.evaluate(coarse[0][:, None], coarse[1])
    counts = []
    for axis in (0, 1):
        step = np.linalg.norm(np.diff(grid, axis=axis), axis=2).max()
        counts.append(int(np.clip(np.ceil(4 * step / spacing), *_PER_PATCH)))
    total = np.prod([count * (len(own) - 1) for count, own in zip(counts, breaks, strict=True)])
    if total > _MOST_SAMPLES:
        share = np.sqrt(_MOST_SAMPLES / total)
        counts = [max(_PER_PATCH[0], int(share * count)) for count in counts]
    u, v = (_steps(own, count) for own, count in zip(breaks, counts, strict=True))
    grid = base.evaluate(u[:, None], v)
    across = [
        np.linalg.norm(one - other, axis=2).max()
        for one, other in ((grid[1:, 1:], grid[:-1, :-1]), (grid[1:, :-1], grid[:-1, 1:]))
    ]
    return grid.reshape(-1, 3), float(max(across))


def _steps(breaks: Array, count: int) -> Array:
    """Parameters that divide every piece between breaks into equal steps."""
    share = np.arange(count) / count
    return np.append((breaks[:-1, None] + np.diff(breaks)[:, None] * share).ravel(), breaks[-1])
