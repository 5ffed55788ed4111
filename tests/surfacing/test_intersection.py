# SPDX-License-Identifier: LGPL-2.1-or-later
"""Intersections whose curves are known: how many, closed or not, how long, and where."""

from __future__ import annotations

import numpy as np
import pytest

import freecad_edgescan as es
from freecad_edgescan.geometry import Circle
from freecad_edgescan.geometry.exact_surfaces import (
    circular_arc,
    extruded_surface,
    revolved_surface,
)

X, Y, Z = np.eye(3)
ORIGIN = np.zeros(3)


def plane(at, one, other, half=60.0):
    corners = [
        [at - half * one - half * other, at - half * one + half * other],
        [at + half * one - half * other, at + half * one + half * other],
    ]
    return es.BSplineSurface(corners, ([0, 0, 1, 1], [0, 0, 1, 1]), (1, 1))


def cylinder(radius, axis, zero, length=40.0, at=ORIGIN):
    circle = Circle(at - axis * length / 2, axis, radius, zero)
    return extruded_surface(circular_arc(circle), axis * length)


def torus(big=20.0, small=6.0):
    return revolved_surface(circular_arc(Circle(big * X, -Y, small, X)), ORIGIN, Z)


def sphere(radius=8.0, at=ORIGIN):
    meridian = circular_arc(Circle(at, -Y, radius, X), -np.pi / 2, np.pi / 2)
    return revolved_surface(meridian, at, Z)


def assert_on_both(curves, a, b, tolerance=1e-3):
    for curve in curves:
        assert np.allclose(a.evaluate(*curve.on_a.T), curve.points, atol=1e-9)
        assert np.allclose(b.evaluate(*curve.on_b.T), curve.points, atol=1e-2 * tolerance)
        middle = (curve.points[1:] + curve.points[:-1]) / 2
        assert a.closest(middle)[2].max() < 1.5 * tolerance
        if curve.closed:
            assert np.array_equal(curve.points[0], curve.points[-1])
        between = curve.curve().sample(500)
        assert max(own.closest(between)[2].max() for own in (a, b)) < tolerance


def test_a_sphere_and_a_plane_meet_in_one_circle():
    a, b = sphere(), plane(3 * Z, X, Y)
    curves = es.intersect_surfaces(a, b)
    assert [curve.closed for curve in curves] == [True]
    assert_on_both(curves, a, b)
    radius = np.sqrt(64 - 9)
    assert np.allclose(np.hypot(*curves[0].points[:, :2].T), radius, atol=1e-5)
    assert curves[0].curve().length() == pytest.approx(2 * np.pi * radius, rel=1e-6)


def test_a_meridian_passes_the_poles_of_a_sphere():
    curves = es.intersect_surfaces(sphere(), plane(ORIGIN, X, Z))
    assert len(curves) == 1 and curves[0].closed
    assert curves[0].length == pytest.approx(16 * np.pi, rel=1e-3)


def test_a_thick_and_a_thin_cylinder_meet_in_two_loops():
    a, b = cylinder(5.0, Z, X), cylinder(3.0, X, Y)
    curves = es.intersect_surfaces(a, b)
    assert [curve.closed for curve in curves] == [True, True]
    assert_on_both(curves, a, b)
    assert curves[0].points[:, 0].mean() * curves[1].points[:, 0].mean() < 0


def test_equal_cylinders_meet_in_two_ellipses_that_cross():
    curves = es.intersect_surfaces(cylinder(5.0, Z, X), cylinder(5.0, X, Y))
    assert len(curves) == 2 and all(curve.closed for curve in curves)
    for curve in curves:
        x, z = curve.points[:, 0], curve.points[:, 2]
        assert min(np.abs(x - z).max(), np.abs(x + z).max()) < 1e-2


