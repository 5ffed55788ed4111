# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arcs and surfaces of engineering as exact B-splines: ruled, extruded, revolved.

Piegl and Tiller, The NURBS Book (1997): sections 7.5 (arcs), 8.3 (extrusion), 8.4 (ruled) and 8.5
(revolution). Parameters round an axis are angles in rad where the pieces of the arc meet.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from freecad_edgescan.geometry.bspline_curve import BSplineCurve
from freecad_edgescan.geometry.bspline_surface import BSplineSurface
from freecad_edgescan.geometry.circle import Circle
from freecad_edgescan.geometry.compatible_curves import compatible_curves
from freecad_edgescan.geometry.frames import orthonormalise

__all__ = ["circular_arc", "extruded_surface", "revolved_surface", "ruled_surface"]

Array = NDArray[np.float64]

_FULL_TURN = 2.0 * np.pi


def circular_arc(circle: Circle, first: float = 0.0, last: float = _FULL_TURN) -> BSplineCurve:
    """Part of a circle between two angles in rad, as a rational quadratic."""
    plane, weights, knots = _unit_arc(first, last)
    side = np.cross(circle.axis, circle.reference)
    poles = circle.centre + circle.radius * plane @ np.stack([circle.reference, side])
    return BSplineCurve(poles, knots, 2, weights=weights)


def ruled_surface(first: BSplineCurve, second: BSplineCurve) -> BSplineSurface:
    """Straight lines between points of equal share of two curves' parameters.

    u runs along the curves and v from the first (0) to the second (1); both parameters in [0, 1].
    """
    one, other = compatible_curves([first, second])
    poles = np.stack([one.poles, other.poles], axis=1)
    weights = None
    if one.weights is not None and other.weights is not None:
        weights = np.stack([one.weights, other.weights], axis=1)
    return BSplineSurface(poles, (one.knots, np.array([0.0, 0, 1, 1])), (one.degree, 1), weights)


def extruded_surface(profile: BSplineCurve, way: ArrayLike) -> BSplineSurface:
    """A curve moved along a straight way (3,) in mm: u along the curve, v in [0, 1] on the way."""
    way = np.asarray(way, dtype=float)
    if not np.linalg.norm(way) > 0.0:
        raise ValueError(f"The way of an extrusion is {way.tolist()} mm; give one with a length.")
    curve = profile.opened()
    poles = np.stack([curve.poles, curve.poles + way], axis=1)
    weights = None if curve.weights is None else np.stack([curve.weights] * 2, axis=1)
    knots = (curve.knots, np.array([0.0, 0, 1, 1]))
    return BSplineSurface(poles, knots, (curve.degree, 1), weights)


def revolved_surface(
    profile: BSplineCurve,
    origin: ArrayLike,
    axis: ArrayLike,
    angle: float = _FULL_TURN,
) -> BSplineSurface:
    """A curve turned about an axis: u is the angle in rad from 0, v runs along the curve.

    Parameters
    ----------
    profile : what is turned
    origin, axis : (3,) point on the axis, mm, and its direction
    angle : rad, in (0, 2π]
    """
    if not 0.0 < angle <= _FULL_TURN * (1.0 + 1e-12):
        raise ValueError(
            f"The angle of a revolution is {angle:g} rad; give one above 0 and up to 2π."
        )
    centre: Array = np.asarray(origin, dtype=float)
    unit: Array = np.asarray(axis, dtype=float)
    if not np.linalg.norm(unit) > 0.0:
        raise ValueError(f"The axis of a revolution is {unit.tolist()}; give one with a length.")
    unit = unit / np.linalg.norm(unit)
    curve = profile.opened()
    plane, turn_weights, knots = _unit_arc(0.0, angle)
    away = curve.poles - centre
    foot = centre + np.outer(away @ unit, unit)
    radial = curve.poles - foot
    reference = orthonormalise(unit, radial[np.argmax(np.linalg.norm(radial, axis=1))])
    side = np.cross(unit, reference)
    # the plane's turn of each pole's own radial vector
    x, y = radial @ reference, radial @ side
    turned = plane[:, None, :1] * (x[:, None] * reference + y[:, None] * side) + plane[
        :, None, 1:
    ] * (x[:, None] * side - y[:, None] * reference)
    weights = np.ones(len(curve.poles)) if curve.weights is None else curve.weights
    return BSplineSurface(
        foot + turned, (knots, curve.knots), (2, curve.degree), np.outer(turn_weights, weights)
    )


def _unit_arc(first: float, last: float) -> tuple[Array, Array, Array]:
    """Poles (n, 2), weights and knots of the unit circle's arc between two angles."""
    if not 0.0 < last - first <= _FULL_TURN * (1.0 + 1e-12):
        raise ValueError(
            f"An arc from {first:g} to {last:g} rad is not part of a circle; give angles in order "
            "at most 2π apart."
        )
    pieces = int(np.ceil((last - first) / (np.pi / 2) * (1.0 - 1e-12)))
    angles = np.linspace(first, last, 2 * pieces + 1)
    half = (last - first) / (2 * pieces)
    radius = np.where(np.arange(len(angles)) % 2 == 1, 1.0 / np.cos(half), 1.0)
    poles = radius[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    if np.isclose(last - first, _FULL_TURN, rtol=1e-12):
        poles[-1] = poles[0]
    knots = np.r_[first, np.repeat(angles[::2], 2), last]
    return poles, 1.0 / radius, knots
