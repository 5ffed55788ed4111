# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a walk steps on: where to look for the next edge point, and which one to believe."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np

from ..geometry.frames import turned_along
from .section import Frames, Section, Station, frames_from_sides
from .stop import Stop

_SHORTEST_STEP = 0.25  # of the edge pitch
_MOST_BENT = 0.25  # rad, turn of the edge in one step
_TIGHT_TURNS = (0.3, 0.6)  # rad, tried in half an edge pitch where the edge seems to end
_LARGEST_TURN = 0.35  # rad, of tangent or sides between two edge points beyond what was predicted
_TANGENT_GAIN = 0.5  # how much of a tangent's innovation is believed
_BEND_GAIN = 0.15  # how much of it is put down to a change of bend


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

    def stride(self, section: Section, stations: Sequence[Station]) -> Station:
        """Measure the next station; one with a stop when the edge cannot be followed further.

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

    def stride(self, section: Section, stations: Sequence[Station]) -> Station:
        """Step on; where that fails, in shorter steps, and round a bend at last."""
        last, pitch = stations[-1], self.edge_pitch
        step = min(1.5 * last.step, self.longest_step) if np.isfinite(last.step) else pitch
        step = min(step, max(_MOST_BENT / _bend(last), _SHORTEST_STEP * pitch))
        while True:
            predicted = predict(last.frame, step)
            width = self.half_width * float(np.clip(step / pitch, 0.6, 1.0))
            measured = section.measure(predicted, width, last)
            stop = measured.stop or jumped(last, predicted, measured, step)
            if stop is None:
                return _steered(last, predicted, measured, step)
            if 0.5 * step < _SHORTEST_STEP * pitch:
                break
            step *= 0.5
        bent = _round_a_bend(section, last, 0.5 * pitch, self.half_width)
        return replace(last, stop=section.ending(last, stop)) if bent is None else bent


def predict(frame: Frames, step: float) -> Frames:
    """The section one step further, on the osculating circle of the edge."""
    tangent, bend = frame.tangent, frame.bend
    origin = frame.origin + step * tangent + 0.5 * step**2 * bend
    ahead = tangent + step * bend
    ahead = ahead / np.linalg.norm(ahead, axis=-1, keepdims=True)
    turned = turned_along(frame.sides, tangent, ahead)
    onward = bend - np.einsum("mi,mi->m", bend, ahead)[:, None] * ahead
    return frames_from_sides(origin, ahead, turned, onward, frame.curvature)


def reversed_frame(frame: Frames) -> Frames:
    """The same section, walked the other way."""
    return frames_from_sides(frame.origin, -frame.tangent, frame.sides, frame.bend, frame.curvature)


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
            measured = section.measure(predicted, 0.6 * half_width, last)
            if measured.stop or jumped(last, predicted, measured, step):
                continue
            if measured.sigma > 2.0 * max(last.sigma, measured.noise):
                continue
            station = _steered(last, predicted, measured, step)
            onward = predict(station.frame, step)
            after = section.measure(onward, 0.6 * half_width, station)
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
    return replace(measured, frame=steered, step=step)