def test_a_torus_is_cut_into_circles_also_along_its_seam():
    ring = es.intersect_surfaces(torus(), plane(ORIGIN, X, Y))
    assert [round(curve.length / (2 * np.pi)) for curve in ring] == [26, 14]
    sections = es.intersect_surfaces(torus(), plane(ORIGIN, Y, Z))
    assert [curve.length / (2 * np.pi) for curve in sections] == pytest.approx([6, 6], rel=1e-3)
    slanted = np.arcsin(6 / 20)
    villarceau = es.intersect_surfaces(
        torus(), plane(ORIGIN, X, np.cos(slanted) * Y + np.sin(slanted) * Z)
    )
    assert [curve.length / (2 * np.pi) for curve in villarceau] == pytest.approx([20, 20], rel=1e-3)


def test_a_loop_much_smaller_than_the_surfaces_is_found():
    curves = es.intersect_surfaces(sphere(), plane(7.9999 * Z, X, Y), tolerance=1e-4)
    assert len(curves) == 1 and curves[0].closed
    assert curves[0].length == pytest.approx(2 * np.pi * np.sqrt(64 - 7.9999**2), rel=1e-2)


def test_open_branches_end_at_the_rims():
    a, b = cylinder(5.0, Z, X), plane(0.1 * Y, X, Z)
    curves = es.intersect_surfaces(a, b)
    assert [curve.closed for curve in curves] == [False, False]
    assert [curve.length for curve in curves] == pytest.approx([40, 40])
    ends = np.concatenate([curve.points[[0, -1], 2] for curve in curves])
    assert np.allclose(np.abs(ends), 20, atol=1e-9)


def test_a_common_rim_is_found():
    a, b = plane(60 * X, X, Y), plane(60 * Z, Y, Z)
    curves = es.intersect_surfaces(a, b)
    assert [curve.length for curve in curves] == pytest.approx([120])


def test_surfaces_of_many_patches_meet_in_what_the_tolerance_says():
    rng = np.random.default_rng(0)
    knots = np.r_[[0.0] * 3, np.linspace(0, 1, 12), [1.0] * 3]
    x = np.array([knots[i + 1 : i + 4].mean() for i in range(14)]) * 60
    grid = np.stack(np.broadcast_arrays(x[:, None], x, 0.0), axis=-1)
    waves = es.BSplineSurface(grid + [0, 0, 1] * rng.normal(size=(14, 14, 1)) * 4, (knots, knots))
    level = plane(np.array([30, 30, 0.3]), X, Y, 40)
    for tolerance in (1e-1, 1e-3):
        curves = es.intersect_surfaces(waves, level, tolerance)
        assert len(curves) > 3
        assert_on_both(curves, waves, level, tolerance)
        # an open curve begins and ends at the waves' rim
        for curve in curves:
            if not curve.closed:
                ends = curve.on_a[[0, -1]]
                assert np.all(np.abs(ends - 0.5).max(axis=1) == 0.5)
    u, v = np.meshgrid(np.linspace(0, 1, 600), np.linspace(0, 1, 600))
    height = waves.evaluate(u, v)[..., 2] - 0.3
    crossing = np.sum(np.diff(np.sign(height), axis=0) != 0)
    found = sum(np.abs(np.diff(np.floor(curve.on_a[:, 0] * 599))).sum() for curve in curves)
    assert found == pytest.approx(crossing, rel=0.03)


def test_surfaces_apart_or_touching_in_a_point_have_no_curve():
    assert es.intersect_surfaces(sphere(), plane(8.1 * Z, X, Y)) == []
    assert es.intersect_surfaces(sphere(), sphere(at=np.array([100.0, 0, 0]))) == []
    assert es.intersect_surfaces(plane(ORIGIN, X, Y), plane(Z, X, Y)) == []
    assert es.intersect_surfaces(plane(ORIGIN, X, Y), sphere(at=8 * Z)) == []


def test_what_has_no_curve_to_compute_is_refused_with_a_sentence():
    with pytest.raises(ValueError, match="touch or coincide over"):
        es.intersect_surfaces(plane(ORIGIN, X, Y), plane(5 * X, X, Y))
    with pytest.raises(ValueError, match="touch or coincide over"):
        es.intersect_surfaces(plane(ORIGIN, X, Y), cylinder(5.0, X, Y, at=5 * Z))
    with pytest.raises(ValueError, match="tolerance is 0 mm"):
        es.intersect_surfaces(sphere(), sphere(), tolerance=0)
