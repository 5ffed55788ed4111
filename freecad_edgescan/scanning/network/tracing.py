# SPDX-License-Identifier: LGPL-2.1-or-later
"""From tracks to finished edges: the ends of each found, all its sections measured together.

A track is led to the vertex ahead of it; where there is none, the walker goes on from its last
section until the edge ends. Where the walk comes upon another track, the two are one edge. When
all have been led to their ends they are measured, which needs nothing of each other; and settled
one after the other, so that no stretch belongs to two of them.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..automatic import Chosen
from ..edge_ends import led_to_vertex, without_doubtful_end
from ..gait import AdaptiveGait
from ..patch_section import PatchSection
from ..scanned_edge import ScannedEdge
from ..section import Frames, Station
from ..sides_beyond import sides_beyond
from ..stop import Stop
from ..trace import Trace, turned
from ..walker import walk
from .cloud_workers import CloudWorkers
from .finishing import finished, part_of_trace, parted_at_bend
from .soundness import corners_within, sound_stretches
from .strips import NOBODY, Strips
from .tracks import Track, leading_on

__all__ = ["Tracer"]

_BEYOND = 12.0  # pitches past the last section, where a vertex is looked for before walking there
_CAREFUL = 0.7  # edge pitches, of a step where an edge seems to end
_FEWEST = 4  # stations that lead to a vertex
_AHEAD = 0.7  # share of another track's sections that lie ahead where it is one edge with this one
_AT_HOME = 4  # stations at a track's ends, which a walk may come near to
_RETURNED = 1.0  # pitches from other stations, at which it has turned back
_ROUNDS = ((0.0, 0.95), (0.95, 1.0))  # shares of the work; what the first one leaves is little
_WALKING = 0.25  # of a round, before its walks are measured
_MOSTLY = 0.8  # of an edge that evidence carries, where parting it leads nowhere
_HELD = 0.6  # share of a track's sections that belong to another edge, from which on it is that one


class Tracer:
    """Leads the tracks of a cloud to their ends, one after the other, and has them measured.

    Parameters
    ----------
    workers : who measure, with the cloud
    tracks : in order of confidence
    chosen : parameters and settings of all of them
    """

    def __init__(self, workers: CloudWorkers, tracks: list[Track], chosen: Chosen) -> None:
        self.workers, self.tracks, self.chosen = workers, tracks, chosen
        self.strips = Strips(chosen.settings.cloud_pitch)
        self.open = set(range(len(tracks)))
        self.settled: set[int] = set()
        self.yielded: dict[int, set[int]] = {}
        for number, track in enumerate(tracks):
            frames = track.sections.frames
            self.strips.take(number, frames.origin, frames.tangent)

    def edges(self) -> Iterator[tuple[float, list[ScannedEdge]]]:
        """The edges of each track: mostly one; none where it belongs to another edge, or is none.

        Yields
        ------
        Share of the work that is done, and the edges that are new.
        """
        waiting = list(range(len(self.tracks)))
        for begin, end in _ROUNDS:
            traces = []
            for done, number in enumerate(waiting):
                yield begin + _WALKING * (end - begin) * done / len(waiting), []
                trace = self._traced(number)
                if trace is not None:
                    answer = self.workers.submit(finished, (trace, self.chosen))
                    traces.append((number, trace, answer))
            for done, (number, trace, answer) in enumerate(traces):
                share = _WALKING + (1.0 - _WALKING) * done / len(traces)
                yield begin + share * (end - begin), self._settled(number, trace, answer())
            waiting = self._set_free()

    def _traced(self, number: int) -> Trace | None:
        """The walk along a track to its ends, which takes its strip."""
        if number not in self.open:
            return None
        self.open.discard(number)
        track = self._unclaimed(number)
        self.strips.give_up(number)
        if track is None:
            return None
        trace = self._trace(number, track)
        frames = Frames.join([station.frame for station in trace.stations])
        self.strips.take(number, frames.origin, frames.tangent)
        return trace

    def _settled(self, number: int, trace: Trace, edge: ScannedEdge | None) -> list[ScannedEdge]:
        """What of a finished edge stays, now that those before it are settled."""
        self.strips.give_up(number)
        edges = self._sound_edges(trace, edge)
        if edges:
            self.settled.add(number)
            self.strips.take(
                number,
                np.concatenate([edge.points for edge in edges]),
                np.concatenate([edge.tangents for edge in edges]),
            )
        return edges

    def _set_free(self) -> list[int]:
        """Tracks that were left out for the sake of others which came to nothing."""
        free = [
            number
            for number, holders in self.yielded.items()
            if number not in self.settled and not holders & self.settled
        ]
        self.yielded.clear()
        self.open.update(free)
        for number in free:
            frames = self.tracks[number].sections.frames
            self.strips.take(number, frames.origin, frames.tangent)
        return sorted(free)

    def _sound_edges(
        self, trace: Trace, edge: ScannedEdge | None, again: int = 2
    ) -> list[ScannedEdge]:
        """The finished edge of a trace, or of those of its stretches that evidence carries."""
        settings, cloud = self.chosen.settings, self.workers.cloud
        if edge is None:
            parts = parted_at_bend(trace, settings.cloud_pitch) if again else []
            return self._parts(parts, again - 1)
        holders = self.strips.holders(edge.points, edge.tangents)
        against = np.isin(holders, list(self.settled)) | sides_beyond(edge, cloud, settings)
        stretches = sound_stretches(edge, cloud, settings.edge_pitch, against)
        if len(stretches) == 1 and len(stretches[0]) == len(edge):
            return [edge]
        if not again:
            whole = sum(len(stretch) for stretch in stretches) >= _MOSTLY * len(edge)
            return [edge] if whole else []
        return self._parts([part_of_trace(trace, edge, part) for part in stretches], again - 1)

    def _parts(self, traces: list[Trace], again: int) -> list[ScannedEdge]:
        edges = []
        for trace in traces:
            edge = finished(self.workers.cloud, (trace, self.chosen))
            edges += self._sound_edges(trace, edge, again)
        return edges

    def _unclaimed(self, number: int) -> Track | None:
        """What of a track does not belong to an edge that was finished before."""
        track = self.tracks[number]
        holders = self.strips.of_frames(track.sections.frames, but=number)
        held = (holders != NOBODY) & ~np.isin(holders, list(self.open))
        if not held.any():
            return track
        if held.mean() >= _HELD:
            self.yielded[number] = set(holders[held].tolist())
            return None
        runs = np.split(np.arange(len(held)), np.flatnonzero(np.diff(held.astype(int))) + 1)
        longest = max((run for run in runs if not held[run[0]]), key=len)
        return Track(track.sections[longest], False) if len(longest) >= 2 else None

    def _trace(self, number: int, track: Track) -> Trace:
        stations = track.stations()
        if track.closed:
            return Trace(stations, (Stop.CLOSED, Stop.CLOSED))
        stations, end = self._to_the_end(number, stations)
        if end is Stop.CLOSED:
            return Trace(stations, (end, end))
        outward = [turned(station) for station in reversed(stations)]
        outward, start = self._to_the_end(number, outward)
        stations = [turned(station) for station in reversed(outward)]
        return Trace(stations, (start, start if start is Stop.CLOSED else end))

    def _to_the_end(self, number: int, stations: list[Station]) -> tuple[list[Station], Stop]:
        """Stations on to where the edge ends ahead."""
        settings = self.chosen.settings
        beyond, pitch = _BEYOND * settings.cloud_pitch, settings.edge_pitch
        gait = AdaptiveGait(pitch, settings.half_width, _CAREFUL * pitch)
        section = PatchSection(self.workers.cloud, settings)
        near = _RETURNED * settings.cloud_pitch
        while True:
            if len(stations) >= _FEWEST:
                led = led_to_vertex(self.workers.cloud, stations, settings, beyond)
                if led is not None:
                    return led, Stop.CORNER
                # From a section that looks aside no walk finds on.
                stations = without_doubtful_end(stations)

            places = np.array([station.frame.origin[0] for station in stations])
            own = places[_AT_HOME:-_AT_HOME]

            def meets(here: np.ndarray, there: np.ndarray, own: np.ndarray = own) -> bool:
                back = len(own) and np.min(np.sum((own - there) ** 2, axis=1)) < near**2
                return bool(back or self._holder(number, here, there) != NOBODY)

            onward = walk(section, stations[-1], gait, meets, behind=stations[:-1])
            walked = [*stations, *onward.stations]
            straight = _before_a_corner(walked, len(stations))
            if len(straight) < len(walked):
                return straight, Stop.CORNER
            if onward.stop is not Stop.GATE:
                return walked, onward.stop
            here, there = (station.frame.origin[0] for station in walked[-2:])
            other = self._holder(number, here, there)
            joined = self._joined(walked[:-1], other)
            if joined is None:
                return walked[:-1], Stop.CORNER
            stations = joined

    def _holder(self, number: int, here: np.ndarray, there: np.ndarray) -> int:
        """Who else owns the strip that a step leads to."""
        way = (there - here) / max(float(np.linalg.norm(there - here)), 1e-12)
        return int(self.strips.holders(there[None], way[None], but=number)[0])

    def _joined(self, stations: list[Station], other: int) -> list[Station] | None:
        """The stations with those of an open track that begins where they end."""
        if other not in self.open:
            return None
        last = stations[-1].frame
        own = leading_on(self.tracks[other], last).stations()
        ahead = _onward(stations[-1], own)
        if self.tracks[other].closed or len(ahead) < max(2, _AHEAD * len(own)):
            return None
        gap = np.linalg.norm(ahead[0].frame.origin - last.origin)
        if gap > _BEYOND * self.chosen.settings.cloud_pitch:
            return None
        joined = [*stations, *ahead]
        if len(_before_a_corner(joined, len(stations))) < len(joined):
            return None
        self.open.discard(other)
        self.strips.give_up(other)
        return joined


def _before_a_corner(stations: list[Station], known: int) -> list[Station]:
    """The stations up to the first corner that the walk has turned behind those that were known."""
    places = np.array([station.frame.origin[0] for station in stations])
    turned_at = corners_within(places, False)
    turned_at = turned_at[turned_at >= known - 2]
    return stations[: int(turned_at[0]) + 1] if len(turned_at) else stations


def _onward(last: Station, stations: list[Station]) -> list[Station]:
    """Those stations that lead on from one to the next, each looking the way of the walk."""
    kept: list[Station] = []
    for station in stations:
        before = (kept[-1] if kept else last).frame
        step = station.frame.origin[0] - before.origin[0]
        if float(step @ before.tangent[0]) <= 0.3 * float(np.linalg.norm(step)):
            continue
        same = float(station.frame.tangent[0] @ before.tangent[0]) > 0.0
        kept.append(station if same else turned(station))
    return kept
