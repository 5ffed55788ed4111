# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fitted circles against the circles the points were made from."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.geometry import Circle, fit_circle

TRUTH = Circle(
    np.array([100.0, -50.0, 7.0]), np.array([0.6, 0.0, 0.8]), 35.0, np.array([0.8, 0.0, -0.6])
)


def noisy_arc(angle, count, sigma, seed=0):
    noise = np.random.default_rng(seed).normal(size=(count, 3)) * sigma
    return TRUTH.evaluate(np.linspace(0.3, 0.3 + angle, count)) + noise


@pytest.mark.parametrize("angle", [0.05, 0.5, 3.0, 6.0])
def test_points_of_an_arc_give_its_circle(angle):
    fit = fit_circle(noisy_arc(angle, 50, 0.0))
    assert np.allclose(fit.circle.centre, TRUTH.centre, atol=1e-4)
    assert np.allclose(fit.circle.axis, TRUTH.axis, atol=1e-5)
    assert fit.circle.radius == pytest.approx(35, abs=1e-4)


def test_angles_start_at_the_first_point_and_grow():
    points = noisy_arc(5.0, 40, 0.0)
    circle = fit_circle(points[::-1]).circle
    assert np.allclose(circle.axis, -TRUTH.axis)
    assert np.allclose(circle.angles(points[::-1]), np.linspace(0, 5, 40), atol=1e-6)
    assert np.allclose(circle.evaluate(np.linspace(0, 5, 40)), points[::-1], atol=1e-5)


@pytest.mark.parametrize("angle", [0.3, 1.5, 6.2])
def test_chi_square_is_the_number_of_degrees_of_freedom(angle):
    ratios = []
    for seed in range(20):
        fit = fit_circle(noisy_arc(angle, 60, 0.05, seed), 0.05)
        ratios.append(fit.chi_square / fit.freedom)
    assert np.mean(ratios) == pytest.approx(1, abs=0.08)


def test_radius_of_a_short_noisy_arc_is_not_biased():
    radii = [fit_circle(noisy_arc(0.6, 200, 0.05, seed)).circle.radius for seed in range(30)]
    assert np.mean(radii) == pytest.approx(35, abs=3 * np.std(radii) / np.sqrt(30) + 0.02)


def test_wild_points_count_by_their_sigma():
    points = noisy_arc(2.0, 60, 0.01)
    sigma = np.full(60, 0.01)
    points[::5] += np.random.default_rng(1).normal(size=(12, 3)) * 2
    sigma[::5] = 2
    assert fit_circle(points, sigma).circle.radius == pytest.approx(35, abs=0.02)


def test_three_points_have_one_circle():
    fit = fit_circle([[1, 0, 0], [0, 1, 0], [-1, 0, 0]])
    assert np.allclose(fit.circle.centre, 0, atol=1e-9)
    assert fit.circle.radius == pytest.approx(1)


def test_points_on_a_line_have_no_circle():
    for points in (np.outer(np.arange(9.0), [1, 2, 3]), np.ones((5, 3))):
        with pytest.raises(ValueError, match="straight line"):
            fit_circle(points)
