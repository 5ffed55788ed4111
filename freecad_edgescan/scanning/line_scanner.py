# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scanning one line across an edge with a measuring machine (Schreve 4.2).

Along the line each next target lies one line pitch further on the straight line through the last
two contacts; the search for it begins one prehit distance in the air and goes square to that
straight line, in the scanning plane.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import atan2, ceil, cos, hypot, pi, sin

import numpy as np

from .cmm import Cmm
from .probe_settings import ProbeSettings
from .probed_line import farthest_from_chord
from .scan_plane import ScanPlane
from .start import numbers
from .stop import Stop

__all__ = ["LineScanner", "ScannedLine"]

_MOST_POINTS = 4.0  # times as many as fit on a line of one amplitude
_SLACK = 1.0 + 1e-6  # of a pitch, for rounding errors
_SAME_POINT = 1e-6  # line pitches
_LEAST_PROGRESS = 0.1  # line pitches, towards the target
_BACK = -0.8  # cosine of a turn that is no edge any more but the way back
_ONWARD = 0.9  # cosine between a step and the surface behind the edge, that lies on it
_LONGER_STEPS = (2.0, 3.0)  # line pitches, tried after a point that was touched twice
_NEAR = 0.25  # amplitudes from its target, where a collision is as good as a touch
_FAR = 2.0  # amplitudes between two lines that do not follow each other
_EDGE_GAP = 0.5  # line pitches between the contacts beside the edge
_GOOD_GAP = 0.25  # line pitches that such a gap may be longer
_BESIDE = 0.1  # line pitches that the edge may lie beside where it was predicted
_ROUND_TURNS = (0.6, 1.2, 1.8)  # rad, tried round an edge behind which nothing was touched
_LEAST_TURN = 0.3  # rad, to the surface behind the edge: below it the probe is there already


@dataclass(frozen=True)
class ScannedLine:
    """Contacts (n, 3) in the order of travel, and why there are no more, if they do not suffice."""

    contacts: np.ndarray
    stop: Stop | None


class _Halted(Exception):
    """No further contact on this line."""

    def __init__(self, stop: Stop) -> None:
        super().__init__(stop.value)
        self.stop = stop


