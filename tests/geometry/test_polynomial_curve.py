# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plane polynomials against exact curves, a general optimiser and all roots of a resultant."""

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from freecad_edgescan.geometry.polynomial_curve import (
    OffsetCurve,
    PolynomialCurve,
    fit_polynomial,
    meeting_parameters,
)


def curve(*coefficients):
    c = np.array(coefficients, dtype=float)
    return PolynomialCurve(c, np.eye(len(c)))


@pytest.mark.parametrize("degree", [1, 2, 3])
def test_points_on_a_line_are_fitted_exactly(degree):
    points = np.linspace(0, 1, 9)[:, None] * [3.0, -4.0] + [1.0, 2.0]
    fitted, u = fit_polynomial(points, degree)
    assert u == pytest.approx(np.linspace(0, 1, 9))
    assert fitted.at(u) == pytest.approx(points, abs=1e-12)
    assert fitted.derivative(0.3) == pytest.approx([3.0, -4.0], abs=1e-9)


def test_a_line_is_the_total_least_squares_line():
    rng = np.random.default_rng(4)
    points = rng.normal(size=(40, 2)) * [5.0, 0.7] @ [[0.6, 0.8], [-0.8, 0.6]]
    points = points[np.argsort(points @ [0.6, 0.8])]
    fitted, _ = fit_polynomial(points, 1)
    centred = points - points.mean(axis=0)
    axis = np.linalg.svd(centred)[2][0]
    way = fitted.coefficients[1] / np.linalg.norm(fitted.coefficients[1])
    assert abs(way @ axis) == pytest.approx(1.0, abs=1e-12)
    assert way @ (points[-1] - points[0]) > 0


