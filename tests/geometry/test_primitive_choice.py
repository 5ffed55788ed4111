# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines are taken for lines, circles for circles, and nothing else for either."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.geometry import Circle, Line, common_plane, simplest_curve

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


# ---------------------------------------------------------------- a common plane


def meander(count, out_of_plane=0.0):
    """A curve that bends both ways, and leaves its plane along a slow wave, mm."""
    u = np.linspace(0.0, 2.0 * np.pi, count)
    return np.column_stack([10.0 * u, 8.0 * np.sin(u), out_of_plane * np.sin(1.5 * u)])


def planes(truth, alike=1, trials=100, closed=False):
    covariance = np.tile(SIGMA**2 * np.eye(3), (len(truth), 1, 1))
    return [
        common_plane(truth + noise(len(truth), seed, alike), covariance, closed)
        for seed in range(trials)
    ]


@pytest.mark.parametrize("alike", [1, 5, 20])
@pytest.mark.parametrize("count", [3, 10, 100, 400])
def test_a_plane_curve_has_a_plane(count, alike):
    found = planes(meander(count), alike)
    assert sum(plane is not None for plane in found) >= 99
    if count >= 100:
        assert all(abs(plane.normal[2]) > 0.999 for plane in found if plane is not None)


@pytest.mark.parametrize("count", [100, 400])
def test_a_curve_that_leaves_its_plane_by_a_few_sigma_has_none(count):
    assert all(plane is None for plane in planes(meander(count, 4.0 * SIGMA)))
    assert all(plane is None for plane in planes(meander(count, 1.0)))


def test_a_closed_plane_curve_has_a_plane():
    assert all(
        plane is not None for plane in planes(arc(101, 30.0, 60.0 * np.pi)[:-1], closed=True)
    )


def test_what_is_known_badly_out_of_the_plane_does_not_forbid_it():
    """An edge point may be known ten times worse in one direction across the edge."""
    truth = meander(200)
    off = noise(200, 1) * [1.0, 1.0, 10.0]
    even, true = np.diag([1.0, 1.0, 1.0]), np.diag([1.0, 1.0, 100.0])
    assert common_plane(truth + off, np.tile(SIGMA**2 * even, (200, 1, 1))) is None
    assert common_plane(truth + off, np.tile(SIGMA**2 * true, (200, 1, 1))) is not None


def test_exact_points_and_unknown_ones():
    none = np.zeros((50, 3, 3))
    assert common_plane(meander(50), none) is not None
    assert common_plane(meander(50, 0.1), none) is None
    assert common_plane(meander(50), np.full((50, 3, 3), np.nan)) is None
    assert common_plane(meander(2), none[:2]) is None
