# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a cloud is from any shape, point by point, and on which side."""

from __future__ import annotations

from collections import Counter
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..cloud import PointCloud
from ..cloud.progress import Stage
from ..scanning import Progress
from ..surfacing import Deviation
from ..surfacing.deviation import points_of
from .trimmed_face import TrimmedFace

__all__ = ["MeasurableShape", "shape_deviation", "write_deviations"]

Array = NDArray[np.float64]

_AT_ONCE = 200_000  # points
_SAME = 1e-6  # mm, by which distances from two faces may differ where these share an edge


def shape_deviation(
    cloud: PointCloud | ArrayLike, shape: Any, progress: Progress | None = None
) -> Deviation:
    """Signed distances of points from the nearest face of a shape.

    Parameters
    ----------
    cloud : PointCloud or (n, 3) array, mm
        Points on the part's surface; compensate a cloud of probe centres first.
    shape : Part.Shape with faces: a surface, a shell or a solid
    progress : object with ``update(fraction, so_far) -> bool``, optional
        Told the share that is done; when it answers False those of the first points are the result.

    Returns
    -------
    Deviation: positive on the side of the face's normal, which of a solid is outside. ``outside``
    are points whose nearest place is a free rim of the shape; ``parameters`` are those of the
    nearest face.

    Raises
    ------
    ValueError: a shape without a face, no points, or a cloud of probe centres.
    """
    return MeasurableShape(shape).deviation(points_of(cloud), progress)


class MeasurableShape:
    """The faces of a shape as numbers: distances from them need FreeCAD no more.

    Parameters
    ----------
    shape : Part.Shape

    Raises
    ------
    ValueError: a shape without a face.
    """

    def __init__(self, shape: Any) -> None:
        faces = [] if shape.isNull() else shape.Faces
        if not faces:
            raise ValueError("The shape has no face to measure deviations from; choose another.")
        shared = Counter(int(edge.hashCode()) for face in faces for edge in face.Edges)
        seams = {int(edge.hashCode()) for face in faces for edge in face.Edges if edge.isSeam(face)}
        self._free = [name for name, count in shared.items() if count == 1 and name not in seams]
        self._faces = [(TrimmedFace(face), *_box(face)) for face in faces]

    def deviation(self, points: Array, progress: Progress | None = None) -> Deviation:
        """Deviations of points (n, 3), mm; those of the first ones when progress answers False."""
        parts: list[Deviation] = []
        for start in range(0, len(points), _AT_ONCE):
            end = min(start + _AT_ONCE, len(points))
            told = Stage(progress, start / len(points), end / len(points))
            found = self._of_some(points[start:end], told)
            if found is None:
                break
            parts.append(found)
        return Deviation.joined(parts)

    def _of_some(self, points: Array, progress: Stage) -> Deviation | None:
        """Deviations of all points, or None when cancelled before the last face."""
        distance = np.full(len(points), np.inf)
        height = np.zeros(len(points))
        outside = np.zeros(len(points), dtype=bool)
        at = np.zeros((len(points), 2))
        for number, (face, low, high) in enumerate(self._faces, 1):
            rows = _may_be_nearer(points, low, high, distance + _SAME)
            if len(rows):
                off, above, uv, on_rim = face.closest(points[rows])
                nearer = off < distance[rows] - _SAME
                # Over an edge that two faces share, the one that the point is more above tells the
                # side
                same = off <= distance[rows] + _SAME
                nearer |= same & (np.abs(above) > np.abs(height[rows]))
                rows = rows[nearer]
                distance[rows], height[rows], at[rows] = off[nearer], above[nearer], uv[nearer]
                outside[rows] = np.isin(on_rim[nearer], self._free)
            if not progress.update(number / len(self._faces), None) and number < len(self._faces):
                return None
        return Deviation(np.where(height < 0.0, -distance, distance), outside, (at[:, 0], at[:, 1]))


def write_deviations(points: ArrayLike, deviation: Deviation, path: str | PathLike[str]) -> None:
    """Write points, their deviations, and whether they count, as a .csv table.

    Parameters
    ----------
    points : (n, 3) mm
    deviation : Deviation of these points
    path : of the file
    """
    deviation.to_csv(points, path)


def _box(face: Any) -> tuple[Array, Array]:
    """Least and largest coordinates (3,) of a face."""
    box = face.BoundBox
    return np.array([box.XMin, box.YMin, box.ZMin]), np.array([box.XMax, box.YMax, box.ZMax])


def _may_be_nearer(points: Array, low: Array, high: Array, so_far: Array) -> NDArray[np.intp]:
    """Rows of the points that are nearer to a face's box than to the faces before."""
    apart = np.maximum(np.maximum(low - points, points - high), 0.0)
    return np.flatnonzero(np.linalg.norm(apart, axis=1) < so_far)
