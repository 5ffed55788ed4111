# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fitted lines against the lines the points were made from."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.geometry import fit_line

DIRECTION = np.array([2.0, -1.0, 2.0]) / 3.0


def test_points_of_a_line_give_that_line_without_residuals():
    fit = fit_line(np.array([5, 6, 7]) + np.outer([0, 1, 4, 9], DIRECTION))
    assert np.allclose(fit.line.direction, DIRECTION)
    assert np.abs(fit.residuals).max() < 1e-14 and fit.freedom == 4


def test_chi_square_is_the_number_of_degrees_of_freedom():
    rng = np.random.default_rng(0)
    sigma = rng.uniform(0.01, 0.1, 500)
    points = (
        np.outer(np.linspace(0, 50, 500), DIRECTION) + rng.normal(size=(500, 3)) * sigma[:, None]
    )
    fit = fit_line(points, sigma)
    assert fit.chi_square / fit.freedom == pytest.approx(1, abs=0.15)
    assert np.linalg.norm(np.cross(fit.line.direction, DIRECTION)) < 5e-4


def test_precise_points_count_more_than_wild_ones():
    points = np.array([[0, 0, 0], [5, 1, 0], [10, 0, 0.0]])
    fit = fit_line(points, [0.001, 1, 0.001])
    assert fit.line.closest(points)[1][[0, 2]].max() < 1e-5


def test_the_line_runs_from_the_first_to_the_last_point():
    points = np.outer([9, 4, 1, 0], DIRECTION)
    assert np.allclose(fit_line(points).line.direction, -DIRECTION)


def test_places_along_the_line_lead_back_to_the_points():
    points = np.outer([0, 2, 7.0], DIRECTION)
    line = fit_line(points).line
    along, distance = line.closest(points)
    assert np.allclose(line.evaluate(along), points) and np.allclose(distance, 0)


def test_equal_points_and_bad_sigmas_are_refused():
    with pytest.raises(ValueError, match="equal"):
        fit_line(np.ones((4, 3)))
    with pytest.raises(ValueError, match="two or more"):
        fit_line(np.ones((1, 3)))
    with pytest.raises(ValueError, match=r"sigma of point 1 is -1"):
        fit_line(np.eye(3), [1, -1, 1])
    with pytest.raises(ValueError, match="one for each point"):
        fit_line(np.eye(3), [1, 1])
