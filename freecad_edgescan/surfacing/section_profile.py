# SPDX-License-Identifier: LGPL-2.1-or-later
"""The line, arc or spline that points of a section follow.

The simplest that explains the points is taken: a line or an arc counts as explaining them when it
leaves hardly more over than the spline does, or than the noise.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from ..geometry import BSplineCurve, Circle, Line, fit_circle, fit_curve, fit_line
from ..geometry.exact_surfaces import circular_arc

__all__ = ["ProfileKind", "SectionProfile", "section_profile"]

Array = NDArray[np.float64]
_Shape = TypeVar("_Shape", Line, Circle)

_AS_GOOD = 1.05  # rms relative to the spline's, for the degrees of freedom that leaves
_EXACT = 1e-7  # of the size
_MOSTLY = 0.95  # of the points, which a line or an arc follows
_MEDIAN = 1.4826  # standard deviations in a median absolute deviation
_ROUNDS = 4
_MOST = 1200  # points the spline is fitted to
_STRAY = 5.0  # of the rms
_LARGEST_TURN = 1.95 * np.pi
_END_SIGMA = 2.0  # of the wanted ends, relative to that of the points; less makes hooks


class ProfileKind(StrEnum):
    """What the profile is."""

    LINE = "line"
    ARC = "arc"
    SPLINE = "spline"


@dataclass(frozen=True, eq=False)
class SectionProfile:
    """A profile, the primitive it is part of (None for a spline), and which points it follows."""

    kind: ProfileKind
    curve: BSplineCurve
    primitive: Line | Circle | None
    followed: NDArray[np.bool_]


def section_profile(
    points: Array, noise: float, ends: tuple[Array | None, Array | None], kind: ProfileKind | None
) -> SectionProfile:
    """The profile through points (m, 3) of a plane, in order.

    Parameters
    ----------
    points : (m, 3) mm
    noise : mm, standard deviation of the points in the plane
    ends : where the profile is to begin and to end, (3,) mm each; None: with the points
    kind : what it is to be; None: the simplest that explains the points

    Raises
    ------
    ValueError: an arc wanted through points on a line.
    """
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    sigma = max(noise, _EXACT * size)
    followed = np.ones(len(points), dtype=bool)
    spline = _spline(points, sigma, ends)
    for _ in range(2):
        off = spline.closest(points)[1]
        rms = float(np.sqrt(np.mean(off[followed] ** 2)))
        near = off <= _STRAY * max(rms, sigma)
        if np.array_equal(near, followed):
            break
        followed = near
        spline = _spline(points[followed], sigma, ends)
    x = points[followed]
    freedom = max(len(x) - len(spline.poles), 1)
    least = float(np.sqrt(np.sum(spline.closest(x)[1] ** 2) / freedom))
    limit = max(_AS_GOOD * max(least, noise), _EXACT * size)
    if kind is ProfileKind.LINE or kind is None:
        line, near, rms = _robust(lambda some: fit_line(some).line, points, sigma)
        if kind or (rms <= limit and near.mean() >= _MOSTLY):
            return SectionProfile(ProfileKind.LINE, _segment(line, points[near], ends), line, near)
    if kind is ProfileKind.ARC or kind is None:
        try:
            circle, near, rms = _robust(_circle, points, sigma)
        except ValueError:
            if kind:
                raise
            return SectionProfile(ProfileKind.SPLINE, spline, None, followed)
        turn = float(np.ptp(_angles(circle, points[near])))
        if kind or (rms <= limit and near.mean() >= _MOSTLY and turn <= _LARGEST_TURN):
            arc = _arc(circle, points[near], ends)
            return SectionProfile(ProfileKind.ARC, arc, circle, near)
    return SectionProfile(ProfileKind.SPLINE, spline, None, followed)


def _robust(
    fit: Callable[[Array], _Shape], points: Array, sigma: float
) -> tuple[_Shape, NDArray[np.bool_], float]:
    """A line or circle without strays, the points it follows, and their rms, mm."""
    near = np.ones(len(points), dtype=bool)
    for _ in range(_ROUNDS):
        shape = fit(points[near])
        off = np.linalg.norm(shape.residuals(points), axis=1)
        spread = max(_MEDIAN * float(np.median(off)), sigma)
        kept = off <= _STRAY * spread
        if np.array_equal(kept, near):
            break
        near = kept
    return shape, near, float(np.sqrt(np.mean(off[near] ** 2)))


def _spline(points: Array, sigma: float, ends: tuple[Array | None, Array | None]) -> BSplineCurve:
    rows = np.unique(np.linspace(0, len(points) - 1, _MOST).astype(np.intp))
    x, deviation = points[rows], np.full(len(rows), sigma)
    first, last = ends
    if first is not None:
        x, deviation = np.vstack([first, x]), np.append(_END_SIGMA * sigma, deviation)
    if last is not None:
        x, deviation = np.vstack([x, last]), np.append(deviation, _END_SIGMA * sigma)
    return fit_curve(x, deviation)


def _segment(line: Line, x: Array, ends: tuple[Array | None, Array | None]) -> BSplineCurve:
    along = line.closest(x)[0]
    limits = [along.min(), along.max()]
    for k, end in enumerate(ends):
        if end is not None:
            limits[k] = line.closest(end[None])[0][0]
    return BSplineCurve(line.evaluate(np.array(limits)), np.array([0.0, 0, 1, 1]), 1)


def _circle(x: Array) -> Circle:
    """The circle through points, its angles counted from their middle and growing along them."""
    circle = fit_circle(x).circle
    middle = x[len(x) // 2] - circle.centre
    reference = middle - (middle @ circle.axis) * circle.axis
    circle = replace(circle, reference=reference / np.linalg.norm(reference))
    angles = _angles(circle, x)
    if angles[: len(x) // 2].mean() > angles[len(x) // 2 :].mean():
        circle = replace(circle, axis=-circle.axis)
    return circle


def _angles(circle: Circle, x: Array) -> Array:
    """Angles (m,) of points in (-π, π]."""
    side = np.cross(circle.axis, circle.reference)
    return np.asarray(
        np.arctan2((x - circle.centre) @ side, (x - circle.centre) @ circle.reference)
    )


def _arc(circle: Circle, x: Array, ends: tuple[Array | None, Array | None]) -> BSplineCurve:
    angles = _angles(circle, x)
    limits = [angles.min(), angles.max()]
    for k, end in enumerate(ends):
        if end is not None:
            limits[k] = _angles(circle, end[None])[0]
    return circular_arc(circle, float(limits[0]), float(limits[1]))
