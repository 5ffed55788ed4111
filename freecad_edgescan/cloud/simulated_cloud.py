# SPDX-License-Identifier: LGPL-2.1-or-later
"""A point cloud that knows where it came from: the face of each point and the exact edges."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .point_cloud import PointCloud
from .true_edge import TrueEdge

__all__ = ["SimulatedCloud", "add_noise"]


class SimulatedCloud(PointCloud):
    """Points measured on a simulated part, with the truth beside them.

    Parameters
    ----------
    points, probe_radius, approach : as for ``PointCloud``; all points finite
    labels : (n,) int, index into ``face_names`` of the face each point lies on
    face_names : names of the faces
    edges : the exact sharp edges of the part

    Raises
    ------
    ValueError: points that are not finite, or labels that do not match points or faces.
    """

    labels: NDArray[np.intp]
    face_names: tuple[str, ...]
    edges: tuple[TrueEdge, ...]

    def __init__(
        self,
        points: ArrayLike,
        labels: ArrayLike,
        face_names: Sequence[str],
        edges: Sequence[TrueEdge],
        probe_radius: float = 0.0,
        approach: ArrayLike | None = None,
    ) -> None:
        super().__init__(points, probe_radius, approach)
        faces = np.array(labels, dtype=np.intp)
        if self.dropped or faces.shape != (len(self),):
            raise ValueError(
                f"{faces.size} labels do not match {len(self)} finite points; give one for each."
            )
        if faces.min() < 0 or faces.max() >= len(face_names):
            raise ValueError(
                f"The labels run from {faces.min()} to {faces.max()}, but there are "
                f"{len(face_names)} face names; give each label a name."
            )
        faces.setflags(write=False)
        object.__setattr__(self, "labels", faces)
        object.__setattr__(self, "face_names", tuple(face_names))
        object.__setattr__(self, "edges", tuple(edges))


def add_noise(
    points: NDArray[np.float64], level: float, seed: int | Sequence[int]
) -> NDArray[np.float64]:
    """Points with an independent uniform error in [-level, level] on each coordinate.

    Parameters
    ----------
    points : (n, 3) array
        Exact points, mm.
    level : float
        η, mm.
    seed : int or sequence of int
        Anything ``numpy.random.default_rng`` takes.

    Raises
    ------
    ValueError: a negative noise level.
    """
    if not 0.0 <= level < np.inf:
        raise ValueError(f"The noise level is {level} mm; give 0 or a positive number.")
    if level == 0.0:
        return points
    errors = np.random.default_rng(seed).uniform(-level, level, points.shape)
    return np.asarray(points + errors, dtype=np.float64)
