# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a probed scan is made with: every value filled in, before the first touch."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..cloud.point_cloud import PointCloud
from .cmm import Cmm
from .edge_site import EdgeSite
from .errors import ScanError
from .filled_in import GIVEN, SEARCH_DISTANCE, WAYS, filled_in, with_distances, with_probe_of
from .guidelines import Guidelines, check_possible
from .parameters import Pattern, ScanParameters
from .point_cloud_cmm import PointCloudCmm
from .recommended import ProbeChoice, measure_and_choose
from .start import Start, numbers

__all__ = ["ScanPlan", "plan_for_cloud", "plan_for_cmm"]

Point = Sequence[float] | np.ndarray

_MEASURED = ("amplitude", "line_pitch", "edge_pitch", "tolerance", "degree", "cloud_pitch")


@dataclass(frozen=True)
class ScanPlan:
    """A probed scan that can begin.

    Attributes
    ----------
    parameters : with every value filled in
    reasons : of each value, by name
    start : where the first line starts
    warnings : sentences about given values that break a guideline, and about guidelines that
        contradict each other
    air_known : whether it is known on which side of the part the air is
    tolerance_to_learn : whether the first line is to tell the tolerance
    """

    parameters: ScanParameters
    reasons: Mapping[str, str]
    start: Start
    warnings: tuple[str, ...] = ()
    air_known: bool = True
    tolerance_to_learn: bool = False

    def with_tolerance(self, tolerance: float, reason: str) -> ScanPlan:
        """The same plan with another tolerance, mm."""
        return replace(
            self,
            parameters=replace(self.parameters, tolerance=tolerance),
            reasons={**self.reasons, "tolerance": reason},
            tolerance_to_learn=False,
        )


def plan_for_cloud(
    cloud: PointCloud, at: Point | Start, given: ScanParameters, min_angle: float
) -> ScanPlan:
    """Plan a probed scan of a cloud.

    Nothing of the cloud is measured when nothing has to be.

    Parameters
    ----------
    at : a click, or the start of the first line
    given : what the user asked for
    min_angle : least turn between the two sides of the edge, rad

    Raises
    ------
    ScanError: no edge there, or values that cannot work with this cloud or with each other.
    """
    known, reasons = with_probe_of(cloud, given)
    air_known = known.approach is not None
    complete = all(getattr(known, name) is not None for name in _MEASURED)
    if isinstance(at, Start) and complete and air_known:
        filled = with_distances(known, float(known.cloud_pitch or 0.0), reasons)
        filled = filled_in(filled, reasons, **WAYS)
        check_possible(filled)
        return ScanPlan(filled, reasons, at, _pitch_warnings(filled))
    site, choice = measure_and_choose(cloud, at, given, min_angle)
    start = at if isinstance(at, Start) else _start_on(cloud, site, choice.parameters)
    warnings = _warnings(choice, given)
    return ScanPlan(choice.parameters, choice.reasons, start, warnings, air_known)


def plan_for_cmm(cmm: Cmm, start: Start, given: ScanParameters) -> ScanPlan:
    """Plan a scan with a machine, which knows nothing of the part.

    Raises
    ------
    ScanError: no amplitude, values that cannot work with each other, or a cloud of ball centres
        of which nobody says where the air is.
    """
    if given.amplitude is None:
        raise ScanError(
            "A measuring machine needs the amplitude, the length of a scan line over both sides "
            "of the edge; give ScanParameters(amplitude=...) in mm."
        )
    _check_machine(cmm)
    reasons = dict.fromkeys(given.given(), GIVEN)
    amplitude, line_pitch = given.amplitude, given.line_pitch or given.amplitude / 16.0
    air_known = True
    known = given
    if isinstance(cmm, PointCloudCmm):
        air_known = _knows_the_air(cmm, given)
        known = filled_in(known, reasons, cloud_pitch=(cmm.pitch, "the machine's own"))
        if cmm.kind != "ball":
            known = with_distances(known, cmm.pitch, reasons)
    filled = filled_in(
        known,
        reasons,
        line_pitch=(line_pitch, "a sixteenth of the amplitude"),
        edge_pitch=(line_pitch, "the line pitch"),
        tolerance=(amplitude / 50.0, "a fiftieth of the amplitude"),
        degree=(2, "a quadratic follows bent and plane surfaces"),
        # A start that was touched on the part lies one radius below the ball's centre.
        prehit_distance=(
            2.0 * line_pitch + float(cmm.probe_radius),
            "twice the line pitch and the probe radius",
        ),
        search_distance=SEARCH_DISTANCE,
        **WAYS,
        pattern=(Pattern.SQUARE, "lines straight across the edge"),
        probe_radius=(float(cmm.probe_radius), "the machine's own"),
        approach=(tuple(np.asarray(cmm.approach, dtype=float)), "the machine's own"),
    )
    check_possible(filled)
    warnings = (*_pitch_warnings(filled), *_probe_warnings(cmm, given))
    return ScanPlan(filled, reasons, start, warnings, air_known, given.tolerance is None)


