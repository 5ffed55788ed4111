# SPDX-License-Identifier: LGPL-2.1-or-later
"""The analytical error of a probed scan as curves: figures 5.2 to 5.5 and D.9 to D.12.

The objects of the published curves are not stated; each figure says which one it shows.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from ..scanning.error_model import largest_deviation, model_error
from .doe_curves import Curve, Curves

__all__ = ["angle_figure", "deviation_figure", "fillet_figure", "model_curve", "probe_figure"]

SHARES = np.linspace(0.05, 1.0, 20)  # s/r
RADIUS = 50.0  # mm, R
ANGLE = 110.0  # degrees
FILLET_RADIUS = 1.0  # mm
PROBE_RADIUS = 1.0  # mm
_KINDS = {1: "line", 2: "quadratic"}
_ARC = "length of a line section over its radius, s/r"
_ERROR = "error of the edge point, mm"


def deviation_figure(degree: int, number: str) -> Curves:
    """Largest deviation of the best curve from a circular arc."""
    curve = Curve.of(_KINDS[degree], SHARES, [largest_deviation(degree, s) for s in SHARES])
    return Curves(
        f"Figure {number}: largest deviation of a {_KINDS[degree]} from an arc",
        _ARC,
        "deviation over the radius",
        (curve,),
        logarithmic=True,
    )


def angle_figure(degree: int, number: str) -> Curves:
    """Influence of the intersection angle."""
    curves = (
        model_curve(f"θ = {angle:g}°", degree, angle=angle) for angle in (90.0, 110.0, 130.0, 150.0)
    )
    note = f"R = {RADIUS:g}, R_f = {FILLET_RADIUS:g}, R_p = {PROBE_RADIUS:g} mm."
    return _figure(degree, number, "intersection angle", curves, note)


def probe_figure(degree: int, number: str) -> Curves:
    """Influence of the probe radius."""
    curves = (
        model_curve(f"R_p = {radius:g} mm", degree, probe_radius=radius)
        for radius in (0.25, 0.5, 1.0, 2.5)
    )
    note = f"R = {RADIUS:g}, R_f = {FILLET_RADIUS:g} mm, θ = {ANGLE:g}°."
    return _figure(degree, number, "probe radius", curves, note)


def fillet_figure(degree: int, number: str) -> Curves:
    """Influence of the fillet radius."""
    curves = (
        model_curve(f"R_f = {radius:g} mm", degree, fillet_radius=radius)
        for radius in (0.0, 1.0, 2.0, 4.0)
    )
    note = f"R = {RADIUS:g}, R_p = {PROBE_RADIUS:g} mm, θ = {ANGLE:g}°."
    return _figure(degree, number, "fillet radius", curves, note)


def model_curve(
    name: str,
    degree: int,
    shares: NDArray[np.float64] = SHARES,
    section_radius: float = RADIUS,
    angle: float = ANGLE,
    fillet_radius: float = FILLET_RADIUS,
    probe_radius: float = PROBE_RADIUS,
) -> Curve:
    """Analytical error over s/r with r = R - R_p; the angle in degrees."""
    arcs = shares * (section_radius - probe_radius)
    shape = section_radius, float(np.radians(angle)), fillet_radius, probe_radius
    return Curve.of(name, shares, [float(model_error(degree, arc, *shape)) for arc in arcs])


def _figure(degree: int, number: str, influence: str, curves: Iterable[Curve], note: str) -> Curves:
    title = f"Figure {number}: influence of the {influence} on the analytical error, "
    return Curves(
        title + _KINDS[degree], _ARC, _ERROR, tuple(curves), notes=(note,), logarithmic=True
    )
