# SPDX-License-Identifier: LGPL-2.1-or-later
"""The polynomial curve that lies best along an arc of a circle.

The arc is parameterised by its length and the whole of it counts, not a number of points on it
(Schreve 5.2.2, appendices C and D). The closed forms printed there are differences of nearly
equal terms when the arc is short for its radius. Here the arc is projected on Legendre
polynomials by Gauss' quadrature, and seen from its own beginning, where nothing cancels.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import ArrayLike, NDArray

__all__ = ["ArcPolynomial", "fit_arc"]

Array = NDArray[np.float64]

_NODES, _WEIGHTS = legendre.leggauss(24)  # to rounding, up to a full circle


@dataclass(frozen=True)
class ArcPolynomial:
    """Best polynomial along the arc r (cos(u/r) - 1, sin(u/r)), 0 <= u <= s.

    Attributes
    ----------
    coefficients : (..., degree + 1, 2) of Legendre polynomials in 2 u/s - 1, mm
    arc_length : (...) s, mm
    radius : (...) r, mm; negative: the arc bends to the other side
    """

    coefficients: Array
    arc_length: Array
    radius: Array

    @property
    def degree(self) -> int:
        """Highest power of u."""
        return self.coefficients.shape[-2] - 1

    def at(self, u: ArrayLike, derivative: int = 0) -> Array:
        """Points (..., 2) at arc lengths u (...), mm, or their derivatives by u."""
        parts = np.moveaxis(self.coefficients, -2, 0)
        scale = 2.0 / self.arc_length
        slopes = legendre.legder(parts, derivative) if derivative else parts
        place = np.asarray(u) * scale - 1.0
        basis = legendre.legvander(place, len(slopes) - 1).reshape(*place.shape, -1)
        values = np.einsum("...k,k...i->...i", basis, slopes)
        return np.asarray(values * scale[..., None] ** derivative)

    def powers(self) -> Array:
        """Coefficients (..., degree + 1, 2) of 1, u, u², … as in Schreve eq. C2, D2.2.

        There the circle's centre is the origin, so that the arc begins in (r, 0).
        """
        zero = np.zeros_like(self.arc_length)
        factorial = 1.0
        rows = []
        for power in range(self.degree + 1):
            factorial *= max(power, 1)
            rows.append(self.at(zero, power) / factorial)
        rows[0] = rows[0] + np.stack([self.radius, zero], axis=-1)
        return np.stack(rows, axis=-2)


def fit_arc(degree: int, arc_length: ArrayLike, radius: ArrayLike) -> ArcPolynomial:
    """Fit the polynomial with the least mean square distance at equal parameters.

    Parameters
    ----------
    degree : of the polynomial, 0 or more
    arc_length : (...) s > 0, mm
    radius : (...) r of the arc, mm, not zero; its sign says to which side it bends

    Notes
    -----
    Schreve eq. 5.2.2.1 (C3, D2.3).
    """
    s, r = np.broadcast_arrays(np.asarray(arc_length, dtype=float), np.asarray(radius, dtype=float))
    turn = 0.5 * s[..., None] * (1.0 + _NODES) / r[..., None]
    arc = np.stack([-2.0 * np.sin(0.5 * turn) ** 2, np.sin(turn)], axis=-1) * r[..., None, None]
    basis = legendre.legvander(_NODES, degree) * _WEIGHTS[:, None]
    norms = np.arange(degree + 1) + 0.5
    coefficients = norms[:, None] * np.einsum("nk,...ni->...ki", basis, arc)
    return ArcPolynomial(coefficients, s, r)
