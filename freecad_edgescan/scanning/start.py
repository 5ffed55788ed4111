# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a scan begins and ends, as a person touches it (Schreve 4.6)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .errors import ScanError

Vector = Sequence[float] | np.ndarray
UNIT_BLUR = 8 * float(np.finfo(float).eps)  # what rounding leaves between a unit vector and 1


@dataclass(frozen=True)
class Start:
    """First point of the first scan line, that line's direction, and the direction of the walk.

    Attributes
    ----------
    point : (3,) array, mm, on one side of the edge, half an amplitude away from it
    across : (3,) unit vector from the point towards the edge
    along : (3,) unit vector, roughly the direction to walk in
    """

    point: np.ndarray
    across: np.ndarray
    along: np.ndarray

    def __init__(self, point: Vector, across: Vector, along: Vector) -> None:
        object.__setattr__(self, "point", _point("start point", point))
        object.__setattr__(self, "across", _unit("direction across the edge", across))
        object.__setattr__(self, "along", _unit("direction along the edge", along))
        if abs(float(self.across @ self.along)) > 0.97:
            raise ScanError(
                f"The start's directions across {_text(across)} and along {_text(along)} are "
                "nearly the same; give one across the edge and one along it."
            )

    @classmethod
    def from_points(cls, first: Vector, second: Vector, third: Vector) -> Start:
        """Start touched as three points: on the line's start, across the edge, along the edge."""
        a, b, c = (_point("start point", p) for p in (first, second, third))
        return cls(a, b - a, c - a)


@dataclass(frozen=True)
class Gate:
    """Where a walk ends: a line of one amplitude across the edge.

    Attributes
    ----------
    point : (3,) array, mm, the gate's first end
    across : (3,) unit vector from there across the edge
    """

    point: np.ndarray
    across: np.ndarray

    def __init__(self, point: Vector, across: Vector) -> None:
        object.__setattr__(self, "point", _point("gate point", point))
        object.__setattr__(self, "across", _unit("direction across the gate", across))

    @classmethod
    def from_points(cls, first: Vector, second: Vector) -> Gate:
        """Gate touched as two points: its first end, and the direction across the edge."""
        a, b = (_point("gate point", p) for p in (first, second))
        return cls(a, b - a)

    def crossing(
        self, before: np.ndarray, after: np.ndarray, amplitude: float, upright: np.ndarray
    ) -> float | None:
        """Share of the way from one edge point to the next where the gate is crossed, or None.

        The gate reaches from its point over one amplitude across, and without end both ways
        along ``upright`` (the approach).
        """
        plane = np.cross(self.across, upright)
        size = float(np.linalg.norm(plane))
        if size < 1e-6:
            return None
        plane /= size
        distance = float((before - self.point) @ plane), float((after - self.point) @ plane)
        if distance[0] == distance[1] or distance[0] * distance[1] > 0:
            return None
        share = distance[0] / (distance[0] - distance[1])
        crossing = before + share * (after - before) - self.point
        along = self.across - (self.across @ upright) * upright
        reach = float(crossing @ along) / float(along @ along)
        return share if 0.0 <= reach <= amplitude else None


def numbers(value: object) -> np.ndarray | None:
    """Three finite numbers as an array, or None when they are something else."""
    try:
        array = np.array(value, dtype=float)
    except (TypeError, ValueError):
        return None
    return array if array.shape == (3,) and bool(np.all(np.isfinite(array))) else None


def _point(name: str, value: Vector) -> np.ndarray:
    point = numbers(value)
    if point is None:
        raise ScanError(f"The {name} is {_text(value)}; give three finite numbers in mm.")
    point.setflags(write=False)
    return point


def _unit(name: str, value: Vector) -> np.ndarray:
    vector = _point(name, value)
    size = float(np.linalg.norm(vector))
    if size == 0.0:
        raise ScanError(f"The {name} has no length; give two different points or a direction.")
    # A unit vector stays as it is, bit for bit: it may have been kept in a document or a macro.
    unit = vector if abs(size - 1.0) <= UNIT_BLUR else vector / size
    unit.setflags(write=False)
    return unit


def _text(value: object) -> str:
    try:
        return "(" + ", ".join(f"{float(x):g}" for x in value) + ")"  # type: ignore[attr-defined]
    except (TypeError, ValueError):
        return repr(value)
