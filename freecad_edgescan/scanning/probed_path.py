# SPDX-License-Identifier: LGPL-2.1-or-later
"""The smooth course of a probed edge: what many edge points know of its direction and bend."""

from __future__ import annotations

import numpy as np

from .section import Frames, frames_from_sides

__all__ = ["smooth_frames"]

_MOST_POINTS = 10  # on each side of an edge point, or as many as lie within the length
_FEWEST_POINTS = 3
_TANGENTS = 0.2  # of the length: the error of a point that weighs like one radian of a tangent
_MOST_TURN = 0.3  # rad, of the edge from the middle to the end of what is taken together


def smooth_frames(
    points: np.ndarray, tangents: np.ndarray, sides: np.ndarray, length: float
) -> Frames:
    """Sections on the parabolas that fit each edge point's neighbourhood best.

    A parabola over so many points that the edge turns little among them knows tangent and bend
    far better than two following scan lines do, and its own middle is a smoothed edge point. The
    walk's own tangents count for little where the edge points reach far, and hold the direction
    where they lie closer together than they scatter. Over less than the length, what looks like a
    bend may be scatter, and the shorter it is the more the edge is taken to be straight.

    Parameters
    ----------
    points : (m, 3) mm, edge points of the walk, m >= 1
    tangents : (m, 3) unit vectors, its tangents
    sides : (m, 2, 3) unit vectors along the two surfaces, away from the edge
    length : mm to each side of an edge point, that is taken together even if it holds many points
    """
    if len(points) < 2:
        return frames_from_sides(points, tangents, sides)
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    at = np.append(0.0, np.cumsum(steps * _along(points, tangents)))
    step = abs(float(at[-1])) / (len(points) - 1)
    most = max(_MOST_POINTS, round(length / max(step, 1e-12)))
    _, _, bend = _parabolas(points, tangents, at, most, length)
    turn = float(np.median(np.linalg.norm(bend, axis=1))) * step
    reach = int(np.clip(_MOST_TURN / max(turn, 1e-12), _FEWEST_POINTS, most))
    origin, tangent, bend = _parabolas(points, tangents, at, reach, length)
    return frames_from_sides(origin, tangent, sides, bend)


def _along(points: np.ndarray, tangents: np.ndarray) -> np.ndarray:
    """Share of each step between two edge points that lies along the walk, (m - 1,)."""
    way = tangents[1:] + tangents[:-1]
    way = way / np.linalg.norm(way, axis=1, keepdims=True)
    steps = np.diff(points, axis=0)
    size = np.maximum(np.linalg.norm(steps, axis=1), 1e-300)
    return np.asarray(np.einsum("mi,mi->m", steps, way) / size)


def _parabolas(
    points: np.ndarray, tangents: np.ndarray, at: np.ndarray, reach: int, length: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Point, unit tangent and bend at each edge point, (m, 3) each."""
    origin, tangent, bend = (np.zeros_like(points) for _ in range(3))
    weight = _TANGENTS * length
    for j in range(len(points)):
        low, high = max(0, j - reach), min(len(points), j + reach + 1)
        u = at[low:high] - at[j]
        degree = min(2, high - low - 1)
        scale = max(float(np.abs(u).max()), 1e-300)
        powers = (u / scale)[:, None] ** np.arange(degree + 1)
        slopes = np.zeros_like(powers)
        slopes[:, 1:] = np.arange(1, degree + 1) * powers[:, :-1] / scale
        bends = np.zeros((1, degree + 1))
        bends[:, 2:] = max(0.0, length - float(np.ptp(u))) * 2.0 / scale**2
        rows = np.vstack([powers, weight * slopes, weight * bends])
        values = np.vstack([points[low:high], weight * tangents[low:high], np.zeros((1, 3))])
        c = np.linalg.lstsq(rows, values, rcond=None)[0]
        speed = float(np.linalg.norm(c[1]))
        origin[j], tangent[j] = c[0], c[1] / speed
        if degree == 2:
            bent = 2.0 * c[2] / speed**2
            bend[j] = bent - (bent @ tangent[j]) * tangent[j]
    return origin, tangent, bend
