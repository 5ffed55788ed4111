# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parameters for the edge near a click, with their reasons and the error to expect."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..cloud.point_cloud import PointCloud, require_surface
from ..geometry.place_text import place_text
from ..geometry.plain_number import plain
from .automatic import MIN_ANGLE, choose_parameters
from .edge_site import EdgeSite, measure_site
from .errors import ScanError
from .first_section import first_section, place_to_look
from .guidelines import Bound
from .least_angle import check_least_angle
from .parameters import ScanParameters
from .recommended import measure_and_choose
from .start import Start

__all__ = ["Recommendation", "recommend_parameters"]

Point = Sequence[float] | np.ndarray
_LENGTHS = (
    "amplitude",
    "line_pitch",
    "edge_pitch",
    "tolerance",
    "prehit_distance",
    "search_distance",
    "cloud_pitch",
    "probe_radius",
)
_CHOICES = ("degree", "pattern", "tangent", "steering", "compensation")


@dataclass(frozen=True)
class Recommendation:
    """What was measured at an edge, what to scan it with, and what will come of it.

    Attributes
    ----------
    place : (3,) mm, of the edge in the cloud's own points
    section_radius : of the more bent one of the two surfaces across the edge, mm; its centre lies
        outside of the smaller wedge, or when it is negative on the wedge's side; infinite for
        planes
    angle : intersection angle θ, rad
    fillet_radius : of the rounding, mm; 0 where none was found
    cloud_pitch : in the direction in which points lie farthest apart, mm
    noise_level : η, mm: √3 times the standard deviation along the normal
    parameters : for `scan_edge`, with every value filled in
    reasons : why each value is as it is, by name
    bounds : the guidelines for a probed scan; none for patches
    contradictions : sentences about guidelines that cannot all be kept
    warnings : sentences about values that break a guideline
    model_bias : error of the edge point because the surfaces are not the curves laid on them, mm
    noise_error : standard deviation of an edge point by the noise, mm; each probed line is taken
        by itself, though its neighbours make it less in the end
    method : "probe" or "patch"
    """

    place: np.ndarray
    section_radius: float
    angle: float
    fillet_radius: float
    cloud_pitch: float
    noise_level: float
    parameters: ScanParameters
    reasons: Mapping[str, str]
    bounds: tuple[Bound, ...]
    contradictions: tuple[str, ...]
    warnings: tuple[str, ...]
    model_bias: float
    noise_error: float
    method: str = "probe"

    @property
    def expected_error(self) -> float:
        """Distance of an edge point from the true edge to expect, root mean square, mm."""
        return float(np.hypot(self.model_bias, self.noise_error))

    def text(self) -> str:
        """Everything, for a person."""
        lines = [
            f"Edge near ({place_text(self.place)}), scanned with method {self.method!r}",
            f"  surfaces         {self._surfaces()}",
            f"  angle            {np.degrees(self.angle):.1f} deg",
            f"  rounding         {self._rounding()}",
            f"  cloud pitch      {plain(self.cloud_pitch, 4)} mm, the largest distance between "
            "points",
            f"  noise level      {plain(self.noise_level, 4)} mm",
            "Parameters",
        ]
        for name in (*_LENGTHS, *_CHOICES, "approach"):
            value = getattr(self.parameters, name)
            if value is not None:
                words = name.replace("_", " ")
                reason = self.reasons.get(name, "")
                lines.append(f"  {words:<16} {_text(name, value):<16} {reason}".rstrip())
        for title, sentences in (
            ("Guidelines", [bound.text() for bound in self.bounds]),
            ("Contradictions", self.contradictions),
            ("Warnings", self.warnings),
        ):
            if sentences:
                lines += [title, *(f"  {sentence}" for sentence in sentences)]
        lines.append(
            f"Error to expect: {plain(self.expected_error, 2)} mm (form of the surfaces "
            f"{self.model_bias:.2g}, noise {plain(self.noise_error, 2)} mm)"
        )
        if self.method == "probe":
            lines.append("Schreve: sections of the dissertation that docs/probe.md goes by.")
        return "\n".join(lines)

    def _surfaces(self) -> str:
        if not np.isfinite(self.section_radius):
            return "plane"
        return f"radius {plain(abs(self.section_radius), 4)} mm across the edge"

    def _rounding(self) -> str:
        return f"radius {plain(self.fillet_radius, 3)} mm" if self.fillet_radius else "none found"


def recommend_parameters(
    cloud: PointCloud,
    at: Point | Start,
    parameters: ScanParameters | None = None,
    method: str = "probe",
    min_angle: float = MIN_ANGLE,
) -> Recommendation:
    """Measure the edge near a click and say how to scan it.

    These are the values that `scan_edge` takes by itself for all that is None.

    Parameters
    ----------
    cloud : the scanned points
    at : a point near the edge, mm, or a `Start`
    parameters : values that are given are kept, and the others chosen to go with them
    method : "probe" or "patch"
    min_angle : least turn between the two sides, rad

    Raises
    ------
    ScanError: no edge here, or parameters that cannot work; the text says what to do.
    ValueError: a cloud without a surface.
    """
    given = parameters or ScanParameters()
    if method not in ("probe", "patch"):
        raise ScanError(f"The method is {method!r}; choose 'patch' or 'probe'.")
    check_least_angle(min_angle)
    if not isinstance(cloud, PointCloud):
        raise ScanError(
            f"recommend_parameters measures in a PointCloud and was given {type(cloud).__name__}; "
            "make a cloud with read_cloud(path) or PointCloud(points)."
        )
    require_surface(cloud)
    if method == "patch":
        return _for_patches(cloud, at, given, min_angle)
    site, choice = measure_and_choose(cloud, at, given, min_angle)
    return _recommendation(
        site,
        choice.parameters,
        choice.reasons,
        choice.expected.model_bias,
        choice.expected.noise_error,
        bounds=choice.guidelines.bounds,
        contradictions=choice.guidelines.contradictions,
        warnings=choice.guidelines.warnings(choice.parameters),
    )


def _for_patches(
    cloud: PointCloud, at: Point | Start, given: ScanParameters, min_angle: float
) -> Recommendation:
    """A patch lays circles on the surfaces, as far as these are smooth: form does no harm."""
    near = place_to_look(cloud, at, given)
    chosen = choose_parameters(cloud, near, given, min_angle)
    start = at if isinstance(at, Start) else None
    chosen = chosen.with_seed(first_section(cloud, near, start, chosen))
    site = measure_site(cloud, at, given, min_angle)
    return _recommendation(site, chosen.parameters, chosen.reasons, 0.0, site.sigma, method="patch")


def _recommendation(
    site: EdgeSite,
    parameters: ScanParameters,
    reasons: Mapping[str, str],
    model_bias: float,
    noise_error: float,
    bounds: tuple[Bound, ...] = (),
    contradictions: tuple[str, ...] = (),
    warnings: tuple[str, ...] = (),
    method: str = "probe",
) -> Recommendation:
    around = site.around
    return Recommendation(
        site.frame.origin[0],
        around.section_radius,
        around.angle,
        around.fillet_radius,
        around.cloud_pitch,
        around.noise_level,
        parameters,
        dict(reasons),
        bounds,
        contradictions,
        warnings,
        model_bias,
        noise_error,
        method,
    )


def _text(name: str, value: object) -> str:
    if name in _LENGTHS:
        return f"{plain(float(np.asarray(value)), 4)} mm"
    if name == "approach":
        return (
            "("
            + ", ".join(f"{part:.3g}" for part in np.round(np.asarray(value, dtype=float), 6) + 0.0)
            + ")"
        )
    return str(value)
