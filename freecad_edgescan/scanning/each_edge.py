# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of a network scanned one by one, each from a place on it, as from a click."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from ..cloud.point_cloud import PointCloud
from .errors import ScanError
from .progress import Progress
from .scan import scan_edge
from .scanned_edge import ScannedEdge

__all__ = ["scan_each"]

Array = NDArray[np.float64]

_ON_EDGE = 1.5  # pitches from a scanned edge, within which a point is part of it
_FEWEST = 4  # edge points that are worth another scan


def scan_each(
    cloud: PointCloud, edges: Sequence[ScannedEdge], progress: Progress | None = None
) -> list[tuple[Array, ScannedEdge]]:
    """Scan edges again, each by itself.

    An edge that a scan from its middle does not reach all of is scanned from the middle of what is
    left, too; one that belongs to an edge scanned before is not scanned again.

    Parameters
    ----------
    cloud : in which they were found
    edges : as found by `find_edges`
    progress : told the share that is done, and the list so far; False ends it, and what was scanned
        until then is handed over

    Returns
    -------
    Places (3,) from which edges can be scanned, and these edges. A place at which there is no edge
    by itself is left out.
    """
    scanned: list[tuple[Array, ScannedEdge]] = []
    for number, edge in enumerate(edges):
        left = _not_in(edge.points, [found for _, found in scanned], cloud.pitch)
        while len(left) >= min(_FEWEST, len(edge)):
            if progress is not None and not progress.update(number / len(edges), scanned):
                return scanned
            place = left[len(left) // 2]
            try:
                found = scan_edge(cloud, at=place)
            except ScanError:
                break
            rest = _not_in(left, [found], cloud.pitch)
            if not len(found) or len(rest) == len(left):
                break
            scanned.append((place, found))
            left = rest
    return scanned


def _not_in(points: Array, edges: list[ScannedEdge], pitch: float) -> Array:
    """The longest stretch of edge points (m, 3) that no edge is along."""
    free = np.ones(len(points), dtype=bool)
    for edge in edges:
        if len(edge):
            reach = max(_ON_EDGE * pitch, 0.6 * float(edge.parameters.edge_pitch or 0.0))
            free &= cKDTree(edge.points).query(points)[0] > reach
    runs = np.split(np.arange(len(points)), np.flatnonzero(np.diff(free.astype(int))) + 1)
    longest = max((run for run in runs if len(run) and free[run[0]]), key=len, default=np.array([]))
    stretch: Array = points[longest.astype(int)]
    return stretch
