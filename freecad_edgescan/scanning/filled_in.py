# SPDX-License-Identifier: LGPL-2.1-or-later
"""Filling in what nobody gave: a value, and the reason for it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from ..cloud.point_cloud import PointCloud
from .parameters import Compensation, ScanParameters, Steering, Tangent

__all__ = ["GIVEN", "SEARCH_DISTANCE", "WAYS", "filled_in", "with_distances", "with_probe_of"]

GIVEN = "given"
SEARCH_DISTANCE = (30.0, "as in the published case study (Schreve appendix F)")
# The ways of a probed scan that nobody has to choose.
WAYS = {
    "tangent": (Tangent.POLYNOMIALS, "follows sides that bend (Schreve 4.4.1.3)"),
    "steering": (Steering.TANGENT, "the edge's direction is smoothed anyway"),
    "compensation": (Compensation.INTERSECTION, "each line with its neighbours (Schreve 4.5.4)"),
}
_PREHIT = 4.0  # cloud pitches (Schreve appendix F)


def filled_in(
    given: ScanParameters, reasons: dict[str, str], **defaults: tuple[object, str]
) -> ScanParameters:
    """Take a default (value, reason) for each value that is missing, and note why.

    A reason that is noted already stays.
    """
    values: dict[str, Any] = {}
    for name, (value, reason) in defaults.items():
        if getattr(given, name) is None:
            values[name] = value
            reasons.setdefault(name, reason)
    return replace(given, **values)


def with_distances(given: ScanParameters, pitch: float, reasons: dict[str, str]) -> ScanParameters:
    """With the distances that go to the machine with each touch."""
    return filled_in(
        given,
        reasons,
        prehit_distance=(
            _PREHIT * pitch,
            f"{_PREHIT:g} times the cloud pitch (Schreve appendix F)",
        ),
        search_distance=SEARCH_DISTANCE,
    )


def with_probe_of(
    cloud: PointCloud, given: ScanParameters
) -> tuple[ScanParameters, dict[str, str]]:
    """The given parameters with the cloud's own probe."""
    reasons = dict.fromkeys(given.given(), GIVEN)
    own = "the cloud's own"
    known = filled_in(given, reasons, probe_radius=(cloud.probe_radius, own))
    if cloud.approach is not None:
        known = filled_in(known, reasons, approach=(cloud.approach, own))
    return known, reasons
