# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a walk to the finished edge of the patch method."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..cloud.point_cloud import PointCloud
from ..geometry import Line, simplest_curve
from .air import convex_by_approach, convex_by_rounding
from .automatic import Chosen
from .corner import largest_sigma, turned_covariance
from .edge_ends import Vertices, corners_at, vertices_of, walked_to_vertices
from .edge_gate import EdgeGate, until
from .edge_path import path_along
from .edge_points import Measured, measure_together
from .end_course import on_course
from .laid_again import laid_again, wavers
from .rounded_fits import RoundedFits
from .scan_lines import ScanLines
from .scanned_edge import ScannedEdge, Vertex
from .section import SectionPoints, frames_from_sides
from .smoothing import smoothed
from .stop import GIVEN_ENDS, Stop
from .trace import Trace
from .vertex import FoundVertex
from .whole_edge import reserve

# Times the usual, where an end of an edge is not believed.
_MOST_SCATTER = 4.5
_MOST_LEVERAGE, _WILD_LEVERAGE = 4.0, 10.0
_LAID_AGAIN = 2  # times, that sections are laid along a rounded edge once it is measured
_NO_NOISE = 1e-3  # pitches


def finish_edge(
    cloud: PointCloud, trace: Trace, chosen: Chosen, arrived: EdgeGate | None = None
) -> ScannedEdge:
    """Measure the walked edge as a whole, take the probe radius off, and state what is known.

    Parameters
    ----------
    trace : the walk
    arrived : the gate it was to pass, which is found again on the finished edge points

    Raises
    ------
    ScanError: the cloud holds probe centres and nothing tells on which side the air is; a rounding
        leaves next to nothing of a side.
    """
    settings = chosen.settings
    met = float(np.median([station.noise for station in trace.stations]))
    noise = max(met, 0.5 * settings.noise)
    pitches = settings.edge_pitch, 1.5 * settings.cloud_pitch, chosen.parameters.chord_height
    path = path_along(walked_to_vertices(cloud, trace, settings), *pitches)
    measured = measure_together(cloud, path, settings, noise)
    for _ in range(_LAID_AGAIN):
        if not isinstance(measured.fits, RoundedFits) or not wavers(measured):
            break
        path = laid_again(measured, path, *pitches)
        radius = float(np.median(measured.fits.radius)) * settings.reach
        again = measure_together(cloud, path, settings, noise, radius)
        measured = again
    if not trace.closed:
        measured = _without_unsupported_ends(measured, trace.stops, settings.cloud_pitch)
        if isinstance(measured.fits, RoundedFits):
            measured = select_sections(measured, on_course(measured, trace.stops))
    if arrived is not None and trace.stops[1] is Stop.GATE:
        measured = select_sections(measured, until(arrived, measured.corners().point))
    vertices = vertices_of(cloud, measured, trace.stops, settings)
    measured = _cut_at(vertices, measured)
    frames = measured.frames
    seen = measured.corners()
    probe = chosen.parameters.probe_radius or 0.0
    roughly = measured.rounding(settings.cloud_pitch, trace.closed)
    rounding = measured.rounding(settings.cloud_pitch, trace.closed, circular=True)
    convex = _convex(chosen, seen.normals, *roughly)
    edge = measured.corners(-probe if convex else probe) if probe else seen
    fillet, sigma = _fillet(*rounding, probe, convex)
    # The path knows the edge's direction from all its points, a section only from its own.
    straight = simplest_curve(edge.point, largest_sigma(edge.covariance), trace.closed)
    smooth = smoothed(
        measured,
        edge,
        settings.cloud_pitch,
        trace.closed,
        isinstance(straight, Line),
        (trace.stops[0] not in GIVEN_ENDS, trace.stops[1] not in GIVEN_ENDS),
    )
    standing = frames_from_sides(smooth.point, frames.tangent, edge.sides)
    larger = reserve(smooth.independent)
    normals = -standing.normals if convex is False else standing.normals
    return ScannedEdge(
        points=smooth.point,
        tangents=standing.tangent,
        normals=normals,
        angle=np.pi - standing.turn,
        convex=convex,
        covariance=turned_covariance(larger**2 * smooth.covariance, frames.normals, normals),
        fillet_radius=fillet,
        fillet_sigma=sigma,
        supported=measured.supplied & edge.found,
        compensation=np.full(len(frames), "offset" if probe else "none"),
        closed=trace.closed,
        stops=corners_at(vertices, trace.stops),
        message="",
        scan_lines=ScanLines(
            frames, measured.points, measured.removed, measured.fits, seen.point, smooth.point
        ),
        single=(edge.point, turned_covariance(edge.covariance, frames.normals, normals)),
        reserve=larger,
        overhang=cloud.tree.query(seen.point)[0],
        vertices=(_stated(vertices[0]), _stated(vertices[1])),
        third_normals=(
            None if vertices[0] is None else vertices[0].normal,
            None if vertices[1] is None else vertices[1].normal,
        ),
        parameters=chosen.parameters,
        reasons=chosen.reasons,
    )