def _probe_warnings(cmm: Cmm, given: ScanParameters) -> tuple[str, ...]:
    """About a probe radius that is not the machine's."""
    radius = given.probe_radius
    if radius is None or np.isclose(radius, float(cmm.probe_radius)):
        return ()
    return (
        f"A probe radius of {radius:g} mm was given, and the machine says that its own is "
        f"{float(cmm.probe_radius):g} mm; the given one was taken off.",
    )


def _check_machine(cmm: Cmm) -> None:
    """Refuse a machine that does not say what its probe is.

    Raises
    ------
    ScanError
    """
    radius = cmm.probe_radius
    number = isinstance(radius, int | float | np.number) and not isinstance(radius, bool)
    if not (number and np.isfinite(radius) and radius >= 0.0):
        raise ScanError(
            f"The machine's probe_radius is {radius!r}; it has to be 0, or the radius in mm."
        )
    approach = numbers(cmm.approach)
    if approach is None or not np.any(approach):
        raise ScanError(
            f"The machine's approach is {cmm.approach!r}; it has to be the direction in which its "
            "probe points, three numbers that are not all zero."
        )


def _knows_the_air(cmm: PointCloudCmm, given: ScanParameters) -> bool:
    """Whether a virtual machine knows from where its cloud was probed.

    A virtual ball comes along its own approach; the points of a cloud came along the cloud's.
    """
    if given.approach is not None or cmm.cloud.approach is not None or cmm.kind == "ball":
        return True
    radius = cmm.probe_radius if given.probe_radius is None else given.probe_radius
    if radius:
        raise ScanError(
            f"The cloud holds the centres of a ball of radius {radius:g} mm, and nothing tells "
            "along which direction it came; give the cloud an approach, or "
            "ScanParameters(approach=...)."
        )
    return False


def _pitch_warnings(parameters: ScanParameters) -> tuple[str, ...]:
    """About pitches that are possible but too small, which needs no measuring."""
    if parameters.cloud_pitch is None:
        return ()
    return Guidelines.of_pitch(parameters.cloud_pitch).warnings(parameters)


def _warnings(choice: ProbeChoice, given: ScanParameters) -> tuple[str, ...]:
    """About what the user gave; what was chosen here is as good as the edge allows."""
    return (*choice.guidelines.warnings(given), *choice.guidelines.contradictions)


def _start_on(cloud: PointCloud, site: EdgeSite, parameters: ScanParameters) -> Start:
    """The first line starts on the first side, half an amplitude along the surface from the edge.

    That way leads round the rounding, which is shorter than its two tangents.
    """
    frame, around = site.frame, site.around
    away = around.line_section(float(parameters.amplitude or 0.0)) + around.cut_off
    rise = 0.5 * float(frame.curvature[0, 0]) * away**2
    place = frame.origin[0] + away * frame.sides[0, 0] + rise * frame.normals[0, 0]
    nearest = cloud.points[cloud.tree.query(place)[1]]
    return Start(nearest, -frame.sides[0, 0], frame.tangent[0])
