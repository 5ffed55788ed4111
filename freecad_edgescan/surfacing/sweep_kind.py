# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sweeps that are something simpler: ruled, extruded, revolved surfaces and pipes."""

from __future__ import annotations

from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from ..geometry import BSplineCurve, Circle, fit_circle, fit_line
from .swept_surface import SweptSurface

__all__ = ["SweepKind", "sweep_kinds"]

Array = NDArray[np.float64]

_SAMPLES = 50


class SweepKind(StrEnum):
    """What a sweep may also be called."""

    RULED = "ruled"  # straight profiles
    EXTRUSION = "extrusion"  # equal profiles along straight rails
    REVOLUTION = "revolution"  # rails are arcs about one axis, and the profile turns about it
    PIPE = "pipe"  # circular profiles


def sweep_kinds(sweep: SweptSurface, tolerance: float) -> tuple[SweepKind, ...]:
    """All simpler kinds of surface that the sweep is within a tolerance, mm.

    Raises
    ------
    ValueError: a tolerance that is not positive.
    """
    if not tolerance > 0.0:
        raise ValueError(f"The tolerance is {tolerance} mm; give a positive length.")
    profiles = [profile.sample(_SAMPLES) for profile in sweep.profiles]
    rails = [rail.sample(_SAMPLES) for rail in sweep.rails]
    found = []
    if all(_is_straight(points, tolerance) for points in profiles):
        found.append(SweepKind.RULED)
    elif all(_circle(points, tolerance) is not None for points in profiles):
        found.append(SweepKind.PIPE)
    if all(_is_straight(points, tolerance) for points in rails):
        moves = [points - profiles[0] for points in profiles]
        if all(np.ptp(move, axis=0).max() <= 2.0 * tolerance for move in moves):
            found.append(SweepKind.EXTRUSION)
    elif _is_revolved(rails, sweep.profiles, tolerance):
        found.append(SweepKind.REVOLUTION)
    return tuple(found)


def _is_straight(points: Array, tolerance: float) -> bool:
    return bool(np.linalg.norm(fit_line(points).line.residuals(points), axis=1).max() <= tolerance)


def _circle(points: Array, tolerance: float) -> Circle | None:
    """The circle through points, or None when they are not on one."""
    if _is_straight(points, tolerance):
        return None
    fit = fit_circle(points, tolerance)
    near = np.linalg.norm(fit.residuals, axis=1).max() <= tolerance
    return fit.circle if near else None


def _is_revolved(rails: list[Array], profiles: tuple[BSplineCurve, ...], tolerance: float) -> bool:
    circles = [_circle(points, tolerance) for points in rails]
    first = circles[0]
    if first is None:
        return False
    axis = first.axis
    for circle in circles[1:]:
        if circle is None or np.linalg.norm(np.cross(axis, circle.axis)) > 1e-3:
            return False
        apart = circle.centre - first.centre
        if np.linalg.norm(np.cross(apart, axis)) > tolerance:
            return False
    # every profile has the same distance from the axis and the same height on it
    v = np.linspace(0.0, 1.0, _SAMPLES)
    meridians = []
    for profile in profiles:
        away = profile.evaluate(v) - first.centre
        height = away @ axis
        radius = np.linalg.norm(away - height[:, None] * axis, axis=1)
        meridians.append(np.stack([radius, height], axis=1))
    return all(
        np.linalg.norm(meridian - meridians[0], axis=1).max() <= tolerance
        for meridian in meridians[1:]
    )
