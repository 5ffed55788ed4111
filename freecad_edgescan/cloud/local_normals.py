# SPDX-License-Identifier: LGPL-2.1-or-later
"""Local normals of a cloud, beside edges those of each point's own side.

A point takes the nearest quadric that the points around follow and that holds the point itself.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from .local_quadrics import FLAT, LocalQuadrics, local_quadrics
from .point_cloud import FEWEST_POINTS, PointCloud
from .progress import Progress, Stage

__all__ = ["cloud_quadrics", "local_normals", "normals_held", "scatter_of"]

Array = NDArray[np.float64]

NEIGHBOURS = 36  # also where lines of points lie ten times as far apart as the points on them
MOST_NEIGHBOURS = 250
SCATTER = 4.5  # of the noise: how far a point may be from its quadric
CANDIDATES = 8  # quadrics a point may be held by
AT_ONCE = 200_000


def local_normals(
    cloud: PointCloud, within: NDArray[np.bool_], progress: Progress | None = None
) -> Array:
    """Unit normals (m, 3) of either sign at some points of a cloud; nan where it is not smooth.

    Parameters
    ----------
    cloud : PointCloud
    within : (n,) bool, the m points that are asked about
    progress : told the share that is done; where it answers False, the others' normals are nan
    """
    reach = float(np.sqrt(38.0 * cloud.noise * cloud.pitch))  # for a slope within 0.03 rad
    quadrics = cloud_quadrics(cloud, reach, within, Stage(progress, 0.0, 0.7))
    usable = quadrics.smooth(cloud.pitch, cloud.noise)
    scatter = scatter_of(cloud.pitch, cloud.noise)
    held = Stage(progress, 0.7, 1.0)
    return normals_held(quadrics, usable, cloud.points[within], scatter, held)[0]


def cloud_quadrics(
    cloud: PointCloud,
    reach: float,
    within: NDArray[np.bool_] | None = None,
    progress: Progress | None = None,
) -> LocalQuadrics:
    """Quadrics over neighbourhoods of at least a reach, mm, among all points or some (n,) bool.

    Raises
    ------
    ValueError: a cloud without a surface.
    """
    pitch = cloud.pitch
    if not (len(cloud) >= FEWEST_POINTS and pitch > 0.0):  # nan is not
        raise ValueError(
            f"The {len(cloud)} points of the cloud are too few, or too much alike, to have local "
            f"normals; give {FEWEST_POINTS} or more of a surface."
        )
    reach = max(reach, float(np.sqrt(NEIGHBOURS / np.pi)) * pitch)
    neighbours = min(int(np.pi * (reach / pitch) ** 2) + 1, MOST_NEIGHBOURS)
    return local_quadrics(cloud.tree, reach, neighbours, within, progress)


def scatter_of(pitch: float, noise: float) -> float:
    """How far from its surface a point may be, mm."""
    return SCATTER * max(noise, FLAT * pitch)


def normals_held(
    quadrics: LocalQuadrics,
    usable: NDArray[np.bool_],
    points: Array,
    scatter: float,
    progress: Progress | None = None,
) -> tuple[Array, NDArray[np.intp]]:
    """Normals (n, 3) of the nearest usable quadrics that hold the points, and their rows (n,).

    A quadric holds a point within its reach and no farther above or below it than the scatter, mm.
    Where none does, the normal is nan and the row -1.
    """
    tree = cKDTree(quadrics.origins, balanced_tree=False)
    count = min(CANDIDATES, len(quadrics.origins))
    normals, holders = np.full(points.shape, np.nan), np.full(len(points), -1, dtype=np.intp)
    for start in range(0, len(points), AT_ONCE):
        open_ = np.arange(start, min(start + AT_ONCE, len(points)))
        near = tree.query(points[open_], k=range(1, count + 1), workers=-1)[1]
        for number in range(count):
            x, row = points[open_], near[:, number]
            height, normal = quadrics.at(row, x)
            off = np.linalg.norm(x - quadrics.origins[row], axis=1)
            held = usable[row] & (np.abs(height) <= scatter) & (off <= quadrics.reach[row])
            normals[open_[held]], holders[open_[held]] = normal[held], row[held]
            open_, near = open_[~held], near[~held]
            if not len(open_):
                break
        if progress and not progress.update(min(start + AT_ONCE, len(points)) / len(points), None):
            break
    return normals, holders
