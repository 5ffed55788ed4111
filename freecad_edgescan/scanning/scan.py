# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scan an edge: from a cloud and a click to edge points.

1. check what was given, and choose what was not;
2. find the first section near the click;
3. walk, both ways or to the gate;
4. measure the whole edge together.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..cloud.point_cloud import PointCloud, require_surface
from .automatic import MIN_ANGLE, Chosen, choose_parameters
from .errors import ScanError
from .gait import AdaptiveGait
from .parameters import ScanParameters
from .patch_edge import finish_edge
from .patch_section import PatchSection
from .progress import Progress
from .report import describe
from .scanned_edge import ScannedEdge
from .section import Station
from .seed import Seed, find_seed, nearest_seed
from .start import Gate, Start, numbers
from .stop import Stop
from .trace import LineGate, PointGate, Trace, trace_both_ways, trace_one_way, turned

Point = Sequence[float] | np.ndarray
_FEWEST_POINTS = 3  # edge points that make an edge
_FARTHEST_CLICK = 10.0  # pitches from the nearest cloud point
_CLOSE_CLICK = 4.0  # pitches from an edge within which a click means it
_LOOK_AROUND = 60.0  # pitches round a click without an edge, to name the nearest one


def scan_edge(
    cloud: PointCloud,
    at: Point | Start,
    gate: Point | Gate | None = None,
    parameters: ScanParameters | None = None,
    method: str = "patch",
    min_angle: float = MIN_ANGLE,
    progress: Progress | None = None,
) -> ScannedEdge:
    """Scan the edge near a click, or from a start to a gate.

    Parameters
    ----------
    cloud : the scanned points
    at : a point near the edge (mm): the edge is walked both ways until it ends; or a `Start`
    gate : where to stop: a `Gate`, or a point to walk to
    parameters : what is None in them is chosen from the cloud
    method : "patch" uses all the points on both sides
    min_angle : least turn between the two sides, rad
    progress : told about the edge points as they are found; may cancel

    Returns
    -------
    ScannedEdge, also when the walk could not go on: `stops` and `message` say why it ended.

    Raises
    ------
    ScanError: nothing to scan here, or parameters that cannot work; the text says what to do.
    ValueError: a cloud without a surface.
    """
    if not isinstance(cloud, PointCloud):
        raise ScanError(
            f"scan_edge needs a PointCloud and was given {type(cloud).__name__}; "
            "make one with read_cloud(path) or PointCloud(points)."
        )
    if method != "patch":
        raise ScanError(f"The method is {method!r}; the one there is is 'patch'.")
    if not 0.0 < min_angle < np.pi:
        raise ScanError(f"The least angle is {min_angle!r}; give one between 0 and pi, in rad.")
    require_surface(cloud)
    start = at if isinstance(at, Start) else None
    near = _near(cloud, at, parameters or ScanParameters())
    chosen = choose_parameters(cloud, near, parameters or ScanParameters(), min_angle)
    seed = _seed(cloud, near, start, chosen)
    first, chosen = seed.station, chosen.with_seed(seed)
    section = PatchSection(cloud, chosen.settings)
    arrived = _gate(gate, start, first, chosen)
    trace = _trace(section, first, start, arrived, progress)
    if len(trace.stations) >= _FEWEST_POINTS or Stop.CANCELLED in trace.stops:
        edge = finish_edge(cloud, trace, chosen, arrived)
        _check_known(edge, chosen)
        if len(edge) >= _FEWEST_POINTS or Stop.CANCELLED in trace.stops:
            return replace(edge, message=describe(edge, gate))
    raise ScanError(
        f"The edge found at ({_text(first.frame.origin[0])}) cannot be followed: the walk "
        f"{trace.stops[1].value} within two steps. Click farther from its ends, or give a "
        "larger amplitude."
    )


def _check_known(edge: ScannedEdge, chosen: Chosen) -> None:
    """An edge known worse than the cloud's pitch is none."""
    sigma = float(np.median(edge.sigma)) if len(edge) else 0.0
    pitch = chosen.settings.cloud_pitch
    if sigma > pitch:
        raise ScanError(
            f"What meets near ({_text(edge.points[len(edge) // 2])}) is known only to "
            f"{sigma:.3g} mm (one sigma), worse than the cloud's pitch of {pitch:.3g} mm: the "
            "sides are too narrow, too curved or too noisy. Click elsewhere, or scan denser."
        )


