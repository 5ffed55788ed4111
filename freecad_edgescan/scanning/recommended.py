# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rules by which a probed scan is fitted to an edge that was measured.

There is one set of rules: what a scan takes for None is what `recommend_parameters` recommends.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..cloud.point_cloud import PointCloud
from ..geometry.plain_number import plain
from .edge_site import EdgeSite, measure_site
from .error_model import largest_deviation
from .errors import ScanError
from .expected_error import ExpectedError, expected_error
from .filled_in import GIVEN, SEARCH_DISTANCE, WAYS, filled_in, with_distances, with_probe_of
from .guidelines import LEAST_PITCHES, Guidelines, check_possible, least_tolerance
from .parameters import Pattern, ScanParameters
from .safeguards import Safeguards
from .start import Start
from .surroundings import Surroundings

__all__ = [
    "ProbeChoice",
    "choose_for_site",
    "measure_and_choose",
]

Point = Sequence[float] | np.ndarray

_FEWEST_PITCHES = 3.0  # cloud pitches on each side: below it not even lines have their points
_DEEPEST = 0.25  # amplitudes to search: half a side
_POINTS = 6  # of a line section, where there is room for them
_MOST_POINTS = 20  # of a line section: about as many as the best published scans had
_LONGEST = 20.0  # line sections, in lengths of what is drawn out to the edge: noise grows by 1/5
_TOLERANCE = 1.25  # times the least one
_UNEVEN = 0.02  # cloud pitches: what is left of a surface's form between its points
_UNSEEN = 0.25  # of the noise: a bias that noise hides along the whole edge


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


def measure_and_choose(
    cloud: PointCloud, at: Point | Start, given: ScanParameters, min_angle: float
) -> tuple[EdgeSite, ProbeChoice]:
    """Measure an edge and choose the parameters of a probed scan for it.

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
    site = measure_site(cloud, at, known, min_angle)
    choice = choose_for_site(site, known)
    return site, replace(choice, reasons={**choice.reasons, **reasons})


def choose_for_site(site: EdgeSite, given: ScanParameters) -> ProbeChoice:
    """Choose the parameters of a probed scan for an edge that was measured.

    Raises
    ------
    ScanError: values that cannot work with this cloud or with each other.
    """
    if given.amplitude is None:
        _check_room(site)
    if given.degree is not None:
        best = _for_degree(site, given, given.degree)
    else:
        line, best = (_for_degree(site, given, degree) for degree in (1, 2))
        # What contacts lie too early is the same for both.
        more = line.expected.model_bias - best.expected.model_bias
        scatter = best.expected.noise_error
        straight = more <= _UNSEEN * scatter
        best = line if straight else best
        best.reasons["degree"] = _why(straight, max(more, 0.0), scatter)
    check_possible(best.parameters)
    return best


def _check_room(site: EdgeSite) -> None:
    """Refuse an edge whose sides are too short for any scan line.

    Raises
    ------
    ScanError
    """
    pitch = site.around.cloud_pitch
    if 0.5 * site.room <= _FEWEST_PITCHES * pitch:
        raise ScanError(
            f"The sides of this edge leave {plain(max(0.5 * site.room, 0.0), 3)} mm for a scan "
            "line, as far as they are smooth and clear of a rounding and of other edges, and the "
            f"cloud's points lie up to {plain(pitch, 3)} mm apart: too few. Take method='patch', "
            "which uses all points, or give an amplitude."
        )


def _why(straight: bool, more: float, scatter: float) -> str:
    if not np.isfinite(scatter):
        return "the amplitude has not enough points for a quadratic"
    return (
        f"a line would be off by {plain(more, 2)} mm more all along the edge, "
        f"{'far below' if straight else 'too much for'} the {plain(scatter, 2)} mm that noise does "
        "to a quadratic"
    )


def _for_degree(site: EdgeSite, given: ScanParameters, degree: int) -> ProbeChoice:
    around, reasons = site.around, dict.fromkeys(given.given(), GIVEN)
    pitch = around.cloud_pitch
    slid = (given.safeguards or Safeguards()).slide
    least_pitch = LEAST_PITCHES * pitch
    amplitude, line_pitch = given.amplitude, given.line_pitch
    if amplitude is None:
        amplitude, reasons["amplitude"] = _amplitude(site, degree, line_pitch or least_pitch)
    if line_pitch is None:
        line_pitch, reasons["line_pitch"] = _line_pitch(around, amplitude, degree)
    # From deep down the far side of a sharp edge is touched from within.
    search = min(SEARCH_DISTANCE[0], _DEEPEST * amplitude)
    filled = filled_in(
        given,
        reasons,
        search_distance=(search, "half a side, at most the 30 mm of Schreve appendix F"),
    )
    filled = filled_in(
        with_distances(filled, pitch, reasons),
        reasons,
        **WAYS,
        amplitude=(amplitude, ""),
        line_pitch=(line_pitch, ""),
        edge_pitch=_edge_pitch(line_pitch, least_pitch),
        tolerance=_tolerance(around, amplitude, degree, slid),
        degree=(degree, ""),
        pattern=(Pattern.SQUARE, "lines straight across the edge"),
        cloud_pitch=(
            pitch,
            "the largest distance between points near the start (Schreve 4.7.1, 7.2)",
        ),
        approach=(tuple(-site.air), "from outside the smaller wedge of the two surfaces"),
    )
    guidelines = Guidelines.of(around, degree, line_pitch, projected=not slid)
    expected = expected_error(around, amplitude, line_pitch, degree, site.early)
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
    return (
        amplitude,
        f"best for surfaces of radius {plain(around.arc_radius, 3)} mm, with points enough",
    )


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
    return (
        least,
        f"{LEAST_PITCHES:g} times the cloud pitch of {plain(around.cloud_pitch, 3)} mm "
        "(Schreve 4.4.4)",
    )


def _edge_pitch(line_pitch: float, least: float) -> tuple[float, str]:
    if line_pitch >= least:
        return line_pitch, "the line pitch (Schreve table 1)"
    return least, f"{LEAST_PITCHES:g} times the cloud pitch (Schreve 4.4.4)"


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
        f"the noise level of {plain(around.noise_level, 3)} mm with a little room, so that points "
        "on a rounding are told from the surface (after Schreve 5.3.3.5.1.1)"
    )
