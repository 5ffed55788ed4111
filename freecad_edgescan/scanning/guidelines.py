# SPDX-License-Identifier: LGPL-2.1-or-later
"""Guidelines for the parameters of a probed scan (Schreve 5.3.4, table 1).

Bounds follow from the part, the probe and the cloud round an edge. They warn and never refuse:
outside of them a scan is inaccurate or ends early, but it can be tried. `check_possible` alone
refuses, what cannot work at all.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from ..geometry.plain_number import plain
from .errors import ScanError
from .parameters import ScanParameters
from .surroundings import Surroundings

__all__ = [
    "LEAST_PITCHES",
    "Bound",
    "Guidelines",
    "Limit",
    "check_possible",
    "least_tolerance",
]

LEAST_PITCHES = 1.5  # cloud pitches, more than the diagonal of a grid (Schreve 4.4.4)
_LEAST_POINTS = 3.0  # of a line section (Schreve 5.3.4.6)
_OFF_PLANE = np.radians(10.0)  # between scanning plane and square to the surface (5.3.3.5)

# By degree; a cubic has no guideline of its own and takes the quadratic's.
_LONGEST_ARC = {1: 0.1, 2: 0.6}  # s/r (Schreve 5.3.4.6.3, 5.3.4.6.4)
_BEST_ARC = {1: 0.08, 2: 0.4}  # s/r (Schreve 5.3.4.6.5, 5.3.4.6.6)
_LARGEST_PITCH = {1: 0.022, 2: 0.133}  # of r (Schreve 5.3.4.7.1, 5.3.4.7.3)
_BEST_PITCH = {1: 0.003, 2: 0.013}  # of r (Schreve 5.3.4.7.2, 5.3.4.7.4)


class Limit(StrEnum):
    """What a bound is for its parameter."""

    MINIMUM = "minimum"
    MAXIMUM = "maximum"
    OPTIMUM = "optimum"


@dataclass(frozen=True)
class Bound:
    """A value that a parameter should keep to.

    Attributes
    ----------
    parameter : its name in `ScanParameters`
    limit : minimum, maximum or optimum
    value : mm
    equation : where it comes from in the source
    sentence : why
    """

    parameter: str
    limit: Limit
    value: float
    equation: str
    sentence: str

    def text(self) -> str:
        """The bound as one line."""
        words = self.parameter.replace("_", " ")
        value = plain(self.value, 4)
        return f"{words}: {self.limit} {value} mm (Schreve {self.equation}): {self.sentence}"


@dataclass(frozen=True)
class Guidelines:
    """All bounds for one edge and one degree.

    Attributes
    ----------
    bounds : tuple of `Bound`
    contradictions : sentences, one for each parameter whose least value is above its largest;
        such an edge may be scanned, but expect it to be inaccurate
    """

    bounds: tuple[Bound, ...]
    contradictions: tuple[str, ...]

    @classmethod
    def of(
        cls,
        around: Surroundings,
        degree: int,
        line_pitch: float | None = None,
        projected: bool = True,
    ) -> Guidelines:
        """Guidelines for an edge.

        Parameters
        ----------
        around : what is known about the edge
        degree : of the line sections
        line_pitch : the one that is used, mm; None: the least one
        projected : whether points are projected square to the scanning plane, as printed; when
            they are slid along the edge, that adds nothing to the noise

        Notes
        -----
        Schreve 5.3.4.6 and 5.3.4.7. The sign of 5.3.4.6.2 is put right: from A = 2s + df and
        three points on a section follows A >= 6ρ_L + 2φ(R_p + R_f).
        """
        kind = min(degree, 2)
        r, gap, pitch = around.arc_radius, around.rounding, around.cloud_pitch
        least_pitch = LEAST_PITCHES * pitch
        step = least_pitch if line_pitch is None else line_pitch
        name = "line" if kind == 1 else "quadratic"
        longest, best = _LONGEST_ARC[kind], _BEST_ARC[kind]
        arcs = ("5.3.4.6.4", "5.3.4.6.6") if kind == 1 else ("5.3.4.6.3", "5.3.4.6.5")
        pitches = ("5.3.4.7.3", "5.3.4.7.4") if kind == 1 else ("5.3.4.7.1", "5.3.4.7.2")
        low, high, optimum = Limit.MINIMUM, Limit.MAXIMUM, Limit.OPTIMUM
        every = (
            Bound(
                "amplitude", low, 3.0 * gap, "5.3.4.6.1",
                f"the way round the edge takes {plain(gap, 3)} mm; each side should be as long.",
            ),
            Bound(
                "amplitude", low, 2.0 * _LEAST_POINTS * step + gap, "5.3.4.6.2, corrected",
                f"three points on each side, {plain(step, 3)} mm apart.",
            ),
            Bound(
                "amplitude", high, 2.0 * longest * r + gap, arcs[0],
                f"on longer arcs than {longest:g} times the radius of {plain(r, 3)} mm a {name} "
                "departs from the surface.",
            ),
            Bound(
                "amplitude", optimum, 2.0 * best * r + gap, arcs[1],
                f"a {name} does best on an arc of {best:g} times the radius of {plain(r, 3)} mm.",
            ),
            Bound(
                "cloud_pitch", high, _LARGEST_PITCH[kind] * r, pitches[0],
                f"three points at the least line pitch on the longest arc for a {name}.",
            ),
            Bound(
                "cloud_pitch", optimum, _BEST_PITCH[kind] * r, pitches[1],
                f"about twenty points on the best arc for a {name}; denser clouds gain nothing.",
            ),
            *_pitch_bounds(pitch),
            Bound("edge_pitch", optimum, step, "table 1", "as large as the line pitch."),
            Bound(
                "tolerance", low, least_tolerance(around, projected), "5.3.3.5.1.1",
                f"the noise level of {plain(around.noise_level, 3)} mm"
                + (", and what points off the scanning plane add to it." if projected else "."),
            ),
        )  # fmt: skip
        bounds = tuple(bound for bound in every if 0.0 < bound.value < np.inf)  # planes have none
        return cls(bounds, tuple(_contradictions(bounds)))

    @classmethod
    def of_pitch(cls, cloud_pitch: float) -> Guidelines:
        """The guidelines that follow from the cloud pitch alone, mm."""
        return cls(_pitch_bounds(cloud_pitch), ())

    def least(self, parameter: str) -> float:
        """Largest minimum of a parameter, mm; 0 without one."""
        return max((b.value for b in self._of(parameter, Limit.MINIMUM)), default=0.0)

    def most(self, parameter: str) -> float:
        """Smallest maximum of a parameter, mm; infinite without one."""
        return min((b.value for b in self._of(parameter, Limit.MAXIMUM)), default=np.inf)

    def best(self, parameter: str) -> float:
        """Optimum of a parameter brought within its bounds, mm.

        Where these contradict each other the minimum counts: without enough points there is no
        edge at all.
        """
        optimum = [b.value for b in self._of(parameter, Limit.OPTIMUM)]
        value = optimum[0] if optimum else self.least(parameter)
        return max(min(value, self.most(parameter)), self.least(parameter))

    def warnings(self, parameters: ScanParameters) -> tuple[str, ...]:
        """Sentences for the parameters that break a guideline."""
        return tuple(self._warnings(parameters))

    def _warnings(self, parameters: ScanParameters) -> Iterable[str]:
        for bound in self.bounds:
            value = getattr(parameters, bound.parameter)
            if value is None or bound.limit is Limit.OPTIMUM:
                continue
            below = bound.limit is Limit.MINIMUM
            if (value < bound.value) if below else (value > bound.value):
                words = bound.parameter.replace("_", " ")
                yield (
                    f"The {words} of {plain(value, 4)} mm is {'below' if below else 'above'} the "
                    f"guideline of {plain(bound.value, 4)} mm (Schreve {bound.equation}): "
                    f"{bound.sentence}"
                )

    def _of(self, parameter: str, limit: Limit) -> list[Bound]:
        return [b for b in self.bounds if b.parameter == parameter and b.limit is limit]


def least_tolerance(around: Surroundings, projected: bool = True) -> float:
    """Least scanning tolerance ε_min = η + ρ_c sin 10°, mm (Schreve eq. 5.3.3.5.1.1).

    Parameters
    ----------
    projected : False leaves out the second term, see `Guidelines.of`
    """
    off = around.cloud_pitch * float(np.sin(_OFF_PLANE)) if projected else 0.0
    return around.noise_level + off


def check_possible(parameters: ScanParameters) -> None:
    """Refuse what cannot work at all; what is not given is not looked at.

    Raises
    ------
    ScanError: a line or edge pitch below the cloud pitch, or a line that is too short for the
        points its curves need (Schreve ineq. 4.7.1.1).
    """
    p = parameters
    for name in ("line_pitch", "edge_pitch"):
        value = getattr(p, name)
        if value is not None and p.cloud_pitch is not None and value < p.cloud_pitch:
            raise ScanError(
                f"The {name.replace('_', ' ')} of {value:g} mm is below the cloud pitch of "
                f"{plain(p.cloud_pitch, 3)} mm, where there is nothing to touch; give at least "
                f"{plain(p.cloud_pitch, 3)} mm, better "
                f"{plain(LEAST_PITCHES * p.cloud_pitch, 3)} mm."
            )
    if p.amplitude is None or p.line_pitch is None or p.degree is None:
        return
    points, needed = 0.5 * p.amplitude / p.line_pitch, p.degree + 1
    if points <= needed:
        raise ScanError(
            f"An amplitude of {p.amplitude:g} mm at a line pitch of {p.line_pitch:g} mm makes "
            f"{points:.3g} points on each side of the edge; degree {p.degree} needs more than "
            f"{needed} (Schreve 4.7.1.1). Give an amplitude above "
            f"{plain(2.0 * needed * p.line_pitch, 3)} mm, a line pitch below "
            f"{plain(0.5 * p.amplitude / needed, 3)} mm, or a lower degree."
        )


def _pitch_bounds(pitch: float) -> tuple[Bound, ...]:
    least, reason = LEAST_PITCHES * pitch, "so that no point is touched twice"
    sentence = f"{LEAST_PITCHES:g} times the cloud pitch of {plain(pitch, 3)} mm, {reason}."
    return tuple(
        Bound(name, Limit.MINIMUM, least, "4.4.4", sentence)
        for name in ("line_pitch", "edge_pitch")
    )


def _contradictions(bounds: tuple[Bound, ...]) -> Iterable[str]:
    for parameter in dict.fromkeys(bound.parameter for bound in bounds):
        mine = [bound for bound in bounds if bound.parameter == parameter]
        low = [bound for bound in mine if bound.limit is Limit.MINIMUM]
        high = [bound for bound in mine if bound.limit is Limit.MAXIMUM]
        if not low or not high:
            continue
        least = max(low, key=lambda bound: bound.value)
        most = min(high, key=lambda bound: bound.value)
        if least.value > most.value:
            yield (
                f"The {parameter.replace('_', ' ')} should be at least {plain(least.value, 4)} mm "
                f"(Schreve {least.equation}) and at most {plain(most.value, 4)} mm (Schreve "
                f"{most.equation}), which cannot both be; the edge may be scanned, but "
                "inaccurately."
            )
