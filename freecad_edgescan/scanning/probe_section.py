# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edge points from lines that a measuring machine scans across the edge (a `Section`).

Square and zigzag are two ways of laying the next line; everything else is the same. The edge
points of the walk are intermediate ones: the probe radius is taken off in a second pass.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..geometry.place_text import place_text
from .cmm import Cmm
from .errors import ScanError
from .line_scanner import LineScanner, ScannedLine
from .parameters import Pattern
from .probe_settings import ProbeSettings
from .probed_line import ProbedLine, measure_line
from .probed_tangent import edge_tangent
from .scan_plane import ScanPlane
from .section import Frames, Station, frames_from_sides
from .sharpness import UNKNOWN, Sharpness
from .start import Start
from .stop import Stop

__all__ = ["ProbeSection"]

_DEGENERATED = 0.25  # edge pitches a zigzag's turning point may be off before it is laid anew
_ELSEWHERE = 2.0  # amplitudes from the last edge point: the machine has come from another walk
_ALONG_THE_PROBE = 0.999  # cosine between the first line and the probe, which leaves no plane
_LARGEST_LEAN = 0.7  # rad, of a side against the side it was before
_FEWEST_CONTACTS = 5  # of a line that ended early, for two sides and the split
_JUMP = 1.0  # steps that an edge point may lie aside of where it was predicted