def _cut_at(vertices: Vertices, measured: Measured) -> Measured:
    """Leave out edge points beyond a vertex, as long as some are left."""
    point, tangent = measured.corners().point, measured.frames.tangent
    keep = np.ones(len(point), dtype=bool)
    for vertex, way in zip(vertices, (-1.0, 1.0), strict=True):
        if vertex is not None:
            beyond = way * np.einsum("mi,mi->m", point - vertex.point, tangent) > 0.0
            near = np.linalg.norm(point - vertex.point, axis=1) < measured.fits.reach
            keep &= ~(beyond & near)
    kept = np.flatnonzero(keep)
    if len(kept) < 3:
        return measured
    return select_sections(measured, slice(kept[0], kept[-1] + 1))


def _stated(vertex: FoundVertex | None) -> Vertex | None:
    return None if vertex is None else (vertex.point, vertex.covariance)


def _convex(
    chosen: Chosen, normals: np.ndarray, rounding: np.ndarray, sigma: np.ndarray
) -> bool | None:
    approach, probe = chosen.parameters.approach, chosen.parameters.probe_radius
    if approach is not None:
        return convex_by_approach(normals, np.asarray(approach))
    if probe:
        return convex_by_rounding(probe, rounding, sigma)
    return None


def _fillet(
    rounding: np.ndarray, sigma: np.ndarray, probe: float, convex: bool | None
) -> tuple[np.ndarray, np.ndarray]:
    """Radius on the part from the rounding of the cloud (Schreve 5.2.1: R_f + R_p outside)."""
    if not probe:
        return rounding, sigma
    radius = rounding - probe if convex else rounding + probe
    measurable = radius > 3.0 * sigma
    return np.where(measurable, radius, np.nan), np.where(measurable, sigma, np.nan)


def _without_unsupported_ends(
    measured: Measured, stops: tuple[Stop, Stop], cloud_pitch: float
) -> Measured:
    """Leave out sections at the ends that stand beyond their points, or on unlikely ones.

    A walk may overshoot: where a side has ended, points of other surfaces keep it going for a
    while, and scatter. A start that was given and a gate are no such ends; only their very last
    sections, which have neighbours on one side alone, are looked at, and wild ones.
    """
    first, last = measured.extent
    reached = (measured.at > first - 0.3 * cloud_pitch) & (measured.at < last + 0.3 * cloud_pitch)
    reached &= np.all(measured.fits.count >= 6, axis=1)
    # Without noise the scatter is that of rounding errors, and says nothing.
    scatter = measured.noise + _NO_NOISE * cloud_pitch
    scatter = scatter / np.median(scatter, axis=0)
    with np.errstate(invalid="ignore"):  # nan, which is sound nowhere, of next to no points
        leverage = np.sqrt(measured.fits.inverse[..., 0, 0])
    leverage /= np.median(leverage, axis=0)
    sound = reached & measured.supplied
    sound &= np.all((scatter < _MOST_SCATTER) & (leverage < _MOST_LEVERAGE), axis=1)
    wild = np.any(leverage > _WILD_LEVERAGE, axis=1)
    given = reached & (sound | (_inside(len(sound)) & ~wild))
    good = [np.flatnonzero(given if stop in (Stop.START, Stop.GATE) else sound) for stop in stops]
    if not len(good[0]) or not len(good[1]) or good[0][0] > good[1][-1]:
        return measured
    return select_sections(measured, slice(good[0][0], good[1][-1] + 1))


def _inside(sections: int) -> np.ndarray:
    """All sections but the last two at each end, (m,) bool."""
    inside = np.ones(sections, dtype=bool)
    inside[:2] = inside[-2:] = False
    return inside


def select_sections(measured: Measured, part: slice) -> Measured:
    """The same measurement of consecutive sections only."""
    mine = (measured.points.owner >= part.start) & (measured.points.owner < part.stop)
    points = measured.points[mine]
    points = SectionPoints(
        points.index,
        points.owner - part.start,
        points.along,
        points.side,
        points.away,
        points.height,
    )
    return replace(
        measured,
        frames=measured.frames[part],
        points=points,
        removed=measured.removed[mine],
        fits=measured.fits[part],
        noise=measured.noise[part],
        half_length=measured.half_length[part],
        supplied=measured.supplied[part],
        at=measured.at[part],
    )
