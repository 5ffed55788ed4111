# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a walk steps on: where to look for the next edge point, and which one to believe."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np

from ..geometry.frames import turned_along, unit
from .section import Frames, Section, Station, frames_from_sides
from .stop import Stop

_SHORTEST_STEP = 0.25  # of the edge pitch
_SHORTER = 0.5 ** np.arange(1, 8)  # of a step that failed
_MOST_BENT = 0.25  # rad, turn of the edge in one step
_TIGHT_TURNS = (0.3, 0.6)  # rad, tried in half an edge pitch where the edge seems to end
_LARGEST_TURN = 0.35  # rad, of tangent or sides between two edge points beyond what was predicted
_TANGENT_GAIN = 0.5  # how much of a tangent's innovation is believed
_BEND_GAIN = 0.15  # how much of it is put down to a change of bend
_EXPECTED = 0.02  # of a step, or half of a turn in rad, up to which an edge runs on as predicted
_RAN_ON = 3  # stations in a row after which it is expected to
_AHEAD = 6  # stations that are then measured at once
_MOST_TURNED = 0.8  # rad, turn of the edge up to the last of them


class Gait(Protocol):
    """How a walk gets from its last edge points to the next one.

    Attributes
    ----------
    longest_step : mm, largest distance of two following edge points
    """

    @property
    def longest_step(self) -> float:
        """Largest distance of two following edge points, mm."""
        ...

    def stride(self, section: Section, stations: Sequence[Station]) -> list[Station]:
        """Measure the next stations, at least one; where the edge ends, one with a stop.

        Parameters
        ----------
        section : who measures
        stations : those of this walk so far, at least one
        """
        ...


@dataclass(frozen=True)
class AdaptiveGait:
    """Follows the edge's tangent and bend, in shorter steps where the edge turns or ends.

    Attributes
    ----------
    edge_pitch : distance of the edge points, mm
    half_width : of the slab at full step, mm
    longest_step : where the edge runs as predicted, mm; the edge pitch or more
    """

    edge_pitch: float
    half_width: float
    longest_step: float

    def stride(self, section: Section, stations: Sequence[Station]) -> list[Station]:
        """Step on; where that fails, in shorter steps, and round a bend at last."""
        last, pitch = stations[-1], self.edge_pitch
        # Stations that were not walked to may stand on one place.
        step = max(1.5 * last.step, _SHORTEST_STEP * pitch) if np.isfinite(last.step) else pitch
        step = min(step, self.longest_step)
        step = min(step, max(_MOST_BENT / _bend(last), _SHORTEST_STEP * pitch))
        most = int(np.clip(_MOST_TURNED / (step * _bend(last)), 1, _AHEAD))
        found = self._run_on(section, last, step, most if _as_expected(stations) else 1)
        if found[0].stop is None:
            return found
        failed = found[0]
        shorter = step * _SHORTER[step * _SHORTER >= _SHORTEST_STEP * pitch]
        if len(shorter):
            predicted = predict(last.frame, shorter)
            measured = section.measure(predicted, self._widths(shorter), last)
            for k, each in enumerate(shorter.tolist()):
                failed = _followed(last, predicted[k], measured[k], each)
                if failed.stop is None:
                    return [failed]
        bent = _round_a_bend(section, last, 0.5 * pitch, self.half_width)
        if bent is not None:
            return [bent]
        assert failed.stop is not None
        return [replace(last, stop=section.ending(last, failed.stop))]

    def _run_on(self, section: Section, last: Station, step: float, count: int) -> list[Station]:
        """Measure the next stations together, and believe them as far as they are as expected.

        The first one may be surprising, or say why the edge was not followed; those behind it
        were looked for without knowing it.
        """
        ahead = predict(last.frame, step * np.arange(1, count + 1))
        widths = self._widths(np.full(count, step))
        found: list[Station] = []
        for k, measured in enumerate(section.measure(ahead, widths, last)):
            predicted = predict(last.frame, step) if found else ahead[0]
            station = _followed(last, predicted, measured, step)
            if found and (
                station.stop is not None or _surprise(last, ahead[k], measured, step) > _EXPECTED
            ):
                break
            found.append(station)
            if station.stop is not None:
                break
            last = station
        return found

    def _widths(self, steps: np.ndarray) -> np.ndarray:
        """Half the width of the slab at the end of each step, mm."""
        return self.half_width * np.clip(steps / self.edge_pitch, 0.6, 1.0)


def predict(frame: Frames, step: float | np.ndarray) -> Frames:
    """The sections one or several steps further, on the osculating circle of the edge.

    Parameters
    ----------
    frame : one section, or m
    step : mm, one, or (m,) for each section, or of one section
    """
    tangent, bend = frame.tangent, frame.bend
    step = np.reshape(step, (-1, 1))
    kappa = np.sqrt(np.einsum("mi,mi->m", bend, bend))[:, None]
    # The angle travelled; of both signs alike, and where the edge is straight sin x / x is one.
    angle = np.maximum(np.abs(step) * kappa, 1e-300)
    cosine, sine = np.cos(angle), step * (np.sin(angle) / angle)
    half = np.sin(0.5 * angle) / (0.5 * angle)
    origin = frame.origin + sine * tangent + 0.5 * np.square(step * half) * bend
    ahead = cosine * tangent + sine * bend
    onward = cosine * bend - kappa**2 * sine * tangent
    sides = turned_along(frame.sides, tangent, ahead)
    curvature = np.broadcast_to(frame.curvature, (len(ahead), 2))
    return frames_from_sides(origin, ahead, sides, onward, curvature)


