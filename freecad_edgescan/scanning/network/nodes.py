# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nodes: some of a cloud's points, evenly spread, with the normals of the surface round them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np

from ...cloud.cubes import one_of_each_cube
from ...cloud.point_cloud import PointCloud
from .pieces import in_pieces

__all__ = ["Nodes", "spread_nodes"]


@dataclass(frozen=True)
class Nodes:
    """Evenly spread points of a cloud.

    Attributes
    ----------
    rows : (k,) numbers of the points in the cloud
    places : (k, 3) mm, the middles of their neighbourhoods
    normals : (k, 3) unit normals of the planes through these, of either sign
    scatter : (k,) standard deviation of a neighbourhood's points about its plane, mm
    """

    rows: np.ndarray
    places: np.ndarray
    normals: np.ndarray
    scatter: np.ndarray

    def __len__(self) -> int:
        return len(self.rows)


def spread_nodes(cloud: PointCloud, spacing: float, neighbours: int) -> Nodes:
    """One point for each occupied cube of a grid, with its neighbourhood's plane.

    Parameters
    ----------
    spacing : side of the cubes, mm
    neighbours : number of points of a neighbourhood
    """
    rows = one_of_each_cube(cloud.points, spacing)
    count = min(neighbours, len(cloud))
    pieces = in_pieces(partial(_planes, cloud, count), rows)
    return Nodes(rows, *(np.concatenate(values) for values in zip(*pieces, strict=True)))


def _planes(cloud: PointCloud, count: int, rows: np.ndarray) -> tuple[np.ndarray, ...]:
    near = cloud.tree.query(cloud.points[rows], k=count)[1]
    offsets = cloud.points[near]
    centre = offsets.mean(axis=1)
    offsets -= centre[:, None]
    squares, axes = np.linalg.eigh(offsets.transpose(0, 2, 1) @ offsets)
    scatter = np.sqrt(np.maximum(squares[:, 0], 0.0) / max(count - 3, 1))
    return centre, axes[:, :, 0], scatter
