# SPDX-License-Identifier: LGPL-2.1-or-later
"""The vertex at the end of an edge: where its two sides and a third surface meet.

The edge is drawn out straight, or with its bend, from its last points. Among the cloud's points
near its end that belong to neither side, the plane most of them share is a third surface; it is
fitted without what lies next to the sides, where a rounding may be, and cut with the edge.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..cloud.point_cloud import PointCloud
from .evened import one_per_cell
from .local_surface import LocalSurface, fit_local_surface
from .section import Frames, section_points
from .shared_planes import normals_of, shared_planes

__all__ = ["EdgeEnd", "FoundVertex", "find_vertex"]

_BALL = 12.0  # pitches round the end, besides a rounding, in which a third surface is looked for
_FEWEST = 15  # points of a third surface
_FLATTEST = 0.25  # sine of the angle of the edge to a third surface, at least
_SHORT, _FAR = 4.0, 6.0  # pitches before and behind the last edge point for a vertex
_IN_COMMON = 0.5  # of an edge point's variance, that its neighbours share and no mean makes less
_CUT = 0.2  # sine, of the angle between a third surface and a side it is told from
# Noises by which the points of a third surface scatter, and pitches by which it may be uneven where
# there is hardly any noise, as real faces are.
_SCATTER, _UNEVEN = 1.2, 0.1


@dataclass(frozen=True)
class EdgeEnd:
    """The last points of an edge, seen from inside it.

    Attributes
    ----------
    points : (k, 3) mm, edge points, the last one at the end
    covariance : (k, 3, 3) mm², of each of them
    frame : one section that stands on the last one, its tangent out of the edge
    clear : (2,) distance from the edge from which on each side has no rounding, mm
    overlap : how many neighbouring edge points share their cloud points
    noise : standard deviation of the cloud's points along the normal, mm
    """

    points: np.ndarray
    covariance: np.ndarray
    frame: Frames
    clear: np.ndarray
    overlap: float
    noise: float


@dataclass(frozen=True)
class FoundVertex:
    """A vertex.

    Attributes
    ----------
    point : (3,) mm
    covariance : (3, 3) mm²
    normal : (3,) unit normal of the third surface there, either way
    """

    point: np.ndarray
    covariance: np.ndarray
    normal: np.ndarray


def find_vertex(
    cloud: PointCloud, end: EdgeEnd, min_angle: float, beyond: float = 0.0
) -> FoundVertex | None:
    """The vertex at the end of an edge, or None where no third surface is found.

    Parameters
    ----------
    min_angle : least turn between two surfaces, rad
    beyond : how much farther than usual the vertex may lie, mm
    """
    edge = _DrawnOut.of(end)
    rounded = float(end.clear.max())
    radius = _BALL * cloud.pitch + 2.0 * rounded + beyond
    ball = cloud.tree.query_ball_point(end.frame.origin[0], radius, return_sorted=False)
    index = np.asarray(ball, dtype=np.int64)
    if len(index) < _FEWEST:
        return None
    points = cloud.points[index]
    heights = _over_sides(end.frame, points)
    foreign = _foreign(cloud, end, index, points)
    if np.count_nonzero(foreign) < _FEWEST:
        return None
    even = one_per_cell(points[foreign], radius / 12.0)
    off = np.linalg.norm(even - end.frame.origin[0], axis=1)
    weight = np.exp(-np.square(off / (0.6 * radius)))
    far = _FAR * cloud.pitch + 2.0 * rounded + beyond
    clear = rounded + 0.5 * cloud.pitch
    # Where this edge is rounded, so may be all round a third surface, and it ends in no line.
    scatter = max(_SCATTER * end.noise, _UNEVEN * cloud.pitch)
    most_scatter = scatter if rounded <= cloud.pitch else np.inf
    for normal, centre in shared_planes(even, normals_of(cloud, even), weight, min_angle):
        slope = float(normal @ edge.tangent)
        if abs(slope) < _FLATTEST:
            continue
        at = float(normal @ (centre - edge.origin)) / slope
        if not -_SHORT * cloud.pitch - rounded < at < far:
            continue
        # A surface that a side cuts at an angle is clear of it where it lies off it.
        cuts = np.abs(end.frame.normals[0] @ normal) < np.sqrt(1.0 - _CUT**2)
        room = np.all((np.abs(heights) > clear) | ~cuts, axis=1)
        surface = fit_local_surface(
            points[room], normal, edge.at(at), radius, end.noise, cloud.pitch, most_scatter
        )
        if surface is None:
            continue
        found = _cut(edge, surface, at, radius)
        if found is not None:
            return found
    return None


@dataclass(frozen=True)
class _DrawnOut:
    """The edge beyond its end: origin + u·tangent + u²/2·bend, known with a covariance."""

    origin: np.ndarray
    tangent: np.ndarray
    bend: np.ndarray
    places: np.ndarray
    spread: np.ndarray
    overlap: float

    @classmethod
    def of(cls, end: EdgeEnd) -> _DrawnOut:
        last, tangent, bend = end.frame.origin[0], end.frame.tangent[0], end.frame.bend[0]
        u = (end.points - last) @ tangent
        flat = end.points - 0.5 * (u**2)[:, None] * bend
        if len(u) < 3:
            return cls(flat[-1], tangent, bend, u, end.covariance.mean(axis=0), end.overlap)
        terms = np.stack([np.ones_like(u), u], axis=1)
        (origin, way), *_ = np.linalg.lstsq(terms, flat, rcond=None)
        size = float(np.linalg.norm(way))
        return cls(origin, way / size, bend, u, end.covariance.mean(axis=0), end.overlap)

    def at(self, u: float) -> np.ndarray:
        return self.origin + u * self.tangent + 0.5 * u**2 * self.bend

    def way(self, u: float) -> np.ndarray:
        way = self.tangent + u * self.bend
        return way / np.linalg.norm(way)

    def covariance(self, u: float) -> np.ndarray:
        """Of the straight line at u, whose points share cloud points and more."""
        middle = self.places.mean()
        scatter = float(np.square(self.places - middle).sum())
        leverage = 1.0 / len(self.places)
        leverage += (u - middle) ** 2 / scatter if len(self.places) > 2 else 1.0
        return self.spread * (self.overlap * leverage + _IN_COMMON)


def _over_sides(frame: Frames, points: np.ndarray) -> np.ndarray:
    """Heights (n, 2) over both sides, drawn out to all sides, mm."""
    offset = points - frame.origin[0]
    height = offset @ frame.normals[0].T
    away = offset @ frame.sides[0].T
    return np.asarray(height - 0.5 * frame.curvature[0] * away**2)


def _foreign(cloud: PointCloud, end: EdgeEnd, index: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Which points belong to neither side nor to the rounding between them, (n,) bool."""
    frame = end.frame
    seen = section_points(frame, np.zeros_like(index), np.arange(len(index)), points)
    near = 4.0 * end.noise + 0.05 * cloud.pitch + 0.05 * seen.away
    expected = 0.5 * frame.curvature[0, seen.side] * seen.away**2
    own = np.abs(seen.height - expected) <= near
    own |= (seen.away < end.clear[seen.side] + 0.5 * cloud.pitch) & (seen.along < 0.0)
    foreign = np.ones(len(index), dtype=bool)
    foreign[seen.index[own]] = False
    return foreign


def _cut(edge: _DrawnOut, surface: LocalSurface, at: float, radius: float) -> FoundVertex | None:
    """Where the edge, drawn out, meets a surface within a radius from its end."""
    for _ in range(8):
        point, way = edge.at(at), edge.way(at)
        normal = surface.normal(point)
        slope = float(normal @ way)
        if abs(slope) < _FLATTEST:
            return None
        # Heights are measured along the plane's own normal.
        step = surface.height(point) * float(normal @ surface.axes[2]) / slope
        at -= step
        if abs(at) > radius:
            return None
    point, way, normal = edge.at(at), edge.way(at), surface.normal(edge.at(at))
    slope = float(normal @ way)
    if abs(slope) < _FLATTEST or abs(step) > 1e-9 * (1.0 + abs(at)):
        return None
    along_the_edge = np.eye(3) - np.outer(way, normal) / slope
    covariance = along_the_edge @ edge.covariance(at) @ along_the_edge.T
    covariance += np.outer(way, way) * surface.uncertainty(point) / slope**2
    return FoundVertex(point, covariance, normal)
