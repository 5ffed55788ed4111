# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two ends of an edge: walked on to its vertices, and the vertices measured.

A walk stops short of a corner, where its slab takes in the next surface, or goes past it. Where a
third surface is found, the sections of the finished edge are laid up to the vertex.

A cloud of probe centres has no vertices here: its surfaces meet elsewhere than those of the part,
and on which side of a third surface the air is nobody has said.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..cloud.point_cloud import PointCloud
from .corner import across_axes
from .edge_points import Measured
from .gait import predict
from .patch_section import PatchSettings
from .section import Frames, Station, frames_from_sides
from .stop import Stop
from .trace import Trace, turned
from .vertex import EdgeEnd, FoundVertex, find_vertex

__all__ = [
    "Vertices",
    "corners_at",
    "led_to_vertex",
    "vertices_of",
    "walked_to_vertices",
    "without_doubtful_end",
]

Vertices = tuple[FoundVertex | None, FoundVertex | None]

# Ends of a walk at which another surface may turn out to begin.
_MAY_BE_CORNERS = (Stop.CORNER, Stop.CLOUD_END)
_DRAWN_OUT = 16.0  # pitches of edge that are drawn out to a vertex
_FEWEST, _MOST = 4, 40  # edge points for that
_STRAIGHT_ON = np.cos(0.4)  # of a turn between two stations that a corner may be to blame for
_FULL_STEP = 0.5  # of the longest step of a walk
_DOUBTFUL = 2.5  # times the median sigma of a walk
_SHORT, _NEAR = 0.5, 0.75  # pitches before a vertex, between which a walk ends


def walked_to_vertices(cloud: PointCloud, trace: Trace, settings: PatchSettings) -> Trace:
    """The same walk, led on to half a pitch before its vertices, or cut there."""
    stations = trace.stations
    for k, stop in enumerate(trace.stops):
        if _may_have_a_vertex(stop, settings) and len(stations) >= _FEWEST:
            outward = stations if k else [turned(station) for station in reversed(stations)]
            outward = led_to_vertex(cloud, _steadied(outward), settings) or outward
            stations = outward if k else [turned(station) for station in reversed(outward)]
    return replace(trace, stations=stations)


def _may_have_a_vertex(stop: Stop, settings: PatchSettings) -> bool:
    return stop in _MAY_BE_CORNERS and not settings.probe_radius


def led_to_vertex(
    cloud: PointCloud, walked: list[Station], settings: PatchSettings, beyond: float = 0.0
) -> list[Station] | None:
    """Stations up to half a pitch before the vertex ahead of them; None where there is none.

    Parameters
    ----------
    walked : four stations at least, outward
    beyond : how much farther than where a walk ends the vertex may lie, mm
    """
    pitch = settings.cloud_pitch
    stations = without_doubtful_end(walked)
    last = stations[-1]
    steps = max(last.step, settings.edge_pitch) if np.isfinite(last.step) else settings.edge_pitch
    few = stations[-int(np.clip(round(_DRAWN_OUT * pitch / steps), _FEWEST, _MOST)) :]
    end = EdgeEnd(
        points=np.array([station.frame.origin[0] for station in few]),
        covariance=np.array([station.sigma**2 * np.eye(3) for station in few]),
        frame=_agreed(few[-_FEWEST:]),
        clear=np.median([station.begins for station in few], axis=0),
        overlap=1.0,
        noise=settings.noise,
    )
    beyond += _gap(walked[-1], last)
    vertex = find_vertex(cloud, end, settings.min_angle, beyond)
    if vertex is None:
        return None
    ahead = [
        float((vertex.point - station.frame.origin[0]) @ station.frame.tangent[0])
        for station in stations
    ]
    kept = len(stations)
    while kept > _FEWEST and ahead[kept - 1] < _SHORT * pitch:
        kept -= 1
    stations, last = stations[:kept], stations[kept - 1]
    # Where this edge is rounded, so may be those that it meets, and leave nothing of a side. Sharp
    # ones' sides seem to begin a fraction of a pitch away, too.
    rounded = float(end.clear.max())
    left = ahead[kept - 1] - (rounded if rounded > pitch else 0.0)
    if left <= _NEAR * pitch:
        return stations
    step = left - _SHORT * pitch
    # It has not been measured: its neighbours know better where the edge runs.
    onward = replace(last, frame=predict(last.frame, step), sigma=3.0 * last.sigma, step=step)
    return [*stations, onward]


