# SPDX-License-Identifier: LGPL-2.1-or-later
"""Short tracks looked at once more, closely: few sections may agree by chance."""

from __future__ import annotations

import numpy as np

from ..measured_sections import MeasuredSections
from ..patch_section import PatchSettings
from ..section import Frames, frames_from_sides
from ..stop import Stop
from .cloud_workers import CloudWorkers
from .measuring import measure_sections
from .tracks import Track, join_tracks

__all__ = ["confirmed"]

_SHORT = 7  # sections, below which a track is looked at again
_STEP = 1.5  # pitches between its new sections
_BEYOND = 2  # new sections before and behind it
_REACH = 13.0  # pitches, at least
_AGREE = 0.7  # of the new sections between the old ones, that find the edge, too
_NEAR = 0.8  # pitches, from where it was
_LARGEST_SIGMA, _LEAST_COVER = 0.45, 0.55


def confirmed(workers: CloudWorkers, tracks: list[Track], settings: PatchSettings) -> list[Track]:
    """The long tracks, and of the short ones those that are confirmed, with more sections."""
    long = [track for track in tracks if len(track) >= _SHORT or track.closed]
    short = [track for track in tracks if not (len(track) >= _SHORT or track.closed)]
    if not short:
        return long
    pitch = settings.cloud_pitch
    laid = [_laid(track, _STEP * pitch) for track in short]
    frames = Frames.join([part for part, _ in laid])
    # What stands under a rounding was seen by looking beyond it, and is only seen so.
    far = [float(np.median(track.sections.reach)) > _REACH * pitch for track in short]
    farther = np.repeat(far, [len(part) for part, _ in laid])
    measured = MeasuredSections.unmeasured(frames, Stop.LOST, settings.reach)
    for which, reach in ((~farther, _REACH * pitch), (farther, settings.reach)):
        rows = np.flatnonzero(which)
        seen = measure_sections(workers, frames[rows], settings.with_reach(reach), times=2)
        measured = measured.replaced(rows, seen)
    off = np.linalg.norm(measured.frames.origin - frames.origin, axis=1)
    with np.errstate(invalid="ignore"):
        good = measured.found & (off < _NEAR * pitch) & (measured.cover > _LEAST_COVER)
        good &= measured.sigma < _LARGEST_SIGMA * pitch
    good &= measured.frames.turn >= settings.min_angle
    ends = np.cumsum([len(part) for part, _ in laid])
    kept = []
    for (part, within), end in zip(laid, ends, strict=True):
        rows = np.arange(end - len(part), end)
        if np.mean(good[rows[within]]) >= _AGREE:
            kept.append(_track(measured[rows], good[rows], within))
    return sorted([*long, *kept], key=lambda track: track.length, reverse=True)


def _laid(track: Track, step: float) -> tuple[Frames, np.ndarray]:
    """Sections laid along a track and a little beyond, and which of them are between its ends."""
    frames = track.sections.frames
    at = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(frames.origin, axis=0), axis=1)))
    count = max(2, round(at[-1] / step) + 1)
    own = np.linspace(0.0, at[-1], count)
    beyond = step * np.arange(1, _BEYOND + 1)
    place = np.concatenate([-beyond[::-1], own, at[-1] + beyond])
    within = (place >= 0.0) & (place <= at[-1])
    nearest = np.abs(place[:, None] - at).argmin(axis=1)
    inside = np.clip(place, 0.0, at[-1])
    origin = np.stack([np.interp(inside, at, frames.origin[:, k]) for k in range(3)], axis=1)
    chord = frames.origin[-1] - frames.origin[0]
    size = float(np.linalg.norm(chord))
    if len(track) > 2 or size == 0.0:
        tangent = frames.tangent[nearest]
    else:
        tangent = np.repeat(chord[None] / size, len(place), 0)
    origin = origin + (place - inside)[:, None] * tangent
    return (
        frames_from_sides(
            origin, tangent, frames.sides[nearest], frames.bend[nearest], frames.curvature[nearest]
        ),
        within,
    )


def _track(measured: MeasuredSections, good: np.ndarray, within: np.ndarray) -> Track:
    """The good sections, without those beyond an end that a bad one lies before."""
    first, last = np.flatnonzero(within)[[0, -1]]
    while first > 0 and good[first - 1]:
        first -= 1
    while last + 1 < len(good) and good[last + 1]:
        last += 1
    rows = np.arange(first, last + 1)
    return join_tracks([Track(measured[rows[good[rows]]], False)])
