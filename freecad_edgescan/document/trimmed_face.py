# SPDX-License-Identifier: LGPL-2.1-or-later
"""One face of a shape as its surface and its rim, for the distances of many points at once."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..geometry import BSplineCurve
from ..surfacing.parameterised import beyond_the_rim
from .native_curve import curve_of
from .native_surface import as_nurbs, surface_of

__all__ = ["TrimmedFace"]

Array = NDArray[np.float64]

_SAMPLES = 48  # of each edge of the rim, in the surface's parameters
_AT_ONCE = 20_000  # points


class TrimmedFace:
    """A face: the part of its surface within its rim.

    Parameters
    ----------
    face : Part.Face
    """

    def __init__(self, face: Any) -> None:
        self.surface = surface_of(face)
        converted = as_nurbs(face)
        self._segments = _rim_segments(converted)
        if converted.Orientation == "Reversed":
            first, last = self.surface.parameter_range[0]
            self._segments[..., 0] = first + last - self._segments[..., 0]
        self.rim: list[tuple[int, BSplineCurve]] = [
            (int(edge.hashCode()), curve_of(edge)) for edge in face.Edges if edge.Length > 1e-9
        ]

    def closest(self, points: Array) -> tuple[Array, Array, Array, NDArray[np.int64]]:
        """Distances, heights, feet's parameters, and the rim's edges of points (n, 3), mm.

        Distances (n,) are from the face, heights (n,) from its tangent plane at the foot, positive
        on the side of the normal. Where a foot lies on the rim the last array (n,) holds the hash
        of that edge, else 0.
        """
        u, v, distance = self.surface.closest(points)
        on_rim = np.zeros(len(points), dtype=np.int64)
        beyond = np.flatnonzero(~self._within(u, v) | beyond_the_rim(points, self.surface, u, v))
        if len(beyond):
            feet, distance[beyond], on_rim[beyond] = self._on_the_rim(points[beyond])
            u[beyond], v[beyond], _ = self.surface.closest(feet)
        away = points - self.surface.evaluate(u, v)
        height = np.einsum("mi,mi->m", away, self.surface.normal(u, v))
        return distance, height, np.column_stack([u, v]), on_rim

    def _on_the_rim(self, points: Array) -> tuple[Array, Array, NDArray[np.int64]]:
        """Feet (n, 3), distances (n,) and edges (n,) of points that are nearest to the rim."""
        feet = np.zeros_like(points)
        distance = np.full(len(points), np.inf)
        number = np.zeros(len(points), dtype=np.int64)
        for name, curve in self.rim:
            at, off = curve.closest(points)
            nearer = off < distance
            feet[nearer], distance[nearer] = curve.evaluate(at[nearer]), off[nearer]
            number[nearer] = name
        return feet, distance, number

    def _within(self, u: Array, v: Array) -> NDArray[np.bool_]:
        """Whether parameters lie within the rim or on it: by how often a ray crosses it."""
        (u0, u1), (v0, v1) = self.surface.parameter_range
        inwards = 1e-7
        u = np.clip(u, u0 + inwards * (u1 - u0), u1 - inwards * (u1 - u0))
        v = np.clip(v, v0 + inwards * (v1 - v0), v1 - inwards * (v1 - v0))
        start, end = self._segments[:, 0], self._segments[:, 1]
        rise = end[:, 1] - start[:, 1]
        slope = (end[:, 0] - start[:, 0]) / np.where(rise != 0.0, rise, 1.0)
        inside = np.zeros(len(u), dtype=bool)
        for begin in range(0, len(u), _AT_ONCE):
            rows = slice(begin, begin + _AT_ONCE)
            height = v[rows, None]
            spans = (start[:, 1] > height) != (end[:, 1] > height)
            right = u[rows, None] < start[:, 0] + (height - start[:, 1]) * slope
            inside[rows] = (spans & right).sum(axis=1) % 2 == 1
        return inside


def _rim_segments(face: Any) -> Array:
    """Short straight pieces (k, 2, 2) of the rim in the surface's parameters; a seam has two."""
    pieces = []
    for wire in face.Wires:
        for edge in wire.OrderedEdges:
            found = face.curveOnSurface(edge)
            if found is None:
                continue
            curve, first, last = found[:3]
            at = np.linspace(first, last, _SAMPLES).tolist()
            path = np.array([(place.x, place.y) for place in map(curve.value, at)])
            pieces.append(np.stack([path[:-1], path[1:]], axis=1))
    return np.concatenate(pieces) if pieces else np.zeros((0, 2, 2))