@pytest.mark.parametrize("degree", [2, 3])
def test_a_polynomial_minimises_the_distance_at_the_chord_length_parameters(degree):
    rng = np.random.default_rng(5)
    x = np.linspace(0, 4, 12)
    points = np.column_stack([x, 0.2 * x**2]) + rng.normal(size=(12, 2)) * 0.05
    fitted, u = fit_polynomial(points, degree)
    lengths = np.append(0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
    assert u == pytest.approx(lengths / lengths[-1])
    for axis in range(2):
        assert fitted.coefficients[::-1, axis] == pytest.approx(
            np.polyfit(u, points[:, axis], degree), abs=1e-8
        )


@pytest.mark.parametrize("degree", [1, 2, 3])
def test_the_leverage_is_the_variance_of_the_curve_for_unit_noise(degree):
    rng = np.random.default_rng(6)
    x = np.linspace(0.0, 6.0, 9)
    points = np.column_stack([x, np.zeros(9)])
    at, heights = 1.3, []
    for _ in range(1500):
        noisy = points + np.column_stack([np.zeros(9), 1e-3 * rng.normal(size=9)])
        heights.append(fit_polynomial(noisy, degree)[0].at(at)[1])
    leverage = fit_polynomial(points, degree)[0].leverage(at)
    assert np.var(heights) / 1e-6 == pytest.approx(leverage, rel=0.15)


@pytest.mark.parametrize("degree", [1, 2, 3])
def test_the_closest_parameter_is_that_of_a_general_minimiser(degree):
    rng = np.random.default_rng(7)
    bent = curve([0, 0], [4, 1], [0.5, -1.5], [0.1, 0.6])
    bent = PolynomialCurve(bent.coefficients[: degree + 1], np.eye(degree + 1))
    start = rng.uniform(0, 1, 30)
    points = bent.at(start) + rng.normal(size=(30, 2)) * 0.1
    found = bent.closest(points, start)
    for point, u, near in zip(points, found, start, strict=True):
        best = minimize_scalar(
            lambda v, p=point: np.sum((bent.at(v) - p) ** 2),
            bounds=(near - 0.3, near + 0.3),
            method="bounded",
            options={"xatol": 1e-10},
        )
        assert u == pytest.approx(best.x, abs=1e-6)


def test_two_lines_meet_where_elimination_says():
    first, second = curve([0, 0], [2, 1]), curve([5, -1], [-1, 2])
    a, b = meeting_parameters(first, second)
    u = np.linalg.solve(np.array([[2.0, 1.0], [1.0, -2.0]]), [5.0, -1.0])
    assert (a, b) == pytest.approx(tuple(u))
    assert first.at(a) == pytest.approx(second.at(b))


def test_parallel_lines_do_not_meet():
    assert meeting_parameters(curve([0, 0], [2, 1]), curve([0, 1], [4, 2])) is None


def all_meetings(first, second):
    """Every real crossing of two plane quadratics: roots of their resultant."""
    # Implicit form of the second curve, by eliminating its parameter.
    (x0, y0), (x1, y1), (x2, y2) = second.coefficients
    found = []
    # x(u), y(u) of the first curve as polynomials, highest power first.
    x, y = (np.poly1d(first.coefficients[::-1, k]) for k in range(2))
    a, b = x - x0, y - y0
    one = a * y2 - b * x2  # = v (x1 y2 - y1 x2)
    two = a * y1 - b * x1  # = v² (x2 y1 - y2 x1)
    w = x1 * y2 - y1 * x2
    for u in (one * one + two * w).roots:
        if abs(u.imag) < 1e-9:
            v = one(u.real) / w
            found.append((u.real, v))
    return found


def test_quadratics_meet_where_their_resultant_says():
    rng = np.random.default_rng(8)
    met = 0
    for _ in range(200):
        first = curve([-4, 0], [3, 0.2 * rng.normal()], [0.2 * rng.normal(), 0.8 * rng.normal()])
        second = curve([0.6, -5], [0.2 * rng.normal(), 3], [rng.normal(), 0.3 * rng.normal()])
        found = meeting_parameters(first, second)
        truth = np.array(all_meetings(first, second)).reshape(-1, 2)
        if found is None:
            ahead = (truth > 0.8) & (truth < 3.9)
            assert not ahead.all(axis=1).any()
            continue
        met += 1
        assert np.abs(truth - found).max(axis=1).min() < 1e-6
    assert met > 100


def test_a_curve_that_crosses_the_other_one_twice_is_met_at_the_first_crossing():
    """The second curve bends back over the first one (Schreve figure 4.8)."""
    first = curve([-4.0, 0.0], [3.0, 0.0])
    # A parabola from above right: it crosses y = 0 near x = 0 first, and once more at x = -2.
    second = curve([2.2, 1.2], [-0.9, -2.2], [-1.1, 0.8])
    heights = np.roots(second.coefficients[::-1, 1])
    first_crossing = min(v for v in heights.real if v > 0.0)
    a, b = meeting_parameters(first, second)
    assert b == pytest.approx(first_crossing, abs=1e-9)
    assert first.at(a) == pytest.approx(second.at(b), abs=1e-9)


def test_an_offset_curve_keeps_its_distance_and_its_direction():
    bent = curve([0, 0], [4, 1], [0.5, -1.5])
    moved = OffsetCurve(bent, 0.3)
    u = np.linspace(0, 1, 11)
    gap = moved.at(u) - bent.at(u)
    way = bent.derivative(u)
    assert np.linalg.norm(gap, axis=1) == pytest.approx(0.3)
    assert np.einsum("ni,ni->n", gap, way) == pytest.approx(0.0, abs=1e-12)
    assert np.all(way[:, 0] * gap[:, 1] - way[:, 1] * gap[:, 0] > 0)
    numeric = (moved.at(u + 1e-6) - moved.at(u - 1e-6)) / 2e-6
    assert moved.derivative(u) == pytest.approx(numeric, abs=1e-7)


def test_offset_quarter_arcs_meet_where_the_offset_circles_do():
    """Two circles of radius 10 about (±6, 0) meet at (0, 8); their parallels at 2 mm as well."""
    for distance, height in ((0.0, 8.0), (2.0, np.sqrt(12.0**2 - 36.0))):
        curves = []
        for side in (-1.0, 1.0):
            angle = np.linspace(0.6, 0.9, 9) if side < 0 else np.pi - np.linspace(0.6, 0.9, 9)
            points = np.column_stack([6 * side + 10 * np.cos(angle), 10 * np.sin(angle)])
            fitted, _ = fit_polynomial(points, 3)
            # Outwards is to the right of a curve that runs anticlockwise, to the left of the other.
            curves.append(OffsetCurve(fitted, -distance if side < 0 else distance))
        a, b = meeting_parameters(*curves)
        assert curves[0].at(a) == pytest.approx([0.0, height], abs=4e-3)
        assert curves[1].at(b) == pytest.approx([0.0, height], abs=4e-3)
