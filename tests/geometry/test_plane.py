# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plane of least squares."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import minimize

from freecad_edgescan.geometry import fit_plane


def test_points_of_a_plane_lie_in_it():
    rng = np.random.default_rng(1)
    normal = np.array([2.0, -1.0, 2.0]) / 3.0
    x = rng.normal(size=(30, 3)) * 5.0
    x += (4.0 - x @ normal)[:, None] * normal
    plane = fit_plane(x)
    assert abs(plane.normal @ normal) == pytest.approx(1.0)
    assert np.abs(plane.residuals(x)).max() < 1e-12
    assert plane.residuals(x + 0.3 * normal) == pytest.approx(np.tile(0.3 * normal, (30, 1)))


def test_no_other_plane_has_a_smaller_weighted_sum_of_squares():
    rng = np.random.default_rng(2)
    x, sigma = rng.normal(size=(40, 3)) * [5.0, 4.0, 0.3], rng.uniform(0.1, 1.0, 40)
    plane = fit_plane(x, sigma)

    def squares(values):
        normal = np.array([values[0], values[1], 1.0])
        off = (x @ normal - values[2]) / np.linalg.norm(normal)
        return float(np.square(off / sigma).sum())

    least = minimize(squares, [0.0, 0.0, 0.0], tol=1e-12).fun
    found = np.square(np.linalg.norm(plane.residuals(x), axis=1) / sigma).sum()
    assert found == pytest.approx(least, rel=1e-6)


def test_two_points_are_too_few():
    with pytest.raises(ValueError, match="three or more"):
        fit_plane(np.zeros((2, 3)))
