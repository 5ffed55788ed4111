# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a straight line meets a torus round the z axis (Schreve 3.2 and appendix G3)."""

from __future__ import annotations

import numpy as np

__all__ = ["ray_torus"]

_REAL = 1e-4  # of the torus' size: imaginary part below which a root may be a double real one
_NEWTON_STEPS = 12
_POLISHED = 1e-13  # of the torus' size
_ON_IT = 1e-9  # of the torus' size


def ray_torus(
    start: np.ndarray,
    way: np.ndarray,
    major_radius: float,
    section_radius: float,
    centre_height: float,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """All intersections of the line start + λ way with (ρ, z) = (a + r cos v, b + r sin v).

    The quartic (eq. 3.2.3) knows only a²; roots that belong to −a are left out. Roots are polished
    by Newton's method on the torus itself.

    Parameters
    ----------
    start : (3,) mm
    way : (3,) unit vector
    major_radius : a, mm; may be smaller than r, or negative
    section_radius : r, mm
    centre_height : b, mm

    Returns
    -------
    λ (k,) mm in ascending order, the section angle v (k,) in (−π, π], and the azimuth (k,) rad
    """
    a, r = major_radius, section_radius
    # From the point of the line closest to the centre, and in units of the torus' size, the
    # coefficients of the quartic are all of the order of one.
    size = abs(a) + r
    centre = np.array([0.0, 0.0, centre_height])
    shift = float((centre - start) @ way)
    s = (start + shift * way - centre) / size
    a, r = a / size, r / size
    k1 = float(s @ s) - a * a - r * r
    k2 = 2.0 * float(s @ way)
    k3 = 4.0 * a * a * (r * r - s[2] ** 2)
    k4 = -8.0 * a * a * way[2] * s[2]
    k5 = -4.0 * a * a * way[2] ** 2
    quartic = [1.0, 2.0 * k2, 2.0 * k1 + k2 * k2 - k5, 2.0 * k1 * k2 - k4, k1 * k1 - k3]
    roots = np.roots(quartic)
    u = np.unique(roots.real[np.abs(roots.imag) < _REAL])
    for _ in range(_NEWTON_STEPS):
        p = s + u[:, None] * way
        rho = np.hypot(p[:, 0], p[:, 1])
        off = rho - a
        distance = np.hypot(off, p[:, 2])
        gap = distance - r
        speed = off * (p[:, 0] * way[0] + p[:, 1] * way[1]) / np.maximum(rho, 1e-300)
        speed = (speed + p[:, 2] * way[2]) / np.maximum(distance, 1e-300)
        step = np.divide(gap, speed, out=np.zeros_like(gap), where=np.abs(speed) > 1e-12)
        u = u - np.clip(step, -0.01, 0.01)
        if not len(u) or np.abs(step).max() < _POLISHED:
            break
    p = s + u[:, None] * way
    rho = np.hypot(p[:, 0], p[:, 1])
    good = np.abs(np.hypot(rho - a, p[:, 2]) - r) < _ON_IT
    u, p, rho = u[good], p[good], rho[good]
    order = np.argsort(u)
    u, p, rho = u[order], p[order], rho[order]
    fresh = np.append(True, np.diff(u) > _ON_IT) if len(u) else np.zeros(0, dtype=bool)
    u, p, rho = u[fresh], p[fresh], rho[fresh]
    v = np.arctan2(p[:, 2], rho - a)
    return shift + size * u, v, np.arctan2(p[:, 1], p[:, 0])
