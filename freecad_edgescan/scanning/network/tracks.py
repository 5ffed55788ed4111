# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tracks: the sections of one edge in order, all looking the same way, steadied by each other.

One narrow section reads its tangent off a few pitches and knows it badly; where its neighbours
stand tells it well.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ...geometry.frames import turned_along
from ..measured_sections import MeasuredSections
from ..section import Frames, Station, frames_from_sides
from .chains import Chain
from .soundness import corners_within

__all__ = [
    "Track",
    "join_tracks",
    "leading_on",
    "reversed_track",
    "split_at_corners",
    "track_of",
    "without_doubtful_ends",
]

_BESIDE = 2  # sections on each side that tell a tangent
_DOUBTFUL = 2.5  # times the median sigma of a track
_ASIDE = 0.5  # pitches of a last section beside where the others lead
_LEADING = 5  # sections that lead straight on
_MOST_DOUBTFUL = 2  # sections at an end
_FEWEST = 4  # sections that are left of it


@dataclass(frozen=True)
class Track:
    """Sections of one edge in order.

    Attributes
    ----------
    sections : (k) alike in direction and sides
    closed : whether the last one is followed by the first
    """

    sections: MeasuredSections
    closed: bool

    def __len__(self) -> int:
        return len(self.sections)

    @property
    def length(self) -> float:
        """Length from the first to the last section, mm."""
        steps = np.diff(self.sections.frames.origin, axis=0)
        return float(np.linalg.norm(steps, axis=1).sum())

    def stations(self) -> list[Station]:
        """The sections as stations of a walk."""
        origin = self.sections.frames.origin
        steps = np.append(np.nan, np.linalg.norm(np.diff(origin, axis=0), axis=1))
        return [
            replace(self.sections.station(number), step=float(step))
            for number, step in enumerate(steps)
        ]


def track_of(sections: MeasuredSections, chain: Chain) -> Track:
    """The track of a chain."""
    own = sections[chain.rows]
    frames = own.frames
    tangent = np.where(chain.forward[:, None], frames.tangent, -frames.tangent)
    own = replace(own, frames=replace(frames, tangent=tangent))
    return _steadied(_with_other_sides(own, _crossed(frames.sides, tangent)), chain.closed)


def split_at_corners(track: Track) -> list[Track]:
    """The track, or its parts between the corners that it turns, without these."""
    count = len(track)
    corners = corners_within(track.sections.frames.origin, track.closed)
    if not len(corners):
        return [track]
    order = np.arange(count)
    if track.closed:
        first = int(corners[0])
        order = np.roll(order, -first)
        corners = (corners - first) % count
    parts, begin = [], 0
    for corner in [*corners.tolist(), count]:
        rows = order[begin:corner]
        if len(rows) >= 2:
            part = track.sections[rows]
            ways = np.ones(len(rows), dtype=bool)
            parts.append(track_of(part, Chain(np.arange(len(rows)), ways, False)))
        begin = corner + 1
    return parts


def without_doubtful_ends(track: Track, pitch: float) -> Track:
    """The track without last sections that are known badly, or stand beside its course.

    Such a section is followed by none, so that a track breaks off there; and it turns the end
    away from where the edge goes on.

    Parameters
    ----------
    pitch : of the cloud, mm
    """
    if track.closed:
        return track
    track = _without_doubtful_end(track, pitch)
    return reversed_track(_without_doubtful_end(reversed_track(track), pitch))


def _without_doubtful_end(track: Track, pitch: float) -> Track:
    known = _DOUBTFUL * float(np.median(track.sections.sigma))
    for _ in range(_MOST_DOUBTFUL):
        if len(track) <= _FEWEST:
            break
        rest = join_tracks([Track(track.sections[np.arange(len(track) - 1)], False)])
        aside = _aside(rest.sections.frames, track.sections.frames.origin[-1])
        if track.sections.sigma[-1] <= known and aside <= _ASIDE * pitch:
            break
        track = rest
    return track


