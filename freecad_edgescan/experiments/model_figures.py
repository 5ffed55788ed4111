# SPDX-License-Identifier: LGPL-2.1-or-later
"""The analytical error of a probed scan as curves: figures 5.2 to 5.5 and D.9 to D.12.

The objects of the published curves are not stated; each figure says which one it shows.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np

from ..scanning.error_model import largest_deviation, model_error
from .doe_curves import Curve, Curves

__all__ = [
    "Shape",
    "angle_figure",
    "deviation_figure",
    "fillet_figure",
    "model_errors",
    "probe_figure",
]

KINDS = {1: "line", 2: "quadratic"}
SHARES = np.linspace(0.05, 1.0, 20)  # s/r
ARCS = np.linspace(2.5, 50.0, 20)  # mm
ANGLES = (90.0, 110.0, 130.0, 150.0)  # degrees
PROBE_RADII = (0.25, 0.5, 1.0, 2.5)  # mm
FILLET_RADII = (0.0, 1.0, 2.0, 4.0)  # mm


@dataclass(frozen=True)
class Shape:
    """Two surfaces, their rounding and the probe; mm and rad."""

    radius: float
    angle: float
    fillet_radius: float
    probe_radius: float


SHAPE = Shape(radius=50.0, angle=np.radians(110.0), fillet_radius=1.0, probe_radius=1.0)


def deviation_figure(degree: int, number: str) -> Curves:
    """Largest deviation of the best curve from a circular arc."""
    curve = Curve.of(KINDS[degree], SHARES, [largest_deviation(degree, s) for s in SHARES])
    return Curves(
        f"Figure {number}: largest deviation of a {KINDS[degree]} from an arc",
        "length of a line section over its radius, s/r",
        "deviation over the radius",
        (curve,),
        logarithmic=True,
    )


def angle_figure(degree: int, number: str) -> Curves:
    """Influence of the intersection angle."""
    curves = {f"θ = {angle:g}°": replace(SHAPE, angle=np.radians(angle)) for angle in ANGLES}
    note = f"R = {SHAPE.radius:g}, R_f = {SHAPE.fillet_radius:g}, R_p = {SHAPE.probe_radius:g} mm."
    return _figure(degree, number, "intersection angle", curves, note)


def probe_figure(degree: int, number: str) -> Curves:
    """Influence of the probe radius."""
    curves = {f"R_p = {radius:g} mm": replace(SHAPE, probe_radius=radius) for radius in PROBE_RADII}
    note = f"R = {SHAPE.radius:g}, R_f = {SHAPE.fillet_radius:g} mm, θ = {_degrees(SHAPE)}."
    return _figure(degree, number, "probe radius", curves, note)


def fillet_figure(degree: int, number: str) -> Curves:
    """Influence of the fillet radius."""
    curves = {
        f"R_f = {radius:g} mm": replace(SHAPE, fillet_radius=radius) for radius in FILLET_RADII
    }
    note = f"R = {SHAPE.radius:g}, R_p = {SHAPE.probe_radius:g} mm, θ = {_degrees(SHAPE)}."
    return _figure(degree, number, "fillet radius", curves, note)


def model_errors(degree: int, arcs: Iterable[float], shape: Shape) -> list[float]:
    """Analytical error for line sections of some lengths, mm."""
    return [
        float(
            model_error(
                degree, arc, shape.radius, shape.angle, shape.fillet_radius, shape.probe_radius
            )
        )
        for arc in arcs
    ]


def _figure(
    degree: int, number: str, influence: str, shapes: dict[str, Shape], note: str
) -> Curves:
    return Curves(
        f"Figure {number}: influence of the {influence} on the error, {KINDS[degree]}",
        "length of a line section s, mm",
        "analytical error of the edge point, mm",
        tuple(
            Curve.of(name, ARCS, model_errors(degree, ARCS, shape))
            for name, shape in shapes.items()
        ),
        notes=(note,),
    )


def _degrees(shape: Shape) -> str:
    return f"{np.degrees(shape.angle):g}°"
