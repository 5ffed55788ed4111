# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which stretches of a finished edge its evidence carries.

A walk or a bridge may have led round a corner, or on between two edges: there both sides are
missing though the cloud has points, or the edge turns at one place as no edge bends.
"""

from __future__ import annotations

import numpy as np

from ...cloud.point_cloud import PointCloud
from ..scanned_edge import ScannedEdge

__all__ = ["corners_within", "sound_stretches"]

_SUDDEN = 1.0  # rad, turn at one place besides twice the bend beside it
_LONGEST_BRIDGE = 5  # edge points in sequence without support of their own, where there are points
_NO_POINTS = 2.0  # pitches from the nearest point, besides what a rounding takes away
_LONGEST_STEP = 3.0  # edge pitches
_WIDEST = 26.0  # pitches, of a gap
_FEWEST = 3


def corners_within(points: np.ndarray, closed: bool, width: int = 2) -> np.ndarray:
    """Numbers of the points (k, 3) after which a line through them turns a corner.

    It turns there by much more than it bends on either side.

    Parameters
    ----------
    width : points over which a direction is taken
    """
    count = len(points)
    if count < 2 * width + 2:
        return np.zeros(0, dtype=np.intp)
    if closed:
        points = np.vstack([points[-3 * width :], points, points[: 3 * width + 1]])
    chord = points[width:] - points[:-width]
    chord = chord / np.maximum(np.linalg.norm(chord, axis=1, keepdims=True), 1e-12)

    def turn(apart: int) -> np.ndarray:
        cosine = np.einsum("ni,ni->n", chord[:-apart], chord[apart:])
        return np.arccos(np.clip(cosine, -1.0, 1.0))

    # From the chord that ends at a point to the one that begins at the next one.
    across = turn(width + 1)
    beside = turn(width)
    last = len(across)
    before = np.append(np.zeros(width), beside)[:last]
    after = np.append(beside[width + 1 :], np.zeros(last))[:last]
    sudden = across > _SUDDEN + 2.0 * np.maximum(before, after)
    # Of several in sequence the strongest one.
    strongest = np.array(
        [
            sudden[j] and across[j] >= across[max(0, j - width) : j + width + 1].max()
            for j in range(last)
        ],
        dtype=bool,
    )
    where = np.flatnonzero(strongest) + width
    if closed:
        where = where - 3 * width
        where = where[(where >= 0) & (where < count)]
    return where


def sound_stretches(
    edge: ScannedEdge, cloud: PointCloud, edge_pitch: float, against: np.ndarray
) -> list[np.ndarray]:
    """Numbers of the edge points of each stretch that the evidence carries; all when it is sound.

    Parameters
    ----------
    edge_pitch : distance of the edge points, mm
    against : (m,) bool, at which of its points something else speaks against the edge
    """
    count = len(edge)
    bad = _unsupported(edge, cloud) | against
    cut_after = np.zeros(count, dtype=bool)
    cut_after[corners_within(edge.points, edge.closed, 3)] = True
    steps = np.linalg.norm(np.diff(edge.points, axis=0), axis=1)
    gap = cloud.tree.query(0.5 * (edge.points[1:] + edge.points[:-1]))[0]
    far = gap > _NO_POINTS * cloud.pitch + edge.overhang[1:]
    cut_after[:-1] |= (steps > _LONGEST_STEP * edge_pitch) & ~far
    cut_after[:-1] |= steps > _WIDEST * cloud.pitch
    if not bad.any() and not cut_after.any():
        return [np.arange(count)]
    if edge.closed and cut_after.sum() + bad.sum() > 0:
        # The stretch that leads over the end is one.
        first = int(np.flatnonzero(bad | cut_after)[0]) + 1
        order = np.roll(np.arange(count), -first)
    else:
        order = np.arange(count)
    stretches, current = [], []
    for number in order:
        if not bad[number]:
            current.append(number)
        if (bad[number] or cut_after[number]) and current:
            stretches.append(current)
            current = []
    if current:
        stretches.append(current)
    return [np.array(stretch) for stretch in stretches if len(stretch) >= _FEWEST]


def _unsupported(edge: ScannedEdge, cloud: PointCloud) -> np.ndarray:
    """Edge points (m,) without support of their own, for long though there are points."""
    bare = ~edge.supported
    if not bare.any():
        return bare
    rounded = float(np.median(edge.overhang))
    near = cloud.tree.query(edge.points)[0] < _NO_POINTS * cloud.pitch + rounded
    runs = np.split(np.arange(len(bare)), np.flatnonzero(np.diff(bare.astype(int))) + 1)
    bad = np.zeros(len(bare), dtype=bool)
    for run in runs:
        if not bare[run[0]]:
            continue
        at_end = not edge.closed and (run[0] == 0 or run[-1] == len(bare) - 1)
        if at_end or (len(run) >= _LONGEST_BRIDGE and near[run].mean() > 0.5):
            bad[run] = True
    return bad
