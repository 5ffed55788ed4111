# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections all over a cloud, measured by `PatchSection` in pieces, in threads."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from ...cloud.point_cloud import PointCloud
from ..patch_section import PatchSection, PatchSettings
from ..section import Frames
from ..sections import Sections
from ..stop import Stop

__all__ = ["measure_sections"]

_AT_ONCE = 256  # sections measured together
_THREADS = min(4, os.cpu_count() or 1)


def measure_sections(
    cloud: PointCloud, predicted: Frames, settings: PatchSettings, times: int = 1
) -> Sections:
    """Measure sections near predicted ones.

    Parameters
    ----------
    predicted : m sections
    settings : of all of them
    times : how often they are measured, each time from where they were found
    """
    frames, alive = predicted, np.arange(len(predicted))
    result = Sections.unmeasured(predicted, Stop.LOST, settings.reach)
    for _ in range(times):
        measured = _measured(cloud, frames, settings)
        result = result.replaced(alive, measured)
        found = measured.found
        alive, frames = alive[found], measured.frames[found]
    return result


def _measured(cloud: PointCloud, frames: Frames, settings: PatchSettings) -> Sections:
    if not len(frames):
        return Sections.unmeasured(frames, Stop.LOST, settings.reach)
    # Neighbours lie in one piece, so that the tree's pages are met once.
    pieces = [
        frames[rows] for rows in np.array_split(np.arange(len(frames)), -(-len(frames) // _AT_ONCE))
    ]
    if len(pieces) == 1:
        return _measured_at_once(cloud, frames, settings)
    with ThreadPoolExecutor(_THREADS) as pool:  # NumPy lets go of the interpreter's lock
        return Sections.join(
            list(pool.map(lambda piece: _measured_at_once(cloud, piece, settings), pieces))
        )


def _measured_at_once(cloud: PointCloud, frames: Frames, settings: PatchSettings) -> Sections:
    half_width = np.full(len(frames), settings.half_width)
    return PatchSection(cloud, settings).look(frames, half_width)
