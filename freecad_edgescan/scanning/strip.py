# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cloud's points in a strip along an edge, each in the sections it lies near to."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from ..cloud.point_cloud import PointCloud
from .edge_path import EdgePath
from .section import SectionPoints, section_points


def strip_points(
    cloud: PointCloud, path: EdgePath, reach: float, half_width: float
) -> SectionPoints:
    """Points within the reach of an edge, once for every section whose slab they lie in.

    Parameters
    ----------
    path : sections along the edge
    reach : distance from the edge, mm
    half_width : half the width of a slab, mm
    """
    frames, spacing = path.frames, path.spacing
    stride = max(1, int(reach / max(spacing, 1e-12)))
    centres = frames.origin[
        np.unique(np.append(np.arange(0, len(frames), stride), len(frames) - 1))
    ]
    radius = float(np.hypot(reach, 0.5 * reach) + half_width)
    balls = cloud.tree.query_ball_point(centres, radius, return_sorted=False)
    # Marked, since sorting out what lies in two of them takes longer.
    near = np.zeros(len(cloud), dtype=bool)
    for ball in balls:
        near[ball] = True
    index = _each_place_once(cloud.points, np.flatnonzero(near))
    points = cloud.points.take(index, axis=0)
    # No point is farther than that; to know it spares the search some nodes.
    _, nearest = cKDTree(frames.origin).query(points, distance_upper_bound=1.01 * radius)
    offset = points - frames.origin.take(nearest, axis=0)
    ahead = np.einsum("ni,ni->n", offset, frames.tangent.take(nearest, axis=0))
    neighbours = int(np.ceil(half_width / max(float(np.diff(path.at).min()), 1e-3 * spacing) + 0.5))
    parts = []
    for step in range(-neighbours, neighbours + 1):
        owner = nearest + step
        if path.closed:
            owner %= len(frames)
        # Inside of a bend a narrow slab of points fans out to twice its width.
        onward = np.nan_to_num(path.ahead(step) if step else np.zeros(len(frames)), nan=np.inf)
        rows = np.flatnonzero(np.abs(ahead - onward[nearest]) <= 2.0 * half_width)
        found = section_points(frames, owner[rows], index[rows], points.take(rows, axis=0))
        parts.append(
            found[(np.abs(found.along) <= half_width) & (found.away > 0) & (found.away < reach)]
        )
    return SectionPoints(
        *(
            np.concatenate([getattr(part, name) for part in parts])
            for name in ("index", "owner", "along", "side", "away", "height")
        )
    )


def _each_place_once(points: np.ndarray, index: np.ndarray) -> np.ndarray:
    """Leave out points that repeat another one exactly: they are no measurement of their own."""
    x, y, z = points.take(index, axis=0).T
    # Equal points have an equal sum, and others only by chance.
    total = x + np.sqrt(2.0) * y + np.sqrt(3.0) * z
    ordered = np.sort(total)
    if np.all(ordered[1:] > ordered[:-1]):
        return index
    order = np.argsort(total, kind="stable")
    first = points[index[order]]
    repeats = np.append(False, np.all(first[1:] == first[:-1], axis=1))
    return np.sort(index[order[~repeats]])
