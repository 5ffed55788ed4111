# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scan an edge with a probe, virtual or real.

1. fill in what was not given;
2. scan the first line, from the start that was given or from an edge found near the click;
3. walk, both ways or to the gate;
4. take the probe radius off all edge points together.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..cloud.point_cloud import PointCloud
from ..geometry.place_text import place_text
from .cmm import Cmm
from .edge_gate import heading_for, make_gate
from .errors import ScanError
from .parameters import ScanParameters
from .point_cloud_cmm import PointCloudCmm
from .probe_gait import ProbeGait
from .probe_section import ProbeSection
from .probe_settings import ProbeSettings
from .probed_edge import finish_probed_edge
from .progress import Progress
from .report import describe
from .scan_plan import ScanPlan, plan_for_cloud, plan_for_cmm
from .scanned_edge import ScannedEdge
from .section import Station
from .start import Gate, Start
from .stop import Stop
from .tolerance import TOLERANCE_REASON, learned_tolerance
from .trace import Trace, trace_both_ways, trace_one_way

__all__ = ["scan_with_cmm", "scan_with_probe"]

Point = Sequence[float] | np.ndarray
_FEWEST_POINTS = 3  # edge points that make an edge
_ENDED_FROM_OUTSIDE = {Stop.CANCELLED, Stop.CMM_FAILED}  # it is no fault of the edge


def scan_with_cmm(
    cmm: Cmm,
    at: Point | Start,
    gate: Point | Gate | None,
    parameters: ScanParameters,
    min_angle: float,
    progress: Progress | None,
) -> ScannedEdge:
    """Scan with a machine; see `scan_edge`."""
    if not isinstance(at, Start):
        raise ScanError(
            f"A measuring machine cannot look for an edge near {at!r}; give at=Start(point, "
            "across, along) or Start.from_points(p1, p2, p3)."
        )
    if parameters.cloud_pitch is not None:
        raise ScanError(
            f"A cloud pitch of {parameters.cloud_pitch:g} mm was given with a measuring machine, "
            "which has no cloud; leave it out."
        )
    return _scan(cmm, plan_for_cmm(cmm, at, parameters), at, gate, min_angle, progress)


def scan_with_probe(
    cloud: PointCloud,
    at: Point | Start,
    gate: Point | Gate | None,
    parameters: ScanParameters,
    min_angle: float,
    progress: Progress | None,
) -> ScannedEdge:
    """Scan a cloud with a virtual machine; see `scan_edge`."""
    plan = plan_for_cloud(cloud, at, parameters, min_angle)
    cmm = PointCloudCmm(cloud, "closest", plan.parameters.cloud_pitch)
    return _scan(cmm, plan, at, gate, min_angle, progress)


def _scan(
    cmm: Cmm,
    plan: ScanPlan,
    at: Point | Start,
    gate: Point | Gate | None,
    min_angle: float,
    progress: Progress | None,
) -> ScannedEdge:
    section, first = _begin(cmm, plan, min_angle)
    if plan.tolerance_to_learn and first.line is not None:
        tolerance = learned_tolerance(first.line, section.settings)
        plan = plan.with_tolerance(tolerance, TOLERANCE_REASON)
        section, first = _begin(cmm, plan, min_angle)
    settings = section.settings
    begins = at if isinstance(at, Start) else None
    reach = 0.5 * settings.amplitude
    arrived = make_gate(gate, begins, first, reach, settings.edge_pitch, settings.approach)
    gait = ProbeGait(settings)
    trace: Trace
    if begins is None and arrived is None:
        trace = trace_both_ways(section, first, gait, progress)
    else:
        if begins is None:
            first = heading_for(first, arrived)
        trace = trace_one_way(section, first, gait, arrived, progress)
    if len(trace.stations) < _FEWEST_POINTS and not _ENDED_FROM_OUTSIDE & set(trace.stops):
        raise ScanError(
            f"The edge found at ({place_text(first.frame.origin[0])}) cannot be followed: the walk "
            f"{trace.stops[1].value} within two lines{_because(section.failure)}. Start farther "
            "from its ends, or change the amplitude or the edge pitch."
        ) from section.failure
    edge = finish_probed_edge(
        trace,
        settings,
        plan.parameters,
        plan.reasons,
        arrived,
        plan.air_known,
        cmm.selection if isinstance(cmm, PointCloudCmm) else 0.0,
    )
    words = [describe(edge, gate), _because(section.failure, "The machine said: {}.")]
    return replace(edge, message=" ".join(filter(None, [*words, *plan.warnings])))


def _begin(cmm: Cmm, plan: ScanPlan, min_angle: float) -> tuple[ProbeSection, Station]:
    """Scan the first line.

    Raises
    ------
    ScanError: it shows no edge.
    """
    settings, start = ProbeSettings.from_parameters(plan.parameters, min_angle), plan.start
    section = ProbeSection(cmm, settings)
    first = section.begin(start)
    if first.stop is not None:
        raise ScanError(
            f"The first line, from ({place_text(start.point)}) across "
            f"({place_text(start.across)}), "
            f"{first.stop.value}{_because(section.failure)}. Check the start, the approach, the "
            f"amplitude of {settings.amplitude:g} mm, the prehit distance of "
            f"{settings.prehit_distance:g} mm and the search distance of "
            f"{settings.search_distance:g} mm."
        ) from section.failure
    return section, first


def _because(failure: Exception | None, words: str = " ({})") -> str:
    """What the machine said when it failed."""
    return words.format(str(failure) or type(failure).__name__) if failure else ""
