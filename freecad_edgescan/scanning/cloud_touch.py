# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a virtual probe meets first among the points near its search line (Schreve 3.3.2 to 3.3.4).

Each kind of touch looks at candidates in the coordinates of the search line: `along` it from where
the search begins, and squared distance from it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

__all__ = ["BallTouch", "ClosestTouch", "Touch", "TriangleTouch"]

_DEEP = 2.0  # pitches behind the first point met in which the corners of a triangle are looked for


class Touch(Protocol):
    """How a search line meets points.

    Attributes
    ----------
    corridor : mm, how far from the search line a point may lie
    depth : mm, how far along the line, before or behind a contact, points may lie that matter
    """

    @property
    def corridor(self) -> float:
        """How far from the search line a point may lie, mm."""
        ...

    @property
    def depth(self) -> float:
        """How far along the line, before or behind a contact, points may lie that matter, mm."""
        ...

    def first(
        self, points: np.ndarray, start: np.ndarray, way: np.ndarray, farthest: float
    ) -> np.ndarray | None:
        """The contact on a search line not farther than some distance, or None.

        Parameters
        ----------
        points : (n, 3) mm, all that lie in the corridor there, and others
        start : (3,) mm
        way : (3,) unit vector
        farthest : mm
        """
        ...


@dataclass(frozen=True)
class ClosestTouch:
    """The first point of the cloud within one pitch of the search line (Schreve 3.3.2).

    First is the one with the smallest positive parameter on the line, as with a real probe. Taking
    the one closest to the line among the first few would follow the pattern better, but scans
    lose their edge more often then.

    Attributes
    ----------
    corridor : the pitch that tells a gap from surface, mm
    """

    corridor: float
    depth = 0.0

    def first(
        self, points: np.ndarray, start: np.ndarray, way: np.ndarray, farthest: float
    ) -> np.ndarray | None:
        """The point itself, (3,) mm."""
        along, aside = _on_the_line(points, start, way)
        near = np.flatnonzero((along > 0.0) & (along <= farthest) & (aside <= self.corridor**2))
        if not len(near):
            return None
        return np.asarray(points[near[along[near].argmin()]])


@dataclass(frozen=True)
class BallTouch:
    """The centre of a ball that rolls along the search line until it meets a point (3.3.3).

    A ball dips into the gaps between points by up to R − √(R² − d²/3) where these lie a distance d
    apart (eq. 3.3.3.3).

    Attributes
    ----------
    corridor : radius R of the ball, mm
    """

    corridor: float

    @property
    def depth(self) -> float:
        """The ball meets a point straight ahead one radius before it."""
        return self.corridor

    def first(
        self, points: np.ndarray, start: np.ndarray, way: np.ndarray, farthest: float
    ) -> np.ndarray | None:
        """The ball's centre, (3,) mm."""
        along, aside = _on_the_line(points, start, way)
        near = np.flatnonzero(aside <= self.corridor**2)
        if not len(near):
            return None
        half = np.sqrt(self.corridor**2 - aside[near])
        # Eq. 3.3.3.2, with the squared distance from the line in its bracket; both signs.
        stations = np.concatenate([along[near] - half, along[near] + half])
        stations = stations[(stations > 0.0) & (stations <= farthest)]
        return start + stations.min() * way if len(stations) else None


@dataclass(frozen=True)
class TriangleTouch:
    """Where the search line pierces a triangle of three points near it (Schreve 3.3.4).

    Two corners are the points closest to the line where the surface is met first; the third is the
    closest one that makes a triangle round the line. Where there is none, as at the rim of a
    cloud, the closest point is the contact.

    Attributes
    ----------
    pitch : mm
    """

    pitch: float

    @property
    def depth(self) -> float:
        """Two corners may lie behind the one that is met first."""
        return _DEEP * self.pitch

    @property
    def corridor(self) -> float:
        """Corners lie up to three pitches from the line."""
        return 3.0 * self.pitch

    def first(
        self, points: np.ndarray, start: np.ndarray, way: np.ndarray, farthest: float
    ) -> np.ndarray | None:
        """The piercing point, (3,) mm."""
        along, aside = _on_the_line(points, start, way)
        met = along[(along > 0.0) & (along <= farthest) & (aside <= self.pitch**2)]
        if not len(met):
            return None
        surface = (along > 0.0) & (along <= met.min() + _DEEP * self.pitch)
        near = np.flatnonzero(surface & (aside <= self.corridor**2))
        near = near[np.argsort(aside[near])]
        axes = _across(way)
        flat = (points[near] - start) @ axes.T
        a, b = flat[:2] if len(near) > 2 else (flat[0], flat[0])
        for i in range(2, len(near)):
            shares = _shares(a, b, flat[i])
            if shares is not None and shares.min() >= 0.0:
                return start + float(shares @ along[near[[0, 1, i]]]) * way
        return np.asarray(points[near[0]])


def _on_the_line(
    points: np.ndarray, start: np.ndarray, way: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Parameter of points on a line, and squared distance from it (Schreve A6.1, A7.1)."""
    offset = points - start
    along = offset @ way
    return along, np.einsum("ni,ni->n", offset, offset) - along * along


def _across(way: np.ndarray) -> np.ndarray:
    """Two unit vectors (2, 3) square to a unit vector."""
    spare = np.eye(3)[int(np.abs(way).argmin())]
    first = spare - (spare @ way) * way
    first = first / np.linalg.norm(first)
    return np.array([first, np.cross(way, first)])


def _shares(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> np.ndarray | None:
    """Shares of three corners (2,) in the origin, or None when they lie on one line."""
    area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    if abs(area) < 1e-12 * max(float(a @ a), float(b @ b), float(c @ c), 1e-300):
        return None
    of_a = (b[0] * c[1] - b[1] * c[0]) / area
    of_b = (c[0] * a[1] - c[1] * a[0]) / area
    return np.array([of_a, of_b, 1.0 - of_a - of_b])
