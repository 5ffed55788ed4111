# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every value a probed scan needs and nobody gave, each with its reason.

There is one set of rules: what a scan takes for None is what `recommend_parameters` recommends.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..cloud.point_cloud import PointCloud
from .cmm import Cmm
from .edge_site import EdgeSite, measure_site
from .error_model import largest_deviation
from .errors import ScanError
from .expected_error import ExpectedError, expected_error
from .guidelines import LEAST_PITCHES, Guidelines, Surroundings, check_possible, least_tolerance
from .parameters import Pattern, ScanParameters
from .safeguards import Safeguards
from .start import Start

__all__ = [
    "ProbeChoice",
    "choose_for_site",
    "choose_probe_parameters",
    "complete_for_cmm",
    "measure_and_choose",
]

Point = Sequence[float] | np.ndarray

_POINTS = 6  # of a line section, where there is room for them
_MOST_POINTS = 20  # of a line section: about as many as the best published scans had
_LONGEST = 20.0  # line sections, in lengths of what is drawn out to the edge: noise grows by 1/5
_TOLERANCE = 1.25  # times the least one
_UNEVEN = 0.02  # cloud pitches: what is left of a surface's form between its points
_UNSEEN = 0.25  # of the noise: a bias that noise hides along the whole edge
_PREHIT = 4.0  # cloud pitches (Schreve appendix F)
_SEARCH = 30.0  # mm (Schreve appendix F)
_GIVEN = "given"
_MEASURED = ("amplitude", "line_pitch", "edge_pitch", "tolerance", "degree", "cloud_pitch")


@dataclass(frozen=True)
class ProbeChoice:
    """Parameters of a probed scan with every value filled in.

    Attributes
    ----------
    parameters : for the scan
    reasons : of each value, by name
    guidelines : for the edge and the degree chosen
    expected : the error to expect
    """

    parameters: ScanParameters
    reasons: dict[str, str]
    guidelines: Guidelines
    expected: ExpectedError


def choose_probe_parameters(
    cloud: PointCloud, at: Point | Start, given: ScanParameters, min_angle: float
) -> tuple[ScanParameters, dict[str, str], Start]:
    """Fill in the parameters of a probed scan of a cloud.

    Nothing of the cloud is measured when nothing has to be.

    Parameters
    ----------
    at : a click, or the start of the first line
    given : what the user asked for
    min_angle : least turn between the two sides of the edge, rad

    Returns
    -------
    parameters, the reason of each, and where the first line starts

    Raises
    ------
    ScanError: no edge there, or values that cannot work with this cloud or with each other.
    """
    known, reasons = _from_cloud(cloud, given)
    complete = all(getattr(known, name) is not None for name in _MEASURED)
    if isinstance(at, Start) and complete and known.approach is not None:
        filled = _with_distances(known, float(known.cloud_pitch or 0.0), reasons)
        check_possible(filled)
        return filled, reasons, at
    site, choice = measure_and_choose(cloud, at, given, min_angle)
    start = at if isinstance(at, Start) else _start_on(cloud, site, choice.parameters)
    return choice.parameters, choice.reasons, start


def measure_and_choose(
    cloud: PointCloud, at: Point | Start, given: ScanParameters, min_angle: float
) -> tuple[EdgeSite, ProbeChoice]:
    """Measure an edge and choose the parameters of a probed scan for it.

    Parameters and errors: see `choose_probe_parameters`.
    """
    known, reasons = _from_cloud(cloud, given)
    site = measure_site(cloud, at, known, min_angle)
    choice = choose_for_site(site, known)
    return site, replace(choice, reasons={**choice.reasons, **reasons})


