# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fitted curves against the curves the points were made from."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.geometry import fit_curve

NOISE = 0.05


def helix(s):
    return np.column_stack([20 * np.cos(6 * s), 20 * np.sin(6 * s), 30 * s])


def straight(s):
    return np.column_stack([100 * s, 50 * s, 0 * s])


def bump(s):
    return np.column_stack([200 * s, 3 * np.exp(-(((s - 0.6) / 0.03) ** 2)), 0 * s])


def ring(s):
    a = 2 * np.pi * s
    return np.column_stack([30 * np.cos(a), 30 * np.sin(a), 3 * np.sin(2 * a)])


def measured(curve, count, sigma, seed=0, closed=False):
    truth = curve(np.linspace(0, 1, count, endpoint=not closed))
    return truth + np.random.default_rng(seed).normal(size=truth.shape) * sigma


def error(fitted, curve):
    """Root mean square distance of the true curve, per direction across it."""
    distance = fitted.closest(curve(np.linspace(0, 1, 2001)[10:-10]))[1]
    return np.sqrt(np.mean(distance**2) / 2)


@pytest.mark.parametrize(
    ("curve", "most_poles"), [(straight, 4), (helix, 14), (bump, 20), (ring, 16)]
)
@pytest.mark.parametrize("seed", range(3))
def test_the_curve_is_much_closer_to_the_truth_than_its_points(curve, most_poles, seed):
    closed = curve is ring
    fitted = fit_curve(measured(curve, 400, NOISE, seed, closed), NOISE, closed=closed)
    assert error(fitted, curve) < 0.35 * NOISE
    assert len(fitted.poles) <= most_poles


@pytest.mark.parametrize("curve", [straight, helix, bump, ring])
def test_the_curve_keeps_within_the_stated_sigma(curve):
    closed = curve is ring
    points = measured(curve, 400, NOISE, 7, closed)
    distance = fit_curve(points, NOISE, closed=closed).closest(points)[1]
    assert 0.9 < np.sqrt(np.mean((distance / NOISE) ** 2) / 2) < 1.05


def test_a_closed_curve_is_twice_smooth_at_its_seam():
    fitted = fit_curve(measured(ring, 200, NOISE, closed=True), NOISE, closed=True)
    first, last = fitted.parameter_range
    assert fitted.periodic
    for order in range(3):
        assert np.allclose(*fitted.derivative([first, last - 1e-9], order), atol=1e-8)


def test_a_repeated_last_point_of_a_closed_curve_changes_nothing():
    points = measured(ring, 50, NOISE, closed=True)
    again = fit_curve(np.vstack([points, points[:1]]), NOISE, closed=True)
    assert np.allclose(again.poles, fit_curve(points, NOISE, closed=True).poles)


def test_the_curve_spans_its_points_from_first_to_last():
    points = measured(helix, 300, NOISE)
    ends = fit_curve(points, NOISE).evaluate([-1e9, 1e9])
    assert np.linalg.norm(ends - points[[0, -1]], axis=1).max() < 3 * NOISE


def test_parameters_are_close_to_the_arc_length_even_of_dense_noisy_points():
    fitted = fit_curve(measured(helix, 1000, 0.5), 0.5)
    first, last = fitted.parameter_range
    assert last - first == pytest.approx(np.hypot(120, 30), rel=0.15)
    assert error(fitted, helix) < 0.35 * 0.5


def test_points_of_great_sigma_do_not_pull():
    rng = np.random.default_rng(4)
    sigma = np.where(rng.random(300) < 0.3, 3.0, 0.01)
    truth = helix(np.linspace(0, 1, 300))
    points = truth + rng.normal(size=truth.shape) * sigma[:, None]
    assert error(fit_curve(points, sigma), helix) < 0.01
    sigma[sigma > 1] = np.inf
    assert error(fit_curve(points, sigma), helix) < 0.01


