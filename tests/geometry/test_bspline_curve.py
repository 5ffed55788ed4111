# SPDX-License-Identifier: LGPL-2.1-or-later
"""B-spline curves against finite differences, brute force, and curves known exactly."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.geometry import BSplineCurve


def any_curve(kind, seed=3):
    rng = np.random.default_rng(seed)
    poles = np.cumsum(rng.normal(size=(12, 3)) * 4, axis=0)
    weights = rng.uniform(0.5, 2, 12) if "rational" in kind else None
    if "periodic" in kind:
        knots = np.cumsum(rng.uniform(0.5, 2, 13))
        return BSplineCurve.from_distinct_knots(poles, knots, [1] * 13, 3, True, weights)
    knots = np.r_[[0.0] * 4, np.cumsum(rng.uniform(0.5, 2, 8)), [20.0] * 4]
    return BSplineCurve(poles, knots, 3, False, weights)


KINDS = ["clamped", "periodic", "clamped rational", "periodic rational"]


def quarter_circle(radius=5.0):
    poles = radius * np.array([[1, 0, 0], [1, 1, 0], [0, 1, 0]])
    return BSplineCurve(poles, [0, 0, 0, 1, 1, 1], 2, weights=[1, np.sqrt(0.5), 1])


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("order", [1, 2, 3])
def test_derivatives_are_the_limits_of_differences(kind, order):
    curve = any_curve(kind)
    first, last = curve.parameter_range
    u = np.linspace(first + 0.1, last - 0.1, 41)
    u = u[np.abs(u[:, None] - curve.knots).min(axis=1) > 0.01]
    lower, higher = (curve.derivative(u + h, order - 1) for h in (-1e-4, 1e-4))
    exact = curve.derivative(u, order)
    assert np.allclose((higher - lower) / 2e-4, exact, atol=1e-5 * np.abs(exact).max())


@pytest.mark.parametrize("kind", KINDS)
def test_closest_point_is_that_of_a_dense_search(kind):
    curve = any_curve(kind)
    rng = np.random.default_rng(5)
    points = curve.sample(300) + rng.normal(size=(300, 3)) * rng.choice([0.01, 1, 10], (300, 1))
    u, distance = curve.closest(points)
    dense = curve.sample(20001)
    brute = np.array([np.linalg.norm(dense - p, axis=1).min() for p in points])
    assert np.all(distance <= brute + 1e-9)
    assert np.all(distance >= brute - 0.01)
    assert np.allclose(np.linalg.norm(curve.evaluate(u) - points, axis=1), distance)


def test_a_point_of_the_curve_is_at_no_distance_from_it():
    curve = any_curve("periodic")
    u = np.linspace(*curve.parameter_range, 100)[1:-1]
    found, distance = curve.closest(curve.evaluate(u))
    assert np.allclose(found, u) and distance.max() < 1e-9


def test_beyond_the_ends_the_end_is_closest():
    curve = BSplineCurve([[0, 0, 0], [10, 0, 0]], [0, 0, 1, 1], 1)
    u, distance = curve.closest([[-3, 4, 0], [13, 4, 0]])
    assert u.tolist() == [0, 1] and np.allclose(distance, 5)


def test_a_periodic_curve_is_twice_smooth_at_its_seam():
    curve = any_curve("periodic rational")
    first, last = curve.parameter_range
    for order in range(3):
        before, after = curve.derivative([last - 1e-9, first + 1e-9], order)
        assert np.allclose(before, after, atol=1e-6)


def test_a_periodic_curve_goes_on_where_it_began():
    curve = any_curve("periodic")
    first, last = curve.parameter_range
    u = np.linspace(first, last, 10)
    assert np.allclose(curve.evaluate(u + 3 * (last - first)), curve.evaluate(u))


def test_a_rational_quadratic_is_an_exact_circle():
    arc = quarter_circle()
    u = np.linspace(0, 1, 20)
    assert np.allclose(np.linalg.norm(arc.evaluate(u), axis=1), 5)
    assert np.allclose(arc.curvature(u), 0.2)
    assert np.allclose(arc.curvature_vector(u), -arc.evaluate(u) / 25)
    assert np.allclose(np.sum(arc.tangent(u) * arc.evaluate(u), axis=1), 0)
    assert arc.length() == pytest.approx(5 * np.pi / 2)


def test_steps_by_length_are_equally_long():
    arc = quarter_circle()
    points = arc.sample_by_length(0.5)
    assert len(points) == 17
    assert np.ptp(np.linalg.norm(np.diff(points, axis=0), axis=1)) < 1e-9
    turn = arc.parameters_at_length([5 * np.pi / 4])
    assert np.allclose(arc.evaluate(turn), 5 * np.sqrt(0.5) * np.array([1, 1, 0]))


def test_sampling_a_periodic_curve_repeats_no_point():
    points = any_curve("periodic").sample_by_length(1.0)
    assert np.linalg.norm(points[0] - points[-1]) > 0.5


@pytest.mark.parametrize("kind", KINDS)
def test_reversed_curve_is_the_same_curve_backwards(kind):
    curve = any_curve(kind)
    u = np.linspace(*curve.parameter_range, 50)
    assert np.allclose(curve.reversed().evaluate(u[::-1]), curve.evaluate(u))


def test_knots_once_with_multiplicities_give_the_curve_back():
    for kind in KINDS:
        curve = any_curve(kind)
        knots, counts = curve.distinct_knots_and_multiplicities()
        again = BSplineCurve.from_distinct_knots(
            curve.poles, knots, counts, 3, curve.periodic, curve.weights
        )
        assert np.allclose(again.knots, curve.knots)
        assert np.all(np.diff(knots) > 0)


def test_multiplicities_of_a_clamped_curve_sum_to_its_knots_and_of_a_periodic_one_to_its_poles():
    assert any_curve("clamped").distinct_knots_and_multiplicities()[1].sum() == 12 + 3 + 1
    assert any_curve("periodic").distinct_knots_and_multiplicities()[1][:-1].sum() == 12


def test_a_double_seam_knot_keeps_the_curve():
    rng = np.random.default_rng(2)
    poles, knots, counts = rng.normal(size=(9, 3)), [0, 1, 3, 4, 6, 8, 10], [2, 1, 2, 1, 1, 2, 2]
    curve = BSplineCurve.from_distinct_knots(poles, knots, counts, 3, True)
    assert curve.distinct_knots_and_multiplicities()[1].tolist() == counts
    assert np.allclose(curve.evaluate(0), curve.evaluate(10 - 1e-12))
    assert np.allclose(curve.reversed().evaluate(2.5), curve.evaluate(7.5))


def test_what_does_not_belong_together_is_refused_with_numbers():
    with pytest.raises(ValueError, match="need 6 knots, not 5"):
        BSplineCurve(np.zeros((3, 3)), [0, 0, 1, 1, 1], 2)
    with pytest.raises(ValueError, match="at least 4 poles, not 3"):
        BSplineCurve(np.zeros((3, 3)), [0, 0, 1, 1, 1], 3)
    with pytest.raises(ValueError, match="must not decrease"):
        BSplineCurve(np.zeros((2, 3)), [0, 1, 0, 1], 1)
    with pytest.raises(ValueError, match="positive numbers"):
        BSplineCurve(np.zeros((2, 3)), [0, 0, 1, 1], 1, weights=[1, -1])
    with pytest.raises(ValueError, match="positive length"):
        any_curve("clamped").sample_by_length(0)
