# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closest points of surfaces against brute force and surfaces with known distances."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.geometry import BSplineSurface, Circle
from freecad_edgescan.geometry.exact_surfaces import (
    circular_arc,
    extruded_surface,
    revolved_surface,
)

X, Z = np.array([1.0, 0, 0]), np.array([0, 0, 1.0])


def torus(big=20.0, small=6.0):
    section = Circle(big * X, np.array([0, -1.0, 0]), small, X)
    return revolved_surface(circular_arc(section), [0, 0, 0], Z)


def bumpy(rational=False, seed=7):
    rng = np.random.default_rng(seed)
    u, v = np.meshgrid(np.linspace(0, 60, 10), np.linspace(0, 40, 8), indexing="ij")
    poles = np.stack([u, v, 8 * np.sin(u / 9) * np.cos(v / 7)], axis=-1)
    poles += rng.normal(size=poles.shape)
    knots = [np.r_[[0.0] * 3, np.linspace(0, 1, n - 2), [1.0] * 3] for n in (10, 8)]
    return BSplineSurface(poles, knots, (3, 3), rng.uniform(0.5, 2, (10, 8)) if rational else None)


def test_distances_to_a_torus_are_exact_also_over_its_seams():
    surface = torus()
    rng = np.random.default_rng(0)
    points = rng.uniform([-30, -30, -10], [30, 30, 10], (3000, 3))
    ring = np.hypot(points[:, 0], points[:, 1])
    u, v, distance = surface.closest(points)
    exact = np.abs(np.hypot(ring - 20, points[:, 2]) - 6)
    assert np.allclose(distance, exact, atol=1e-9)
    assert np.allclose(np.linalg.norm(surface.evaluate(u, v) - points, axis=1), distance)


@pytest.mark.parametrize("rational", [False, True])
@pytest.mark.parametrize("away", [0.01, 3.0, 100.0])
def test_no_place_of_a_dense_search_is_closer(rational, away):
    surface = bumpy(rational)
    rng = np.random.default_rng(3)
    u, v = rng.random((2, 100))
    points = surface.evaluate(u, v) + rng.normal(size=(100, 3)) * away
    dense = surface.evaluate(*np.meshgrid(*[np.linspace(0, 1, 401)] * 2)).reshape(-1, 3)
    distance = surface.closest(points)[2]
    brute = np.array([np.linalg.norm(dense - p, axis=1).min() for p in points])
    assert np.all(distance <= brute + 1e-6)
    assert np.all(distance >= brute - 0.3)


def test_points_off_the_surface_along_its_normals_come_back_to_their_parameters():
    surface = bumpy()
    u, v = np.random.default_rng(1).uniform(0.02, 0.98, (2, 500))
    points = surface.evaluate(u, v) + 0.2 * surface.normal(u, v)
    found = surface.closest(points)
    assert np.allclose(found[0], u, atol=1e-9) and np.allclose(found[1], v, atol=1e-9)
    assert np.allclose(found[2], 0.2, atol=1e-9)


def test_beyond_the_rim_the_rim_is_closest():
    arc = circular_arc(Circle(np.zeros(3), Z, 5.0, X), 0.0, np.pi / 2)
    surface = extruded_surface(arc, [0, 0, 4])
    u, v, distance = surface.closest([[5, -3, 2], [3, 3, 8], [6, -4, 7]])
    assert np.allclose(u, [0, np.pi / 4, 0], atol=1e-9) and np.allclose(v, [0.5, 1, 1])
    assert np.allclose(distance, [3, np.hypot(4, 5 - np.sqrt(18)), np.sqrt(1 + 16 + 9)])


def test_a_start_near_the_foot_leads_to_it():
    surface = bumpy()
    u, v = np.random.default_rng(2).uniform(0.1, 0.9, (2, 200))
    points = surface.evaluate(u, v) + 0.2 * surface.normal(u, v)
    found = surface.closest(points, start=(u + 0.01, v - 0.01))
    assert np.allclose(found[0], u, atol=1e-9) and np.allclose(found[1], v, atol=1e-9)


def test_a_surface_of_one_patch_folded_back_is_searched_on_both_sheets():
    poles = np.array([[[0, 0, 0], [0, 9, 0]], [[40, 0, 0], [40, 9, 0]]], float)
    poles = np.concatenate([poles, poles[::-1] + 3 * Z])
    surface = BSplineSurface(poles, (np.repeat([0.0, 1], 4), [0, 0, 1, 1]), (3, 1))
    x = np.linspace(1, 20, 30)
    points = np.stack([x, np.full(30, 4.0), np.where(np.arange(30) % 2, 0.3, 2.7)], axis=1)
    u = surface.closest(points)[0]
    assert np.all((u > 0.5) == (points[:, 2] > 1.5))


def test_points_that_are_none_are_refused():
    with pytest.raises(ValueError, match=r"\(m, 3\) array, not one of shape"):
        torus().closest(np.zeros((4, 2)))
    with pytest.raises(ValueError, match="not a finite number"):
        torus().closest([[0, 0, np.nan]])


def test_no_points_have_no_feet():
    assert all(len(values) == 0 for values in torus().closest(np.zeros((0, 3))))


def test_feet_on_a_sharp_bend_are_found_along_it():
    """A roof whose ridge lies on a knot: above it the ridge is closest, wherever one starts."""
    poles = np.zeros((3, 5, 3))
    poles[..., 0] = np.linspace(0, 40, 3)[:, None]
    poles[..., 1], poles[..., 2] = np.linspace(-10, 10, 5), [0, 5, 10, 5, 0]
    poles[1, :, 2] += 4
    knots = np.repeat([0.0, 1], 3), np.r_[[0.0] * 3, 0.5, 0.5, [1.0] * 3]
    roof = BSplineSurface(poles, knots, (2, 2))
    x = np.linspace(2, 38, 60)
    points = np.stack([x, 0.3 * np.sin(7 * x), np.full(60, 16.0)], axis=1)
    _, v, distance = roof.closest(points)
    assert np.allclose(v, 0.5)
    assert np.allclose(distance, roof.curve_at(v=0.5).closest(points)[1], atol=1e-12)
