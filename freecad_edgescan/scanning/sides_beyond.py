# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the sides of a found edge end at it, as those of an edge do, or go on beyond it.

Beside a thin wall a section may take the outer face for one side and, for the other, a floor that
begins behind the wall: drawn out, the two meet, but the outer face passes by as if nothing were
there. Over a narrow step, one face drawn out meets the other before that one has ended. So behind
an edge the surface of either side must have no points, and next to it there must be none outside of
the wedge of the two: sharp or rounded, the cloud turns away there to the inside.
"""

from __future__ import annotations

import numpy as np
from scipy.ndimage import uniform_filter1d

from ..cloud.point_cloud import PointCloud
from .patch_section import PatchSettings
from .scan_lines import ScanLines
from .scanned_edge import ScannedEdge
from .section import frames_from_sides, unrolled

__all__ = ["sides_beyond"]

# Pitches behind an edge: the rows in which a side's points are counted. Both must have them, since
# one alone may be the far side of a narrow rib or slot.
_ROWS = (0.5, 1.5, 2.5)
# The same next to an edge, where whatever lies outside of the wedge is counted. A rib or a slot is
# wider, or shows no sides.
_NEXT = (0.5, 0.85, 1.2)
_HALF_WIDTH = 1.5  # pitches along the edge
_OUTSIDE, _ASIDE = 4.0, 0.2  # standard deviations, and pitches, above one of the sides
_ON_SURFACE = 3.0  # standard deviations from it
_POOLED = 5  # edge points whose counts are taken together
# Of the points that a surface has there: where so many are found, a surface is as likely as strays
# that are a twentieth of it.
_AS_MANY = 0.32
_FEWEST = 3  # edge points in sequence


def sides_beyond(edge: ScannedEdge, cloud: PointCloud, settings: PatchSettings) -> np.ndarray:
    """Edge points (m,) at which one of the sides goes on behind the edge.

    Parameters
    ----------
    settings : that the edge was measured with
    """
    count, lines = len(edge), edge.scan_lines
    if count < _FEWEST or not isinstance(lines, ScanLines):
        return np.zeros(count, dtype=bool)
    pitch = settings.cloud_pitch
    # Where the fitted sides meet, before a probe's radius is taken off: there the cloud is.
    curvature = lines.fits.coefficients[..., 2] / lines.fits.reach
    frames = frames_from_sides(
        lines.meeting_points, edge.tangents, edge.sides, lines.frames.bend, curvature
    )
    balls = cloud.tree.query_ball_point(
        frames.origin, pitch * np.hypot(_ROWS[-1], 2.0 * _HALF_WIDTH), return_sorted=False
    )
    owner = np.repeat(np.arange(count), [len(ball) for ball in balls])
    index = np.concatenate([np.asarray(ball, dtype=np.int64) for ball in balls])
    along, offset, sound = unrolled(frames, owner, cloud.points[index])
    within = sound & (np.abs(along) < _HALF_WIDTH * pitch)
    owner, offset = owner[within], offset[within]
    away = np.einsum("nki,ni->nk", frames.sides[owner], offset)
    height = np.einsum("nki,ni->nk", frames.normals[owner], offset)
    height -= 0.5 * frames.curvature[owner] * away**2
    mode = "wrap" if edge.closed else "nearest"

    def filled(part: np.ndarray, distance: np.ndarray, rows: tuple[float, ...]) -> np.ndarray:
        """Edge points with as many points in each row as a surface has there."""
        row = np.digitize(distance / pitch, rows) - 1
        number = len(rows) - 1
        counted = part & (row >= 0) & (row < number)
        found = np.bincount(owner[counted] * number + row[counted], minlength=count * number)
        share = found.reshape(count, number) / (2.0 * _HALF_WIDTH * np.diff(rows))
        pooled = uniform_filter1d(share, min(_POOLED, count), axis=0, mode=mode)
        return np.asarray(pooled.min(axis=1) > _AS_MANY)

    aside = np.maximum(_OUTSIDE * settings.noise, _ASIDE * pitch) + 2.0 * edge.own_sigma[owner]
    ahead = np.einsum("ni,ni->n", frames.tangent[owner], offset)
    apart = np.linalg.norm(offset - ahead[:, None] * frames.tangent[owner], axis=1)
    beyond = filled(height.max(axis=1) > aside, apart, _NEXT)
    height = np.abs(height)
    on_surface = height < _ON_SURFACE * settings.noise
    for side, other in ((0, 1), (1, 0)):
        # What is nearer to the other side belongs to that one.
        mine = (away[:, other] < 0.0) | (height[:, side] < height[:, other])
        beyond |= filled(on_surface[:, side] & mine, -away[:, side], _ROWS)
    return _in_sequence(beyond)


def _in_sequence(marked: np.ndarray) -> np.ndarray:
    """Those of the marked edge points (m,) that are enough in sequence."""
    runs = np.split(np.arange(len(marked)), np.flatnonzero(np.diff(marked.astype(int))) + 1)
    return np.concatenate([marked[run] & (len(run) >= _FEWEST) for run in runs])