def test_an_uncertain_direction_across_does_not_spoil_the_certain_one():
    s = np.linspace(0, 1, 300)
    out = np.column_stack([np.cos(s), np.sin(s), 0 * s])
    along = np.column_stack([-np.sin(s), np.cos(s), 0 * s])
    up = np.tile([0.0, 0.0, 1.0], (300, 1))
    rng = np.random.default_rng(0)
    truth = 50 * out
    points = truth + out * rng.normal(size=(300, 1)) * 0.01 + up * rng.normal(size=(300, 1)) * 0.3
    covariance = 0.01**2 * out[:, :, None] * out[:, None] + 0.3**2 * up[:, :, None] * up[:, None]
    for tangents in (None, along):
        fitted = fit_curve(points, 0.3, covariance, tangents)
        away = fitted.evaluate(fitted.closest(truth)[0]) - truth
        assert np.sqrt(np.mean(np.sum(away * out, axis=1) ** 2)) < 0.005
        assert len(fitted.poles) < 9


def test_misfit_along_the_curve_costs_no_poles():
    s = np.linspace(0, 1, 300)
    s = s + 0.01 * np.sin(40 * s)
    assert len(fit_curve(straight(s), 0.001).poles) == 4


def test_too_small_sigmas_do_not_make_it_follow_the_noise():
    fitted = fit_curve(measured(helix, 300, NOISE), NOISE / 5)
    assert error(fitted, helix) < 0.5 * NOISE
    assert len(fitted.poles) < 40


def test_there_is_at_most_about_one_pole_for_three_points():
    fitted = fit_curve(measured(helix, 200, 0.5), 1e-6)
    assert len(fitted.poles) <= 200 / 3 + 3


def test_a_tolerance_is_kept_and_a_wide_one_takes_fewer_poles():
    points = helix(np.linspace(0, 1, 400))
    fine = fit_curve(points, NOISE, tolerance=1e-3)
    coarse = fit_curve(points, NOISE, tolerance=0.1)
    assert fine.closest(points)[1].max() <= 1e-3
    assert coarse.closest(points)[1].max() <= 0.1
    assert len(coarse.poles) < len(fine.poles)


@pytest.mark.parametrize(("count", "degree"), [(2, 1), (3, 2), (4, 3), (5, 3), (7, 3)])
def test_few_points_make_a_curve_of_the_degree_they_allow(count, degree):
    points = helix(np.linspace(0, 0.1, count))
    fitted = fit_curve(points, 0.01)
    assert fitted.degree == degree
    assert fitted.closest(points)[1].max() < 0.02


def test_repeated_points_and_zero_sigmas_are_no_trouble():
    points = np.repeat(helix(np.linspace(0, 0.3, 30)), 3, axis=0)
    assert fit_curve(points, 0.0).closest(points)[1].max() < 1e-3
    sigma = np.tile([0.0, 0.01, 1.0], 30)
    assert fit_curve(points, sigma).closest(points)[1].max() < 1e-2


def test_far_from_the_origin_the_curve_is_the_same():
    points = measured(helix, 100, NOISE)
    far = np.array([1e6, -2e6, 3e5])
    near = fit_curve(points, NOISE)
    assert np.allclose(fit_curve(points + far, NOISE).poles - far, near.poles, atol=1e-5)


def test_a_gap_is_bridged_smoothly():
    s = np.r_[np.linspace(0, 0.45, 100), np.linspace(0.6, 1, 90)]
    points = helix(s) + np.random.default_rng(1).normal(size=(190, 3)) * 0.01
    fitted = fit_curve(points, 0.01)
    assert fitted.closest(helix(np.linspace(0.45, 0.6, 50)))[1].max() < 0.3


def test_what_cannot_be_fitted_is_refused():
    with pytest.raises(ValueError, match="1 different points"):
        fit_curve(np.ones((5, 3)), 0.1)
    with pytest.raises(ValueError, match="at least 3"):
        fit_curve(np.eye(3)[:2], 0.1, closed=True)
    with pytest.raises(ValueError, match="finite"):
        fit_curve(np.eye(3), np.inf)
    with pytest.raises(ValueError, match="covariances"):
        fit_curve(np.eye(3), 0.1, np.eye(3))
