# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a probed walk to the finished edge: the probe radius taken off in a second pass."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.spatial import cKDTree

from .air import convex_by_approach
from .corner import turned_covariance
from .edge_gate import EdgeGate, until
from .parameters import Compensation, ScanParameters
from .probe_compensation import (
    compensated_curves,
    cut_of_ruled_surfaces,
    from_compensated_points,
)
from .probe_settings import ProbeSettings
from .probed_corners import carried_lines, corners_of_lines
from .probed_line import ProbedLine
from .probed_lines import ProbedLines
from .probed_path import smooth_frames
from .scanned_edge import ScannedEdge
from .section import frames_from_sides
from .trace import Trace

__all__ = ["finish_probed_edge"]


def finish_probed_edge(
    trace: Trace,
    settings: ProbeSettings,
    parameters: ScanParameters,
    reasons: Mapping[str, str],
    arrived: EdgeGate | None = None,
    air_known: bool = True,
    selection: float = 0.0,
) -> ScannedEdge:
    """Compensate the lines of a walk for the probe radius, and state what is known.

    Parameters
    ----------
    trace : the walk, of at least two stations
    settings, parameters, reasons : of the scan
    arrived : the gate it was to pass
    air_known : whether the approach tells on which side the air is
    selection : how far too early contacts lie, in standard deviations (`PointCloudCmm.selection`)
    """
    stations = [station for station in trace.stations if station.line is not None]
    walked = [station.line for station in stations if station.line is not None]
    tangents = np.array([station.frame.tangent[0] for station in stations])
    sides = np.array([line.rough_sides for line in walked])
    edge_points = np.array([line.edge_point for line in walked])
    frames = smooth_frames(edge_points, tangents, sides, 0.25 * settings.amplitude)
    convex = convex_by_approach(frames.normals, settings.approach)
    distance = settings.probe_radius if convex else -settings.probe_radius
    lines = carried_lines(walked, frames, settings) if settings.safeguards.slide else walked
    corners = corners_of_lines(lines, frames, distance, selection)
    if settings.compensation is Compensation.INTERSECTION:
        corners = corners.with_neighbours(frames)
        points, how = corners.points(frames), _alone_at_the_ends("intersection", len(walked))
    else:
        points, how = _one_by_one(walked, settings.compensation, distance)
    known = np.flatnonzero(corners.found & np.isfinite(points).all(axis=1))
    if arrived is not None:
        known = known[until(arrived, points[known])]
    points, lines, how = points[known], [lines[j] for j in known], how[known]
    walked_frames = frames[known]
    standing = frames_from_sides(points, walked_frames.tangent, corners.sides[known])
    normals = standing.normals if convex or not air_known else -standing.normals
    unknown = np.full(len(points), np.nan)
    contacts = cKDTree(np.vstack([line.contacts for line in walked]))
    return ScannedEdge(
        points=points,
        tangents=standing.tangent,
        normals=normals,
        angle=np.pi - standing.turn,
        convex=convex if air_known else None,
        covariance=turned_covariance(corners.covariance[known], walked_frames.normals, normals),
        fillet_radius=unknown,
        fillet_sigma=unknown,
        supported=np.ones(len(points), dtype=bool),
        compensation=how if settings.probe_radius else np.full(len(points), "none"),
        closed=trace.closed,
        stops=trace.stops,
        message="",
        scan_lines=ProbedLines(tuple(lines), walked_frames, points),
        overhang=contacts.query(np.array([line.edge_point for line in lines]))[0],
        parameters=parameters,
        reasons=reasons,
        method="probe",
    )


def _one_by_one(
    lines: list[ProbedLine], compensation: Compensation, distance: float
) -> tuple[np.ndarray, np.ndarray]:
    """Edge points (m, 3), and how each was compensated, in one of the printed ways."""
    how = _alone_at_the_ends(str(compensation), len(lines))
    points = np.full((len(lines), 3), np.nan)
    for j, line in enumerate(lines):
        if how[j] == Compensation.CURVE:
            point = compensated_curves(line, distance)
        elif compensation is Compensation.POINT:
            point = from_compensated_points(lines[j - 1], line, lines[j + 1], distance)
        else:
            point = cut_of_ruled_surfaces(lines, j, distance)
        if point is not None:
            points[j] = point
    return points, how


def _alone_at_the_ends(how: str, count: int) -> np.ndarray:
    """The name of a compensation with both neighbours; lines with one are offset as curves."""
    names = np.full(count, how, dtype="<U24")
    names[[0, -1]] = str(Compensation.CURVE)
    return names
