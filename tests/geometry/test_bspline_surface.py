# SPDX-License-Identifier: LGPL-2.1-or-later
"""B-spline surfaces against SciPy's curves, finite differences and exactly known surfaces."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import BSpline

from freecad_edgescan.geometry import BSplineCurve, BSplineSurface, Circle
from freecad_edgescan.geometry.exact_surfaces import (
    circular_arc,
    extruded_surface,
    revolved_surface,
    ruled_surface,
)


def any_surface(rational=False, seed=4):
    rng = np.random.default_rng(seed)
    u, v = np.meshgrid(np.linspace(0, 40, 9), np.linspace(0, 25, 7), indexing="ij")
    poles = np.stack([u, v, 3 * np.sin(u / 9) * np.cos(v / 8)], axis=-1)
    poles += rng.normal(size=poles.shape)
    knots_u = np.r_[[0.0] * 4, np.sort(rng.uniform(0, 2, 5)), [2.0] * 4]
    knots_v = np.r_[[-1.0] * 3, [0.0, 0.5, 0.5, 2.0], [3.0] * 3]
    weights = rng.uniform(0.6, 1.6, (9, 7)) if rational else None
    return BSplineSurface(poles, (knots_u, knots_v), (3, 2), weights)


def torus(big=20.0, small=6.0):
    section = Circle(np.array([big, 0, 0]), np.array([0, -1.0, 0]), small, np.array([1.0, 0, 0]))
    return revolved_surface(circular_arc(section), [0, 0, 0], [0, 0, 1])


def sphere(radius=8.0):
    meridian = Circle(np.zeros(3), np.array([0, -1.0, 0]), radius, np.array([1.0, 0, 0]))
    return revolved_surface(circular_arc(meridian, -np.pi / 2, np.pi / 2), [0, 0, 0], [0, 0, 1])


def parameters(surface, count=400, seed=1):
    limits = np.array(surface.parameter_range)
    return np.random.default_rng(seed).uniform(limits[:, 0], limits[:, 1], (count, 2)).T


@pytest.mark.parametrize("rational", [False, True])
def test_a_surface_is_the_curves_of_its_curves(rational):
    surface = any_surface(rational)
    u, v = parameters(surface, 30)
    weights = np.ones((9, 7)) if surface.weights is None else surface.weights
    homogeneous = np.concatenate([surface.poles * weights[..., None], weights[..., None]], -1)
    along_u = BSpline(surface.knots[0], homogeneous, 3)(u)
    point = np.array(
        [BSpline(surface.knots[1], row, 2)(x) for row, x in zip(along_u, v, strict=True)]
    )
    assert np.allclose(surface.evaluate(u, v), point[:, :3] / point[:, 3:], atol=1e-12)


@pytest.mark.parametrize("rational", [False, True])
@pytest.mark.parametrize("order", [(1, 0), (0, 1), (1, 1), (2, 0), (0, 2), (2, 1)])
def test_derivatives_are_the_limits_of_differences(rational, order):
    surface = any_surface(rational)
    u, v = parameters(surface)
    far = (np.abs(u[:, None] - surface.knots[0]).min(axis=1) > 1e-3) & (
        np.abs(v[:, None] - surface.knots[1]).min(axis=1) > 1e-3
    )
    u, v, h = u[far], v[far], 1e-5
    if order[0]:
        lower = (order[0] - 1, order[1])
        pair = [surface.derivative(u + s, v, *lower) for s in (-h, h)]
    else:
        lower = (order[0], order[1] - 1)
        pair = [surface.derivative(u, v + s, *lower) for s in (-h, h)]
    exact = surface.derivative(u, v, *order)
    assert np.allclose((pair[1] - pair[0]) / (2 * h), exact, atol=1e-6 * np.abs(exact).max())


def test_parameters_are_broadcast_to_a_grid():
    surface = any_surface()
    grid = surface.evaluate(np.linspace(0, 2, 5)[:, None], np.linspace(-1, 3, 4))
    assert grid.shape == (5, 4, 3)
    assert np.allclose(grid[2, 1], surface.evaluate(1.0, -1 + 4 / 3))
    assert np.allclose(grid[0, 0], surface.poles[0, 0])
    assert np.allclose(grid[-1, -1], surface.poles[-1, -1])


def test_a_torus_of_rational_quadratics_is_exact():
    surface = torus()
    x = surface.evaluate(*parameters(surface))
    assert np.allclose(np.hypot(np.hypot(x[:, 0], x[:, 1]) - 20, x[:, 2]), 6, atol=1e-12)
    assert surface.closed == (True, True)


def test_the_normal_of_a_sphere_is_radial():
    surface = sphere()
    u, v = parameters(surface)
    assert np.allclose(surface.normal(u, v), surface.evaluate(u, v) / 8, atol=1e-9)


def test_closed_surfaces_go_on_over_their_seam():
    surface = torus()
    (first, last), _ = surface.parameter_range
    u = np.linspace(first, last, 7)
    turn = last - first
    assert np.allclose(surface.evaluate(u + turn, 1.0), surface.evaluate(u, 1.0), atol=1e-12)


@pytest.mark.parametrize("rational", [False, True])
def test_inserting_knots_raising_degrees_and_cutting_change_no_point(rational):
    surface = any_surface(rational)
    u, v = parameters(surface)
    exact = surface.evaluate(u, v)
    refined = surface.refined(u=[0.3, 0.3, 1.9], v=[1.0])
    assert refined.poles.shape == (12, 8, 3)
    assert np.allclose(refined.evaluate(u, v), exact, atol=1e-12)
    raised = surface.elevated((5, 3))
    assert raised.degree == (5, 3)
    assert np.allclose(raised.evaluate(u, v), exact, atol=1e-11)
    part = surface.restricted(u=(0.4, 1.7), v=(0.5, 2.5))
    assert part.parameter_range == ((0.4, 1.7), (0.5, 2.5))
    inside = (u > 0.4) & (u < 1.7) & (v > 0.5) & (v < 2.5)
    assert np.allclose(part.evaluate(u[inside], v[inside]), exact[inside], atol=1e-12)


def test_split_halves_meet_and_together_are_the_whole():
    surface = any_surface(rational=True)
    before, after = surface.split(1, 0.8)
    u = np.linspace(0, 2, 20)
    assert np.allclose(before.evaluate(u, 0.8), after.evaluate(u, 0.8), atol=1e-12)
    assert np.allclose(before.evaluate(u, 0.1), surface.evaluate(u, 0.1), atol=1e-12)
    assert np.allclose(after.evaluate(u, 2.1), surface.evaluate(u, 2.1), atol=1e-12)


@pytest.mark.parametrize("rational", [False, True])
def test_reversed_and_transposed_surfaces_have_the_same_points(rational):
    surface = any_surface(rational)
    u, v = parameters(surface)
    exact = surface.evaluate(u, v)
    assert np.allclose(surface.reversed(0).evaluate(2 - u, v), exact)
    assert np.allclose(surface.reversed(1).evaluate(u, 2 - v), exact)
    assert np.allclose(surface.transposed().evaluate(v, u), exact)
    assert np.allclose(surface.transposed().normal(v, u), -surface.normal(u, v))


@pytest.mark.parametrize("rational", [False, True])
def test_curves_of_constant_parameter_lie_on_the_surface(rational):
    surface = any_surface(rational)
    u, v = np.linspace(0, 2, 15), np.linspace(-1, 3, 15)
    for at in (0.0, 0.77, 2.0):
        assert np.allclose(surface.curve_at(u=at).evaluate(v), surface.evaluate(at, v))
    for at in (-1.0, 0.5, 3.0):
        assert np.allclose(surface.curve_at(v=at).evaluate(u), surface.evaluate(u, at))


def test_knots_once_with_multiplicities_give_the_surface_back():
    surface = any_surface(rational=True)
    (u, count_u), (v, count_v) = surface.distinct_knots_and_multiplicities()
    again = BSplineSurface.from_distinct_knots(
        surface.poles, (u, v), (count_u, count_v), surface.degree, surface.weights
    )
    assert all(np.array_equal(a, b) for a, b in zip(again.knots, surface.knots, strict=True))


def test_ruled_and_extruded_surfaces_hold_their_curves():
    arc = circular_arc(Circle(np.zeros(3), np.array([0, 0, 1.0]), 5.0, np.array([1.0, 0, 0])), 0, 2)
    line = BSplineCurve([[0, 0, 9], [3, 8, 9]], [0, 0, 4, 4], 1)
    ruled = ruled_surface(arc, line)
    share = np.linspace(0, 1, 9)
    assert np.allclose(ruled.evaluate(share, 0), arc.evaluate(2 * share))
    assert np.allclose(ruled.evaluate(share, 1), line.evaluate(4 * share))
    cylinder = extruded_surface(arc, [0, 0, 4])
    assert np.allclose(cylinder.evaluate(2 * share, 0.25), arc.evaluate(2 * share) + np.eye(3)[2])


def test_what_does_not_belong_together_is_refused_with_numbers():
    square, knots = np.zeros((2, 2, 3)), np.array([0.0, 0, 1, 1])
    with pytest.raises(ValueError, match=r"\(nu, nv, 3\) array, not one of shape \(4, 3\)"):
        BSplineSurface(np.zeros((4, 3)), (knots, knots), (1, 1))
    with pytest.raises(ValueError, match="in v need 4 knots, not 5"):
        BSplineSurface(square, (knots, np.append(knots, 1.0)), (1, 1))
    with pytest.raises(ValueError, match="Degree 3 in u needs at least 4 poles, not 2"):
        BSplineSurface(square, (knots, knots))
    with pytest.raises(ValueError, match="must be equal"):
        BSplineSurface(square, (np.arange(4.0), knots), (1, 1))
    with pytest.raises(ValueError, match="2 × 2 positive numbers"):
        BSplineSurface(square, (knots, knots), (1, 1), -np.ones((2, 2)))
    with pytest.raises(ValueError, match="not a finite number"):
        BSplineSurface(square + np.nan, (knots, knots), (1, 1))
    with pytest.raises(ValueError, match="counts 2 times"):
        BSplineSurface(np.zeros((4, 2, 3)), (np.array([0, 0, 0.5, 0.5, 1, 1]), knots), (1, 1))
    surface = any_surface()
    with pytest.raises(ValueError, match=r"A knot at 2 cannot be inserted in u; .* 0 and 2"):
        surface.refined(u=[2.0])
    with pytest.raises(ValueError, match=r"from 1 to 0\.5 in u"):
        surface.restricted(u=(1.0, 0.5))
    with pytest.raises(ValueError, match="degree in u is 3 and cannot become 2"):
        surface.elevated((2, 2))
    with pytest.raises(ValueError, match="only one of them"):
        surface.curve_at(u=1.0, v=1.0)
    with pytest.raises(ValueError, match="above 0 and up to 2π"):
        revolved_surface(surface.curve_at(u=1.0), [0, 0, 0], [0, 0, 1], 7.0)
