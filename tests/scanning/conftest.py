# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts whose edges are known exactly, scanned with Gaussian noise along the normal."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.scanning import scan_edge


@dataclass(frozen=True)
class Wedge:
    """Two half-planes that meet in a straight edge, and a cloud of them.

    middle (3,), along (3,), sides (2, 3) away from the edge, outward (2, 3) normals out of the
    smaller wedge; the edge is `length` long.
    """

    cloud: PointCloud
    middle: np.ndarray
    along: np.ndarray
    sides: np.ndarray
    outward: np.ndarray
    angle: float
    length: float

    def at(self, share=0.0, aside=0.0, k=0):
        """A place on side k, share of the length from the middle, some mm from the edge."""
        return self.middle + share * self.length * self.along + aside * self.sides[k]

    def across(self, points):
        """Vectors (m, 3) from the edge's line to points."""
        offset = np.asarray(points) - self.middle
        return offset - (offset @ self.along)[:, None] * self.along

    def distance(self, points):
        return np.linalg.norm(self.across(points), axis=1)

    def place_along(self, points):
        return (np.asarray(points) - self.middle) @ self.along


def scattered(rng, length, width, pitch):
    """One point at random in each cell of a grid, (n,) (n,)."""
    n, m = max(round(length / pitch), 1), max(round(width / pitch), 1)
    i, j = np.indices((n, m)).reshape(2, -1)
    return (i + rng.random(n * m)) * length / n, (j + rng.random(n * m)) * width / m


def make_wedge(
    degrees=90.0,
    pitch=0.5,
    noise=0.02,
    rounding=0.0,
    length=40.0,
    width=14.0,
    seed=0,
    raised=0.0,
    probe_radius=0.0,
    approach=None,
    moved=(3.0, -2.0, 1.0),
    turned=True,
):
    """A wedge; `raised` moves the apex of the cloud (not the edge) out of the wedge, mm."""
    rng = np.random.default_rng([seed, 77])
    half = np.radians(degrees) / 2
    sides = np.array([[0, s * np.sin(half), -np.cos(half)] for s in (1, -1)])
    outward = np.array([[0, s * np.cos(half), np.sin(half)] for s in (1, -1)])
    touching = rounding / np.tan(half)
    parts = []
    for k in range(2):
        x, s = scattered(rng, length, width - touching, pitch)
        height = noise * rng.normal(size=len(x))
        flat = (touching + s)[:, None] * sides[k] + height[:, None] * outward[k]
        parts.append(flat + (x - length / 2)[:, None] * [1, 0, 0])
    if rounding:
        span = np.pi - 2 * half
        x, arc = scattered(rng, length, rounding * span, pitch)
        turn = arc / rounding - span / 2
        radius = rounding + noise * rng.normal(size=len(x))
        y, z = radius * np.sin(turn), radius * np.cos(turn) - rounding / np.sin(half)
        parts.append(np.column_stack([x - length / 2, y, z]))
    points = np.vstack(parts) + np.array([0, 0, raised])
    turn = Rotation.random(random_state=seed) if turned else Rotation.identity()
    place = np.asarray(moved, dtype=float)
    return Wedge(
        PointCloud(
            turn.apply(points) + place,
            probe_radius,
            None if approach is None else turn.apply(approach),
        ),
        place,
        turn.apply([1.0, 0, 0]),
        turn.apply(sides),
        turn.apply(outward),
        np.radians(degrees),
        length,
    )


@dataclass(frozen=True)
class Can:
    """The closed upper end of a cylinder: its rim is a circle."""

    cloud: PointCloud
    centre: np.ndarray
    axis: np.ndarray
    radius: float

    def on_rim(self, turn):
        """The point of the rim at a turn round the axis, rad."""
        first = np.cross(self.axis, [0.3, -0.5, 0.8])
        first /= np.linalg.norm(first)
        second = np.cross(self.axis, first)
        return self.centre + self.radius * (np.cos(turn) * first + np.sin(turn) * second)

    def distance(self, points):
        offset = np.asarray(points) - self.centre
        height = offset @ self.axis
        return np.hypot(
            np.linalg.norm(offset - height[:, None] * self.axis, axis=1) - self.radius, height
        )


def make_can(radius=10.0, height=8.0, pitch=0.5, noise=0.02, seed=0):
    rng = np.random.default_rng([seed, 78])
    arc, down = scattered(rng, 2 * np.pi * radius, height, pitch)
    wall = radius + noise * rng.normal(size=len(arc))
    turn = arc / radius
    x, y = scattered(rng, 2 * radius, 2 * radius, pitch)
    lid = np.column_stack([x - radius, y - radius, noise * rng.normal(size=len(x))])
    lid = lid[np.hypot(lid[:, 0], lid[:, 1]) < radius]
    rotation = Rotation.random(random_state=seed)
    place = np.array([5.0, 4.0, -3.0])
    points = np.vstack([np.column_stack([wall * np.cos(turn), wall * np.sin(turn), -down]), lid])
    return Can(
        PointCloud(rotation.apply(points) + place), place, rotation.apply([0, 0, 1.0]), radius
    )


