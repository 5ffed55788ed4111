# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a probed scan touched, line by line: for pictures and for people who want evidence."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .probed_line import ProbedLine
from .scan_lines import ScanLine, upright_axes
from .section import Frames

__all__ = ["ProbedLines"]


@dataclass(frozen=True)
class ProbedLines:
    """The lines of a whole edge.

    Attributes
    ----------
    lines : one for each edge point; their contacts are what the machine answered
    frames : (m) sections of the edge's smooth course
    edge_points : (m, 3) mm
    """

    lines: tuple[ProbedLine, ...]
    frames: Frames
    edge_points: np.ndarray

    def __len__(self) -> int:
        return len(self.lines)

    def reversed(self) -> ProbedLines:
        """The same lines in the other order."""
        return ProbedLines(self.lines[::-1], self.frames.backward(), self.edge_points[::-1])

    def course(self, j: int) -> np.ndarray:
        """Where line j was touched: its contacts in the order of travel, (k, 3) mm in space."""
        return self.lines[j].contacts

    def __getitem__(self, j: int) -> ScanLine:
        """Return the line of edge point j, in the plane across the edge."""
        if not -len(self) <= j < len(self):
            raise IndexError(f"There are {len(self)} scan lines; {j} is none of them.")
        j %= len(self)
        line, origin = self.lines[j], self.frames.origin[j]
        axes = upright_axes(self.frames.normals[j], self.frames.tangent[j])

        def seen(xy: np.ndarray) -> np.ndarray:
            return np.asarray((line.place(xy) - origin) @ axes.T)

        split = np.setdiff1d(
            np.arange(len(line.contacts)), np.concatenate([s.contacts for s in line.sections])
        )
        plane = (line.contacts - line.origin) @ line.axes.T
        removed = [~section.kept for section in line.sections]
        points = [section.points for section in line.sections]
        sides = [np.full(len(part), k) for k, part in enumerate(points)]
        curves = [
            seen(section.curve.at(np.linspace(0.0, max(u, 1.0), 40)))
            for section, u in zip(line.sections, line.meeting, strict=True)
        ]
        return ScanLine(
            seen(np.vstack([*points, plane[split]])),
            np.concatenate([*sides, np.zeros(len(split), dtype=np.int64)]),
            np.concatenate([*removed, np.ones(len(split), dtype=bool)]),
            (curves[0], curves[1]),
            seen(line.sections[0].curve.at(line.meeting[0])),
            (self.edge_points[j] - origin) @ axes.T,
            axes,
            origin,
        )
