# SPDX-License-Identifier: LGPL-2.1-or-later
"""An edge as it is drawn while it grows and when it is finished: plain arrays."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from freecad_edgescan.scanning import ScannedEdge
from freecad_edgescan.scanning.progress import SoFar

from .picking import Array

__all__ = ["LiveEdge"]

_FEWEST, _MOST = 50, 4000  # points of the drawn curve


@dataclass(frozen=True)
class LiveEdge:
    """What a preview draws.

    Attributes
    ----------
    points : (m, 3) edge points, mm
    sigma : (m,) mm
    scan_lines : (k, 3) points each, mm, across the edge
    curve : (c, 3) points of the curve through them
    """

    points: Array
    sigma: Array
    scan_lines: Sequence[Array] = ()
    curve: Array = field(default_factory=lambda: np.zeros((0, 3)))

    @classmethod
    def of_walk(cls, so_far: SoFar) -> LiveEdge:
        """What a walk has found so far; the curve is still the line from point to point."""
        points = so_far.points
        return cls(points, so_far.sigma, so_far.scan_lines, points)

    @classmethod
    def of_edge(cls, edge: ScannedEdge) -> LiveEdge:
        """A finished edge, with the curve the document will hold."""
        lines = [edge.scan_lines.course(number) for number in range(len(edge))]
        count = int(np.clip(4 * len(edge), _FEWEST, _MOST))
        curve = edge.curve().sample(count)
        if edge.closed:
            curve = np.vstack([curve, curve[:1]])
        return cls(edge.points, edge.sigma, lines, curve)