class LineScanner:
    """Scans lines with a machine and keeps where the machine stands.

    Parameters
    ----------
    cmm : who touches
    settings : pitches, amplitude, prehit and search distance
    """

    def __init__(self, cmm: Cmm, settings: ProbeSettings) -> None:
        self.cmm, self.settings = cmm, settings
        self.position: np.ndarray | None = None

    def scan(
        self,
        plane: ScanPlane,
        start: tuple[float, float],
        heading: tuple[float, float],
        first: np.ndarray | None = None,
        onward: tuple[float, float] | None = None,
        edge_at: float | None = None,
    ) -> ScannedLine:
        """Scan a line until it is one amplitude long, with half of it behind the edge.

        Parameters
        ----------
        plane : in which the line is scanned
        start : coordinates in the plane of the first target, which is touched along y
        heading : unit direction in the plane from the first contact to the second
        first : (3,) mm, a contact that is already there and begins the line
        onward : unit direction in the plane of the surface behind the edge, where it is known
        edge_at : x in the plane, mm, where an edge known to be sharp is expected; the gap between
            the contacts is narrowed there
        """
        line = _Line(plane, onward, edge_at)
        try:
            if first is None:
                first = self._first(plane, start)
            line.add(first)
            self._second(line, heading)
            most = _MOST_POINTS * self.settings.amplitude / self.settings.line_pitch + 10.0
            # As printed a line is too long by half a pitch on the average.
            short = 0.0 if edge_at is None else 0.5 * self.settings.line_pitch
            while not line.complete(
                self.settings.amplitude - short, self.settings.half_line - short
            ):
                if len(line) > most:
                    return ScannedLine(np.array(line.contacts), Stop.NO_EDGE)
                self._next(line)
        except _Halted as halt:
            # What lies behind the edge may suffice.
            return ScannedLine(np.array(line.contacts).reshape(-1, 3), halt.stop)
        return ScannedLine(np.array(line.contacts), None)

    def _first(self, plane: ScanPlane, start: tuple[float, float]) -> np.ndarray:
        self._fly_over(plane.place(*start))
        contact, collided = self._touch(plane, *start, 0.0, 1.0)
        if contact is None:
            raise _Halted(Stop.OFF_OBJECT)
        if collided:
            away = float(np.linalg.norm(contact - plane.place(*start)))
            allowed = self.settings.safeguards.near_collisions
            if not allowed or away > _NEAR * self.settings.amplitude:
                raise _Halted(Stop.COLLISION)
        return contact

    def _fly_over(self, target: np.ndarray) -> None:
        """Come from another end of the edge, high above the part."""
        if self.position is None:
            return
        way = target - self.position
        if np.linalg.norm(way) < _FAR * self.settings.amplitude:
            return
        rise = -self.settings.search_distance * self.settings.approach
        for place in (self.position + rise, target + rise):
            if self._go(place) is not None:
                raise _Halted(Stop.COLLISION)
            self.position = place

    def _second(self, line: _Line, heading: tuple[float, float]) -> None:
        line.heading = heading
        self._next(line)

    def _next(self, line: _Line) -> None:
        """Touch the next point; refill the gap before it."""
        pitch, safeguards = self.settings.line_pitch, self.settings.safeguards
        x, y = line.end
        ux, uy = line.heading
        contact, _ = self._touch(line.plane, x + pitch * ux, y + pitch * uy, -uy, ux)
        if contact is None:
            contact = self._round_the_edge(line)
        if contact is None:
            raise _Halted(Stop.OFF_OBJECT)
        if not line.moved_on(contact, pitch, safeguards.step_on):
            contact = self._step_on(line) if safeguards.step_on else None
            if contact is None:
                raise _Halted(Stop.REPEATED_POINT)
        gap = hypot(*line.step_to(contact))
        if gap > safeguards.largest_gap * pitch * _SLACK:
            for between in self._between(line, contact, ceil(gap / (pitch * _SLACK)) - 1):
                self._add(line, between)
        self._add(line, contact)

    def _add(self, line: _Line, contact: np.ndarray) -> None:
        """Add a contact, after some more of them when the edge may lie before it."""
        pitch = self.settings.line_pitch
        if line.passes_the_edge(contact, _BESIDE * pitch):
            dx, dy = line.step_to(contact)
            gap = hypot(dx, dy)
            count = ceil((gap / pitch - _GOOD_GAP) / _EDGE_GAP) - 1
            for between in self._between(line, contact, count):
                line.add(between)
            line.add(contact)
            # The last of these steps is too short to tell the way on.
            line.heading = (dx / gap, dy / gap)
        else:
            line.add(contact)

    def _step_on(self, line: _Line) -> np.ndarray | None:
        """Look for a new point in longer steps."""
        (x, y), (ux, uy), pitch = line.end, line.heading, self.settings.line_pitch
        for longer in _LONGER_STEPS:
            step = longer * pitch
            contact, _ = self._touch(line.plane, x + step * ux, y + step * uy, -uy, ux)
            if contact is not None and line.moved_on(contact, pitch, True):
                return contact
        return None

    def _round_the_edge(self, line: _Line) -> np.ndarray | None:
        """Look for the part once more when a search went past it (Schreve figure 4.20)."""
        x, y = line.end
        if not self.settings.safeguards.feel_round:
            # Between the last contact and where the search has ended.
            ux, uy = line.heading
            pitch, depth = self.settings.line_pitch, self.settings.search_distance
            ex, ey = pitch * ux - depth * uy, pitch * uy + depth * ux
            size = hypot(ex, ey)
            contact, _ = self._touch(line.plane, x + 0.5 * ex, y + 0.5 * ey, -ey / size, ex / size)
            return contact
        angle, pitch = atan2(line.heading[1], line.heading[0]), self.settings.line_pitch
        turns: Sequence[float] = _ROUND_TURNS
        if line.onward is not None:
            left = (atan2(line.onward[1], line.onward[0]) - angle) % (2.0 * pi)
            # Behind the edge there is nothing to feel round for: the part ends here.
            turns = (0.5 * left, left) if _LEAST_TURN < left < pi else ()
        for turn in turns:
            ux, uy = cos(angle + turn), sin(angle + turn)
            contact, _ = self._touch(line.plane, x + pitch * ux, y + pitch * uy, -uy, ux)
            if contact is not None and hypot(*line.step_to(contact)) < self.settings.amplitude:
                return contact
        return None

    def _between(self, line: _Line, contact: np.ndarray, count: int) -> list[np.ndarray]:
        """Touch points between the last contact and one too far from it (Schreve 4.2.2)."""
        (x, y), (ex, ey) = line.end, line.plane.coordinates(contact)
        gx, gy = ex - x, ey - y
        size = hypot(gx, gy)
        ux, uy = gx / size, gy / size
        least, done = _LEAST_PROGRESS * self.settings.line_pitch, 0.0
        found = []
        for k in range(1, count + 1):
            share = k / (count + 1)
            # An edge in the gap may stand half the gap above its chord.
            between, _ = self._touch(
                line.plane, x + share * gx, y + share * gy, -uy, ux, lift=0.5 * size
            )
            if between is None:
                continue
            bx, by = line.plane.coordinates(between)
            along = (bx - x) * ux + (by - y) * uy
            if min(along - done, size - along) > least:
                found.append(between)
                done = along
        return found

    def _touch(
        self, plane: ScanPlane, x: float, y: float, dx: float, dy: float, lift: float = 0.0
    ) -> tuple[np.ndarray | None, bool]:
        """Contact of a search for a target along a direction, and whether the way to it collided.

        What it collided with is measured again there (Schreve 4.7.2).
        """
        way = dx * plane.across + dy * plane.inward
        start = plane.place(x, y) - (self.settings.prehit_distance + lift) * way
        before = self.position
        collision = self._go(start)
        if collision is None or before is None:
            return self._search(start, way, lift), False
        contact = self._measured_again(before, collision)
        self._leave(contact, way)
        return contact, True

    def _measured_again(self, before: np.ndarray, collision: np.ndarray) -> np.ndarray:
        """Contact of a search from where the machine came from, in its direction of travel."""
        travel = collision - before
        size = float(np.linalg.norm(travel))
        if size == 0.0:
            return collision
        way = travel / size
        clear = collision - min(self.settings.prehit_distance, size) * way
        self.cmm.move(collision, clear)  # the way it came from is free
        self.position = clear
        again = self._search(clear, way)
        return collision if again is None else again

    def _leave(self, contact: np.ndarray, way: np.ndarray) -> None:
        """Rise from a surface against the direction in which the part was expected."""
        place = contact - self.settings.prehit_distance * way
        if self._go(place) is None:
            self.position = place

    def _search(self, start: np.ndarray, way: np.ndarray, lift: float = 0.0) -> np.ndarray | None:
        """Contact of a search along a direction; the machine goes back from it into the air."""
        prehit = self.settings.prehit_distance + lift
        contact = self.cmm.touch(start, way, prehit, self.settings.search_distance)
        self.position = start
        if contact is None:
            return None
        contact = _point(contact)
        self.position = start + max(float((contact - start) @ way) - prehit, 0.0) * way
        return contact

    def _go(self, target: np.ndarray) -> np.ndarray | None:
        if self.position is None:
            return None
        collision = self.cmm.move(self.position, target)
        return None if collision is None else _point(collision)


