# SPDX-License-Identifier: LGPL-2.1-or-later
"""The error of a probed edge point that can be known beforehand.

Two alike surfaces meet at an angle; across the edge each is an arc of a circle, and the edge
between them is rounded. The probe's centres run on smaller arcs. Polynomials are laid along the
arcs, offset by the probe radius and intersected (Schreve 5.2, appendices C and D): that they are
no arcs gives `model_error`, that points scatter about them gives `noise_error`.

The surfaces of the source are hollow, as seen from the air. A negative section radius stands for
surfaces that bulge into the air, infinity for planes. A negative probe radius stands for a ball
inside the smaller wedge of the two surfaces, which cannot come nearer to the edge than a rounding
of its own radius lets it: give that as the fillet radius at least. The same equations hold.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..geometry.arc_fit import ArcPolynomial, fit_arc

__all__ = [
    "gap_to_edge",
    "largest_deviation",
    "model_error",
    "noise_error",
    "rounding_half_angle",
]

Array = NDArray[np.float64]

_DEGREES = (1, 2, 3)  # the source stops at 2
_NEWTON_STEPS = 30


def rounding_half_angle(
    section_radius: ArrayLike, angle: ArrayLike, fillet_radius: ArrayLike = 0.0
) -> Array:
    """Half the arc angle φ of the rounding between the two surfaces, rad.

    Parameters
    ----------
    section_radius : R of the surfaces across the edge, mm
    angle : intersection angle θ in (0, π), rad
    fillet_radius : R_f, mm

    Raises
    ------
    ValueError: an angle outside (0, π), or a rounding that does not fit between the surfaces.

    Notes
    -----
    Schreve eq. 5.2.1.1.
    """
    radius, angle, fillet = (
        np.asarray(x, dtype=float) for x in (section_radius, angle, fillet_radius)
    )
    if not np.all((angle > 0.0) & (angle < np.pi)):
        raise ValueError(f"The intersection angle is {angle} rad; give one between 0 and pi.")
    with np.errstate(divide="ignore", invalid="ignore"):
        sine = np.cos(0.5 * angle) / (1.0 + fillet / radius)
    if not np.all(np.abs(sine) <= 1.0) or not np.all(1.0 + fillet / radius > 0.0):
        raise ValueError(
            f"A rounding of radius {fillet} mm does not fit between surfaces of radius {radius} mm "
            f"that meet at {np.degrees(angle)} degrees; check the radii."
        )
    return np.asarray(np.arcsin(sine))


def gap_to_edge(
    section_radius: float, angle: float, fillet_radius: float = 0.0, probe_radius: float = 0.0
) -> float:
    """Arc over which the curve of the probe's centres is drawn out to the edge, rα, mm.

    It ends where the compensated curve reaches the sharp edge, so that without a rounding
    nothing is drawn out (Schreve eq. 5.2.1.2, with r = R - R_p).
    """
    if not np.isfinite(section_radius):
        return fillet_radius * float(np.tan(0.5 * (np.pi - angle)))
    half = float(rounding_half_angle(section_radius, angle, fillet_radius))
    return (section_radius - probe_radius) * (0.5 * (np.pi - angle) - half)


def largest_deviation(degree: int, s_over_r: ArrayLike) -> Array:
    """Largest distance of the best polynomial from its arc, over the arc's radius.

    It lies at the arc's ends, between points of equal parameter.

    Parameters
    ----------
    degree : 1, 2 or 3
    s_over_r : (...) length of the arc over its radius, up to 2π

    Notes
    -----
    Schreve eq. C18 (which lacks a square root), D3.2; figures 5.2, C.10, D.9.
    """
    _check_degree(degree)
    fit = fit_arc(degree, s_over_r, 1.0)
    return np.asarray(np.linalg.norm(fit.at(np.zeros_like(fit.arc_length)), axis=-1))


def model_error(
    degree: int,
    arc_length: ArrayLike,
    section_radius: float,
    angle: float,
    fillet_radius: float = 0.0,
    probe_radius: float = 0.0,
) -> Array:
    """Distance of the calculated edge point from the true one, without noise, mm.

    Parameters
    ----------
    degree : of the polynomials, 1, 2 or 3
    arc_length : (...) s of a line section, along the probe's centres, mm
    section_radius : R, mm; negative: the surfaces bulge into the air; infinite: planes
    angle : intersection angle θ in (0, π), rad
    fillet_radius, probe_radius : R_f, R_p, mm

    Returns
    -------
    (...) mm; nan where the drawn out curve does not reach the line of symmetry

    Raises
    ------
    ValueError: a degree, an angle or radii the model is not made for.

    Notes
    -----
    Schreve eq. 5.2.3.2, with a_y in the place of the second c_y (5.2.2.7).
    """
    _check_degree(degree)
    s = np.asarray(arc_length, dtype=float)
    if not np.all(s > 0.0):
        raise ValueError(f"The length of the line section is {s} mm; give positive lengths.")
    half = float(rounding_half_angle(section_radius, angle, fillet_radius))
    if not np.isfinite(section_radius):
        return np.zeros_like(s)
    alpha = 0.5 * (np.pi - angle) - half
    edge = section_radius * np.array([-2.0 * np.sin(0.5 * alpha) ** 2, -np.sin(alpha)])
    fit = fit_arc(degree, s, _centre_radius(section_radius, probe_radius))
    u = _on_symmetry(fit, section_radius, angle, fillet_radius, probe_radius)
    return np.asarray(np.linalg.norm(_offset(fit, u, probe_radius)[0] - edge, axis=-1))


def noise_error(
    degree: int,
    points: int,
    arc_length: float,
    section_radius: float,
    angle: float,
    fillet_radius: float = 0.0,
    probe_radius: float = 0.0,
    noise: float = 0.0,
) -> float:
    """Standard deviation of an edge point by the noise of the points it is made of, mm.

    On each of two sides that meet at θ, equally spaced points scatter along the normal; a
    polynomial is fitted to them and drawn out to the edge. A tilt of the curve moves the offset
    point along the surface only, so that the probe radius matters no further. Both directions
    across the edge are counted: it is the root mean square of the distance.

    Parameters
    ----------
    degree : of the polynomials, 1 or more
    points : number of points of a line section, from its one end to the other
    arc_length : s of a line section, mm
    section_radius, angle, fillet_radius, probe_radius : see `model_error`
    noise : standard deviation along the normal, mm

    Raises
    ------
    ValueError: fewer points than the polynomial has coefficients.
    """
    if points <= degree:
        raise ValueError(
            f"A curve of degree {degree} needs {degree + 1} points and has {points}; make the "
            "amplitude larger or the line pitch smaller."
        )
    if np.isfinite(section_radius):
        fit = fit_arc(degree, arc_length, _centre_radius(section_radius, probe_radius))
        u = _on_symmetry(fit, section_radius, angle, fillet_radius, probe_radius)
        x, y = fit.at(u, 1)
        half = float(rounding_half_angle(section_radius, angle, fillet_radius))
        meeting = 2.0 * (np.arctan2(y, x) - half)  # a curve's bias turns it, too
    else:
        u = np.asarray(-gap_to_edge(section_radius, angle, fillet_radius))
        meeting = angle
    triangle = np.linalg.qr(np.vander(np.linspace(-1.0, 1.0, points), degree + 1))[1]
    edge = np.vander([2.0 * float(u) / arc_length - 1.0], degree + 1)[0]
    leverage = float(np.linalg.norm(np.linalg.solve(triangle.T, edge)))
    return noise * leverage * float(np.sqrt(2.0) / abs(np.sin(meeting)))


def _centre_radius(section_radius: float, probe_radius: float) -> float:
    """Radius r = R - R_p of the arc of the probe's centres, mm."""
    radius = section_radius - probe_radius
    if radius * section_radius <= 0.0 and np.isfinite(radius):
        raise ValueError(
            f"A probe of radius {probe_radius:g} mm does not fit into a hollow surface of radius "
            f"{section_radius:g} mm; check the radii."
        )
    return radius


