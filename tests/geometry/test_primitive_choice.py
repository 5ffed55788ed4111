# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines are taken for lines, circles for circles, and nothing else for either."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.geometry import Circle, Line, simplest_curve

SIGMA = 0.02


def straight(count):
    return np.outer(np.linspace(0, 50, count), [0.6, 0.8, 0.0])


def arc(count, radius, length=50.0):
    a = np.linspace(0, length / radius, count)
    return radius * np.column_stack([np.cos(a), np.sin(a), 0 * a])


def noise(count, seed, alike=1):
    """Noise of standard deviation SIGMA, in which so many neighbours share their error."""
    white = np.random.default_rng(seed).normal(size=(count + alike - 1, 3))
    kernel = np.ones(alike) / np.sqrt(alike)
    return SIGMA * np.column_stack([np.convolve(w, kernel, "valid") for w in white.T])


def share(kind, truth, alike=1, sigma=SIGMA, trials=100, closed=False):
    found = [
        simplest_curve(truth + noise(len(truth), seed, alike), sigma, closed)
        for seed in range(trials)
    ]
    return sum(isinstance(each, kind) for each in found) / trials


@pytest.mark.parametrize("alike", [1, 5, 20])
@pytest.mark.parametrize("count", [3, 10, 100, 400])
def test_a_true_line_is_a_line(count, alike):
    assert share(Line, straight(count), alike) >= 0.99


@pytest.mark.parametrize("alike", [1, 5])
@pytest.mark.parametrize("count", [10, 100, 400])
def test_a_true_arc_is_a_circle(count, alike):
    assert share(Circle, arc(count, 30.0), alike) >= 0.99


def test_a_full_circle_is_a_circle_and_never_a_line():
    truth = arc(101, 30.0, 2 * np.pi * 30)[:-1]
    assert share(Circle, truth, closed=True) >= 0.99


def test_a_closed_curve_is_no_line():
    assert simplest_curve(straight(50), SIGMA, closed=True) is None


def test_a_short_flat_arc_is_the_line_that_explains_it_as_well():
    assert share(Line, arc(60, 50_000.0)) == 1


@pytest.mark.parametrize("radius", [100.0, 500.0, 2000.0])
def test_an_arc_whose_height_is_many_sigma_is_no_line(radius):
    assert share(Line, arc(60, radius)) == 0


def test_a_radius_of_a_hundred_lengths_is_no_circle():
    assert share(Circle, arc(400, 5000.0)) == 0


def test_systematic_misfit_below_the_noise_level_of_many_points_is_seen():
    truth = straight(400)
    truth[:, 2] = 1.5 * SIGMA * np.sin(np.linspace(0, 4 * np.pi, 400))
    assert share((Line, Circle), truth) < 0.05


def test_an_ellipse_and_a_bent_out_of_plane_arc_are_no_circles():
    a = np.linspace(0, 2 * np.pi, 200, endpoint=False)
    ellipse = np.column_stack([30 * np.cos(a), 29.9 * np.sin(a), 0 * a])
    assert share((Line, Circle), ellipse, closed=True) == 0
    assert share((Line, Circle), arc(200, 30.0) + np.outer(np.sin(a), [0, 0, 0.1])) == 0


def test_somewhat_too_small_sigmas_do_not_hide_a_line():
    assert share(Line, straight(100), sigma=SIGMA / 1.3) >= 0.99
    assert share(Line, straight(100), sigma=SIGMA / 3) == 0


def test_two_points_are_a_line_and_equal_points_are_nothing():
    assert isinstance(simplest_curve([[0, 0, 0], [1, 2, 3]], SIGMA), Line)
    assert simplest_curve(np.ones((10, 3)), SIGMA) is None
