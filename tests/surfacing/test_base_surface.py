# SPDX-License-Identifier: LGPL-2.1-or-later
"""Base surfaces: what points lie on is found, and edges are met."""

from __future__ import annotations

import numpy as np
import pytest

import freecad_edgescan as es
from freecad_edgescan.surfacing import ShapeKind

SHARE = np.linspace(0, 1, 41)
FAR = np.array([1e5, -2e4, 3e3])


def placed(points, seed=1):
    turn = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))[0]
    return points @ turn.T + FAR


def round_the_x_axis(radius, turn, count=6000, length=60.0, seed=0):
    """Points at radius(x) round x, through some angle."""
    rng = np.random.default_rng(seed)
    x, angle = length * rng.random(count), turn * rng.random(count)
    r = radius(x)
    return np.stack([x, r * np.cos(angle), r * np.sin(angle)], axis=1)


def on_a_sphere(radius, lowest, count=6000):
    arms = np.random.default_rng(0).normal(size=(count, 3))
    arms /= np.linalg.norm(arms, axis=1)[:, None]
    return radius * arms[arms[:, 2] > lowest]


def graph(count=6000):
    x, y = np.random.default_rng(0).random((2, count)) * [[60], [40]]
    return np.stack([x, y, 0.004 * x**2 - 0.006 * y**2 + 0.002 * x * y], axis=1)


PARTS = {
    "plane": np.random.default_rng(0).random((6000, 3)) * [60, 40, 0],
    "half cylinder": round_the_x_axis(lambda x: 17 + 0 * x, np.pi),
    "little of a cylinder": round_the_x_axis(lambda x: 17 + 0 * x, 0.7),
    "whole cylinder": round_the_x_axis(lambda x: 17 + 0 * x, 2 * np.pi),
    "cone": round_the_x_axis(lambda x: 10 + x / 3, np.pi),
    "slender cone": round_the_x_axis(lambda x: 17 + x / 100, np.pi),
    "sphere": on_a_sphere(25.0, 0.6),
    "quadric": graph(),
}


# a quadric is what is left when no other shape explains the points: it has to be without strays
CASES = [
    (name, strays) for name in PARTS for strays in (0.0, 0.2) if name != "quadric" or not strays
]


@pytest.mark.parametrize("noise", [0.0, 0.03])
@pytest.mark.parametrize(("name", "strays"), CASES)
def test_the_shape_of_a_segment_is_told_and_fitted_below_its_noise(name, noise, strays):
    rng = np.random.default_rng(3)
    true = PARTS[name]
    points = true + noise * rng.normal(size=true.shape)
    count = int(strays * len(points))
    low, high = true.min(axis=0), true.max(axis=0)
    points[:count] = low + (high - low) * rng.random((count, 3)) + [0, 0, 2]
    base = es.base_surface(placed(points))
    assert base.kind == ("cylinder" if "cylinder" in name else "cone" if "cone" in name else name)
    off = base.surface.closest(placed(true[count:]))[2]
    assert off.mean() < max(1e-6, 0.1 * noise) and off.max() < max(1e-4, 0.4 * noise)
    assert base.kind in base.message
    assert np.abs(base.shape.distances(placed(true[count:]))).max() < max(1e-4, 0.4 * noise)


def test_a_whole_cylinder_is_closed_and_a_half_is_not():
    whole, half = (es.base_surface(PARTS[name]) for name in ("whole cylinder", "half cylinder"))
    assert whole.surface.closed == (True, False) and half.surface.closed == (False, False)
    assert "17 mm" in half.message


def test_another_kind_may_be_wanted():
    points = PARTS["little of a cylinder"]
    assert es.base_surface(points, kind="quadric").kind is ShapeKind.QUADRIC
    plane = es.base_surface(points, kind="plane")
    assert plane.kind is ShapeKind.PLANE and plane.surface.poles.shape == (2, 2, 3)


def test_the_base_of_a_segment_serves_to_fit_it(pipe):
    rng = np.random.default_rng(0)
    u, v = rng.uniform(0, np.pi, 5000), rng.random(5000)
    cloud = es.PointCloud(pipe.evaluate(u, v) + 0.02 * rng.normal(size=(5000, 3)))
    base = es.base_surface(cloud)
    fit = es.fit_surface(cloud.points, base.surface, (12, 4))
    assert not fit.outside.any()
    assert fit.average == pytest.approx(0.02 * np.sqrt(2 / np.pi), rel=0.05)


def edges_of(surface):
    (u0, u1), (v0, v1) = surface.parameter_range
    sides = [{"v": v0}, {"u": u1}, {"v": v1}, {"u": u0}]
    return [surface.curve_at(**side) for side in sides]


