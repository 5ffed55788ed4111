# SPDX-License-Identifier: LGPL-2.1-or-later
"""From tracks to finished edges: the ends of each found, all its sections measured together.

A track is led to the vertex ahead of it; where there is none, the walker goes on from its last
section until the edge ends. Where the walk comes upon another track, the two are one edge.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.spatial import cKDTree

from ...cloud.point_cloud import PointCloud
from ..automatic import Chosen
from ..edge_ends import led_to_vertex
from ..errors import ScanError
from ..gait import AdaptiveGait
from ..patch_edge import finish_edge
from ..patch_scan import FEWEST_POINTS, check_edge
from ..patch_section import PatchSection
from ..report import describe
from ..scan_lines import ScanLines
from ..scanned_edge import ScannedEdge
from ..section import Station
from ..stop import Stop
from ..trace import Trace, turned
from ..walker import walk
from .soundness import corners_within, sound_stretches
from .strips import NOBODY, Strips
from .tracks import Track

__all__ = ["Tracer"]

_BEYOND = 12.0  # pitches past the last section, where a vertex is looked for before walking there
_CAREFUL = 0.7  # edge pitches, of a step where an edge seems to end
_FEWEST = 4  # stations that lead to a vertex
_AHEAD = 0.7  # share of another track's sections that lie ahead where it is one edge with this one
_SURE = 0.4  # pitches, of the median sigma of an edge that is believed without a click
_AT_HOME = 4  # stations at a track's ends, which a walk may come near to
_RETURNED = 1.0  # pitches from other stations, at which it has turned back
_STANDS_OUT, _LEAST_NOISE = 11.0, 0.1  # times the noise, and pitches that it counts for at least
_MOSTLY = 0.8  # of an edge that evidence carries, where parting it leads nowhere
_HELD = 0.6  # share of a track's sections that belong to another edge, from which on it is that one


class Tracer:
    """Finishes the tracks of a cloud one after the other.

    Parameters
    ----------
    cloud : PointCloud
    tracks : in order of confidence
    chosen : parameters and settings of all of them
    """

    def __init__(self, cloud: PointCloud, tracks: list[Track], chosen: Chosen) -> None:
        self.cloud, self.tracks, self.chosen = cloud, tracks, chosen
        self.strips = Strips(chosen.settings.cloud_pitch)
        self.open = set(range(len(tracks)))
        for number, track in enumerate(tracks):
            frames = track.sections.frames
            self.strips.take(number, frames.origin, frames.tangent)

    def finish(self, number: int) -> list[ScannedEdge]:
        """The edges of a track: mostly one; none where it belongs to another edge, or is none."""
        if number not in self.open:
            return []
        self.open.discard(number)
        track = self._unclaimed(number)
        self.strips.give_up(number)
        if track is None:
            return []
        edges = self._sound_edges(self._trace(number, track))
        if edges:
            self.strips.take(
                number,
                np.concatenate([edge.points for edge in edges]),
                np.concatenate([edge.tangents for edge in edges]),
            )
        return edges

    def _sound_edges(self, trace: Trace, again: int = 2) -> list[ScannedEdge]:
        """The finished edge of a trace, or of those of its stretches that evidence carries."""
        try:
            edge = self._finished(trace)
        except ScanError:
            return []
        settings = self.chosen.settings
        holders = self.strips.holders(edge.points, edge.tangents)
        others = np.array([holder != NOBODY and holder not in self.open for holder in holders])
        stretches = sound_stretches(edge, self.cloud, settings.edge_pitch, others)
        if not len(edge):
            return []
        if len(stretches) == 1 and len(stretches[0]) == len(edge):
            return [edge]
        if not stretches:
            return []
        if not again:
            whole = sum(len(stretch) for stretch in stretches) >= _MOSTLY * len(edge)
            return [edge] if whole else []
        edges = []
        for stretch in stretches:
            part = _part_of(trace, edge, stretch)
            if len(part.stations) >= FEWEST_POINTS:
                edges += self._sound_edges(part, again - 1)
        return edges

    def _unclaimed(self, number: int) -> Track | None:
        """What of a track does not belong to an edge that was finished before."""
        track = self.tracks[number]
        holders = self.strips.of_frames(track.sections.frames, but=number)
        held = np.array([holder not in self.open and holder != NOBODY for holder in holders])
        if not held.any():
            return track
        if held.mean() >= _HELD:
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

    def _finished(self, trace: Trace) -> ScannedEdge:
        if len(trace.stations) < FEWEST_POINTS:
            raise ScanError("Too few sections of an edge follow each other.")
        edge = finish_edge(self.cloud, trace, self.chosen)
        check_edge(edge, self.cloud, self.chosen)
        self._check_sure(edge)
        return replace(edge, message=describe(edge, None))

    def _check_sure(self, edge: ScannedEdge) -> None:
        """Nobody has clicked here: an edge has to show itself.

        Raises
        ------
        ScanError: its sides turn by less than the least angle, or it is too short for how badly
            it is known.
        """
        settings = self.chosen.settings
        if len(edge) < FEWEST_POINTS:
            raise ScanError("Too few sections of an edge follow each other.")
        if np.pi - np.median(edge.angle) < settings.min_angle:
            raise ScanError("The two sides turn by less than the least angle.")
        # A kink stands out from the smooth surface that explains it best by a share of its turn
        # times the length of its sides; in noise, a bent surface looks like a small one.
        if isinstance(edge.scan_lines, ScanLines):
            length = float(np.median(edge.scan_lines.fits.ends, axis=0).min())
            noise = max(settings.noise, _LEAST_NOISE * settings.cloud_pitch)
            if (np.pi - np.median(edge.angle)) * length < _STANDS_OUT * noise:
                raise ScanError("The sides are too short to tell the edge from a bent surface.")
        if np.median(edge.sigma) > _SURE * settings.cloud_pitch:
            raise ScanError("The edge is known too badly to tell it from a smooth surface.")

    def _to_the_end(self, number: int, stations: list[Station]) -> tuple[list[Station], Stop]:
        """Stations on to where the edge ends ahead."""
        settings = self.chosen.settings
        beyond, pitch = _BEYOND * settings.cloud_pitch, settings.edge_pitch
        gait = AdaptiveGait(pitch, settings.half_width, _CAREFUL * pitch)
        section = PatchSection(self.cloud, settings)
        near = _RETURNED * settings.cloud_pitch
        while True:
            if len(stations) >= _FEWEST:
                led = led_to_vertex(self.cloud, stations, settings, beyond)
                if led is not None:
                    return led, Stop.CORNER

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
        own = self.tracks[other].stations()
        last = stations[-1].frame
        first, end = (
            float(np.linalg.norm(own[k].frame.origin[0] - last.origin[0])) for k in (0, -1)
        )
        if end < first:
            own = [turned(station) for station in reversed(own)]
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


def _part_of(trace: Trace, edge: ScannedEdge, stretch: np.ndarray) -> Trace:
    """The stations of a walk that stand on a stretch of its edge."""
    places = np.array([station.frame.origin[0] for station in trace.stations])
    nearest = cKDTree(edge.points).query(places)[1]
    within = np.isin(nearest, stretch)
    stations = [trace.stations[row] for row in np.flatnonzero(within)]
    if trace.closed and len(within) and within[0] and within[-1] and not within.all():
        # It leads over the end of the closed walk.
        first = int(np.flatnonzero(~within)[-1]) + 1
        order = np.roll(np.arange(len(within)), -first)
        stations = [trace.stations[row] for row in order if within[row]]
    whole = 0 in stretch, len(edge) - 1 in stretch
    start, end = (
        stop if reaches and not trace.closed else Stop.CORNER
        for stop, reaches in zip(trace.stops, whole, strict=True)
    )
    return Trace(stations, (start, end))
