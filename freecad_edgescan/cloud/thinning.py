# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clouds thinned evenly, without rows or clumps: no two points too near, and no holes.

1. One point is taken of every small cube, the one nearest to its middle, so that what follows does
   not depend on how dense the cloud was.
2. Points are taken in a random order that is always the same, unless one taken before is nearer
   than a distance: dart throwing, as in Cook 1986, Stochastic sampling in computer graphics.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from .cubes import one_of_each_cube
from .first_come import first_come
from .part_of_cloud import PartOfCloud
from .point_cloud import PointCloud
from .progress import Progress, Stage

__all__ = ["spaced_rows", "thin_cloud"]

Array = NDArray[np.float64]

_DISTANCE = 0.82  # of the pitch: discs so thrown until none fits in cover 0.547 of a plane
_CUBE = 0.4  # of the distance


def thin_cloud(cloud: PointCloud, pitch: float, progress: Progress | None = None) -> PartOfCloud:
    """Some of a cloud's points, evenly spread over its surface.

    Parameters
    ----------
    cloud : PointCloud
    pitch : float
        1 / √(points per mm²) of what remains, mm, where the cloud is denser than that.
    progress : object with ``update(fraction, so_far) -> bool``, optional
        Told the share that is done; when it answers False the points taken so far are the result:
        none of them are too near, but holes are left, and the message says so.

    Returns
    -------
    PartOfCloud: its ``kept`` (n,) tells which points they are. No two of them are nearer than 0.82
    of the pitch, and no point that was left out is farther than that from one of them. The same
    cloud always gives the same points.

    Raises
    ------
    ValueError: a pitch that is not positive.
    """
    if not 0.0 < pitch < np.inf:
        raise ValueError(f"The pitch is {pitch} mm; give the positive pitch to thin the cloud to.")
    kept = np.zeros(len(cloud), dtype=bool)
    told = Stage(progress, 0.0, 1.0)
    kept[spaced_rows(cloud.points, _DISTANCE * pitch, told)] = True
    said = " It was stopped: holes are left." if told.cancelled else ""
    return PartOfCloud(
        cloud.points[kept],
        kept,
        cloud.probe_radius,
        cloud.approach,
        f"{np.count_nonzero(kept)} of {len(cloud)} points were kept.{said}",
    )


def spaced_rows(
    points: Array, distance: float, progress: Progress | None = None
) -> NDArray[np.intp]:
    """Rows of points (n, 3) of which no two are nearer than a distance, mm, and none is missing.

    Where progress answers False some are missing.
    """
    first = Stage(progress, 0.0, 0.5)
    rows = one_of_each_cube(points, _CUBE * distance)
    x = points[rows] - points[rows[0]]
    chosen = _spaced(x, distance, first)
    # what the cubes left out may still be too far from all that were taken
    spare = np.ones(len(points), dtype=bool)
    spare[rows] = False
    while not first.cancelled:
        taken = rows[chosen]
        left = np.flatnonzero(spare)
        if not len(left):
            break
        tree = cKDTree(points[taken], balanced_tree=False)
        near, _ = tree.query(points[left], distance_upper_bound=distance)
        lonely = left[np.isinf(near)]
        spare[:] = False
        spare[lonely] = True
        if not len(lonely):
            break
        added = lonely[
            _spaced(points[lonely] - points[lonely[0]], distance, Stage(progress, 0.5, 1.0))
        ]
        rows, chosen = np.concatenate([taken, added]), np.ones(len(taken) + len(added), dtype=bool)
        spare[added] = False
        if progress and not progress.update(np.nan, None):
            break
    return np.sort(rows[chosen])


def _spaced(x: Array, distance: float, progress: Progress) -> NDArray[np.bool_]:
    """Which points are taken when each one in turn is, unless one before is too near.

    Where progress answers False, only those that are sure by then.
    """
    rank = np.random.default_rng(0).permutation(len(x))
    one, other = _near_pairs(x, distance)
    return first_come(rank, one, other, progress)


def _near_pairs(x: Array, distance: float) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """All pairs of points nearer than a distance."""
    tree = cKDTree(x, balanced_tree=False)
    pairs = tree.query_pairs(distance * (1.0 - 1e-9), output_type="ndarray")
    return pairs[:, 0], pairs[:, 1]