def _round_a_bend(
    section: Section, last: Station, step: float, half_width: float
) -> Station | None:
    """Look for the edge where it may begin to turn tightly, before it is given up.

    An edge mostly bends along one of its two surfaces. A turn counts when the edge is as well
    known there as before and can be followed from there; at a corner it cannot.
    """
    frame = last.frame
    ways = np.concatenate([frame.sides[0], -frame.sides[0]])
    bends = [(turn / step) * way[None] for turn in _TIGHT_TURNS for way in ways]
    predicted = Frames.join([predict(replace(frame, bend=bend), step) for bend in bends])
    widths = np.full(len(bends), 0.6 * half_width)
    found = []
    for k, measured in enumerate(section.measure(predicted, widths, last)):
        station = _followed(last, predicted[k], measured, step)
        known = measured.sigma <= 2.0 * max(last.sigma, measured.noise)
        if station.stop is None and known:
            found.append(station)
    if not found:
        return None
    onward = Frames.join([predict(station.frame, step) for station in found])
    after = section.measure(onward, widths[: len(found)], found[0])
    for k, station in enumerate(found):
        if not (after[k].stop or jumped(station, onward[k], after[k], step)):
            return station
    return None


def _as_expected(stations: Sequence[Station]) -> bool:
    """Whether the last edge points were where they had been predicted."""
    return len(stations) > _RAN_ON and all(
        station.surprise <= _EXPECTED for station in stations[-_RAN_ON:]
    )


def _bend(station: Station) -> float:
    return max(float(np.linalg.norm(station.frame.bend)), 1e-12)


def _followed(last: Station, predicted: Frames, measured: Station, step: float) -> Station:
    """The measured station as the walk's next one; the last one with a stop where it is none."""
    stop = measured.stop or jumped(last, predicted, measured, step)
    return _steered(last, predicted, measured, step) if stop is None else replace(last, stop=stop)


def jumped(last: Station, predicted: Frames, measured: Station, step: float) -> Stop | None:
    """Whether the measured section cannot be the predicted edge."""
    frame = measured.frame
    if _aside(last, predicted, measured, 4.0) > 0.35 * step:
        return Stop.LOST
    cosine = float(frame.tangent[0] @ predicted.tangent[0])
    for k in range(2):
        cosine = min(cosine, float(frame.sides[0, k] @ predicted.sides[0, k]))
    return Stop.CORNER if cosine < np.cos(_LARGEST_TURN) else None


def _surprise(last: Station, predicted: Frames, measured: Station, step: float) -> float:
    """How far a section is beside the prediction in steps, or half its turn in rad if larger."""
    turned = 1.0 - np.einsum("mki,mki->mk", measured.frame.sides, predicted.sides).min()
    aside = _aside(last, predicted, measured, 2.0) / step
    return max(aside, float(np.sqrt(0.5 * max(turned, 0.0))))


def _aside(last: Station, predicted: Frames, measured: Station, sigmas: float) -> float:
    """How far the measured edge point is beside the prediction beyond some of its sigmas, mm."""
    aside = measured.frame.origin[0] - predicted.origin[0]
    aside = aside - (aside @ predicted.tangent[0]) * predicted.tangent[0]
    known = min(measured.sigma, 3.0 * last.sigma)
    return float(np.sqrt(aside @ aside)) - sigmas * known


def _steered(last: Station, predicted: Frames, measured: Station, step: float) -> Station:
    """The measured station with tangent and bend smoothed by what the walk already knows."""
    frame = measured.frame
    chord = unit(frame.origin - last.frame.origin)
    # The chord ends half a step of bend behind the tangent; it knows the direction well where
    # the section's own tangent, read off a narrow slab, is noisy.
    seen = unit(frame.tangent + unit(chord + 0.5 * step * predicted.bend))
    innovation = seen - predicted.tangent
    size = float(np.linalg.norm(innovation))
    gain = _TANGENT_GAIN if size < 0.1 else min(1.0, _TANGENT_GAIN * size / 0.1)
    tangent = unit(predicted.tangent + gain * innovation)
    bend = predicted.bend + (_BEND_GAIN if size < 0.1 else 0.4) * innovation / step
    bend = bend - np.einsum("mi,mi->m", bend, tangent)[:, None] * tangent
    curvature = 0.7 * predicted.curvature + 0.3 * frame.curvature
    steered = frames_from_sides(frame.origin, tangent, frame.sides, bend, curvature)
    surprise = _surprise(last, predicted, measured, step)
    return replace(measured, frame=steered, step=step, surprise=surprise)