def _near(cloud: PointCloud, at: Point | Start, parameters: ScanParameters) -> np.ndarray:
    """The cloud point where to look for the edge."""
    if isinstance(at, Start):
        reach = 0.5 * (parameters.amplitude or 20.0 * cloud.pitch)
        wanted, farthest = at.point + reach * at.across, 2.0 * reach
    else:
        click = numbers(at)
        if click is None:
            raise ScanError(f"The click is {at!r}; give three finite coordinates in mm.")
        wanted = click
        farthest = _FARTHEST_CLICK * cloud.pitch
    distance, index = cloud.tree.query(wanted)
    if distance > farthest:
        low, high = cloud.bounds
        raise ScanError(
            f"The place ({_text(wanted)}) is {distance:.3g} mm away from the nearest point of the "
            f"cloud, which reaches from ({_text(low)}) to ({_text(high)}); choose a place on it."
        )
    return cloud.points[index] if isinstance(at, Start) else wanted


def _seed(cloud: PointCloud, near: np.ndarray, start: Start | None, chosen: Chosen) -> Seed:
    settings = chosen.for_seed
    along = None if start is None else start.along
    within = None if start is None else settings.reach
    seed = find_seed(cloud, near, settings, along, within)
    if seed is not None:
        return seed
    other = nearest_seed(cloud, near, settings, _LOOK_AROUND * settings.cloud_pitch)
    if other is not None and start is None:
        gap = float(np.linalg.norm(other.station.frame.origin[0] - near))
        if gap < _CLOSE_CLICK * settings.cloud_pitch:
            return other
    message = f"There is no edge within reach of ({_text(near)})"
    if other is None:
        raise ScanError(
            f"{message}: the surface is smooth for {_LOOK_AROUND * settings.cloud_pitch:.3g} mm "
            "round it. Click nearer to an edge."
        )
    place = other.station.frame.origin[0]
    raise ScanError(
        f"{message}: the surface is smooth there. The nearest edge found is "
        f"{np.linalg.norm(place - near):.3g} mm away, at ({_text(place)})."
    )


def _gate(
    gate: Point | Gate | None, start: Start | None, first: Station, chosen: Chosen
) -> LineGate | PointGate | None:
    """What tells the walk that it has arrived."""
    reach = chosen.settings.reach
    if gate is None:
        return None
    if isinstance(gate, Gate):
        _check_gate_ahead(start, gate.point, reach)
        approach = chosen.parameters.approach
        return LineGate(gate, 2.0 * reach, None if approach is None else np.asarray(approach))
    point = numbers(gate)
    if point is None:
        raise ScanError(f"The gate is {gate!r}; give a Gate or three finite coordinates in mm.")
    _check_gate_ahead(start, point, reach)
    away = float(np.linalg.norm(point - first.frame.origin[0]))
    if away < 2.0 * chosen.settings.edge_pitch:
        raise ScanError(
            f"The gate at ({_text(point)}) is {away:.3g} mm from where the walk begins; give one "
            f"at least {2.0 * chosen.settings.edge_pitch:.3g} mm away, or none."
        )
    return PointGate(point, reach)


def _trace(
    section: PatchSection,
    first: Station,
    start: Start | None,
    arrived: LineGate | PointGate | None,
    progress: Progress | None,
) -> Trace:
    settings = section.settings
    gait = AdaptiveGait(settings.edge_pitch, settings.half_width, settings.longest_step)
    if arrived is None and start is None:
        return trace_both_ways(section, first, gait, progress)
    if start is None and arrived is not None:
        target = arrived.point if isinstance(arrived, PointGate) else arrived.gate.point
        if (target - first.frame.origin[0]) @ first.frame.tangent[0] < 0:
            first = turned(first)
    return trace_one_way(section, first, gait, arrived, progress)


def _check_gate_ahead(start: Start | None, point: np.ndarray, reach: float) -> None:
    """A gate just behind the start can never be passed; one farther off may lie round a bend."""
    if start is None:
        return
    way = point - start.point
    if way @ start.along < 0 and np.linalg.norm(way) < 4.0 * reach:
        raise ScanError(
            f"The gate at ({_text(point)}) lies {-float(way @ start.along):.3g} mm behind the "
            "start, against the direction of the walk; turn the start's direction along the edge "
            "round, or move the gate."
        )


def _text(point: np.ndarray) -> str:
    return ", ".join(f"{value:.4g}" for value in point)