def _aside(frames: Frames, place: np.ndarray) -> float:
    """How far a place is beside where sections lead, straight on or with their bend, mm."""
    last = frames[-1]
    offset = place - last.origin[0]
    ahead = float(offset @ last.tangent[0])
    bent = offset - ahead * last.tangent[0] - 0.5 * ahead**2 * last.bend[0]
    few = frames.origin[-_LEADING:]
    middle = few.mean(axis=0)
    way = np.linalg.svd(few - middle)[2][0]
    straight = (place - middle) - ((place - middle) @ way) * way
    return float(min(np.linalg.norm(bent), np.linalg.norm(straight)))


def reversed_track(track: Track) -> Track:
    """The same track the other way."""
    backward = track.sections[np.arange(len(track))[::-1]]
    frames = replace(backward.frames, tangent=-backward.frames.tangent)
    return Track(replace(backward, frames=frames), track.closed)


def leading_on(track: Track, frame: Frames) -> Track:
    """The same track from its end that is nearer to a section, its sides in the order of that."""
    origin = track.sections.frames.origin
    first, last = np.linalg.norm(origin[[0, -1]] - frame.origin, axis=1)
    if last < first:
        track = reversed_track(track)
    both = Frames.join([frame, track.sections.frames[:1]])
    crossed = np.full(len(track), _crossed(both.sides, both.tangent)[1])
    return Track(_with_other_sides(track.sections, crossed), track.closed)


def join_tracks(parts: list[Track], closed: bool = False) -> Track:
    """Tracks behind each other, the sides of each as those of the one before."""
    sections = MeasuredSections.join([part.sections for part in parts])
    count = len(sections)
    chain = Chain(np.arange(count), np.ones(count, dtype=bool), closed)
    return track_of(sections, chain)


def _with_other_sides(sections: MeasuredSections, crossed: np.ndarray) -> MeasuredSections:
    """Sections (k), the two sides of some of them (k,) in the other order."""
    frames, rows = sections.frames, np.arange(len(sections))[:, None]
    order = np.where(crossed[:, None], np.array([1, 0]), np.array([0, 1]))
    return replace(
        sections,
        frames=replace(
            frames,
            sides=frames.sides[rows, order],
            normals=frames.normals[rows, order],
            curvature=frames.curvature[rows, order],
        ),
        begins=sections.begins[rows, order],
        ends=sections.ends[rows, order],
    )


def _crossed(sides: np.ndarray, tangent: np.ndarray) -> np.ndarray:
    """Which sections have their sides the other way round than the first one, (k,)."""
    if len(sides) < 2:
        return np.zeros(len(sides), dtype=bool)
    carried = turned_along(sides[:-1], tangent[:-1], tangent[1:])
    straight = np.einsum("nki,nki->n", carried, sides[1:])
    swapped = np.einsum("nki,nki->n", carried, sides[1:, ::-1])
    changes = np.append(False, swapped > straight)
    return np.asarray(np.cumsum(changes) % 2 == 1)


def _steadied(sections: MeasuredSections, closed: bool) -> Track:
    """The track with tangents and bends as the places of the neighbouring sections tell them."""
    frames, count = sections.frames, len(sections)
    if count < 3:
        return Track(sections, closed)
    rows = np.arange(count)
    if closed:
        before, after = (rows - _BESIDE) % count, (rows + _BESIDE) % count
        middle = rows
    else:
        wide = min(_BESIDE, (count - 1) // 2)
        middle = np.clip(rows, wide, count - 1 - wide)
        before, after = middle - wide, middle + wide
    origin = frames.origin
    first, second = origin[middle] - origin[before], origin[after] - origin[middle]
    bend = _bend(first, second)
    chord = first + second
    tangent = chord / np.maximum(np.linalg.norm(chord, axis=1, keepdims=True), 1e-12)
    # The chord's direction is that in the middle; beside it the edge has turned on.
    beyond = np.einsum("ni,ni->n", origin - origin[middle], tangent)
    tangent = tangent + beyond[:, None] * bend
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    bend = bend - np.einsum("ni,ni->n", bend, tangent)[:, None] * tangent
    steady = frames_from_sides(origin, tangent, frames.sides, bend, frames.curvature)
    return Track(replace(sections, frames=steady), closed)


def _bend(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """Curvature vectors (n, 3), 1/mm, of arcs over two chords that follow each other."""
    a, b = (np.maximum(np.linalg.norm(x, axis=1, keepdims=True), 1e-12) for x in (first, second))
    return np.asarray(2.0 * (second / b - first / a) / (a + b))
