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
from .automatic import choose_parameters
from .edge_checks import check_edge
from .edge_gate import LineGate, PointGate, heading_for, make_gate
from .errors import ScanError
from .first_section import first_section, place_to_look
from .gait import AdaptiveGait
from .parameters import ScanParameters
from .patch_edge import finish_edge
from .patch_section import PatchSection
from .progress import Progress
from .report import describe
from .scanned_edge import ScannedEdge
from .section import Station
from .start import Gate, Start
from .stop import Stop
from .trace import Trace, trace_both_ways, trace_one_way

__all__ = ["FEWEST_POINTS", "scan_with_patches"]

Point = Sequence[float] | np.ndarray
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
            clicked = None if start else np.asarray(at, dtype=np.float64)
            return replace(edge, message=describe(edge, gate, clicked))
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
