# SPDX-License-Identifier: LGPL-2.1-or-later
"""The linear least-squares problem for the poles of a surface whose parameters are given.

Schreve eq. 6.3.2, NᵀN P = NᵀQ. All points of one patch share their basis functions, so that NᵀN is
summed patch by patch from small dense products; it is kept as a band, counted along the direction
with fewer poles.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.interpolate import BSpline
from scipy.linalg import solveh_banded

__all__ = ["TensorSystem"]

Array = NDArray[np.float64]

_AT_ONCE = 8192


class TensorSystem:
    """Normal equations of points with parameters on a tensor-product spline.

    Parameters
    ----------
    u, v : (m,) arrays of parameters within the knots' range
    values : (m, d) array, what the spline is to be there
    knots, degree : of the spline, clamped

    Attributes
    ----------
    shape : number of poles in u and v
    points_of_patch : (ku, kv) int, how many points lie in each patch
    """

    def __init__(
        self,
        u: Array,
        v: Array,
        values: Array,
        knots: tuple[Array, Array],
        degree: tuple[int, int],
    ) -> None:
        nu, nv = (len(k) - p - 1 for k, p in zip(knots, degree, strict=True))
        self.shape = (nu, nv)
        self._stride = (nv, 1) if nv <= nu else (1, nu)
        reach = degree[0] * self._stride[0] + degree[1] * self._stride[1]
        self._band = np.zeros((reach + 1, nu * nv))
        self._right = np.zeros((nu * nv, values.shape[1]))
        (first_u, basis_u), (first_v, basis_v) = (
            _basis(x, k, p) for x, k, p in zip((u, v), knots, degree, strict=True)
        )
        spans = [np.flatnonzero(np.diff(k) > 0.0) - p for k, p in zip(knots, degree, strict=True)]
        count = np.bincount(first_u * nv + first_v, minlength=nu * nv).reshape(nu, nv)
        self.points_of_patch: NDArray[np.intp] = count[np.ix_(*spans)]
        self._assemble(first_u, basis_u, first_v, basis_v, values)

    def _assemble(
        self,
        first_u: NDArray[np.intp],
        basis_u: Array,
        first_v: NDArray[np.intp],
        basis_v: Array,
        values: Array,
    ) -> None:
        width_u, width_v = np.arange(basis_u.shape[1]), np.arange(basis_v.shape[1])
        patch = first_u * self.shape[1] + first_v
        small = len(self._right) < 65536
        order = np.argsort(patch.astype(np.uint16) if small else patch, kind="stable")
        edges = np.flatnonzero(np.diff(patch[order], prepend=-1))
        for start, end in zip(edges, np.append(edges[1:], len(order)), strict=True):
            product = np.zeros((width_u.size * width_v.size,) * 2)
            right = np.zeros((len(product), values.shape[1]))
            for block in range(start, end, _AT_ONCE):
                rows = order[block : min(block + _AT_ONCE, end)]
                basis = (basis_u[rows, :, None] * basis_v[rows, None, :]).reshape(len(rows), -1)
                product += basis.T @ basis
                right += basis.T @ values[rows]
            i, j = divmod(int(patch[order[start]]), self.shape[1])
            pole = self._number((i + width_u)[:, None], (j + width_v)[None, :]).ravel()
            self._right[pole] += right
            below = pole[:, None] - pole
            kept = below >= 0
            column = np.broadcast_to(pole, below.shape)
            self._band[below[kept], column[kept]] += product[kept]

    def _number(self, i: NDArray[np.intp], j: NDArray[np.intp]) -> NDArray[np.intp]:
        return i * self._stride[0] + j * self._stride[1]

    def solve(self, stiffness: sparse.spmatrix, share: float) -> Array:
        """Poles (nu, nv, d) that fit the points and keep an energy low.

        Parameters
        ----------
        stiffness : (nu nv, nu nv) matrix of the energy, poles counted along v first
        share : weight of the energy, relative to the points'
        """
        matrix = stiffness.tocoo()
        row, column = (
            self._number(*divmod(places.astype(np.intp), self.shape[1]))
            for places in (matrix.row, matrix.col)
        )
        kept = row >= column
        weight = share * self._band[0].sum() / matrix.diagonal().sum()
        band = self._band.copy()
        np.add.at(band, ((row - column)[kept], column[kept]), weight * matrix.data[kept])
        solved = solveh_banded(band, self._right, lower=True, check_finite=False)
        nu, nv = self.shape
        i, j = np.meshgrid(np.arange(nu), np.arange(nv), indexing="ij")
        return np.asarray(solved[self._number(i, j)])


def _basis(x: Array, knots: Array, degree: int) -> tuple[NDArray[np.intp], Array]:
    """First basis function that is not zero, and the values of it and its followers."""
    design = BSpline.design_matrix(x, knots, degree)
    shape = (len(x), degree + 1)
    return design.indices.reshape(shape)[:, 0].astype(np.intp), design.data.reshape(shape)
