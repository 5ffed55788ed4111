# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gaps between tracks of one edge, bridged where prediction and evidence agree.

Two tracks are one edge when an arc leads from the end of the one to the end of the other along
both tangents, with the same sides, and when nothing between them speaks against it: either two
sides meet there too, or there are no points.
"""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from ..patch_section import PatchSettings
from ..section import Frames, frames_from_sides
from .chains import follow
from .cloud_workers import CloudWorkers
from .measuring import measure_sections
from .strips import NOBODY, Strips
from .tracks import Track, join_tracks, reversed_track, without_doubtful_ends

__all__ = ["bridged"]

_WIDEST = 24.0  # pitches, of a gap
_STEP = 2.5  # pitches, between the sections looked for in it
_SPEAKS_AGAINST = 0.34  # share of the places with points where no edge is found
_OVERLAP = 1.8  # pitches along an edge between two sections of one place
_POINTS_NEAR = 2.0  # pitches


def bridged(workers: CloudWorkers, tracks: list[Track], settings: PatchSettings) -> list[Track]:
    """Tracks joined to edges, the longest first."""
    pitch = settings.cloud_pitch
    tracks = [without_doubtful_ends(track, pitch) for track in _without_overlaps(tracks, pitch)]
    refused: set[tuple[bytes, bytes]] = set()
    while True:
        pair = _nearest_ends(tracks, pitch, refused)
        if pair is None:
            return sorted(tracks, key=lambda track: track.length, reverse=True)
        (one, end_one), (other, end_other) = pair
        gap = _gap(workers, tracks[one], end_one, tracks[other], end_other, settings)
        if gap is None:
            refused.add(_key(tracks, pair))
            continue
        first = tracks[one] if end_one else reversed_track(tracks[one])
        parts = [Track(first.sections, False), *gap]
        if one != other:
            parts.append(reversed_track(tracks[other]) if end_other else tracks[other])
        joined = join_tracks([part for part in parts if len(part)], closed=one == other)
        tracks = [track for number, track in enumerate(tracks) if number not in (one, other)]
        tracks.append(joined)


def _without_overlaps(tracks: list[Track], pitch: float) -> list[Track]:
    """The tracks, without what lies beside a longer one: so their ends face each other."""
    strips = Strips(pitch)
    kept: list[Track] = []
    for track in sorted(tracks, key=lambda track: track.length, reverse=True):
        frames = track.sections.frames
        held = strips.holders(frames.origin, frames.tangent, along=_OVERLAP) != NOBODY
        if held.all():
            continue
        if held.any():
            runs = np.split(np.arange(len(held)), np.flatnonzero(np.diff(held.astype(int))) + 1)
            longest = max((run for run in runs if not held[run[0]]), key=len)
            track = Track(track.sections[longest], False)
        frames = track.sections.frames
        strips.take(len(kept), frames.origin, frames.tangent)
        kept.append(track)
    return kept


End = tuple[int, int]


def _key(tracks: list[Track], pair: tuple[End, End]) -> tuple[bytes, bytes]:
    one, other = (_end_frame(tracks[number], end).origin.tobytes() for number, end in pair)
    return (one, other) if one < other else (other, one)


def _end_frame(track: Track, end: int) -> Frames:
    """The section at the start (0) or end (1) of a track, looking out of it."""
    return track.sections.frames[-1] if end else track.sections.frames[0].backward()


def _nearest_ends(
    tracks: list[Track], pitch: float, refused: set[tuple[bytes, bytes]]
) -> tuple[End, End] | None:
    """The two facing ends that are nearest to each other, if any are near enough."""
    ends = [
        (number, end)
        for number, track in enumerate(tracks)
        if not track.closed and len(track) >= 2
        for end in (0, 1)
    ]
    if not ends:
        return None
    frames = Frames.join([_end_frame(tracks[number], end) for number, end in ends])
    pairs = cKDTree(frames.origin).query_pairs(_WIDEST * pitch, output_type="ndarray")
    one, other = pairs[:, 0], pairs[:, 1]
    fits, ahead, behind = follow(frames, one, other)
    # Both look out of their tracks: each lies ahead of the other one.
    fits &= ahead & behind
    distance = np.linalg.norm(frames.origin[one] - frames.origin[other], axis=1)
    for number in np.argsort(distance, kind="stable"):
        if not fits[number]:
            continue
        pair = ends[one[number]], ends[other[number]]
        if pair[0][0] == pair[1][0] and tracks[pair[0][0]].length < 3.0 * distance[number]:
            continue
        if _key(tracks, pair) not in refused:
            return pair
    return None


def _gap(
    workers: CloudWorkers,
    one: Track,
    end_one: int,
    other: Track,
    end_other: int,
    settings: PatchSettings,
) -> list[Track] | None:
    """What lies between two ends, as a track or nothing; None when it speaks against an edge."""
    pitch = settings.cloud_pitch
    leave, arrive = _end_frame(one, end_one), _end_frame(other, end_other).backward()
    distance = float(np.linalg.norm(arrive.origin - leave.origin))
    count = int(distance / (_STEP * pitch))
    if count < 1:
        return []
    share = (np.arange(count) + 1.0) / (count + 1.0)
    frames = _between(leave, arrive, distance, share)
    near = workers.cloud.tree.query(frames.origin)[0] < _POINTS_NEAR * pitch
    reach = float(np.median(np.concatenate([one.sections.reach, other.sections.reach])))
    measured = measure_sections(workers, frames, settings.with_reach(reach))
    off = np.linalg.norm(measured.frames.origin - frames.origin, axis=1)
    found = measured.found & (off < 0.15 * distance + pitch)
    if np.count_nonzero(near & ~found) > _SPEAKS_AGAINST * len(share):
        return None
    return [Track(measured[found], False)] if found.any() else []


def _between(leave: Frames, arrive: Frames, distance: float, share: np.ndarray) -> Frames:
    """Sections on the cubic from one section to another, (k)."""
    s = share[:, None]
    p, q = leave.origin, arrive.origin
    u, v = distance * leave.tangent, distance * arrive.tangent
    origin = (
        (2 * s**3 - 3 * s**2 + 1) * p + (s**3 - 2 * s**2 + s) * u
        + (3 * s**2 - 2 * s**3) * q + (s**3 - s**2) * v
    )  # fmt: skip
    tangent = (6 * s**2 - 6 * s) * (p - q) + (3 * s**2 - 4 * s + 1) * u + (3 * s**2 - 2 * s) * v
    sides = np.repeat(leave.sides, len(share), axis=0)
    bend = np.repeat(0.5 * (leave.bend + arrive.bend), len(share), axis=0)
    tangent = tangent / np.linalg.norm(tangent, axis=1, keepdims=True)
    bend = bend - np.einsum("ni,ni->n", bend, tangent)[:, None] * tangent
    curvature = np.repeat(leave.curvature, len(share), axis=0)
    return frames_from_sides(origin, tangent, sides, bend, curvature)
