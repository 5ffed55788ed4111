# SPDX-License-Identifier: LGPL-2.1-or-later
"""Least squares for the rails and profiles of the blend model.

Schreve 6.6.3: with parameters and γ(v) known the surface is linear in the poles of rails and
profiles (eq. 6.6.2.7), which share their corners. γ (eq. 6.6.2.12) is taken from the base surface's
profiles, and once more from the fitted ones.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..geometry import BSplineCurve
from .spline_poles import basis_values, poles_through
from .swept_surface import SweepModel, SweptSurface

__all__ = ["BlendFit"]

Array = NDArray[np.float64]

_DEGREE = 3
_HELD = 1e-6  # weight that holds poles no point supports, relative to the points'


class BlendFit:
    """Rails and profiles over given knots, first those of a base sweep, then fitted ones."""

    def __init__(self, base: SweptSurface, along: Array, across: Array) -> None:
        self._along, self._across = along, across
        n, m = len(along) - _DEGREE - 1, len(across) - _DEGREE - 1
        # numbers of the unknown poles: rails first, then the profiles without the corners
        rails = np.arange(2 * n).reshape(2, n)
        inner = 2 * n + np.arange(2 * (m - 2)).reshape(2, m - 2)
        profiles = [
            np.r_[rails[0, end], inner[k], rails[1, end]] for k, end in ((0, 0), (1, n - 1))
        ]
        self._rails, self._profiles = rails, np.array(profiles)
        self.poles: Array = self._start(base, 2 * n + 2 * (m - 2))
        self.sweep = base

    def _start(self, base: SweptSurface, count: int) -> Array:
        share = np.linspace(0.0, 1.0, 20 * (len(self._along) + len(self._across)))
        poles = np.zeros((count, 3))
        for k, v in enumerate((0.0, 1.0)):
            rail = base.evaluate(share, v)
            poles[self._rails[k]] = poles_through(self._along, _DEGREE, share, rail)
        for k, u in enumerate((0.0, 1.0)):
            profile = poles_through(self._across, _DEGREE, share, base.evaluate(u, share))
            poles[self._profiles[k][1:-1]] = profile[1:-1]
        return poles

    def improve(self, points: Array, u: Array, v: Array) -> None:
        """Solve for the poles, with γ of the present sweep."""
        basis = self._basis(u, v, self.sweep.gamma(v))
        matrix = basis.T @ basis
        held = _HELD * np.trace(matrix) / len(matrix)
        matrix[np.diag_indices_from(matrix)] += held
        self.poles = self.poles + np.linalg.solve(matrix, basis.T @ (points - basis @ self.poles))
        self.sweep = self._as_sweep()

    def _basis(self, u: Array, v: Array, gamma: Array) -> Array:
        """Eq. 6.6.2.6: what each pole counts at the parameters, (m, poles)."""
        rails = basis_values(self._along, _DEGREE, u)
        rails[:, 0] -= 1.0 - u
        rails[:, -1] -= u
        profiles = basis_values(self._across, _DEGREE, v)
        result = np.zeros((len(u), len(self.poles)))
        for number, share in zip(self._rails, (1.0 - v, v), strict=True):
            result[:, number] += (share * gamma)[:, None] * rails
        for number, share in zip(self._profiles, (1.0 - u, u), strict=True):
            result[:, number] += share[:, None] * profiles
        return result

    def _as_sweep(self) -> SweptSurface:
        rails = [BSplineCurve(self.poles[number], self._along) for number in self._rails]
        profiles = [BSplineCurve(self.poles[number], self._across) for number in self._profiles]
        return SweptSurface((rails[0], rails[1]), tuple(profiles), SweepModel.BLEND)