def complete_for_cmm(cmm: Cmm, given: ScanParameters) -> tuple[ScanParameters, dict[str, str]]:
    """Fill in the parameters of a scan with a machine, which knows nothing of the part.

    Raises
    ------
    ScanError: no amplitude, or values that cannot work with each other.
    """
    if given.amplitude is None:
        raise ScanError(
            "A measuring machine needs the amplitude, the length of a scan line over both sides "
            "of the edge; give ScanParameters(amplitude=...) in mm."
        )
    reasons = dict.fromkeys(given.given(), _GIVEN)
    amplitude = given.amplitude
    line_pitch = given.line_pitch or amplitude / 16.0
    filled = _fill(
        given,
        reasons,
        line_pitch=(line_pitch, "a sixteenth of the amplitude"),
        edge_pitch=(line_pitch, "the line pitch"),
        tolerance=(amplitude / 50.0, "a fiftieth of the amplitude"),
        degree=(2, "a quadratic follows bent and plane surfaces"),
        prehit_distance=(2.0 * line_pitch, "twice the line pitch"),
        search_distance=(_SEARCH, "as in the published case study"),
        pattern=(Pattern.SQUARE, "lines straight across the edge"),
        probe_radius=(float(cmm.probe_radius), "the machine's own"),
        approach=(tuple(np.asarray(cmm.approach, dtype=float)), "the machine's own"),
    )
    check_possible(filled)
    return filled, reasons


def choose_for_site(site: EdgeSite, given: ScanParameters) -> ProbeChoice:
    """Choose the parameters of a probed scan for an edge that was measured.

    Raises
    ------
    ScanError: values that cannot work with this cloud or with each other.
    """
    if given.degree is not None:
        best = _for_degree(site, given, given.degree)
    else:
        line, best = (_for_degree(site, given, degree) for degree in (1, 2))
        bias, scatter = line.expected.model_bias, best.expected.noise_error
        straight = bias < _UNSEEN * scatter
        best = line if straight else best
        best.reasons["degree"] = _why(straight, bias, scatter)
    check_possible(best.parameters)
    return best


def _why(straight: bool, bias: float, scatter: float) -> str:
    if not np.isfinite(scatter):
        return "the amplitude has not enough points for a quadratic"
    return (
        f"a line would be off by {bias:.2g} mm all along the edge, "
        f"{'far below' if straight else 'too much for'} the {scatter:.2g} mm that noise does "
        "to a quadratic"
    )


def _for_degree(site: EdgeSite, given: ScanParameters, degree: int) -> ProbeChoice:
    around, reasons = site.around, dict.fromkeys(given.given(), _GIVEN)
    pitch = around.cloud_pitch
    slid = (given.safeguards or Safeguards()).slide
    least_pitch = LEAST_PITCHES * pitch
    amplitude, line_pitch = given.amplitude, given.line_pitch
    if amplitude is None:
        amplitude, reasons["amplitude"] = _amplitude(site, degree, line_pitch or least_pitch)
    if line_pitch is None:
        line_pitch, reasons["line_pitch"] = _line_pitch(around, amplitude, degree)
    filled = _fill(
        _with_distances(given, pitch, reasons),
        reasons,
        amplitude=(amplitude, ""),
        line_pitch=(line_pitch, ""),
        edge_pitch=(max(line_pitch, least_pitch), "the line pitch (table 1)"),
        tolerance=_tolerance(around, amplitude, degree, slid),
        degree=(degree, ""),
        pattern=(Pattern.SQUARE, "lines straight across the edge"),
        cloud_pitch=(pitch, "measured near the start"),
        approach=(tuple(-site.air), "from outside the smaller wedge of the two surfaces"),
    )
    guidelines = Guidelines.of(around, degree, line_pitch, projected=not slid)
    expected = expected_error(around, amplitude, line_pitch, degree)
    return ProbeChoice(filled, reasons, guidelines, expected)


