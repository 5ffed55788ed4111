# SPDX-License-Identifier: LGPL-2.1-or-later
"""The smooth curve of a finished walk, and the sections that stand on it one edge pitch apart."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.interpolate import make_interp_spline, splev, splprep
from scipy.ndimage import gaussian_filter1d

from .section import Frames, Station, frames_from_sides


def sections_along(stations: Sequence[Station], edge_pitch: float, closed: bool) -> Frames:
    """Sections one edge pitch apart on a smoothing spline through the stations.

    Parameters
    ----------
    stations : the walk, in order; at least one
    edge_pitch : mm
    closed : whether the last station leads back to the first
    """
    walked = Frames.join([station.frame for station in stations])
    sigma = np.array([max(station.sigma, 1e-9) for station in stations])
    if len(walked) < 6:
        return walked
    points, weights = walked.origin, 1.0 / np.maximum(sigma, 0.1 * np.median(sigma))
    sides, curvature = walked.sides, walked.curvature
    if closed:
        points, weights = np.vstack([points, points[:1]]), np.append(weights, weights[0])
        sides, curvature = np.append(sides, sides[:1], 0), np.append(curvature, curvature[:1], 0)
    chord = np.linalg.norm(np.diff(points, axis=0), axis=1)
    keep = np.append(True, chord > 1e-3 * edge_pitch)
    points, weights, sides, curvature = (x[keep] for x in (points, weights, sides, curvature))
    if closed:
        points[-1] = points[0]
    at = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
    # The residuals lie in the two directions across the edge: twice as many as there are points.
    spline, _ = splprep(points.T, w=weights, u=at, k=3, s=1.5 * len(points), per=closed)
    fine = np.linspace(at[0], at[-1], 8 * len(points))
    length = np.append(
        0.0, np.cumsum(np.linalg.norm(np.diff(np.array(splev(fine, spline)), axis=1), axis=0))
    )
    count = max(3, round(length[-1] / edge_pitch) + 1)
    wanted = np.linspace(0.0, length[-1], count)[: -1 if closed else None]
    place = np.interp(wanted, length, fine)
    origin, first, second = (np.array(splev(place, spline, der=d)).T for d in range(3))
    speed = np.linalg.norm(first, axis=1, keepdims=True)
    tangent = first / speed
    bend = (second - np.einsum("mi,mi->m", second, tangent)[:, None] * tangent) / speed**2
    spread = 2.0 if len(points) > 12 else 0.5
    mode = "wrap" if closed else "nearest"
    smooth = [gaussian_filter1d(x, spread, axis=0, mode=mode) for x in (sides, curvature)]
    sides, curvature = (make_interp_spline(at, x, k=1)(place) for x in smooth)
    return frames_from_sides(origin, tangent, sides, bend, curvature)
