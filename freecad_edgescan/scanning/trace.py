# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a first station to the whole walk: one way to a gate, or both ways until the edge ends."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from .gait import Gait, reversed_frame
from .progress import Progress
from .section import Section, Station
from .stop import Stop
from .walker import Arrived, Walk, walk

_DOUBTFUL = 2.0  # longest steps before an end from which it is walked to once more
_NOT_ENDS = (Stop.CLOSED, Stop.CANCELLED, Stop.LIMIT, Stop.GATE)


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
    careful: Gait | None = None,
) -> Trace:
    """Walk along the tangent until the edge ends, then from the first station the other way.

    Parameters
    ----------
    careful : a gait of short steps, to walk to an end once more before it is believed
    """
    onward = _to_the_end(section, first, gait, progress, careful, [])
    if onward.stop is Stop.CLOSED:
        return Trace([first, *onward.stations], (Stop.CLOSED, Stop.CLOSED))
    if onward.stop is Stop.CANCELLED:
        return Trace([first, *onward.stations], (Stop.START, Stop.CANCELLED))
    known = [first, *onward.stations]
    backward = _to_the_end(section, turned(first), gait, progress, careful, known)
    stations = [turned(station) for station in reversed(backward.stations)]
    return Trace([*stations, *known], (backward.stop, onward.stop))


def _to_the_end(
    section: Section,
    first: Station,
    gait: Gait,
    progress: Progress | None,
    careful: Gait | None,
    known: list[Station],
) -> Walk:
    """Walk until the edge ends; where short steps lead farther, as round a tight bend, in those."""
    found = walk(section, first, gait, progress=progress, known=known)
    left = np.cumsum([station.step for station in reversed(found.stations)])
    count = len(found.stations) - 1 - int(np.searchsorted(left, _DOUBTFUL * gait.longest_step))
    if careful is None or found.stop in _NOT_ENDS or count < 1:
        return found
    sure, doubtful = found.stations[:count], found.stations[count:]
    told = [*reversed(sure), first, *known[1:]]
    again = walk(
        section,
        sure[-1],
        careful,
        progress=progress,
        known=told,
        behind=[first, *sure[:-1]],
    )
    if again.stop is not Stop.CANCELLED and _length(again.stations) <= _length(doubtful):
        return found
    return Walk([*sure, *again.stations], again.stop)


def _length(stations: list[Station]) -> float:
    return sum(station.step for station in stations)


def turned(station: Station) -> Station:
    """The same station, walked the other way."""
    return replace(station, frame=reversed_frame(station.frame))