class ProbeSection:
    """Measures edge points with a machine.

    Parameters
    ----------
    cmm : who touches
    settings : of the scan
    """

    def __init__(self, cmm: Cmm, settings: ProbeSettings) -> None:
        self.settings = settings
        self.scanner = LineScanner(cmm, settings)
        self.failure: Exception | None = None
        self._walked: list[ProbedLine] = []

    def begin(self, start: Start) -> Station:
        """Scan the first line, from a start as a person gives it (Schreve 4.6)."""
        across = start.across
        if abs(float(self.settings.approach @ across)) > _ALONG_THE_PROBE:
            raise ScanError(
                f"The start's direction across the edge ({place_text(across)}) is that of the "
                "probe; give one along the surface, towards the edge, or another approach than "
                f"({place_text(self.settings.approach)})."
            )
        inward = _square_to(self.settings.approach, across)
        tangent = _cross(across, inward)
        if tangent @ start.along < 0.0:
            tangent = -tangent
        plane = ScanPlane(start.point, across, inward)
        scanned = self._scan(plane, (0.0, 0.0), (1.0, 0.0))
        line = self._measured(scanned, plane, tangent, 0)
        if isinstance(line, Stop):
            sides = np.array([-across, across - inward])
            frame = frames_from_sides(start.point[None], tangent[None], sides[None])
            return Station(frame, stop=line)
        frame = frames_from_sides(line.edge_point[None], tangent[None], line.rough_sides[None])
        away = float(np.linalg.norm(line.edge_point - start.point))
        return Station(
            frame, line=line, stop=Stop.NO_EDGE if away > self.settings.amplitude else None
        )

    def measure(self, predicted: Frames, half_width: np.ndarray, last: Station) -> list[Station]:
        """Scan the next line, towards the one predicted edge point."""
        return [self._next_line(predicted, last)]

    def _next_line(self, predicted: Frames, last: Station) -> Station:
        before = last.line
        if before is None:
            raise TypeError("a probed scan goes on from a line")
        origin, tangent = predicted.origin[0], predicted.tangent[0]
        starts_on = self._stands_on(before, last)
        narrow = self._known_sharp(before)
        target, contact = self._line_start(before, starts_on, predicted, last)
        plane = self._plane(origin, tangent, predicted, starts_on, target)
        sides = predicted.sides[0]
        scanned = self._scan(
            plane,
            plane.coordinates(target),
            plane.direction(-sides[starts_on]),
            contact,
            plane.direction(sides[1 - starts_on]),
            plane.coordinates(origin)[0] if narrow else None,
        )
        line = self._measured(scanned, plane, tangent, starts_on, before.sharpness, narrow)
        if isinstance(line, Stop):
            return Station(predicted, stop=line)
        safeguards = self.settings.safeguards
        point, sides = line.edge_point, line.rough_sides
        here = self._walked_on(line)
        expected = here if narrow else point
        if safeguards.plausible and not self._plausible(expected, sides, predicted, last):
            return Station(predicted, stop=Stop.NO_EDGE)
        behind = self._back(last)
        gap = np.linalg.norm(point - behind.edge_point)
        if gap >= 0.5 * safeguards.baseline * self.settings.amplitude:
            tangent = edge_tangent(line, behind, tangent, self.settings)
        sides = (1.0 - safeguards.smoothing) * sides + safeguards.smoothing * predicted.sides[0]
        return Station(frames_from_sides(here[None], tangent[None], sides[None]), line=line)

    def _walked_on(self, line: ProbedLine) -> np.ndarray:
        """The edge point from which the walk goes on.

        Straight lines through arcs meet off the edge, each somewhere else; an edge that is known
        as sharp is walked along where it is.
        """
        return line.bent_edge_point if self._known_sharp(line) else line.edge_point

    def _known_sharp(self, line: ProbedLine) -> bool:
        return self.settings.safeguards.sharp_edge and line.sharpness.known

    def _plausible(
        self, point: np.ndarray, sides: np.ndarray, predicted: Frames, last: Station
    ) -> bool:
        """Whether a line shows the edge that is walked along, and not just some other bend."""
        off = point - predicted.origin[0]
        step = float(np.linalg.norm(predicted.origin[0] - last.frame.origin[0]))
        aside = off - (off @ predicted.tangent[0]) * predicted.tangent[0]
        if np.linalg.norm(aside) > _JUMP * step + self.settings.tolerance:
            return False
        lean = np.einsum("ki,ki->k", sides, predicted.sides[0]).min()
        return bool(lean > np.cos(_LARGEST_LEAN))

    def ending(self, last: Station, stop: Stop) -> Stop:
        """A line without an edge says itself why."""
        return stop

    def _back(self, last: Station) -> ProbedLine:
        """The line behind from which the step to a new line tells the surfaces' normals."""
        before, walked = last.line, self._walked
        if before is None:
            raise TypeError("a probed scan goes on from a line")
        if any(line is before for line in walked[:-1]):
            walked.clear()  # the walk begins once more, the other way
        if not walked or walked[-1] is not before:
            walked.append(before)
        here, step = before.edge_point, self.settings.edge_pitch
        least = self.settings.safeguards.baseline * self.settings.amplitude - 0.5 * step
        for line in reversed(walked):
            if np.linalg.norm(line.edge_point - here) + step > least:
                return line
        return walked[0]

    def _stands_on(self, before: ProbedLine, last: Station) -> int:
        """The surface the machine is over: a line that was passed over has changed sides."""
        position = self.scanner.position
        if position is None:
            return before.ends_on
        away = position - last.frame.origin[0]
        if np.linalg.norm(away) > _ELSEWHERE * self.settings.amplitude:
            return before.ends_on
        return int((last.frame.sides[0] @ away).argmax())

    def _line_start(
        self, before: ProbedLine, starts_on: int, predicted: Frames, last: Station
    ) -> tuple[np.ndarray, np.ndarray | None]:
        """Where the next line begins, and the contact that already lies there in a zigzag."""
        settings, tangent = self.settings, predicted.tangent[0]
        end = before.contacts[-1 if starts_on == before.ends_on else 0]
        here = last.frame.origin[0]
        ahead = predicted.origin[0] - here
        reach = end - here
        along = float(reach @ tangent)
        reach = reach - along * tangent
        zigzag = settings.pattern is Pattern.ZIGZAG
        if settings.safeguards.restore:
            size = float(np.linalg.norm(reach))
            if self._known_sharp(before):
                size = before.length(starts_on)
            reach = reach * min(max(0.5 * settings.amplitude / max(size, 1e-9), 0.7), 1.4)
            if zigzag:
                target = here + 0.5 * ahead + reach
                off = float(np.linalg.norm(target - end))
                return target, end if off < _DEGENERATED * settings.edge_pitch else None
            return predicted.origin[0] + reach, None
        if zigzag:
            return end, end
        return predicted.origin[0] + reach, None

    def _plane(
        self,
        origin: np.ndarray,
        tangent: np.ndarray,
        predicted: Frames,
        starts_on: int,
        target: np.ndarray,
    ) -> ScanPlane:
        sides = predicted.sides[0]
        wedge = sides[0] + sides[1]
        normal = tangent
        if self.settings.pattern is Pattern.ZIGZAG:
            way = origin - target
            way = way / np.sqrt(way @ way)
            if self.settings.safeguards.restore:
                normal = _cross(way, wedge)
                normal = normal if normal @ tangent > 0.0 else -normal
            else:
                normal = tangent - (tangent @ way) * way  # Schreve eq. 4.2.1.1
            normal = normal / np.sqrt(normal @ normal)
        convex = 1.0 if wedge @ self.settings.approach > 0.0 else -1.0
        inward = _square_to(convex * wedge, normal)
        across = _cross(normal, inward)
        if across @ (sides[1 - starts_on] - sides[starts_on]) < 0.0:
            across = -across
        known = convex if self.settings.safeguards.signed_split else 0.0
        return ScanPlane(origin, across, inward, known)

    def _scan(
        self,
        plane: ScanPlane,
        start: tuple[float, float],
        heading: tuple[float, float],
        first: np.ndarray | None = None,
        onward: tuple[float, float] | None = None,
        edge_at: float | None = None,
    ) -> ScannedLine:
        try:
            return self.scanner.scan(plane, start, heading, first, onward, edge_at)
        except Exception as failure:
            self.failure = failure
            return ScannedLine(np.zeros((0, 3)), Stop.CMM_FAILED)

    def _measured(
        self,
        scanned: ScannedLine,
        plane: ScanPlane,
        tangent: np.ndarray,
        starts_on: int,
        before: Sharpness = UNKNOWN,
        narrow: bool = False,
    ) -> ProbedLine | Stop:
        if scanned.stop is not None and not (
            self.settings.safeguards.short_lines and len(scanned.contacts) >= _FEWEST_CONTACTS
        ):
            return scanned.stop
        line = measure_line(
            scanned.contacts,
            plane.origin,
            tangent,
            plane.across,
            starts_on,
            self.settings,
            plane.wedge * plane.inward if plane.wedge else None,
            narrow,
        )
        if isinstance(line, Stop):
            return scanned.stop or line
        line = replace(line, sharpness=before.after(line.split_off))
        turn = np.pi - np.arccos(np.clip(line.rough_sides[0] @ line.rough_sides[1], -1.0, 1.0))
        return line if turn > self.settings.least_turn else Stop.NO_EDGE


def _square_to(vector: np.ndarray, normal: np.ndarray) -> np.ndarray:
    """Unit vector of what of a vector is square to a unit normal."""
    part = vector - (vector @ normal) * normal
    return part / np.sqrt(part @ part)


def _cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return np.array(
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    )
