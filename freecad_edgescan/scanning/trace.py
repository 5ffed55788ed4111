# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a first station to the whole walk: one way to a gate, or both ways until the edge ends."""

from __future__ import annotations

from dataclasses import dataclass, replace

from .gait import Gait
from .progress import Progress
from .section import Section, Station
from .stop import Stop
from .walker import Arrived, walk


@dataclass(frozen=True)
class Trace:
    """The stations of an edge in order, and why there are no more at its start and end."""

    stations: list[Station]
    stops: tuple[Stop, Stop]

    @property
    def closed(self) -> bool:
        """Whether the last station leads back to the first."""
        return self.stops[1] is Stop.CLOSED


def trace_one_way(
    section: Section,
    first: Station,
    gait: Gait,
    arrived: Arrived | None = None,
    progress: Progress | None = None,
) -> Trace:
    """Walk along the first station's tangent only."""
    onward = walk(section, first, gait, arrived, progress=progress)
    return Trace([first, *onward.stations], (Stop.START, onward.stop))


def trace_both_ways(
    section: Section,
    first: Station,
    gait: Gait,
    progress: Progress | None = None,
) -> Trace:
    """Walk along the tangent until the edge ends, then from the first station the other way."""
    onward = walk(section, first, gait, progress=progress)
    if onward.stop is Stop.CLOSED:
        return Trace([first, *onward.stations], (Stop.CLOSED, Stop.CLOSED))
    if onward.stop is Stop.CANCELLED:
        return Trace([first, *onward.stations], (Stop.START, Stop.CANCELLED))
    known = [first, *onward.stations]
    backward = walk(section, turned(first), gait, progress=progress, known=known)
    stations = [turned(station) for station in reversed(backward.stations)]
    if backward.stop is Stop.CLOSED:
        # Round the whole edge, and over the place where something has ended the first way.
        return Trace([*stations, first], (Stop.CLOSED, Stop.CLOSED))
    return Trace([*stations, *known], (backward.stop, onward.stop))


def turned(station: Station) -> Station:
    """The same station, walked the other way."""
    return replace(station, frame=station.frame.backward())
