# SPDX-License-Identifier: LGPL-2.1-or-later
"""The linear least-squares problem for the poles of a B-spline curve whose knots are given.

Normal equations are kept as a band. For a periodic curve the poles are counted 0, n-1, 1, n-2, …,
so that poles which are neighbours across the seam stay neighbours and the band is only twice as
wide.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.interpolate import BSpline
from scipy.linalg import cho_solve_banded, cholesky_banded

__all__ = ["PoleSystem"]

Array = NDArray[np.float64]

_STIFFNESS = 1e-8
"""Relative weight of the poles' second differences: holds poles that no point supports."""


class PoleSystem:
    """Weighted least squares for the poles.

    Parameters
    ----------
    knots : (n + degree + 1,) array, or (n + 2 degree + 1,) when periodic
        As in `BSplineCurve`.
    degree : int
        Degree of the curve.
    periodic : bool
        Whether the curve is periodic.
    parameters : (m,) array
        Parameter of each point, within the range.
    points : (m, 3) array
        Points in mm.
    weights : (m, 3, 3) array
        Inverse covariance of each point, 1/mm².
    """

    def __init__(
        self,
        knots: Array,
        degree: int,
        periodic: bool,
        parameters: Array,
        points: Array,
        weights: Array,
    ) -> None:
        self._knots, self._degree, self._periodic = knots, degree, periodic
        n = len(knots) - (2 * degree if periodic else degree) - 1
        self._count = n
        if periodic:
            j = np.arange(n)
            self._rank = np.where(j <= (n - 1) // 2, 2 * j, 2 * (n - j) - 1)
        else:
            self._rank = np.arange(n)
        neighbours = min(2 * degree if periodic else degree, n - 1)
        self._band = 3 * (neighbours + 1)
        design = BSpline.design_matrix(parameters, knots, degree)
        value = design.data.reshape(len(parameters), degree + 1)
        place = self._rank[design.indices.reshape(value.shape) % n]
        origin = points.mean(axis=0)
        matrix = self._assemble(place, value, weights)
        matrix += self._stiffness(float(matrix[0].mean()) * _STIFFNESS)
        pull = np.einsum("mxy,my->mx", weights, points - origin)
        right = np.stack(
            [
                np.bincount(place.ravel(), (value * pull[:, axis, None]).ravel(), minlength=n)
                for axis in range(3)
            ],
            axis=1,
        )
        self._factor = cholesky_banded(matrix, lower=True, check_finite=False)
        solved = cho_solve_banded((self._factor, True), right.ravel(), check_finite=False)
        self._local = solved.reshape(n, 3)[self._rank]
        self.poles: Array = self._local + origin

    def _assemble(self, place: NDArray[np.intp], value: Array, weights: Array) -> Array:
        """Lower band (band, 3 n) of the sum of value_a value_b weights at places a, b."""
        ids, group = np.unique(place, axis=0, return_inverse=True)
        pairs = (value[:, :, None] * value[:, None, :]).reshape(len(value), -1, 1)
        entries = (pairs * weights.reshape(-1, 1, 9)).reshape(len(value), -1)
        rows = np.arange(len(value) + 1)
        gather = sparse.csr_matrix(
            (np.ones(len(value)), group.ravel(), rows), (len(value), len(ids))
        )
        entries = gather.T @ entries
        width = value.shape[1]
        entries = entries.reshape(-1, width, width, 3, 3).transpose(0, 1, 3, 2, 4)
        unknown = 3 * ids[:, :, None] + np.arange(3)
        column = np.broadcast_to(unknown[:, None, None, :, :], entries.shape)
        below = unknown[:, :, :, None, None] - column
        size = 3 * self._count
        flat = np.where(below >= 0, below * size + column, self._band * size)
        total = self._band * size + 1
        summed: Array = np.bincount(flat.ravel(), entries.ravel(), minlength=total).astype(float)
        return summed[:-1].reshape(self._band, size)

    def _stiffness(self, weight: float) -> Array:
        """Band of the squared differences of neighbouring poles, second ones where they fit."""
        difference = np.array([1.0, -2.0, 1.0] if self._degree > 1 else [1.0, -1.0])
        width = len(difference)
        first = np.arange(self._count if self._periodic else self._count - width + 1)
        place = self._rank[(first[:, None] + np.arange(width)) % self._count]
        value = np.broadcast_to(difference, place.shape)
        return self._assemble(place, value, np.broadcast_to(weight * np.eye(3), (len(first), 3, 3)))

    @cached_property
    def significance(self) -> Array:
        """By how much chi-square grows when a knot is taken away, for each inner simple knot.

        Without a knot the derivative of the curve's degree does not jump there; the jump is
        linear in the poles, so that its chi-square (3 degrees of freedom) follows from one
        factorisation.
        """
        jumps = self._jumps()
        result = np.empty(jumps.shape[0])
        for first in range(0, len(result), 100):
            rows = jumps[first : first + 100].toarray()
            ranked = np.zeros((len(rows), self._count))
            ranked[:, self._rank] = rows
            right = np.einsum("kn,xy->nxky", ranked, np.eye(3)).reshape(3 * self._count, -1)
            solved = cho_solve_banded((self._factor, True), right, check_finite=False)
            solved = solved.reshape(self._count, 3, len(rows), 3)
            variance = np.einsum("kn,nxky->kxy", ranked, solved)
            jump = rows @ self._local
            answer = np.linalg.solve(variance, jump[:, :, None])[:, :, 0]
            result[first : first + 100] = np.sum(jump * answer, axis=1)
        return result

    def _jumps(self) -> sparse.csr_matrix:
        """Matrix (inner knots, n) of the jumps of the highest derivative."""
        p, t = self._degree, self._knots
        matrix = sparse.identity(len(t) - p - 1, format="csr")
        if self._periodic:
            fold = np.arange(matrix.shape[0]) % self._count
            matrix = sparse.csr_matrix(
                (np.ones(len(fold)), (np.arange(len(fold)), fold)), (len(fold), self._count)
            )
        for order in range(1, p + 1):
            slope = (p - order + 1) / (t[p + 1 : -order] - t[order : -p - 1])
            matrix = sparse.diags(slope) @ (matrix[1:] - matrix[:-1])
        return (matrix[1:] - matrix[:-1]).tocsr()
