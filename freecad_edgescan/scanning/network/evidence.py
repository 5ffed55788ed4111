# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections on edges, all over a cloud: proposed at several scales and confirmed by the patches.

What a smaller scale has found for certain is not looked for at a larger one.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.spatial import cKDTree

from ..measured_sections import MeasuredSections
from ..patch_section import PatchSettings
from ..section import Frames, frames_from_sides
from .cloud_workers import CloudWorkers
from .measuring import measure_sections
from .proposals import ALONG, SCALES, propose_sections
from .spacing import best_apart

__all__ = ["sections_on_edges"]

_REACHES = (9.0, 9.0, 16.0)  # pitches, from an edge to each side, by scale
_LARGEST_SIGMA = 0.5  # pitches
_LEAST_COVER = 0.5
_SURE_SIGMA, _BENT = 0.19, 0.035  # pitches, and 1/pitches: a short look at a sharp edge is better
_LOOKS = 4  # with the whole reach, until a section stands
_STANDS, _TURNED = 0.25, 0.05  # pitches and rad, from one look to the next
_CERTAIN_SIGMA, _CERTAIN_COVER = 0.3, 0.75
_CLAIMED = 2.5  # pitches beside a certain section, where nothing else is looked for
_SAME_WAY = np.cos(np.radians(25.0))
_ASIDE = 1.5  # pitches: two sections nearer than that beside each other are of one edge


def sections_on_edges(
    workers: CloudWorkers,
    settings: PatchSettings,
    spacing: float = ALONG,
    tell: Callable[[float], bool] | None = None,
) -> MeasuredSections:
    """Sections on the edges of a cloud, some pitches apart, in no order.

    Parameters
    ----------
    settings : of a patch; the reach is chosen here
    spacing : pitches, between two sections of an edge
    tell : told the share that is done; where it answers False, the search ends
    """
    pitch = settings.cloud_pitch
    found: list[MeasuredSections] = []
    for number, (scale, reach) in enumerate(zip(SCALES, _REACHES, strict=True)):
        if tell is not None and not tell(number / len(SCALES)):
            break
        proposed = propose_sections(workers.cloud, scale, settings.min_angle)
        if found:
            proposed = proposed[~_claimed(proposed, MeasuredSections.join(found), pitch)]
        measured = measure_sections(workers, proposed, settings.with_reach(reach * pitch))
        measured = measured[measured.found]
        if found:  # what stands where an edge is known only now is nothing new either
            known = MeasuredSections.join(found)
            measured = measured[~_claimed(measured.frames, known, pitch)]
        measured = _seen_farther(workers, measured, settings)
        found.append(measured[_sound(measured, settings)])
    if not found:
        nothing = np.zeros((0, 3)), np.zeros((0, 3)), np.zeros((0, 2, 3))
        return measure_sections(workers, frames_from_sides(*nothing), settings)
    sections = MeasuredSections.join(found)
    return sections[
        best_apart(sections.frames, sections.doubt, 0.6 * spacing * pitch, _ASIDE * pitch)
    ]


def _seen_farther(
    workers: CloudWorkers, sections: MeasuredSections, settings: PatchSettings
) -> MeasuredSections:
    """The sections, those that may stand on a rounding measured again with the whole reach.

    A short look at a wide rounding takes a part of it for a side, which is bent and known badly.
    """
    pitch = settings.cloud_pitch
    with np.errstate(invalid="ignore"):
        doubtful = sections.sigma > _SURE_SIGMA * pitch
    doubtful |= np.abs(sections.frames.curvature).max(axis=1) > _BENT / pitch
    rows = np.flatnonzero(sections.found & doubtful)
    for _ in range(_LOOKS):
        if not len(rows):
            break
        before = sections[rows]
        after = measure_sections(workers, before.frames, settings)
        better = after.found & (after.sigma < 1.1 * before.sigma)
        rows, before, after = rows[better], before[better], after[better]
        sections = sections.replaced(rows, after)
        moved = np.linalg.norm(after.frames.origin - before.frames.origin, axis=1)
        turned = np.abs(after.frames.turn - before.frames.turn)
        rows = rows[(moved > _STANDS * pitch) | (turned > _TURNED)]
    return sections


def _sound(sections: MeasuredSections, settings: PatchSettings) -> np.ndarray:
    """Whether two sides surely meet there at more than the least angle, (m,)."""
    with np.errstate(invalid="ignore"):
        known = sections.sigma < _LARGEST_SIGMA * settings.cloud_pitch
    turning = sections.frames.turn >= settings.min_angle
    return sections.found & known & turning & (sections.cover > _LEAST_COVER)


def _claimed(frames: Frames, sections: MeasuredSections, pitch: float) -> np.ndarray:
    """Which proposals lie where an edge has been found for certain, (m,)."""
    certain = sections.sigma < _CERTAIN_SIGMA * pitch
    certain &= sections.cover > _CERTAIN_COVER
    if not certain.any() or not len(frames):
        return np.zeros(len(frames), dtype=bool)
    known = sections.frames[certain]
    count = min(6, len(known))
    away, near = cKDTree(known.origin).query(
        frames.origin, k=range(1, count + 1), distance_upper_bound=1.3 * ALONG * pitch, workers=-1
    )
    there = np.isfinite(away)
    near = np.where(there, near, 0)
    tangent = known.tangent[near]
    offset = frames.origin[:, None] - known.origin[near]
    ahead = np.einsum("nki,nki->nk", offset, tangent)
    off = np.linalg.norm(offset - ahead[..., None] * tangent, axis=2)
    alike = np.abs(np.einsum("nki,ni->nk", tangent, frames.tangent)) > _SAME_WAY
    return np.any(there & alike & (off < _CLAIMED * pitch), axis=1)
