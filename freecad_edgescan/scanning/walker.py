# SPDX-License-Identifier: LGPL-2.1-or-later
"""The walk along an edge: predict the next section, measure it, decide whether to go on.

One walker for every kind of section. It knows nothing of clouds: a `Section` measures, the walker
steers by tangent and bend, shortens its steps where the edge turns or ends, and says why it
stopped.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..geometry.frames import cross
from .progress import Progress, SoFar
from .section import Frames, Section, Station, frames_from_sides
from .stop import Stop

_TELL_EVERY = 10  # stations
_SHORTEST_STEP = 0.25  # of the edge pitch
_MOST_BENT = 0.25  # rad, turn of the edge in one step
_TIGHT_TURNS = (0.3, 0.6)  # rad, tried in half an edge pitch where the edge seems to end
_LARGEST_TURN = 0.35  # rad, of tangent or sides between two edge points beyond what was predicted
_TANGENT_GAIN = 0.5  # how much of a tangent's innovation is believed
_BEND_GAIN = 0.15  # how much of it is put down to a change of bend

Arrived = Callable[[np.ndarray, np.ndarray], bool]


@dataclass(frozen=True)
class Walk:
    """Stations in walking order, without the first one, and why there are no more."""

    stations: list[Station]
    stop: Stop


def walk(
    section: Section,
    first: Station,
    edge_pitch: float,
    half_width: float,
    longest_step: float,
    arrived: Arrived | None = None,
    limit: int = 100_000,
    progress: Progress | None = None,
    known: Sequence[Station] = (),
) -> Walk:
    """Walk along the tangent of the first station until the edge ends.

    Parameters
    ----------
    section : who measures
    first : where to begin; its tangent is the direction of the walk
    edge_pitch : distance of the edge points, mm; steps are shorter where the edge turns or ends
    half_width : of the slab at full step, mm
    longest_step : where the edge runs as predicted, mm; the edge pitch or more
    arrived : called with the last two edge points; True ends the walk at a gate
    limit : largest number of stations
    progress : told after some stations, may cancel
    known : the first station and what an earlier walk the other way found, for the progress
    """
    stations = [first]
    step, travelled = edge_pitch, 0.0
    teller = _Teller(progress, stations, known)
    while True:
        if len(stations) > limit:
            return teller.last(Walk(stations[1:], Stop.LIMIT))
        last = stations[-1]
        step = min(step, max(_MOST_BENT / _bend(last), _SHORTEST_STEP * edge_pitch))
        predicted = predict(last.frame, step)
        width = half_width * float(np.clip(step / edge_pitch, 0.6, 1.0))
        measured = section.measure(predicted, width)
        stop = measured.stop or jumped(last, predicted, measured, step)
        if stop is not None:
            step *= 0.5
            if step >= _SHORTEST_STEP * edge_pitch:
                continue
            step = 0.5 * edge_pitch
            station = _round_a_bend(section, last, step, half_width)
            if station is None:
                return teller.last(Walk(stations[1:], section.ending(last, stop)))
        else:
            station = _steered(last, predicted, measured, step)
        stations.append(station)
        travelled += step
        step = min(1.5 * step, longest_step)
        here, there = last.frame.origin[0], station.frame.origin[0]
        if arrived is not None and arrived(here, there):
            return teller.last(Walk(stations[1:], Stop.GATE))
        if _closed(stations, travelled, longest_step):
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


def predict(frame: Frames, step: float) -> Frames:
    """The section one step further, on the osculating circle of the edge."""
    tangent, bend = frame.tangent, frame.bend
    origin = frame.origin + step * tangent + 0.5 * step**2 * bend
    ahead = tangent + step * bend
    ahead = ahead / np.linalg.norm(ahead, axis=-1, keepdims=True)
    turned = _carry(frame.sides, tangent, ahead)
    onward = bend - np.einsum("mi,mi->m", bend, ahead)[:, None] * ahead
    return frames_from_sides(origin, ahead, turned, onward, frame.curvature)


def reversed_frame(frame: Frames) -> Frames:
    """The same section, walked the other way."""
    return frames_from_sides(frame.origin, -frame.tangent, frame.sides, frame.bend, frame.curvature)


def _carry(vectors: np.ndarray, before: np.ndarray, after: np.ndarray) -> np.ndarray:
    """Turn vectors (m, k, 3) by the smallest rotation that takes one tangent to the next."""
    axis = cross(before, after)
    cosine = np.einsum("mi,mi->m", before, after)[:, None, None]
    crossed = cross(axis[:, None], vectors)
    return (
        vectors * cosine
        + crossed
        + axis[:, None]
        * np.einsum("mi,mki->mk", axis, vectors)[..., None]
        / np.maximum(1.0 + cosine, 1e-9)
    )


def _round_a_bend(
    section: Section, last: Station, step: float, half_width: float
) -> Station | None:
    """Look for the edge where it may begin to turn tightly, before it is given up.

    An edge mostly bends along one of its two surfaces. A turn counts when the edge is as well
    known there as before and can be followed from there; at a corner it cannot.
    """
    frame = last.frame
    ways = np.concatenate([frame.sides[0], -frame.sides[0]])
    for turn in _TIGHT_TURNS:
        for way in ways:
            bent = replace(frame, bend=(turn / step) * way[None])
            predicted = predict(bent, step)
            measured = section.measure(predicted, 0.6 * half_width)
            if measured.stop or jumped(last, predicted, measured, step):
                continue
            if measured.sigma > 2.0 * max(last.sigma, measured.noise):
                continue
            station = _steered(last, predicted, measured, step)
            onward = predict(station.frame, step)
            after = section.measure(onward, 0.6 * half_width)
            if not (after.stop or jumped(station, onward, after, step)):
                return station
    return None


def _bend(station: Station) -> float:
    return max(float(np.linalg.norm(station.frame.bend)), 1e-12)


def jumped(last: Station, predicted: Frames, measured: Station, step: float) -> Stop | None:
    """Whether the measured section cannot be the predicted edge."""
    frame = measured.frame
    aside = frame.origin[0] - predicted.origin[0]
    aside = aside - (aside @ predicted.tangent[0]) * predicted.tangent[0]
    known = min(measured.sigma, 3.0 * last.sigma)
    if np.linalg.norm(aside) > 0.35 * step + 4.0 * known:
        return Stop.LOST
    cosine = float(frame.tangent[0] @ predicted.tangent[0])
    for k in range(2):
        cosine = min(cosine, float(frame.sides[0, k] @ predicted.sides[0, k]))
    return Stop.CORNER if cosine < np.cos(_LARGEST_TURN) else None


def _steered(last: Station, predicted: Frames, measured: Station, step: float) -> Station:
    """The measured station with tangent and bend smoothed by what the walk already knows."""
    frame = measured.frame
    chord = frame.origin - last.frame.origin
    chord = chord / np.linalg.norm(chord, axis=-1, keepdims=True)
    # The chord ends half a step of bend behind the tangent; it knows the direction well where
    # the section's own tangent, read off a narrow slab, is noisy.
    chord_tangent = chord + 0.5 * step * predicted.bend
    seen = frame.tangent + chord_tangent / np.linalg.norm(chord_tangent, axis=-1, keepdims=True)
    seen = seen / np.linalg.norm(seen, axis=-1, keepdims=True)
    surprise = seen - predicted.tangent
    size = float(np.linalg.norm(surprise))
    gain = _TANGENT_GAIN if size < 0.1 else min(1.0, _TANGENT_GAIN * size / 0.1)
    tangent = predicted.tangent + gain * surprise
    bend = predicted.bend + (_BEND_GAIN if size < 0.1 else 0.4) * surprise / step
    tangent = tangent / np.linalg.norm(tangent, axis=-1, keepdims=True)
    bend = bend - np.einsum("mi,mi->m", bend, tangent)[:, None] * tangent
    curvature = 0.7 * predicted.curvature + 0.3 * frame.curvature
    steered = frames_from_sides(frame.origin, tangent, frame.sides, bend, curvature)
    return replace(measured, frame=steered)


def _closed(stations: list[Station], travelled: float, longest_step: float) -> bool:
    """Whether the walk has come back to its first station."""
    if travelled < 4.0 * longest_step:
        return False
    first, last = stations[0].frame, stations[-1].frame
    gap = first.origin[0] - last.origin[0]
    ahead = float(gap @ last.tangent[0])
    return (
        bool(np.linalg.norm(gap) < 1.2 * longest_step)
        and ahead > -0.6 * longest_step
        and float(first.tangent[0] @ last.tangent[0]) > 0.8
    )