def _point(answer: np.ndarray) -> np.ndarray:
    """What a machine answered, when it is a point."""
    point = numbers(answer)
    if point is None:
        raise ValueError(f"an answer of {answer!r} instead of three finite numbers")
    return point


class _Line:
    """A line being scanned: its contacts, in space and in its plane."""

    def __init__(
        self, plane: ScanPlane, onward: tuple[float, float] | None, edge_at: float | None
    ) -> None:
        self.plane, self.onward, self.edge_at = plane, onward, edge_at
        self.contacts: list[np.ndarray] = []
        self.xy: list[tuple[float, float]] = []
        self.length = 0.0
        self.heading = (1.0, 0.0)

    def __len__(self) -> int:
        return len(self.contacts)

    @property
    def end(self) -> tuple[float, float]:
        return self.xy[-1]

    def add(self, contact: np.ndarray) -> None:
        here = self.plane.coordinates(contact)
        if self.xy:
            x, y = self.xy[-1]
            step = hypot(here[0] - x, here[1] - y)
            self.length += step
            if step > 0.0:
                self.heading = ((here[0] - x) / step, (here[1] - y) / step)
        self.contacts.append(contact)
        self.xy.append(here)

    def passes_the_edge(self, contact: np.ndarray, beside: float) -> bool:
        """Whether the gap before a contact holds, or lies beside, a sharp edge.

        On a rounding more contacts would be of no use: they are cleaned away, and those that are
        not pull the curve.
        """
        if self.edge_at is None:
            return False
        there = self.plane.coordinates(contact)[0]
        return self.end[0] < self.edge_at + beside and there > self.edge_at - beside

    def step_to(self, contact: np.ndarray) -> tuple[float, float]:
        """From the last contact to another one, in the plane."""
        (x, y), (hx, hy) = self.xy[-1], self.plane.coordinates(contact)
        return hx - x, hy - y

    def moved_on(self, contact: np.ndarray, pitch: float, strict: bool) -> bool:
        """Whether a contact is another one than the last, and (strictly) does not lead back."""
        offset = contact - self.contacts[-1]
        if float(offset @ offset) < (_SAME_POINT * pitch) ** 2:
            return False
        if not strict:
            return True
        dx, dy = self.step_to(contact)
        gap, ahead = hypot(dx, dy), dx * self.heading[0] + dy * self.heading[1]
        if gap <= _LEAST_PROGRESS * pitch:
            return False
        if ahead > _BACK * gap or self.onward is None:
            return True
        # Round a sharp edge the way on leads back, too.
        return dx * self.onward[0] + dy * self.onward[1] > _ONWARD * gap

    def complete(self, amplitude: float, half_line: float) -> bool:
        """Whether the line is long enough, as a whole and behind the edge (Schreve 4.2.3)."""
        return self.length >= amplitude and self._behind_edge() >= half_line

    def _behind_edge(self) -> float:
        """Length from where the edge seems to be."""
        xy = np.array(self.xy)
        behind = np.diff(xy[farthest_from_chord(xy, self.plane.wedge) :], axis=0)
        return float(np.hypot(behind[:, 0], behind[:, 1]).sum())
