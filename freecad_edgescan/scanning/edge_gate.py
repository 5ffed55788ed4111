# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a walk is to end: a line across the edge, or a point near it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np

from ..geometry.place_text import place_text
from ..geometry.plain_number import plain
from .errors import ScanError
from .section import Station
from .start import Gate, Start, numbers
from .trace import turned

__all__ = ["EdgeGate", "LineGate", "PointGate", "heading_for", "make_gate", "until"]

Point = Sequence[float] | np.ndarray


class EdgeGate(Protocol):
    """Tells from two following edge points whether the walk has arrived."""

    passes: bool
    """Whether the edge ends with the point behind the gate, not with the one before it."""

    def __call__(self, before: np.ndarray, after: np.ndarray) -> bool:
        """Whether the step from one point to the next arrived."""
        ...


class LineGate:
    """Ends a walk whose last step crossed a gate."""

    passes = True

    def __init__(self, gate: Gate, amplitude: float, approach: np.ndarray | None) -> None:
        self.gate, self.amplitude, self.approach = gate, amplitude, approach

    def __call__(self, before: np.ndarray, after: np.ndarray) -> bool:
        """Whether the step crosses the gate's line."""
        upright = self.approach
        if upright is None:
            upright = np.cross(self.gate.across, after - before)
            size = float(np.linalg.norm(upright))
            if size < 1e-9:
                return False
            upright = upright / size
        return self.gate.crossing(before, after, self.amplitude, upright) is not None


class PointGate:
    """Ends a walk once it is leaving the neighbourhood of a point."""

    passes = False

    def __init__(self, point: np.ndarray, reach: float) -> None:
        self.point, self.reach = point, reach

    def __call__(self, before: np.ndarray, after: np.ndarray) -> bool:
        """Whether the step leads away from the point, near it."""
        was, now = (float(np.linalg.norm(p - self.point)) for p in (before, after))
        return was < self.reach and now > was


def until(arrived: EdgeGate, points: np.ndarray) -> slice:
    """The edge points (m, 3) up to a gate, which is found again on the finished edge."""
    for j in range(1, len(points)):
        if arrived(points[j - 1], points[j]):
            return slice(0, j + 1 if arrived.passes else j)
    return slice(0, len(points))


def make_gate(
    gate: Point | Gate | None,
    start: Start | None,
    first: Station,
    reach: float,
    edge_pitch: float,
    approach: np.ndarray | None,
) -> LineGate | PointGate | None:
    """What tells the walk that it has arrived.

    Parameters
    ----------
    gate : as the user gave it
    start : where the walk begins, if one was given
    first : its first station
    reach : half the amplitude, mm
    edge_pitch : mm
    approach : (3,) unit vector, or None when unknown

    Raises
    ------
    ScanError: a gate that cannot be passed.
    """
    if gate is None:
        return None
    if isinstance(gate, Gate):
        _check_ahead(start, gate.point, reach)
        return LineGate(gate, 2.0 * reach, approach)
    point = numbers(gate)
    if point is None:
        raise ScanError(f"The gate is {gate!r}; give a Gate or three finite coordinates in mm.")
    _check_ahead(start, point, reach)
    away = float(np.linalg.norm(point - first.frame.origin[0]))
    if away < 2.0 * edge_pitch:
        raise ScanError(
            f"The gate at ({place_text(point)}) is {plain(away, 3)} mm from where the walk begins; "
            f"give one at least {plain(2.0 * edge_pitch, 3)} mm away, or none."
        )
    return PointGate(point, reach)


def heading_for(first: Station, arrived: LineGate | PointGate | None) -> Station:
    """The first station, turned to the side of the edge where its gate lies."""
    if arrived is None:
        return first
    target = arrived.point if isinstance(arrived, PointGate) else arrived.gate.point
    ahead = (target - first.frame.origin[0]) @ first.frame.tangent[0] >= 0
    return first if ahead else turned(first)


def _check_ahead(start: Start | None, point: np.ndarray, reach: float) -> None:
    """A gate just behind the start can never be passed; one farther off may lie round a bend."""
    if start is None:
        return
    way = point - start.point
    if way @ start.along < 0 and np.linalg.norm(way) < 4.0 * reach:
        raise ScanError(
            f"The gate at ({place_text(point)}) lies {plain(-float(way @ start.along), 3)} mm "
            "behind the start, against the direction of the walk; turn the start's direction along "
            "the edge round, or move the gate."
        )