def test_four_edges_are_met_in_any_order_and_direction(wave):
    edges = edges_of(wave)
    given = [edges[0], edges[2].reversed(), edges[1], edges[3]]
    base = es.base_surface(edges=given)
    assert base.kind is ShapeKind.EDGES
    for edge in edges:
        assert base.surface.closest(edge.sample(60))[2].max() < 1e-6
    for corner in (0.0, 1.0):
        assert np.allclose(
            base.surface.evaluate(SHARE, 0.0)[[0, -1]], edges[0].evaluate(np.array([0.0, 1.0]))
        )
        assert np.isfinite(base.surface.evaluate(corner, SHARE)).all()
    assert "order 1, 3, 2, 4" in base.message or "order 1, 4, 2, 3" in base.message
    assert "turned round" in base.message


def test_between_straight_edges_the_patch_is_bilinear():
    corners = np.array([[0.0, 0, 0], [30, 0, 5], [30, 20, 0], [0, 20, 5]])
    edges = [es.BSplineCurve([corners[k], corners[(k + 1) % 4]], [0, 0, 1, 1], 1) for k in range(4)]
    surface = es.base_surface(edges=edges).surface
    assert np.allclose(surface.evaluate(0.5, 0.5), corners.mean(axis=0), atol=1e-9)


def test_arcs_are_met_within_the_tolerance(pipe):
    base = es.base_surface(edges=edges_of(pipe), tolerance=1e-3)
    points = base.surface.evaluate(SHARE[:, None], SHARE).reshape(-1, 3)
    assert np.abs(np.hypot(points[:, 1], points[:, 2]) - 17).max() < 2e-3


def test_small_gaps_are_closed_and_large_ones_said(wave):
    edges = edges_of(wave)
    moved = es.BSplineCurve(edges[0].poles + np.array([0.2, 0, 0]), edges[0].knots)
    surface = es.base_surface(edges=[moved, *edges[1:]]).surface
    assert surface.closest(edges[2].sample(50))[2].max() < 1e-6
    far = es.BSplineCurve(edges[0].poles + np.array([0, 0, 7.0]), edges[0].knots)
    with pytest.raises(ValueError, match=r"do not meet.*gaps round the patch are .*7.* mm"):
        es.base_surface(edges=[far, *edges[1:]])
    assert es.base_surface(edges=[far, *edges[1:]], largest_gap=8.0).surface


def test_rails_and_profiles_are_a_sweep(pipe):
    v0, u1, v1, u0 = edges_of(pipe)
    base = es.base_surface(rails=[u0, u1], profiles=[v0, v1])
    assert base.kind is ShapeKind.SWEEP and base.sweep.model == "rotate"
    points = base.surface.evaluate(SHARE[:, None], SHARE).reshape(-1, 3)
    assert np.abs(np.hypot(points[:, 1], points[:, 2]) - 17).max() < 0.02


def test_what_makes_no_base_surface_is_refused(wave):
    edges = edges_of(wave)
    with pytest.raises(ValueError, match="not from 0 of these ways"):
        es.base_surface()
    with pytest.raises(ValueError, match="not from 2 of these ways"):
        es.base_surface(np.eye(3), edges=edges)
    with pytest.raises(ValueError, match="takes four of them, not 3"):
        es.base_surface(edges=edges[:3])
    with pytest.raises(ValueError, match="profiles are missing"):
        es.base_surface(rails=edges[::2])
    with pytest.raises(ValueError, match="for points only"):
        es.base_surface(edges=edges, kind="plane")
    with pytest.raises(ValueError, match="no sweep model 'twist'"):
        es.base_surface(rails=edges[::2], profiles=edges[1::2], model="twist")
    with pytest.raises(ValueError, match="3 points are too few"):
        es.base_surface(np.eye(3))
    with pytest.raises(ValueError, match="no base surface of the kind 'torus'"):
        es.base_surface(np.zeros((50, 3)), kind="torus")
    with pytest.raises(ValueError, match="lie on one line"):
        es.base_surface(np.outer(np.arange(50.0), [1, 2, 3]))
    with pytest.raises(ValueError, match="compensate_cloud"):
        es.base_surface(es.PointCloud(PARTS["plane"], 1.0))
    angle = np.append(np.linspace(0, 2 * np.pi, 20)[:-1], 0)
    ring = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    loop = es.BSplineCurve(ring, np.r_[0, np.linspace(0, 1, 20), 1], 1)
    with pytest.raises(ValueError, match="Edge 1 is closed"):
        es.base_surface(edges=[loop, *edges[1:]])


def test_edges_that_cross_are_refused():
    corners = np.array([[0.0, 0, 0], [10, 10, 0], [10, 0, 0], [0, 10, 0]])
    edges = [es.BSplineCurve([corners[k], corners[(k + 1) % 4]], [0, 0, 1, 1], 1) for k in range(4)]
    with pytest.raises(ValueError, match=r"opposite edges meet or cross near \(5, 5, 0\)"):
        es.base_surface(edges=edges)
