# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of a cloud near a base surface, moved from the probe's centres onto the part."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..cloud import PointCloud
from ..geometry import BSplineSurface

__all__ = ["compensated_segment", "thinned_to_grid"]

Array = NDArray[np.float64]


def compensated_segment(cloud: PointCloud, base: BSplineSurface, distance: float) -> Array:
    """Points (n, 3) mm of the surface near a base surface.

    The centres are moved by the probe radius along the base surface's normals; an angle α between
    these and the surface's own leaves an error of R_p (1 - cos α). Points whose foot is on the
    rim are left out: there the probe rolls over it.

    Parameters
    ----------
    cloud : PointCloud
    base : BSplineSurface
    distance : mm, of the surface from the base surface
    """
    radius = cloud.probe_radius
    corners = base.poles.reshape(-1, 3)
    reach = distance + radius
    near = np.all(
        (cloud.points > corners.min(axis=0) - reach) & (cloud.points < corners.max(axis=0) + reach),
        axis=1,
    )
    points = cloud.points[near]
    u, v, off = base.closest(points)
    inner = off < reach
    for x, (first, last) in zip((u, v), base.parameter_range, strict=True):
        inner &= (x > first) & (x < last)
    points, u, v = points[inner], u[inner], v[inner]
    normal = base.normal(u, v)
    height = np.einsum("mi,mi->m", points - base.evaluate(u, v), normal)
    side = np.sign(np.median(height)) if radius > 0.0 else 1.0
    kept = np.abs(side * height - radius) < distance
    return np.asarray(points[kept] - side * radius * normal[kept])


def thinned_to_grid(points: Array, pitch: float) -> Array:
    """One point for each square of a grid in x and y: that nearest to its middle."""
    cell = np.floor(points[:, :2] / pitch)
    off = np.linalg.norm(points[:, :2] - (cell + 0.5) * pitch, axis=1)
    order = np.argsort(off, kind="stable")
    _, first = np.unique(cell[order], axis=0, return_index=True)
    return points[np.sort(order[first])]
