# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a probed scan steps on along the edge (Schreve 4.4.2 to 4.4.4)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from .parameters import Steering
from .probe_settings import ProbeSettings
from .section import Frames, Section, Station, frames_from_sides
from .stop import Stop

__all__ = ["ProbeGait"]

_FEWER, _MORE = 0.5, 3.0  # times the last edge pitch, that the next one may be
_TWO_STEPS = 4.0  # times as high over a chord of two steps as over one
_NOT_COASTED = (Stop.CMM_FAILED, Stop.CANCELLED)


@dataclass(frozen=True)
class ProbeGait:
    """Steers by the last tangent, or round the circle of the last three edge points.

    Attributes
    ----------
    settings : edge pitch, chord height, steering, and how many bad lines are passed over
    """

    settings: ProbeSettings

    @property
    def longest_step(self) -> float:
        """Largest distance of two following edge points, mm."""
        most = _MORE if self.settings.chord_height else 1.0
        return most * self.settings.edge_pitch

    def stride(self, section: Section, stations: Sequence[Station]) -> list[Station]:
        """Scan the next line that shows an edge."""
        last, pitch = stations[-1], self._pitch(stations)
        stop: Stop | None = None
        for k in range(1, self.settings.safeguards.coasting + 2):
            ahead = self._ahead(stations, k * pitch)
            (station,) = section.measure(ahead, np.array([0.5 * pitch]), last)
            if station.stop is None:
                return [replace(station, step=k * pitch)]
            stop = stop or station.stop
            if station.stop in _NOT_COASTED:
                stop = station.stop
                break
        return [replace(last, stop=stop)]

    def _pitch(self, stations: Sequence[Station]) -> float:
        """The next edge pitch, from the chordal deviation of the last three edge points."""
        wanted, last = self.settings.chord_height, stations[-1].step
        if not np.isfinite(last):
            return self.settings.edge_pitch
        if wanted is None:
            return self.settings.edge_pitch
        if len(stations) < 3:
            return last
        a, b, c = (station.frame.origin[0] for station in stations[-3:])
        chord = c - a
        height = float(np.linalg.norm(np.cross(b - a, chord)) / np.linalg.norm(chord))
        ratio = wanted / max(height, 1e-12)
        if self.settings.safeguards.steady_pitch:
            ratio = (_TWO_STEPS * ratio) ** 0.5
        ratio = min(max(ratio, _FEWER), _MORE)
        most, least = _MORE * self.settings.edge_pitch, self.settings.least_pitch
        return max(min(ratio * last, most), least)

    def _ahead(self, stations: Sequence[Station], step: float) -> Frames:
        """The section one step further."""
        frame = stations[-1].frame
        tangent, origin = frame.tangent, frame.origin + step * frame.tangent  # eq. 4.4.2.1
        if self.settings.steering is Steering.CURVATURE and len(stations) >= 3:
            points = [station.frame.origin[0] for station in stations[-3:]]
            origin, tangent = _on_the_circle(points, step, frame.tangent)
        return frames_from_sides(origin, tangent, frame.sides)


def _on_the_circle(
    points: Sequence[np.ndarray], step: float, tangent: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Point and tangent (1, 3) one step behind the last of three points, on their circle."""
    a, b, c = points
    u, v = b - a, c - a
    normal = np.cross(u, v)
    square = float(normal @ normal)
    if square < 1e-18 * float(v @ v) ** 2:
        return c + step * tangent, tangent
    centre = a + (np.cross(normal, u) * (v @ v) + np.cross(v, normal) * (u @ u)) / (2.0 * square)
    radius = float(np.linalg.norm(c - centre))
    out, axis = (c - centre) / radius, normal / np.sqrt(square)
    way = np.cross(axis, out)
    turn = step / radius
    point = centre + radius * (np.cos(turn) * out + np.sin(turn) * way)
    ahead = np.cos(turn) * way - np.sin(turn) * out
    return point[None], ahead[None]