def without_doubtful_end(stations: list[Station]) -> list[Station]:
    """Without last stations that a corner disturbs: badly known, or turned round it."""
    known = _DOUBTFUL * float(np.median([station.sigma for station in stations]))

    def doubtful(last: Station, before: Station) -> bool:
        onward = float(last.frame.tangent[0] @ before.frame.tangent[0])
        return last.sigma > known or onward < _STRAIGHT_ON

    kept = len(stations)
    while kept > _FEWEST and doubtful(stations[kept - 1], stations[kept - 2]):
        kept -= 1
    return stations[:kept]


def _steadied(stations: list[Station]) -> list[Station]:
    """The same stations; those of short steps at their end bend as the last one before them.

    What noise and a corner turn an edge by in a short step looks like a tight bend.
    """
    steps = np.array([station.step for station in stations])
    # Stations without a step were not walked to.
    full = ~(steps < _FULL_STEP * np.nanmax(steps, initial=0.0))
    known = int(np.flatnonzero(full)[-1])
    bend = stations[known].frame.bend
    ended = [replace(each, frame=replace(each.frame, bend=bend)) for each in stations[known + 1 :]]
    return [*stations[: known + 1], *ended]


def _rounded(begins: np.ndarray) -> np.ndarray:
    """How far a rounding reaches on both sides, (2,) mm; sides of some sections begin at (k, 2).

    A rounding takes as much of both; one side of a sharp edge may begin far off by chance.
    """
    return np.full(2, np.median(begins, axis=0).min())


def _gap(one: Station, other: Station) -> float:
    return float(np.linalg.norm(one.frame.origin - other.frame.origin))


def _agreed(stations: list[Station]) -> Frames:
    """The section at the last of a few stations, with tangent and sides as they all see them."""
    frames, last = Frames.join([station.frame for station in stations]), stations[-1].frame
    chord = frames.origin[-1] - frames.origin[0]
    # The chord's direction is that of the edge in its middle.
    ahead = chord / np.linalg.norm(chord) + 0.5 * np.linalg.norm(chord) * last.bend[0]
    return frames_from_sides(
        last.origin,
        ahead[None],
        frames.sides.mean(axis=0)[None],
        last.bend,
        np.median(frames.curvature, axis=0)[None],
    )


def vertices_of(
    cloud: PointCloud, measured: Measured, stops: tuple[Stop, Stop], settings: PatchSettings
) -> Vertices:
    """The vertices in which a measured edge begins and ends."""
    start, end = (
        find_vertex(cloud, _end_of(measured, k, settings), settings.min_angle)
        if _may_have_a_vertex(stop, settings) and len(measured.at) >= _FEWEST
        else None
        for k, stop in enumerate(stops)
    )
    return start, end


def corners_at(vertices: Vertices, stops: tuple[Stop, Stop]) -> tuple[Stop, Stop]:
    """Why an edge ends: where a vertex was found, it is a corner."""
    start, end = (
        stop if vertex is None else Stop.CORNER
        for vertex, stop in zip(vertices, stops, strict=True)
    )
    return start, end


def _end_of(measured: Measured, k: int, settings: PatchSettings) -> EdgeEnd:
    """The last sections at the start (k = 0) or the end of an edge, towards it."""
    seen, spacing = measured.corners(), float(np.diff(measured.at).mean())
    count = int(np.clip(round(_DRAWN_OUT * settings.cloud_pitch / spacing), _FEWEST, _MOST))
    order = np.arange(len(measured.at))[-count:] if k else np.arange(len(measured.at))[:count][::-1]
    # The very last section has points of other surfaces on one side of it.
    order = order[:-1] if len(order) > _FEWEST else order
    axes = across_axes(measured.frames.normals[order])
    covariance = np.einsum("mai,mab,mbj->mij", axes, seen.covariance[order], axes)
    return EdgeEnd(
        points=seen.point[order],
        covariance=covariance,
        frame=_standing(measured, order, seen.point[order[-1]], seen.sides[order[-1]], k),
        clear=_rounded(measured.fits.begins[order]),
        overlap=max(1.0, 2.0 * settings.half_width / spacing),
        noise=float(np.median(measured.noise[order])),
    )


def _standing(
    measured: Measured, order: np.ndarray, point: np.ndarray, sides: np.ndarray, k: int
) -> Frames:
    """The section at the last of some edge points, out of the edge."""
    frame = frames_from_sides(
        point[None],
        measured.frames.tangent[order[-1:]],
        sides[None],
        np.median(measured.frames.bend[order], axis=0)[None],
        np.median(measured.fits.coefficients[order, :, 2], axis=0)[None] / measured.fits.reach,
    )
    return frame if k else frame.backward()
