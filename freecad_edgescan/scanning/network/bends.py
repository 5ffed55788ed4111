# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places where two edges seem to meet in a corner, but are one that bends with the wall beneath it.

Each of the two took the side of the other one for a third surface. In a corner these two surfaces
meet in an edge of their own, too, though it may be too short to have been found by itself; and the
section across it turns by as much as they do where they meet. Where they are one wall that bends,
some of the turn lies beside that section.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...cloud.point_cloud import PointCloud
from ..patch_section import PatchSection, PatchSettings
from ..scanned_edge import ScannedEdge
from ..section import Frames, frames_from_sides

__all__ = ["bends_at"]

_LAST = 4  # edge points that tell the sides at the end of an edge
_FROM, _TO = 1.5, 8.5  # pitches from the corner, between which the third edge is looked at
_REACH, _LEAST_NOISE = 9.0, 0.03  # pitches
_KNOWN = 0.5  # pitches, largest sigma of a section that says anything
_MOST = 0.75  # of the surfaces' turn, that a section turns by where they bend into each other
_FLATTEST = 0.25  # sine of the angle between two surfaces


def bends_at(cloud: PointCloud, point: np.ndarray, ends: Sequence[tuple[ScannedEdge, int]]) -> bool:
    """Whether two sharp edges do not end in a corner, but are one edge that bends there.

    Parameters
    ----------
    point : (3,) mm, the corner that was taken for one
    ends : the two edges, each with which of its ends is there, 0 or 1
    """
    predicted = _third_edge(cloud.pitch, point, ends)
    if predicted is None:
        return False
    pitch = cloud.pitch
    settings = PatchSettings(
        _REACH * pitch,
        2.0 * pitch,
        pitch,
        max(cloud.noise, _LEAST_NOISE * pitch),
        cloud.probe_radius,
    )
    half_width = np.array([0.5 * (_TO - _FROM) * pitch])
    (seen,) = PatchSection(cloud, settings).settle(predicted, half_width)
    if seen.stop is not None or not seen.sigma < _KNOWN * pitch:
        return False
    return bool(seen.frame.turn[0] < _MOST * predicted.turn[0])


def _third_edge(
    pitch: float, point: np.ndarray, ends: Sequence[tuple[ScannedEdge, int]]
) -> Frames | None:
    """The section where the two surfaces that the edges do not share must meet; None if nowhere."""
    rows = [slice(-_LAST, None) if k else slice(_LAST) for _, k in ends]
    normals, sides = (
        np.array(
            [
                getattr(edge, name)[row].mean(axis=0)
                for (edge, _), row in zip(ends, rows, strict=True)
            ]
        )
        for name in ("normals", "sides")
    )
    # Back along each edge.
    ways = np.array(
        [
            (edge.points[row][0] - edge.points[row][-1]) * (2 * k - 1)
            for (edge, k), row in zip(ends, rows, strict=True)
        ]
    )
    alike = np.abs(normals[0] @ normals[1].T)
    shared = np.unravel_index(int(alike.argmax()), alike.shape)
    one, other = 1 - int(shared[0]), 1 - int(shared[1])
    along = np.cross(normals[0, one], normals[1, other])
    size = float(np.linalg.norm(along))
    if size < _FLATTEST:
        return None
    along /= size
    # Away from the shared surface, where both others are.
    along *= 1.0 if along @ (sides[0, one] + sides[1, other]) > 0.0 else -1.0
    middle = point + 0.5 * (_FROM + _TO) * pitch * along
    return frames_from_sides(middle[None], along[None], ways[None])
