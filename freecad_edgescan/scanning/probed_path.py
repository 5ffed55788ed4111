# SPDX-License-Identifier: LGPL-2.1-or-later
"""The smooth course of a probed edge: what many edge points know of its direction and bend."""

from __future__ import annotations

import numpy as np

from .section import Frames, frames_from_sides

__all__ = ["smooth_frames"]

_MOST_POINTS = 10  # on each side of an edge point
_FEWEST_POINTS = 3
_MOST_TURN = 0.3  # rad, of the edge from the middle to the end of what is taken together


def smooth_frames(points: np.ndarray, sides: np.ndarray) -> Frames:
    """Sections on the parabolas that fit each edge point's neighbourhood best.

    A parabola over so many points that the edge turns little among them knows tangent and bend
    far better than two following scan lines do, and its own middle is a smoothed edge point.

    Parameters
    ----------
    points : (m, 3) mm, edge points of the walk, m >= 2
    sides : (m, 2, 3) unit vectors along the two surfaces, away from the edge
    """
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    at = np.append(0.0, np.cumsum(steps))
    _, _, bend = _parabolas(points, at, _MOST_POINTS)
    turn = np.median(np.linalg.norm(bend, axis=1)) * np.median(steps)
    reach = int(np.clip(_MOST_TURN / max(turn, 1e-12), _FEWEST_POINTS, _MOST_POINTS))
    origin, tangent, bend = _parabolas(points, at, reach)
    return frames_from_sides(origin, tangent, sides, bend)


def _parabolas(
    points: np.ndarray, at: np.ndarray, reach: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Point, unit tangent and bend at each edge point, (m, 3) each."""
    origin, tangent, bend = (np.zeros_like(points) for _ in range(3))
    for j in range(len(points)):
        # As many points behind as ahead, as long as there are enough.
        half = min(reach, max(j, len(points) - 1 - j, 1))
        low, high = max(0, j - half), min(len(points), j + half + 1)
        degree = min(2, high - low - 1)
        u = at[low:high] - at[j]
        scale = max(float(np.abs(u).max()), 1e-300)
        powers = (u / scale)[:, None] ** np.arange(degree + 1)
        c = np.linalg.lstsq(powers, points[low:high], rcond=None)[0]
        speed = float(np.linalg.norm(c[1]))
        origin[j], tangent[j] = c[0], c[1] / speed
        if degree == 2:
            bent = 2.0 * c[2] / speed**2
            bend[j] = bent - (bent @ tangent[j]) * tangent[j]
    return origin, tangent, bend
