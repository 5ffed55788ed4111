# SPDX-License-Identifier: LGPL-2.1-or-later
"""The smooth curve of a finished walk, and the sections that stand on it one edge pitch apart."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from scipy.integrate import cumulative_trapezoid
from scipy.interpolate import make_interp_spline, splev, splprep
from scipy.ndimage import gaussian_filter1d

from ..geometry import Line, simplest_curve
from .section import Frames, frames_from_sides
from .stop import Stop
from .trace import Trace


@dataclass(frozen=True)
class EdgePath:
    """Sections laid along a walked edge.

    Attributes
    ----------
    frames : (m) sections
    at : (m,) their places along the edge, mm
    length : mm, of the whole edge
    closed : whether the last section leads back to the first
    ends : why the edge ends there, at its start and end
    begins : (2,) distance from the edge, mm, where the walk has found that each side begins
    """

    frames: Frames
    at: np.ndarray
    length: float
    closed: bool
    ends: tuple[Stop, Stop]
    begins: np.ndarray = field(default_factory=lambda: np.zeros(2))

    def __len__(self) -> int:
        return len(self.at)

    @property
    def spacing(self) -> float:
        """Median distance of the sections, mm."""
        return float(np.median(np.diff(self.at))) if len(self.at) > 1 else self.length

    def ahead(self, step: int) -> np.ndarray:
        """Distance along the edge to the section a number of steps further, (m,) mm.

        Beyond the ends of an open edge it is nan.
        """
        onward = np.roll(self.at, -step) - self.at
        if self.closed:
            return np.where(onward * step < 0, onward + np.sign(step) * self.length, onward)
        onward[slice(-step, None) if step > 0 else slice(0, -step)] = np.nan
        return onward


def path_along(
    trace: Trace,
    edge_pitch: float,
    least_pitch: float = 0.0,
    chord_height: float | None = None,
) -> EdgePath:
    """Sections one edge pitch apart on a smoothing spline through the stations.

    Parameters
    ----------
    trace : the walk, at least one station
    edge_pitch : mm
    least_pitch, chord_height : mm; with a chord height the sections lie so that the chord between
        two of them deviates by no more from the edge, but between half and three edge pitches
        apart and not nearer than the least pitch (Schreve 4.4.4)
    """
    stations, closed = trace.stations, trace.closed
    walked = Frames.join([station.frame for station in stations])
    sigma = np.array([max(station.sigma, 1e-9) for station in stations])
    if len(walked) < 6:
        return _as_walked(walked, trace)
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
    knots = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
    # The residuals lie in the two directions across the edge: twice as many as there are points.
    misjudged = _misjudgement(knots, points, weights)
    smoothing = 2.0 * len(points) * misjudged
    simple = simplest_curve(points, np.sqrt(misjudged) / weights, closed)
    if isinstance(simple, Line):
        # A spline wiggles, at its ends most of all, where each section borrows from one side only.
        points, smoothing = points - simple.residuals(points), 0.0
    spline, _ = splprep(points.T, w=weights, u=knots, k=3, s=smoothing, per=closed)
    fine = np.linspace(knots[0], knots[-1], 8 * len(points))
    length = np.append(
        0.0, np.cumsum(np.linalg.norm(np.diff(np.array(splev(fine, spline)), axis=1), axis=0))
    )
    pitch = np.full(len(fine), edge_pitch)
    if chord_height is not None:
        bend = np.linalg.norm(_derivatives(spline, fine)[2], axis=1)
        pitch = np.sqrt(8.0 * chord_height / np.maximum(bend, 1e-12))
        pitch = np.clip(pitch, max(0.5 * edge_pitch, least_pitch), 3.0 * edge_pitch)
    # Sections stand where the number of pitches travelled is whole.
    pitches = cumulative_trapezoid(1.0 / pitch, length, initial=0.0)
    count = max(3, round(pitches[-1]) + 1)
    wanted = np.linspace(0.0, pitches[-1], count)[: -1 if closed else None]
    place = np.interp(wanted, pitches, fine)
    origin, tangent, bend = _derivatives(spline, place)
    spread = 2.0 if len(points) > 12 else 0.5
    mode = "wrap" if closed else "nearest"
    smooth = [gaussian_filter1d(x, spread, axis=0, mode=mode) for x in (sides, curvature)]
    sides, curvature = (make_interp_spline(knots, x, k=1)(place) for x in smooth)
    frames = frames_from_sides(origin, tangent, sides, bend, curvature)
    at = np.interp(place, fine, length)
    return EdgePath(frames, at, float(length[-1]), closed, trace.stops, _begins(trace))


def _as_walked(walked: Frames, trace: Trace) -> EdgePath:
    """The few sections of a short walk, as they are."""
    steps = np.linalg.norm(np.diff(walked.origin, axis=0), axis=1)
    at = np.append(0.0, np.cumsum(steps))
    return EdgePath(walked, at, float(at[-1]), trace.closed, trace.stops, _begins(trace))


def _begins(trace: Trace) -> np.ndarray:
    """Where most stations of a walk have seen that each side begins, (2,) mm."""
    begins = np.median([station.begins for station in trace.stations], axis=0)
    return np.nan_to_num(begins)


def _derivatives(spline: tuple, place: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Points, unit tangents and curvature vectors, (m, 3) each."""
    origin, first, second = (np.array(splev(place, spline, der=d)).T for d in range(3))
    speed = np.linalg.norm(first, axis=1, keepdims=True)
    tangent = first / speed
    bend = (second - np.einsum("mi,mi->m", second, tangent)[:, None] * tangent) / speed**2
    return origin, tangent, bend


def _misjudgement(place: np.ndarray, points: np.ndarray, weights: np.ndarray) -> float:
    """How much larger the scatter of points is than their sigmas say, squared.

    Each point is compared with the cubic through its two neighbours on each side, which a smooth
    edge follows closely however it bends.
    """
    if len(points) < 8:
        return 1.0
    steps = np.array([-2, -1, 1, 2])
    middle = np.arange(2, len(points) - 2)
    at = place[middle[:, None] + steps] - place[middle, None]
    share = np.ones(at.shape)
    for k in range(4):
        for other in range(4):
            if other != k:
                share[:, k] *= at[:, other] / (at[:, other] - at[:, k])
    off = points[middle] - np.einsum("mk,mki->mi", share, points[middle[:, None] + steps])
    chord = points[middle + 1] - points[middle - 1]
    chord /= np.maximum(np.linalg.norm(chord, axis=1, keepdims=True), 1e-12)
    off -= np.einsum("mi,mi->m", off, chord)[:, None] * chord
    variance = 1.0 / weights**2
    expected = variance[middle] + np.sum(share**2 * variance[middle[:, None] + steps], axis=1)
    # The median of chi-square with two degrees of freedom is 1.386.
    ratio = np.median(np.sum(off**2, axis=1) / expected) / 1.386
    return float(np.clip(ratio, 0.3, 30.0))
