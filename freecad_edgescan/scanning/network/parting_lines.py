# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines along which edges part faces: the edges, led on to the corners they stop short of.

An edge ends in a vertex that was measured; where none was, it stops some pitches before the corner,
and so do the others there. Its line goes on to where it meets another one, drawn out likewise.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from ..scanned_edge import ScannedEdge
from ..stop import Stop

__all__ = ["PartingLine", "parting_lines"]

_DRAWN_ON = 8.0  # pitches, at most
_MET = 1.5  # pitches between two lines that meet


@dataclass(frozen=True)
class PartingLine:
    """Where an edge parts two faces.

    Attributes
    ----------
    points : (k, 3) mm
    tangents : (k, 3) unit vectors
    sides : (k, 2, 3) unit vectors along the two faces
    """

    points: np.ndarray
    tangents: np.ndarray
    sides: np.ndarray

    def drawn_on(self, before: float, behind: float, step: float) -> PartingLine:
        """The line, straight on by some lengths at its start and end, mm."""
        line = self
        for k, way, length in ((0, -1.0, before), (-1, 1.0, behind)):
            count = int(length / step)
            far = way * step * np.arange(1, count + 1)[:, None]
            line = PartingLine(
                np.concatenate([line.points, self.points[k] + far * self.tangents[k]]),
                np.concatenate([line.tangents, np.repeat(self.tangents[k][None], count, axis=0)]),
                np.concatenate([line.sides, np.repeat(self.sides[k][None], count, axis=0)]),
            )
        return line


def parting_lines(edges: Sequence[ScannedEdge], pitch: float) -> list[PartingLine]:
    """The line of each edge.

    Parameters
    ----------
    edges : of at least one point each
    pitch : of the cloud, mm
    """
    if not edges:
        return []
    own = [PartingLine(edge.points, edge.tangents, edge.sides) for edge in edges]
    far = [[_DRAWN_ON * pitch * _stops_short(edge, k) for k in (0, 1)] for edge in edges]
    tails = [
        line.drawn_on(before, behind, pitch)
        for line, (before, behind) in zip(own, far, strict=True)
    ]
    owner = np.repeat(np.arange(len(tails)), [len(tail.points) for tail in tails])
    tree = cKDTree(np.concatenate([tail.points for tail in tails]))
    lengths = [
        [_to_corner(edge, number, k, tree, owner, pitch) for k in (0, 1)]
        for number, edge in enumerate(edges)
    ]
    return [
        line.drawn_on(before, behind, pitch)
        for line, (before, behind) in zip(own, lengths, strict=True)
    ]


def _stops_short(edge: ScannedEdge, k: int) -> bool:
    return not edge.closed and edge.vertices[k] is None and edge.stops[k] is Stop.CORNER


def _to_corner(
    edge: ScannedEdge, number: int, k: int, lines: cKDTree, owner: np.ndarray, pitch: float
) -> float:
    """How far the corner lies beyond the start (k = 0) or the end of an edge, mm; 0: there is none.

    Parameters
    ----------
    number : of the edge
    lines, owner : places on all lines drawn out, and the number of the edge of each
    """
    end, vertex = edge.points[-k], edge.vertices[k]
    if vertex is not None:
        return float(np.linalg.norm(vertex[0] - end))
    if not _stops_short(edge, k):
        return 0.0
    way = edge.tangents[-k] if k else -edge.tangents[0]
    near = np.asarray(lines.query_ball_point(end, _DRAWN_ON * pitch), dtype=np.intp)
    offset = lines.data[near[owner[near] != number]] - end
    ahead = offset @ way
    beside = np.linalg.norm(offset - ahead[:, None] * way, axis=1)
    met = ahead[(ahead > 0.0) & (beside < _MET * pitch)]
    return float(np.min(met, initial=np.inf)) if len(met) else 0.0
