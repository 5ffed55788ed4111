# SPDX-License-Identifier: LGPL-2.1-or-later
"""A tensor-product spline as polynomial patches, evaluated for many parameters at once.

Each patch is written in powers of its own parameters, which run from -1 to 1. Parameters are
sorted by patch; then all values and derivatives of one patch are one product of matrices.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np
from numpy.polynomial import polynomial
from numpy.typing import NDArray

from freecad_edgescan.geometry.blossom import poles_over_knots

__all__ = ["PolynomialPatches"]

Array = NDArray[np.float64]

_AT_ONCE = 8192  # parameters, so that their powers stay in the processor's cache


class PolynomialPatches:
    """The patches of a spline surface.

    Parameters
    ----------
    poles : (nu, nv, d) array
    knots : clamped knots in both directions
    degree : degrees in both directions

    Attributes
    ----------
    breaks : distinct knots in both directions
    shape : number of patches in both directions
    """

    def __init__(self, poles: Array, knots: tuple[Array, Array], degree: tuple[int, int]) -> None:
        self.breaks = (np.unique(knots[0]), np.unique(knots[1]))
        self.shape = (len(self.breaks[0]) - 1, len(self.breaks[1]) - 1)
        self._order = (degree[0] + 1, degree[1] + 1)
        self._tables: dict[tuple[tuple[int, int], ...], Array] = {}
        coefficients = _powers_along(poles, knots[0], degree[0], self.breaks[0])
        coefficients = np.moveaxis(coefficients, 2, 0)
        coefficients = _powers_along(coefficients, knots[1], degree[1], self.breaks[1])
        self._coefficients = coefficients.transpose(2, 0, 3, 1, 4)  # patches, powers, d

    def table(self, *orders: tuple[int, int]) -> Array:
        """Coefficients (patches, len(orders) * d, powers) of the derivatives of these orders."""
        if orders not in self._tables:
            derived = [self._derived(*order) for order in orders]
            patches = self.shape[0] * self.shape[1]
            powers = self._order[0] * self._order[1]
            joined = np.stack(derived, axis=-2).reshape(patches, powers, -1)
            self._tables[orders] = np.ascontiguousarray(joined.transpose(0, 2, 1))
        return self._tables[orders]

    def _derived(self, du: int, dv: int) -> Array:
        result = self._coefficients
        for axis, order in enumerate((du, dv)):
            scale = 2.0 / np.diff(self.breaks[axis])
            scale = scale.reshape([-1 if place == axis else 1 for place in range(5)])
            for _ in range(order):
                result = np.moveaxis(result, axis + 2, 0)
                raised = np.zeros_like(result)
                raised[:-1] = result[1:] * np.arange(1, len(result))[:, None, None, None, None]
                result = np.moveaxis(raised, 0, axis + 2) * scale
        return result

    def patch_of(self, u: Array, v: Array) -> NDArray[np.intp]:
        """Number of the patch in which parameters (m,), (m,) lie; at a knot the later one."""
        place = [
            np.clip(np.searchsorted(breaks, x, side="right") - 1, 0, len(breaks) - 2)
            for breaks, x in zip(self.breaks, (u, v), strict=True)
        ]
        return np.asarray(place[0] * self.shape[1] + place[1])

    def groups(self, patch: NDArray[np.intp]) -> Iterator[tuple[int, NDArray[np.intp]]]:
        """Each patch's number with the rows that lie in it, at most some thousand at a time."""
        if len(patch) == 1:
            yield int(patch[0]), np.zeros(1, dtype=np.intp)
            return
        count = self.shape[0] * self.shape[1]
        order = np.argsort(patch.astype(np.uint16 if count < 65536 else np.intp), kind="stable")
        edges = np.append(np.flatnonzero(np.diff(patch[order], prepend=-1)), len(order))
        for first, end in pairwise(edges):
            number = int(patch[order[first]])
            for start in range(first, end, _AT_ONCE):
                yield number, order[start : min(start + _AT_ONCE, end)]

    def powers(self, number: int, u: Array, v: Array) -> Array:
        """Products (powers, m) of the powers of a patch's own parameters."""
        row, column = divmod(number, self.shape[1])
        one = _powers(u, self.breaks[0][row : row + 2], self._order[0])
        other = _powers(v, self.breaks[1][column : column + 2], self._order[1])
        return (one[:, None] * other).reshape(-1, len(u))

    def evaluate(self, u: Array, v: Array, orders: Sequence[tuple[int, int]]) -> Array:
        """Derivatives (len(orders), d, m) at parameters (m,), (m,) within the range."""
        table = self.table(*orders)
        result = np.empty((table.shape[1], len(u)))
        for number, rows in self.groups(self.patch_of(u, v)):
            result[:, rows] = table[number] @ self.powers(number, u[rows], v[rows])
        return result.reshape(len(orders), table.shape[1] // len(orders), len(u))


def _powers(x: Array, limits: Array, order: int) -> Array:
    """Powers (order, m) of parameters, scaled from the limits to -1 … 1."""
    local = (2.0 * x - limits[0] - limits[1]) / (limits[1] - limits[0])
    powers = np.ones((order, len(x)))
    for exponent in range(1, order):
        np.multiply(powers[exponent - 1], local, out=powers[exponent])
    return powers


def _powers_along(poles: Array, knots: Array, degree: int, breaks: Array) -> Array:
    """Coefficients (pieces, degree + 1, ...) of the pieces along the first axis of the poles."""
    pieces = np.repeat(breaks, degree + 1)
    flat = poles_over_knots(knots, degree, poles.reshape(len(poles), -1), pieces)
    bezier = flat.reshape(len(breaks) - 1, degree + 1, -1)
    powers = np.einsum("kb,pbd->pkd", _bernstein_in_powers(degree), bezier)
    return powers.reshape(len(breaks) - 1, degree + 1, *poles.shape[1:])


def _bernstein_in_powers(degree: int) -> Array:
    """Column b: coefficients of Bernstein's polynomial b of x in [-1, 1], in powers of x."""
    columns = []
    share = 1.0
    for b in range(degree + 1):
        column = np.array([share])
        for _ in range(b):
            column = polynomial.polymul(column, [0.5, 0.5])
        for _ in range(degree - b):
            column = polynomial.polymul(column, [0.5, -0.5])
        columns.append(column)
        share = share * (degree - b) / (b + 1)
    return np.stack(columns, axis=1)
