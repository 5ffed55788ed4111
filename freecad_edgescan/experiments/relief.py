# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cloud seen from a direction, as a shaded relief: depth on a grid of pixels."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy import ndimage
from scipy.spatial import cKDTree

__all__ = ["Relief", "relief", "view_axes"]

Array = NDArray[np.float64]

LIGHT = np.array([-0.4, 0.5, 0.77])  # from the upper left, before the viewer
MOST_PIXELS = 900  # along the longer side
NEIGHBOURS = 5  # the farthest of so many, itself included, tells how sparse points are
SPREADS = (3, 5, 9, 17)  # pixels that sparse points may cover


@dataclass(frozen=True)
class Relief:
    """What a viewer sees of a cloud.

    Attributes
    ----------
    axes : (3, 3) rows to the right, upwards and towards the viewer, unit vectors
    low : (2,) mm, right and up coordinate of the lower left pixel's corner
    cell : size of a pixel, mm
    depth : (rows, columns) mm towards the viewer, nan where there is no cloud
    """

    axes: Array
    low: Array
    cell: float
    depth: Array

    def project(self, points: ArrayLike) -> Array:
        """Coordinates (n, 3), mm: to the right, upwards, towards the viewer."""
        return np.asarray(np.asarray(points) @ self.axes.T, dtype=np.float64)

    def visible(self, points: ArrayLike) -> NDArray[np.bool_]:
        """Whether points (n, 3) lie before the cloud, or not much more than a pixel inside."""
        seen = self.project(points)
        rows, columns = self.depth.shape
        column, row = np.floor((seen[:, :2] - self.low) / self.cell).astype(int).T
        depth = self.depth[row.clip(0, rows - 1), column.clip(0, columns - 1)]
        return ~(seen[:, 2] < depth - 4 * self.cell)

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """Left, right, bottom, top, mm."""
        rows, columns = self.depth.shape
        left, bottom = self.low
        return left, left + columns * self.cell, bottom, bottom + rows * self.cell

    def shading(self) -> Array:
        """Brightness (rows, columns) in [0, 1], nan where there is no cloud."""
        empty = np.isnan(self.depth)
        weight = ndimage.gaussian_filter((~empty).astype(float), 1.0)
        smooth = ndimage.gaussian_filter(np.where(empty, 0.0, self.depth), 1.0)
        smooth /= np.maximum(weight, 1e-9)
        up, right = np.gradient(smooth, self.cell)
        normal = np.stack([-right, -up, np.ones_like(up)])
        bright = np.tensordot(LIGHT, normal / np.linalg.norm(normal, axis=0), 1)
        return np.where(empty, np.nan, 0.35 + 0.6 * np.clip(bright, 0.0, 1.0))


def view_axes(direction: ArrayLike) -> Array:
    """Rows to the right, upwards and towards a viewer who is in a direction (3,) from the part."""
    towards = np.asarray(direction, dtype=np.float64) / np.linalg.norm(direction)
    upright = np.array([0.0, 0.0, 1.0]) if abs(towards[2]) < 0.95 else np.array([0.0, 1.0, 0.0])
    right = np.cross(upright, towards)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(towards, right), towards])


def relief(points: Array, pitch: float, direction: ArrayLike) -> Relief:
    """Relief of a cloud.

    Parameters
    ----------
    points : (n, 3) array, mm
    pitch : the cloud's pitch, mm; pixels are half as wide, or wider where the picture were large
    direction : (3,) from the part towards the viewer
    """
    axes = view_axes(direction)
    seen = points @ axes.T
    size = np.ptp(seen[:, :2], axis=0)
    cell = max(0.5 * pitch, float(size.max()) / MOST_PIXELS)
    low = seen[:, :2].min(axis=0) - 2 * cell
    columns, rows = (np.floor(size / cell) + 5).astype(int)
    column, row = np.floor((seen[:, :2] - low) / cell).astype(int).T
    depth = np.full((rows, columns), -np.inf)
    spread = _spreads(points, cell)
    for pixels in (1, *SPREADS):
        own = np.full((rows, columns), -np.inf)
        mine = spread == pixels
        np.maximum.at(own, (row[mine], column[mine]), seen[mine, 2])
        depth = np.maximum(depth, ndimage.grey_dilation(own, size=(pixels, pixels)))
    depth = ndimage.grey_closing(depth, size=(3, 3))
    depth[np.isinf(depth)] = np.nan
    return Relief(axes, low, cell, depth)


def _spreads(points: Array, cell: float) -> NDArray[np.intp]:
    """How many pixels each point covers each way, so that sparse surfaces hide what is behind."""
    tree = cKDTree(points, balanced_tree=False)
    neighbours = min(NEIGHBOURS, len(points))
    gap = tree.query(points, k=[neighbours])[0][:, 0] / cell
    return np.array([1, *SPREADS])[np.searchsorted([1.2, *SPREADS[:-1]], gap)]
