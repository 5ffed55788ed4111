# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was touched for each edge point: for pictures and for people who want to see evidence."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from .section import Frames, SectionPoints
from .side_fit import SideFits

_OF_A_SIDE = 8  # of the points of a fitted side, one of so many shows its course


@dataclass(frozen=True)
class ScanLine:
    """One section, in its own plane; all lengths mm.

    Attributes
    ----------
    points : (n, 2) cloud points, along the plane's two axes from the edge point
    side : (n,) 0 or 1, the surface each point may belong to
    removed : (n,) True where a point is no side's: an outlier, another surface's, a rounding's
    curves : two (k, 2) polylines, the fitted sides where they are supported and up to the edge
    meeting_point : (2,) where the two fitted sides meet, before the probe radius is taken off
    edge_point : (2,) the edge point
    axes : (2, 3) unit vectors of the plane's axes in space
    origin : (3,) where the plane's zero stands in space
    """

    points: np.ndarray
    side: np.ndarray
    removed: np.ndarray
    curves: tuple[np.ndarray, np.ndarray]
    meeting_point: np.ndarray
    edge_point: np.ndarray
    axes: np.ndarray
    origin: np.ndarray

    def in_space(self, places: np.ndarray) -> np.ndarray:
        """Places of the plane (k, 2) in the cloud's coordinates, (k, 3) mm."""
        return np.asarray(self.origin + places @ self.axes)


def upright_axes(normals: np.ndarray, tangent: np.ndarray) -> np.ndarray:
    """Axes (2, 3) across an edge, the second one upright: out of the smaller wedge.

    Parameters
    ----------
    normals : (2, 3) unit vectors of the two sides, out of the smaller wedge
    tangent : (3,) unit vector
    """
    upright = normals.sum(axis=0)
    upright = upright / np.linalg.norm(upright)
    return np.array([np.cross(upright, tangent), upright])


@dataclass(frozen=True)
class ScanLines:
    """The sections of a whole edge, with the points of their slabs and their fitted sides."""

    frames: Frames
    points: SectionPoints
    removed: np.ndarray
    fits: SideFits
    meeting_points: np.ndarray
    edge_points: np.ndarray

    def __len__(self) -> int:
        return len(self.frames)

    def __getitem__(self, j: int) -> ScanLine:
        """Return the section of edge point j."""
        if not -len(self) <= j < len(self):
            raise IndexError(f"There are {len(self)} scan lines; {j} is none of them.")
        j %= len(self)
        axes = upright_axes(self.frames.normals[j], self.frames.tangent[j])
        to_plane = axes.T
        mine = np.flatnonzero(self.points.owner == j)
        side, away, height = (
            getattr(self.points, name)[mine] for name in ("side", "away", "height")
        )
        in_space = (
            away[:, None] * self.frames.sides[j, side]
            + height[:, None] * self.frames.normals[j, side]
        )
        return ScanLine(
            in_space @ to_plane,
            side,
            self.removed[mine],
            (self._curve(j, 0) @ to_plane, self._curve(j, 1) @ to_plane),
            (self.meeting_points[j] - self.frames.origin[j]) @ to_plane,
            (self.edge_points[j] - self.frames.origin[j]) @ to_plane,
            axes,
            self.frames.origin[j],
        )

    def course(self, j: int) -> np.ndarray:
        """Where section j was measured: both fitted sides from end to end, (k, 3) mm in space."""
        first, second = (self._curve(j, k)[::_OF_A_SIDE] for k in (0, 1))
        return np.asarray(self.frames.origin[j] + np.vstack([first[::-1], second]))

    def reversed(self) -> ScanLines:
        """The same sections, walked the other way."""
        points = self.points
        return ScanLines(
            self.frames.backward(),
            replace(points, owner=len(self) - 1 - points.owner, along=-points.along),
            self.removed,
            self.fits.backward(),
            self.meeting_points[::-1],
            self.edge_points[::-1],
        )

    def _curve(self, j: int, k: int) -> np.ndarray:
        """Points of a fitted side from the edge to the end of its support, (40, 3)."""
        reach, c = self.fits.reach, self.fits.coefficients[j, k]
        away = np.linspace(0.0, self.fits.ends[j, k] / reach, 40)
        rest = c[0] + c[1] * away + 0.5 * c[2] * away**2
        height = 2.0 * rest / (1.0 + np.sqrt(np.maximum(1.0 - 2.0 * c[2] * rest, 0.0)))
        return reach * (
            away[:, None] * self.frames.sides[j, k] + height[:, None] * self.frames.normals[j, k]
        )
