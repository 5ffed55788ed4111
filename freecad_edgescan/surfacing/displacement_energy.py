# SPDX-License-Identifier: LGPL-2.1-or-later
"""The energy of a spline surface's displacement from its base surface, as a matrix of its poles.

That of a thin plate under tension: the integral of |D''|² + |D'|² / l², where l is the mean size of
a patch and the parameters are measured in mm by the mean size of the surface. A little of it holds
poles that no point supports. Bending joins the displacement smoothly to that of its neighbours;
tension lets it level off within about a patch, so that it never grows across a gap.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.interpolate import BSpline

__all__ = ["displacement_energy"]

Array = NDArray[np.float64]


def displacement_energy(
    knots: tuple[Array, Array], degree: tuple[int, int], size: tuple[float, float]
) -> sparse.csr_matrix:
    """Matrix (nu nv, nu nv) of the energy, poles counted along v first.

    Parameters
    ----------
    knots, degree : of the surface, clamped
    size : mean lengths of the surface in u and v, mm
    """
    (flat_u, slope_u, bend_u), (flat_v, slope_v, bend_v) = (
        [_gram(k, p, order, length) for order in range(3)]
        for k, p, length in zip(knots, degree, size, strict=True)
    )
    bending = sparse.kron(bend_u, flat_v) + sparse.kron(flat_u, bend_v)
    bending = bending + 2.0 * sparse.kron(slope_u, slope_v)
    tension = sparse.kron(slope_u, flat_v) + sparse.kron(flat_u, slope_v)
    patches = np.prod([len(np.unique(k)) - 1 for k in knots])
    energy = sparse.csr_matrix(bending + tension * (patches / (size[0] * size[1])))
    energy.eliminate_zeros()  # kron keeps whole blocks
    return energy


def _gram(knots: Array, degree: int, order: int, length: float) -> sparse.csr_matrix:
    """Integrals over mm of products of the basis functions' derivatives of one order."""
    breaks = np.unique(knots)
    node, weight = np.polynomial.legendre.leggauss(degree + 1)
    half = np.diff(breaks)[:, None] / 2
    at = ((breaks[:-1] + breaks[1:])[:, None] / 2 + half * node).ravel()
    scale = (knots[-1] - knots[0]) / length
    count = len(knots) - degree - 1
    value = np.zeros((len(at), count))
    if order <= degree:
        value = BSpline(knots, np.eye(count), degree)(at, nu=order) * scale**order
    weights = (half * weight).ravel() / scale
    return sparse.csr_matrix(value.T @ (weights[:, None] * value))
