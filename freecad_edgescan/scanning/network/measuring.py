# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections all over a cloud, measured by `PatchSection` in pieces."""

from __future__ import annotations

import numpy as np

from ...cloud.point_cloud import PointCloud
from ..measured_sections import MeasuredSections
from ..patch_section import PatchSection, PatchSettings
from ..section import Frames
from ..stop import Stop
from .cloud_workers import CloudWorkers

__all__ = ["measure_sections"]

_AT_ONCE = 256  # sections measured together


def measure_sections(
    workers: CloudWorkers, predicted: Frames, settings: PatchSettings, times: int = 1
) -> MeasuredSections:
    """Measure sections near predicted ones.

    Parameters
    ----------
    workers : who measure, with the cloud
    predicted : m sections
    settings : of all of them
    times : how often they are measured, each time from where they were found
    """
    frames, alive = predicted, np.arange(len(predicted))
    result = MeasuredSections.unmeasured(predicted, Stop.LOST, settings.reach)
    for _ in range(times):
        if not len(frames):
            break
        measured = _measured(workers, frames, settings)
        result = result.replaced(alive, measured)
        found = measured.found
        alive, frames = alive[found], measured.frames[found]
    return result


def _measured(workers: CloudWorkers, frames: Frames, settings: PatchSettings) -> MeasuredSections:
    # Neighbours lie in one piece, so that the tree's pages are met once.
    pieces = [
        (frames[rows], settings)
        for rows in np.array_split(np.arange(len(frames)), -(-len(frames) // _AT_ONCE))
    ]
    if len(pieces) == 1:
        return _at_once(workers.cloud, pieces[0])
    return MeasuredSections.join(list(workers.map(_at_once, pieces)))


def _at_once(cloud: PointCloud, piece: tuple[Frames, PatchSettings]) -> MeasuredSections:
    frames, settings = piece
    return PatchSection(cloud, settings).look(frames, np.full(len(frames), settings.half_width))
