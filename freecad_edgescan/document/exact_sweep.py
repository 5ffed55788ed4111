# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sweeps that are extrusions or revolutions, as FreeCAD's own surfaces of these kinds."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..geometry import fit_circle
from ..surfacing import SweepKind, SweptSurface
from .native_curve import curve_shape, vector

__all__ = ["exact_shape"]

_SAMPLES = 200


def exact_shape(sweep: SweptSurface, kinds: Sequence[SweepKind]) -> Any | None:
    """The face of an extruded or revolved profile, or None for a sweep of no such kind.

    Parameters
    ----------
    sweep : SweptSurface
    kinds : what it is besides, within a tolerance
    """
    profile = curve_shape(sweep.profiles[0])
    if SweepKind.EXTRUSION in kinds:
        start, end = sweep.rails[0].evaluate(np.array([0.0, 1.0]))
        return profile.extrude(vector(end - start))
    if SweepKind.REVOLUTION in kinds:
        rail = sweep.rails[0].sample(_SAMPLES)
        circle = fit_circle(rail).circle
        angles = np.unwrap(circle.angles(rail))
        turn = float(np.degrees(angles[-1] - angles[0]))
        return profile.revolve(vector(circle.centre), vector(circle.axis), turn)
    return None