def _amplitude(site: EdgeSite, degree: int, line_pitch: float) -> tuple[float, str]:
    """The best amplitude for the surfaces' form, with points enough, in the room there is.

    Flat surfaces have no best one. Neither more points nor a longer curve that is drawn out over
    the same gap tell much more about the edge, and far from it other edges may be met.
    """
    around = site.around
    guidelines = Guidelines.of(around, degree, line_pitch)
    few = 2.0 * _POINTS * line_pitch + around.rounding
    longest = max(_MOST_POINTS * line_pitch, _LONGEST * around.gap)
    enough = 2.0 * longest + around.rounding
    best = guidelines.best("amplitude") if np.isfinite(around.arc_radius) else enough
    least = guidelines.least("amplitude")
    amplitude = max(min(best, enough), min(few, guidelines.most("amplitude")), least)
    if amplitude > site.room:
        return site.room, "as far as both sides are smooth surfaces"
    if amplitude == least:
        return amplitude, "the least that the rounding and the line pitch allow"
    if amplitude == enough:
        return amplitude, "farther off the surfaces tell little more about the edge"
    return amplitude, f"best for surfaces of radius {around.arc_radius:.3g} mm, with points enough"


def _line_pitch(around: Surroundings, amplitude: float, degree: int) -> tuple[float, str]:
    """As many points as the cloud and the published scans have, but enough for the degree."""
    least = LEAST_PITCHES * around.cloud_pitch
    length = around.line_section(amplitude)
    possible = min(0.49 * amplitude, max(length, 0.0)) / (degree + 1)  # q + 1 points (4.7.1.1)
    if possible < least:
        tight = max(possible, around.cloud_pitch)
        return tight, f"the short amplitude leaves no more for degree {degree}"
    many = length / _MOST_POINTS
    if many > least:
        return many, f"{_MOST_POINTS} points on each side"
    return least, f"{LEAST_PITCHES:g} times the cloud pitch of {around.cloud_pitch:.3g} mm (4.4.4)"


def _tolerance(
    around: Surroundings, amplitude: float, degree: int, slid: bool
) -> tuple[float, str]:
    """Little more than what good points are off: all that it lets in besides lies on the rounding.

    Good points are off by noise, by what takes them into the plane of the line, and where the
    surface bends more than the curve.
    """
    least = least_tolerance(around, projected=not slid)
    arc, length = around.arc_radius, around.line_section(amplitude)
    bend = 0.0
    if np.isfinite(arc) and length > 0.0:
        bend = arc * float(largest_deviation(degree, min(length / arc, np.pi)))
    tolerance = _TOLERANCE * least + _UNEVEN * around.cloud_pitch + bend
    return tolerance, (
        f"the noise level of {around.noise_level:.3g} mm with a little room, so that points on a "
        "rounding are told from the surface (after 5.3.3.5.1.1)"
    )


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


def _from_cloud(cloud: PointCloud, given: ScanParameters) -> tuple[ScanParameters, dict[str, str]]:
    """The given parameters with the cloud's own probe."""
    reasons = dict.fromkeys(given.given(), _GIVEN)
    own = "the cloud's own"
    known = _fill(given, reasons, probe_radius=(cloud.probe_radius, own))
    if cloud.approach is not None:
        known = _fill(known, reasons, approach=(cloud.approach, own))
    return known, reasons


def _with_distances(given: ScanParameters, pitch: float, reasons: dict[str, str]) -> ScanParameters:
    """With the distances that go to the machine with each touch."""
    return _fill(
        given,
        reasons,
        prehit_distance=(_PREHIT * pitch, f"{_PREHIT:g} times the cloud pitch (appendix F)"),
        search_distance=(_SEARCH, "as in the published case study (appendix F)"),
    )


def _fill(
    given: ScanParameters, reasons: dict[str, str], **defaults: tuple[object, str]
) -> ScanParameters:
    """Take a default for each value that is missing, and note its reason unless there is one."""
    values: dict[str, Any] = {}
    for name, (value, reason) in defaults.items():
        if getattr(given, name) is None:
            values[name] = value
            reasons.setdefault(name, reason)
    return replace(given, **values)
