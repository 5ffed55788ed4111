# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves and surfaces go to FreeCAD and come back as they were."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan.document.native_curve import curve_of, curve_shape  # noqa: E402
from freecad_edgescan.document.native_surface import surface_of, surface_shape  # noqa: E402
from freecad_edgescan.geometry import BSplineCurve, BSplineSurface, Circle  # noqa: E402
from freecad_edgescan.geometry.exact_surfaces import (  # noqa: E402
    circular_arc,
    extruded_surface,
)

V = FreeCAD.Vector
MOVED = FreeCAD.Placement(V(10, -3, 2), FreeCAD.Rotation(V(1, 2, 3), 50))


def moved(points: Any) -> np.ndarray:
    return np.array([tuple(MOVED.multVec(V(*point))) for point in np.atleast_2d(points)])


def an_arc() -> BSplineCurve:
    return circular_arc(Circle([1.0, 2, 3], [0, 0, 1.0], 7.0, [1.0, 0, 0]), 0.3, 2.9)


def test_a_curve_comes_back_to_the_last_bit() -> None:
    for curve in (
        an_arc(),
        BSplineCurve(np.random.default_rng(0).random((6, 3)), [0] * 4 + [0.3, 1.7] + [2] * 4),
    ):
        back = curve_of(curve_shape(curve))
        assert np.array_equal(back.poles, curve.poles)
        assert np.array_equal(back.knots, curve.knots)
        assert (back.weights is None) == (curve.weights is None)


def test_a_moved_line_and_a_turned_arc_are_where_the_document_shows_them() -> None:
    edge = Part.LineSegment(V(0, 0, 0), V(1, 2, 3)).toShape()
    edge.Placement = MOVED
    assert np.allclose(curve_of(edge).poles, moved([[0, 0, 0], [1, 2, 3]]))
    arc = curve_of(Part.Arc(V(1, 0, 0), V(0, 1, 0), V(-1, 0, 0)).toShape())
    assert np.allclose(np.linalg.norm(arc.sample(30), axis=1), 1.0, atol=1e-12)


def test_a_circle_is_opened_at_its_seam_and_a_trimmed_curve_is_cut() -> None:
    circle = curve_of(Part.Circle(V(0, 0, 0), V(0, 0, 1), 5).toShape())
    assert not circle.periodic
    assert circle.length() == pytest.approx(10 * np.pi)
    native = Part.BSplineCurve()
    native.interpolate([V(0, 0, 0), V(1, 1, 0), V(2, 0, 1), V(3, 2, 0)])
    edge = native.toShape(0.7, 2.5)
    part = curve_of(edge)
    assert part.parameter_range == pytest.approx((0.7, 2.5))
    assert np.allclose(part.evaluate(1.3), tuple(native.value(1.3)), atol=1e-12)


def test_edges_that_follow_each_other_are_one_curve() -> None:
    line = Part.LineSegment(V(3, 0, 0), V(1, 0, 0)).toShape()
    arc = Part.Arc(V(1, 0, 0), V(0, 1, 0), V(-1, 0, 0)).toShape()
    curve = curve_of(Part.Compound([arc, line]))
    assert curve.length() == pytest.approx(2 + np.pi, abs=1e-9)
    ends = curve.evaluate(np.array(curve.parameter_range))
    assert sorted(np.round(ends[:, 0], 9)) == [-1.0, 3.0]
    beyond = curve.sample(200)
    off = np.abs(np.linalg.norm(beyond, axis=1) - 1.0)
    assert np.all((off < 1e-9) | (np.abs(beyond[:, 1]) < 1e-9))


def test_what_is_no_single_curve_is_refused() -> None:
    apart = [Part.LineSegment(V(k, 0, 0), V(k, 1, 0)).toShape() for k in range(2)]
    with pytest.raises(ValueError, match="2 edges of the rail form 2 separate chains"):
        curve_of(Part.Compound(apart), "rail")
    with pytest.raises(ValueError, match="has no edge"):
        curve_of(Part.Shape())


def a_surface(rational: bool) -> BSplineSurface:
    if rational:
        return extruded_surface(an_arc(), [0, 0, 12.0])
    poles = np.random.default_rng(3).random((7, 5, 3))
    knots = np.r_[[0.0] * 4, 0.2, 0.5, 0.5, [1.0] * 4], np.r_[[2.0] * 3, 3, 4, [7.0] * 3]
    return BSplineSurface(poles, knots, (3, 2))


@pytest.mark.parametrize("rational", [False, True])
def test_a_surface_comes_back_to_the_last_bit(rational: bool) -> None:
    surface = a_surface(rational)
    back = surface_of(surface_shape(surface))
    assert np.array_equal(back.poles, surface.poles)
    assert all(np.array_equal(*pair) for pair in zip(back.knots, surface.knots, strict=True))
    assert back.degree == surface.degree
    assert (back.weights is None) == (surface.weights is None)


def test_a_face_that_was_shown_is_the_same_surface() -> None:
    sphere = Part.makeSphere(5.0)
    before = surface_of(sphere)
    sphere.tessellate(0.1)
    after = surface_of(sphere)
    assert np.array_equal(after.poles, before.poles)


def test_faces_of_solids_become_surfaces_with_the_faces_normals() -> None:
    cylinder = Part.makeCylinder(5, 10)
    cylinder.Placement = MOVED
    for face in cylinder.Faces:
        surface = surface_of(face)
        middle = [(low + high) / 2 for low, high in surface.parameter_range]
        point, normal = surface.evaluate(*middle), surface.normal(*middle)
        assert cylinder.isInside(V(*(point - 1e-3 * normal)), 1e-7, False)
        assert not cylinder.isInside(V(*(point + 1e-3 * normal)), 1e-7, True)
    side = surface_of(Part.makeCylinder(5, 10).Faces[0])
    points = side.evaluate(*np.meshgrid(np.linspace(0, 2 * np.pi, 40), np.linspace(0, 10, 5)))
    assert np.allclose(np.linalg.norm(points[..., :2], axis=-1), 5.0, atol=1e-12)
    with pytest.raises(ValueError, match="has 3 faces"):
        surface_of(cylinder)
