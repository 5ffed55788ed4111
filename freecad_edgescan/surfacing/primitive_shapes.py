# SPDX-License-Identifier: LGPL-2.1-or-later
"""Planes, cylinders, cones, spheres and quadrics: distances of points, and the part they cover.

Cones are cylinders whose radius grows along the axis, so that one that hardly tapers is no special
case. Quadrics are graphs of degree 2 over a plane.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Protocol, Self

import numpy as np
from numpy.typing import NDArray

from ..geometry import BSplineCurve, BSplineSurface, Circle
from ..geometry.exact_surfaces import circular_arc, revolved_surface
from ..geometry.frames import orthonormalise
from ..geometry.plain_number import plain

__all__ = ["Cone", "Cylinder", "FlatPlane", "Primitive", "QuadricGraph", "ShapeKind", "Sphere"]

Array = NDArray[np.float64]

_MARGIN = 0.02  # of the covered range, added at both ends
_CLOSED = 0.35  # rad; a smaller gap round an axis is none
_FULL = 2.0 * np.pi
_LINE = np.array([0.0, 0, 1, 1])


class ShapeKind(StrEnum):
    """What a base surface is."""

    PLANE = "plane"
    CYLINDER = "cylinder"
    CONE = "cone"
    SPHERE = "sphere"
    QUADRIC = "quadric"
    EDGES = "edges"  # between four edges
    SWEEP = "sweep"  # along rails


class Primitive(Protocol):
    """What all these shapes can do."""

    @property
    def kind(self) -> ShapeKind:
        """Which of them it is."""

    @property
    def unknowns(self) -> int:
        """How many numbers say where it is."""

    def distances(self, points: Array) -> Array:
        """Signed distances (n,) of points (n, 3), mm."""

    def surface(self, points: Array) -> BSplineSurface:
        """The part that points (n, 3) cover, and a little more."""

    def moved(self, way: Array) -> Primitive:
        """The shape moved by (3,) mm."""

    def said(self) -> str:
        """The shape in words and numbers."""


@dataclass(frozen=True, eq=False)
class FlatPlane:
    """A plane through a point (3,), mm, with a unit normal (3,)."""

    point: Array
    normal: Array
    kind = ShapeKind.PLANE
    unknowns = 3

    def distances(self, points: Array) -> Array:
        """Signed distances (n,), mm."""
        return np.asarray((points - self.point) @ self.normal)

    def surface(self, points: Array) -> BSplineSurface:
        """A rectangle."""
        frame = _frame(points, self.normal)
        local = (points - self.point) @ frame[:2].T
        (a0, a1), (b0, b1) = (_widened(own.min(), own.max()) for own in local.T)
        poles = self.point + np.array([[[a0, b0], [a0, b1]], [[a1, b0], [a1, b1]]]) @ frame[:2]
        return BSplineSurface(
            poles, (np.array([a0, a0, a1, a1]), np.array([b0, b0, b1, b1])), (1, 1)
        )

    def moved(self, way: Array) -> Self:
        """Moved by (3,) mm."""
        return replace(self, point=self.point + way)

    def said(self) -> str:
        """In words."""
        return "A plane"


@dataclass(frozen=True, eq=False)
class Cone:
    """A cone round an axis through a point (3,), mm, with a unit direction (3,).

    Its radius is `radius`, mm, beside the point, and grows along the axis by tan(slope), rad.
    """

    point: Array
    axis: Array
    radius: float
    slope: float
    kind = ShapeKind.CONE
    unknowns = 6

    def distances(self, points: Array) -> Array:
        """Signed distances (n,), mm, positive outside."""
        away = points - self.point
        height = away @ self.axis
        ring = np.linalg.norm(away - height[:, None] * self.axis, axis=1)
        off = ring - self.radius - height * np.tan(self.slope)
        return np.asarray(off * np.cos(self.slope))

    def surface(self, points: Array) -> BSplineSurface:
        """A line turned about the axis over the angles covered, all round without a wide gap."""
        away = points - self.point
        height = away @ self.axis
        low, high = _widened(height.min(), height.max())
        grow = float(np.tan(self.slope))
        if grow != 0.0:  # not over the apex
            apex = -self.radius / grow
            low, high = (max(low, apex), high) if grow > 0.0 else (low, min(high, apex))
        reference = orthonormalise(self.axis, np.zeros(3))
        side = np.cross(self.axis, reference)
        start, turn = _covered(np.arctan2(away @ side, away @ reference))
        out = np.cos(start) * reference + np.sin(start) * side
        ends = [
            self.point + at * self.axis + max(self.radius + at * grow, 1e-6 * self.radius) * out
            for at in (low, high)
        ]
        return revolved_surface(BSplineCurve(np.array(ends), _LINE, 1), self.point, self.axis, turn)

    def moved(self, way: Array) -> Self:
        """Moved by (3,) mm."""
        return replace(self, point=self.point + way)

    def said(self) -> str:
        """In words."""
        return f"A cone of half angle {abs(np.degrees(self.slope)):.4g}°"


@dataclass(frozen=True, eq=False)
class Cylinder(Cone):
    """A cylinder round an axis through a point (3,), mm, with a unit direction (3,)."""

    slope: float = 0.0
    kind = ShapeKind.CYLINDER
    unknowns = 5

    def said(self) -> str:
        """In words."""
        return f"A cylinder of radius {plain(self.radius, 5)} mm"


@dataclass(frozen=True, eq=False)
class Sphere:
    """A sphere with a centre (3,) and a radius, mm."""

    centre: Array
    radius: float
    kind = ShapeKind.SPHERE
    unknowns = 4

    def distances(self, points: Array) -> Array:
        """Signed distances (n,), mm, positive outside."""
        return np.asarray(np.linalg.norm(points - self.centre, axis=1) - self.radius)

    def surface(self, points: Array) -> BSplineSurface:
        """An arc turned about an axis that lies across the part covered."""
        away = points - self.centre
        axis = orthonormalise(_unit(away.mean(axis=0)), np.zeros(3))
        reference = orthonormalise(axis, away.mean(axis=0))
        side = np.cross(axis, reference)
        start, turn = _covered(np.arctan2(away @ side, away @ reference))
        height = np.arcsin(np.clip(away @ axis / np.linalg.norm(away, axis=1), -1.0, 1.0))
        low, high = np.clip(_widened(height.min(), height.max()), -np.pi / 2, np.pi / 2)
        out = np.cos(start) * reference + np.sin(start) * side
        # angles from `out` to `axis`
        arc = circular_arc(Circle(self.centre, np.cross(out, axis), self.radius, out), low, high)
        return revolved_surface(arc, self.centre, axis, turn)

    def moved(self, way: Array) -> Self:
        """Moved by (3,) mm."""
        return replace(self, centre=self.centre + way)

    def said(self) -> str:
        """In words."""
        return f"A sphere of radius {plain(self.radius, 5)} mm"


@dataclass(frozen=True, eq=False)
class QuadricGraph:
    """h = c0 + c1 a + c2 b + c3 a² + c4 ab + c5 b² over the frame (3, 3) at an origin (3,)."""

    origin: Array
    frame: Array
    coefficients: Array
    kind = ShapeKind.QUADRIC
    unknowns = 8  # the plane's tilt counts too, once it is chosen

    def distances(self, points: Array) -> Array:
        """Signed distances (n,), mm, to first order."""
        a, b, h = (self.frame @ (points - self.origin).T).reshape(3, -1)
        c = self.coefficients
        slope_a, slope_b = c[1] + 2 * c[3] * a + c[4] * b, c[2] + c[4] * a + 2 * c[5] * b
        lift = h - (c[0] + c[1] * a + c[2] * b + c[3] * a * a + c[4] * a * b + c[5] * b * b)
        return np.asarray(lift / np.sqrt(1.0 + slope_a**2 + slope_b**2))

    def surface(self, points: Array) -> BSplineSurface:
        """The graph over a rectangle, exactly: a biquadratic patch."""
        local = (points - self.origin) @ self.frame[:2].T
        (a0, a1), (b0, b1) = (_widened(own.min(), own.max()) for own in local.T)
        # blossoms of 1, x, x² at (x0, x0), (x0, x1), (x1, x1)
        a, b = np.array([a0, (a0 + a1) / 2, a1]), np.array([b0, (b0 + b1) / 2, b1])
        aa, bb = np.array([a0 * a0, a0 * a1, a1 * a1]), np.array([b0 * b0, b0 * b1, b1 * b1])
        c = self.coefficients
        h = (c[0] + c[1] * a + c[3] * aa)[:, None] + c[2] * b + c[5] * bb + c[4] * np.outer(a, b)
        poles = np.stack(np.broadcast_arrays(a[:, None], b, h), axis=-1) @ self.frame + self.origin
        return BSplineSurface(poles, (np.repeat([a0, a1], 3), np.repeat([b0, b1], 3)), (2, 2))

    def moved(self, way: Array) -> Self:
        """Moved by (3,) mm."""
        return replace(self, origin=self.origin + way)

    def said(self) -> str:
        """In words."""
        return "A quadric"


def _unit(vector: Array) -> Array:
    length = float(np.linalg.norm(vector))
    return vector / length if length > 0.0 else np.array([0.0, 0.0, 1.0])


def _frame(points: Array, normal: Array) -> Array:
    """Rows: two directions along a plane, the longer extent first, and its normal."""
    centred = points - points.mean(axis=0)
    flat = centred - (centred @ normal)[:, None] * normal
    longest = np.linalg.eigh(flat.T @ flat)[1][:, 2]
    first = orthonormalise(normal, longest)
    return np.stack([first, np.cross(normal, first), normal])


def _widened(low: float, high: float) -> tuple[float, float]:
    spare = _MARGIN * (high - low)
    return float(low - spare), float(high + spare)


def _covered(angles: Array) -> tuple[float, float]:
    """Where the angles begin and how far they reach, rad; all round without a wide gap."""
    ordered = np.sort(np.mod(angles, _FULL))
    gaps = np.diff(np.append(ordered, ordered[0] + _FULL))
    widest = int(np.argmax(gaps))
    if gaps[widest] < _CLOSED:
        return 0.0, _FULL
    turn = _FULL - gaps[widest]
    spare = min(_MARGIN * turn, 0.4 * gaps[widest])
    return float(ordered[(widest + 1) % len(ordered)] - spare), float(turn + 2 * spare)
