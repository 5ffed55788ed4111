# SPDX-License-Identifier: LGPL-2.1-or-later
"""The walk along an edge: one edge point after the other, until there is a reason to stop.

One walker for every kind of section. It knows nothing of clouds or machines: a `Section`
measures, a `Gait` steers, and the walker tells the gate, the closed edge, the limit and the
progress, and keeps what was found.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from .gait import Gait
from .progress import Progress, SoFar
from .section import Section, Station
from .stop import Stop

_TELL_EVERY = 5  # stations

Arrived = Callable[[np.ndarray, np.ndarray], bool]


@dataclass(frozen=True)
class Walk:
    """Stations in walking order, without the first one, and why there are no more."""

    stations: list[Station]
    stop: Stop


def walk(
    section: Section,
    first: Station,
    gait: Gait,
    arrived: Arrived | None = None,
    limit: int = 100_000,
    progress: Progress | None = None,
    known: Sequence[Station] = (),
    behind: Sequence[Station] = (),
) -> Walk:
    """Walk along the tangent of the first station until the edge ends.

    Parameters
    ----------
    section : who measures
    first : where to begin; its tangent is the direction of the walk
    gait : how to step on
    arrived : called with the last two edge points; True ends the walk at a gate
    limit : largest number of stations
    progress : told after some stations, may cancel
    known : the first station and what an earlier walk the other way found, for the progress
    behind : stations that lead up to the first one; where the edge closes, it is at their beginning
    """
    stations = [first]
    home = behind[0] if behind else first
    travelled = sum(station.step for station in [*behind, first][1:])
    teller = _Teller(progress, stations, known)
    while True:
        for station in gait.stride(section, stations):
            if station.stop is not None:
                return teller.last(Walk(stations[1:], station.stop))
            if len(stations) > limit:
                return teller.last(Walk(stations[1:], Stop.LIMIT))
            here, there = stations[-1].frame.origin[0], station.frame.origin[0]
            stations.append(station)
            travelled += station.step
            if arrived is not None and arrived(here, there):
                return teller.last(Walk(stations[1:], Stop.GATE))
            if _closed(home, station, travelled, gait.longest_step):
                return teller.last(Walk(stations[1:], Stop.CLOSED))
            if not teller.tell():
                return Walk(stations[1:], Stop.CANCELLED)


class _Teller:
    """Tells the progress about stations, each once and all of them in order along the edge."""

    def __init__(
        self, progress: Progress | None, stations: list[Station], known: Sequence[Station]
    ) -> None:
        self.progress, self.stations, self.known = progress, stations, known
        # The first station of a second way was told on the first one.
        self.told = 1 if known else 0

    def tell(self, at_least: int = _TELL_EVERY) -> bool:
        """Tell what is new when it is enough; False when the walk is to be cancelled."""
        new = self.stations[self.told :]
        if self.progress is None or len(new) < at_least:
            return True
        self.told = len(self.stations)
        along = [*reversed(self.stations[1:]), *self.known] if self.known else self.stations
        return self.progress.update(float("nan"), SoFar(along, new))

    def last(self, result: Walk) -> Walk:
        """Tell the rest; a cancel that comes now still ends the scan."""
        return result if self.tell(1) else Walk(result.stations, Stop.CANCELLED)


def _closed(home: Station, here: Station, travelled: float, longest_step: float) -> bool:
    """Whether the walk has come back to where it began."""
    if travelled < 4.0 * longest_step:
        return False
    first, last = home.frame, here.frame
    gap = first.origin[0] - last.origin[0]
    ahead = float(gap @ last.tangent[0])
    return (
        bool(np.linalg.norm(gap) < 1.2 * longest_step)
        and ahead > -0.6 * longest_step
        and float(first.tangent[0] @ last.tangent[0]) > 0.8
    )
