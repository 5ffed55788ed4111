# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scan an edge with all the points on both sides.

1. find the first section near the click;
2. walk, both ways or to the gate;
3. measure the whole edge together.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..cloud.point_cloud import PointCloud
from ..geometry.place_text import place_text
from .automatic import Chosen, choose_parameters
from .corner import corners
from .edge_gate import LineGate, PointGate, heading_for, make_gate
from .errors import ScanError
from .fillet import gap_under_rounding
from .first_section import first_section, place_to_look
from .gait import AdaptiveGait
from .parameters import ScanParameters
from .patch_edge import finish_edge
from .patch_section import PatchSection
from .progress import Progress
from .report import describe
from .scan_lines import ScanLines
from .scanned_edge import ScannedEdge
from .section import Station
from .start import Gate, Start
from .stop import Stop
from .trace import Trace, trace_both_ways, trace_one_way

__all__ = ["FEWEST_POINTS", "check_edge", "scan_with_patches"]

Point = Sequence[float] | np.ndarray
_BESIDE = 1.2  # pitches: what an edge may be off its points besides where its sides begin
_CURLED, _BESIDE_CURLED = 0.5, 0.8  # rad by which both sides curl, and what it may be off then
FEWEST_POINTS = 3  # edge points that make an edge


def scan_with_patches(
    cloud: PointCloud,
    at: Point | Start,
    gate: Point | Gate | None,
    parameters: ScanParameters,
    min_angle: float,
    progress: Progress | None,
) -> ScannedEdge:
    """Scan with the patch method; see `scan_edge`."""
    start = at if isinstance(at, Start) else None
    near = place_to_look(cloud, at, parameters)
    chosen = choose_parameters(cloud, near, parameters, min_angle)
    seed = first_section(cloud, near, start, chosen)
    first, chosen = seed.station, chosen.with_seed(seed)
    settings, approach = chosen.settings, chosen.parameters.approach
    arrived = make_gate(
        gate,
        start,
        first,
        settings.reach,
        settings.edge_pitch,
        None if approach is None else np.asarray(approach),
    )
    trace = _trace(PatchSection(cloud, settings), first, start, arrived, progress)
    if len(trace.stations) >= FEWEST_POINTS or Stop.CANCELLED in trace.stops:
        edge = finish_edge(cloud, trace, chosen, arrived)
        check_edge(edge, cloud, chosen)
        if len(edge) >= FEWEST_POINTS or Stop.CANCELLED in trace.stops:
            return replace(edge, message=describe(edge, gate))
    raise ScanError(
        f"The edge found at ({place_text(first.frame.origin[0])}) cannot be followed: the walk "
        f"{trace.stops[1].value} within two steps. Click farther from its ends, or give a "
        "larger amplitude."
    )


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
    if arrived is not None and start is None:
        first = heading_for(first, arrived)
    return trace_one_way(section, first, gait, arrived, progress)


def check_edge(edge: ScannedEdge, cloud: PointCloud, chosen: Chosen) -> None:
    """Refuse what is no edge.

    Raises
    ------
    ScanError: it is known too badly, or its sides come together far outside the points.
    """
    _check_known(edge, chosen)
    _check_beside_points(edge, cloud)


def _check_known(edge: ScannedEdge, chosen: Chosen) -> None:
    """An edge known worse than the cloud's pitch is none."""
    sigma = float(np.median(edge.sigma)) if len(edge) else 0.0
    pitch = chosen.settings.cloud_pitch
    if sigma > pitch:
        raise ScanError(
            f"What meets near ({place_text(edge.points[len(edge) // 2])}) is known only to "
            f"{sigma:.3g} mm (one sigma), worse than the cloud's pitch of {pitch:.3g} mm: the "
            "sides are too narrow, too curved or too noisy. Click elsewhere, or scan denser."
        )


def _check_beside_points(edge: ScannedEdge, cloud: PointCloud) -> None:
    """An edge farther from its points than its sides begin is that of two sides bent together.

    However a rounding, a chamfer or wear has taken an edge away, the sides' own first points are
    where they begin.
    """
    if not len(edge) or not isinstance(edge.scan_lines, ScanLines):
        return
    lines, away = edge.scan_lines, float(np.median(edge.overhang))
    fits = lines.fits
    begins = float(np.median(fits.begins.min(axis=1)))
    middle = edge.points[len(edge) // 2]
    beside = cloud.points[cloud.tree.query(middle)[1]]
    pitch = float(cloud.local_pitch(beside[None])[0, 0])
    # Sides that curl towards each other have no edge but under a rounding that touches both. The
    # faces of a plate meet in no other way: sides that curl apart were nearer each other before.
    half = float(np.median(corners(lines.frames, fits).half_angle))
    rounded = float(gap_under_rounding(np.median(fits.begins.max(axis=1)), half))
    curl = -fits.coefficients[..., 2] * (fits.ends - fits.begins) / fits.reach
    curled = float(np.median(curl.sum(axis=1))) > _CURLED
    if away > begins + _BESIDE * pitch or (curled and away > rounded + _BESIDE_CURLED * pitch):
        raise ScanError(
            f"The sides near ({place_text(middle)}) come together {away:.3g} mm outside the "
            f"points, although they begin {begins:.2g} mm from there: they are the two faces of "
            "something too thin for this pitch, and have no edge there. An edge needs sides of "
            "four pitches; click on a wider one, or scan denser."
        )