def make_cube(size=20.0, pitch=0.5, noise=0.02, seed=0):
    """Three faces of a cube that meet in the origin; its edges are the axes."""
    rng = np.random.default_rng([seed, 79])
    faces = []
    for axis in range(3):
        u, v = scattered(rng, size, size, pitch)
        face = np.empty((len(u), 3))
        face[:, axis] = noise * rng.normal(size=len(u))
        face[:, (axis + 1) % 3], face[:, (axis + 2) % 3] = u, v
        faces.append(face)
    return PointCloud(np.vstack(faces))


@pytest.fixture(scope="session")
def wedge():
    return make_wedge


@pytest.fixture(scope="session")
def can():
    return make_can


@pytest.fixture(scope="session")
def cube():
    return make_cube


def mahalanobis(part, edge):
    """Distance of each edge point from the true straight edge in its own sigmas, (m,)."""
    normals = edge.normals
    axes = np.stack([normals[:, 0] + normals[:, 1], normals[:, 0] - normals[:, 1]], axis=1)
    axes /= np.linalg.norm(axes, axis=-1, keepdims=True)
    away = np.einsum("mai,mi->ma", axes, part.across(edge.points))
    return np.sqrt(np.einsum("ma,mab,mb->m", away, np.linalg.inv(edge.covariance), away))


@pytest.fixture(scope="session")
def sigmas_away():
    return mahalanobis


@pytest.fixture(scope="session")
def right_angle():
    """A sharp right-angled wedge and its edge, scanned from one click."""
    part = make_wedge(90.0)
    return part, scan_edge(part.cloud, part.at(0.1, 0.4))


class ExtrudedPart:
    """A measuring machine over a part that is extruded along y; its contacts are exact.

    The section across y is a polyline of (x, z) with the air on its left, and may be another one
    from some y on. The probe is a point and comes from above.
    """

    probe_radius = 0.0
    approach = np.array([0.0, 0.0, -1.0])

    def __init__(self, *pieces):
        """`pieces`: (from y, to y, polyline), or one polyline for all y."""
        if len(pieces) == 1 and np.ndim(pieces[0]) == 2:
            pieces = ((-np.inf, np.inf, pieces[0]),)
        self.pieces = [(low, high, np.asarray(line, dtype=float)) for low, high, line in pieces]
        self.searches, self.moves, self.collisions = [], [], []

    @classmethod
    def wedge(cls, degrees, reach=40.0, shift=0.0):
        """Polyline of a wedge whose first side is level and ends at x = shift."""
        turn = np.radians(180.0 - degrees)
        return [[-reach, 0.0], [shift, 0.0], [shift + reach * np.cos(turn), -reach * np.sin(turn)]]

    def section(self, y):
        return next(line for low, high, line in self.pieces if low <= y < high)

    def off(self, points):
        """Distances of points from the part's surface, (n,)."""
        return np.array([self._off(point) for point in points])

    def _off(self, point):
        line = self.section(point[1])
        first, way = line[:-1], np.diff(line, axis=0)
        offset = point[[0, 2]] - first
        share = np.clip((offset * way).sum(axis=1) / (way**2).sum(axis=1), 0.0, 1.0)
        return np.linalg.norm(offset - share[:, None] * way, axis=1).min()

    def _meets(self, start, way, farthest):
        """Smallest parameter in (0, farthest] at which a straight way meets the part, or None."""
        met, (dx, dz) = [], way[[0, 2]]
        for low, high, line in self.pieces:
            first, along = line[:-1], np.diff(line, axis=0)
            gap = first - start[[0, 2]]
            size = dx * along[:, 1] - dz * along[:, 0]
            size = np.where(size > 1e-12, size, np.nan)  # out of the air, into the part
            t = (gap[:, 0] * along[:, 1] - gap[:, 1] * along[:, 0]) / size
            share = (gap[:, 0] * dz - gap[:, 1] * dx) / size
            y = start[1] + t * way[1]
            good = (t > 1e-9) & (t <= farthest) & (share >= 0.0) & (share <= 1.0)
            met.extend(t[good & (y >= low) & (y < high)])
        return min(met, default=None)

    def move(self, start, end):
        self.moves.append((start, end))
        t = self._meets(start, end - start, 1.0)
        if t is None:
            return None
        self.collisions.append(start + t * (end - start))
        return self.collisions[-1]

    def touch(self, start, direction, prehit_distance, search_distance):
        self.searches.append((start, direction, prehit_distance))
        t = self._meets(start, direction, prehit_distance + search_distance)
        return None if t is None else start + t * direction


@pytest.fixture(scope="session")
def extruded():
    return ExtrudedPart


def make_strewn_box(size, pitch, noise, seed=0):
    """A box with one corner in the origin, its points at random over its faces, one a pitch²."""
    rng = np.random.default_rng(seed)
    size, faces = np.asarray(size), []
    for axis in range(3):
        others = [k for k in range(3) if k != axis]
        count = int(np.prod(size[others]) / pitch**2)
        for level in (0.0, size[axis]):
            points = np.empty((count, 3))
            points[:, others] = rng.uniform(0.0, size[others], (count, 2))
            points[:, axis] = level + rng.normal(0.0, noise, count)
            faces.append(points)
    return PointCloud(np.vstack(faces))


@pytest.fixture(scope="session")
def strewn_box():
    return make_strewn_box