def _on_symmetry(
    fit: ArcPolynomial,
    section_radius: float,
    angle: float,
    fillet_radius: float,
    probe_radius: float,
) -> Array:
    """Parameters (...) of the offset polynomials on the line of symmetry; nan where none is near.

    Newton's method on Schreve eq. 5.2.3.1, from the arc's own foot of the edge.
    """
    half = float(rounding_half_angle(section_radius, angle, fillet_radius))
    across = np.array([np.sin(half), -np.cos(half)])  # square to the line
    start = -gap_to_edge(section_radius, angle, fillet_radius, probe_radius)
    u = np.full_like(fit.arc_length, start)
    for _ in range(_NEWTON_STEPS):
        point, slope = _offset(fit, u, probe_radius)
        step = ((point - [fillet_radius, 0.0]) @ across) / (slope @ across)
        u = u - step
        if np.all(np.abs(step) <= 1e-13 * fit.arc_length):
            break
    settled = np.abs(step) <= 1e-9 * (fit.arc_length + abs(start))
    return np.where(settled, u, np.nan)


def _offset(fit: ArcPolynomial, u: Array, distance: float) -> tuple[Array, Array]:
    """Offset curve (Schreve eq. 5.2.2.8, 5.2.2.9) seen from (R, 0), and its derivative by u."""
    slope, bend = fit.at(u, 1), fit.at(u, 2)
    speed = np.hypot(slope[..., 0], slope[..., 1])[..., None]
    right = np.stack([slope[..., 1], -slope[..., 0]], axis=-1) / speed
    curvature = (slope[..., :1] * bend[..., 1:] - slope[..., 1:] * bend[..., :1]) / speed**3
    point = fit.at(u) + distance * (right - [1.0, 0.0])
    return point, slope * (1.0 + distance * curvature)


def _check_degree(degree: int) -> None:
    if degree not in _DEGREES:
        raise ValueError(f"The degree is {degree!r}; the error model knows 1, 2 and 3.")
