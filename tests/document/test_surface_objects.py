# SPDX-License-Identifier: LGPL-2.1-or-later
"""Segments, fitted and extended surfaces and their intersections, as objects."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

import freecad_edgescan as es  # noqa: E402
from freecad_edgescan import document  # noqa: E402
from freecad_edgescan.document.native_surface import surface_of  # noqa: E402

V = FreeCAD.Vector
PROBE = 1.5


def feature(doc: Any, shape: Any, name: str = "Shape") -> Any:
    made = doc.addObject("Part::Feature", name)
    made.Shape = shape
    return made


def plane(doc: Any, length: float = 40.0, width: float = 30.0) -> Any:
    return feature(doc, Part.makePlane(length, width), "Plane")


def wave(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    return 0.8 * np.sin(x / 8) * np.cos(y / 7)


def wavy_cloud(doc: Any, count: int = 6000) -> Any:
    x, y = np.random.default_rng(0).uniform((-5, -5), (45, 35), (count, 2)).T
    far = np.random.default_rng(1).uniform((0, 0, 6), (40, 30, 20), (500, 3))
    return document.make_cloud(doc, np.vstack([np.column_stack([x, y, wave(x, y)]), far]))


def test_a_segment_holds_the_points_near_its_base(doc: Any) -> None:
    cloud, base = wavy_cloud(doc), plane(doc)
    segment = document.make_cloud_segment(doc, cloud, base, 3.0)
    assert segment.Points.CountPoints == 0
    doc.recompute()
    points = document.points_of(segment)
    every = document.points_of(cloud)
    x, y, z = every.T
    inside = (x > 0) & (x < 40) & (y > 0) & (y < 30) & (np.abs(z) < 3.0)
    assert len(points) == segment.PointCount == int(inside.sum())
    assert np.allclose(np.sort(points[:, 0]), np.sort(every[inside, 0]))


def test_a_segment_of_probe_centres_lies_on_the_part(doc: Any) -> None:
    x, y = np.random.default_rng(0).uniform((1, 1), (39, 29), (4000, 2)).T
    centres = es.PointCloud(
        np.column_stack([x, y, np.full(4000, PROBE)]), probe_radius=PROBE, approach=(0, 0, -1)
    )
    segment = document.make_cloud_segment(doc, document.make_cloud(doc, centres), plane(doc))
    doc.recompute()
    assert segment.ProbeRadius.Value == 0.0
    assert np.abs(document.points_of(segment)[:, 2]).max() < 1e-5


def test_a_surface_is_fitted_to_a_cloud_and_to_its_segment(doc: Any) -> None:
    cloud, base = wavy_cloud(doc), plane(doc)
    segment = document.make_cloud_segment(doc, cloud, base)
    fits = [document.make_fitted_surface(doc, own, base, (12, 10)) for own in (cloud, segment)]
    doc.recompute()
    for fit in fits:
        assert fit.Maximum.Value < 0.02 and fit.Supported == 100
        u, v = np.meshgrid(np.linspace(2, 38, 20), np.linspace(2, 28, 20))
        x, y, z = np.moveaxis(surface_of(fit.Shape).evaluate(u, v), -1, 0)
        assert np.abs(z - wave(x, y)).max() < 0.02
    automatic = document.make_fitted_surface(doc, segment, base, None, tolerance=0.01)
    doc.recompute()
    assert automatic.Maximum.Value < 0.03


def test_without_a_base_four_edges_or_the_points_themselves_make_it(doc: Any) -> None:
    cloud = wavy_cloud(doc)
    corners = [V(0, 0, 0), V(40, 0, 0), V(40, 30, 0), V(0, 30, 0)]
    edges = [feature(doc, Part.makeLine(corners[k - 1], corners[k]), "Edge") for k in range(4)]
    between = document.make_fitted_surface(doc, cloud, control_points=(12, 10), edges=edges)
    angle, x = np.random.default_rng(0).uniform((0, 0), (2 * np.pi, 40), (4000, 2)).T
    pipe = np.column_stack([x, 10 * np.cos(angle), 10 * np.sin(angle)])
    alone = document.make_fitted_surface(doc, document.make_cloud(doc, pipe), None, (16, 5))
    doc.recompute()
    assert between.Maximum.Value < 0.02
    assert between.Shape.Area == pytest.approx(40 * 30, rel=0.01)
    assert "cylinder" in alone.Message and alone.Maximum.Value < 0.02
    surface = surface_of(alone.Shape)
    assert surface.closed == (True, False)
    (u0, u1), (v0, v1) = surface.parameter_range
    at = surface.evaluate(np.linspace(u0, u1, 60)[:, None], np.linspace(v0, v1, 9))
    assert np.allclose(np.hypot(at[..., 1], at[..., 2]), 10.0, atol=0.02)
    with pytest.raises(ValueError, match="3 edges are given; give a base surface, or four"):
        document.make_fitted_surface(doc, cloud, edges=edges[:3])


def test_an_extension_goes_on_where_the_surface_ends(doc: Any) -> None:
    base = plane(doc)
    longer = document.make_extended_surface(doc, base, "u1", 0.5)
    doc.recompute()
    assert longer.Shape.Area == pytest.approx(40 * 30 * 1.5, rel=1e-9)
    longer.Side = "v0"
    doc.recompute()
    assert longer.Shape.BoundBox.YMin == pytest.approx(-15.0)
    closed = feature(doc, Part.makeCylinder(5, 10).Faces[0])
    refused = document.make_extended_surface(doc, closed, "u0")
    doc.recompute()
    assert "closed in u" in refused.Message and "Invalid" in refused.State


def test_an_intersection_is_found_whole_and_follows(doc: Any) -> None:
    base = plane(doc)
    ball = doc.addObject("Part::Sphere", "Ball")
    ball.Radius = 10
    ball.Placement.Base = V(20, 15, 6)
    curve = document.make_surface_intersection(doc, base, ball)
    doc.recompute()
    assert curve.CurveCount == 1
    assert curve.Length.Value == pytest.approx(2 * np.pi * 8, rel=1e-6)
    ball.Placement.Base = V(0, 15, 6)
    doc.recompute()
    assert curve.Length.Value == pytest.approx(np.pi * 8, rel=1e-6)
    ball.Placement.Base = V(20, 15, 60)
    doc.recompute()
    assert "do not meet" in curve.Message and "Invalid" in curve.State
    assert curve.Length.Value == pytest.approx(np.pi * 8, rel=1e-6)


def test_opencascade_and_our_own_intersection_agree(doc: Any) -> None:
    first, second = plane(doc), feature(doc, Part.makeCylinder(7, 20, V(20, 15, -10)).Faces[0])
    curve = document.make_surface_intersection(doc, first, second)
    doc.recompute()
    (ours,) = es.intersect_surfaces(surface_of(first.Shape), surface_of(second.Shape))
    assert ours.length == pytest.approx(curve.Length.Value, rel=1e-4)


def test_a_chain_of_objects_survives_its_file(doc: Any, tmp_path: Path) -> None:
    base = plane(doc)
    segment = document.make_cloud_segment(doc, wavy_cloud(doc, 2000), base)
    fit = document.make_fitted_surface(doc, segment, base, (8, 8))
    longer = document.make_extended_surface(doc, fit, "u1")
    cut = document.make_surface_intersection(doc, longer, base)
    doc.recompute()
    names = [item.Name for item in (segment, fit, longer, cut)]
    before = {name: doc.getObject(name).InputHash for name in names}
    length = cut.Length.Value
    assert all(before.values())
    doc.saveAs(str(tmp_path / "chain.FCStd"))
    FreeCAD.closeDocument(doc.Name)
    again = FreeCAD.openDocument(str(tmp_path / "chain.FCStd"))
    try:
        for item in again.Objects:
            item.touch()
        again.recompute()
        assert {name: again.getObject(name).InputHash for name in names} == before
        assert again.getObject(names[-1]).Length.Value == pytest.approx(length, rel=1e-12)
    finally:
        FreeCAD.closeDocument(again.Name)


def test_wrong_arguments_make_nothing(doc: Any) -> None:
    base = plane(doc)
    cloud = wavy_cloud(doc, 100)
    count = len(doc.Objects)
    for make, words in (
        (lambda: document.make_cloud_segment(doc, base, base), "is not a point cloud"),
        (lambda: document.make_cloud_segment(doc, cloud, base, 0.0), "positive length"),
        (lambda: document.make_fitted_surface(doc, cloud, cloud), "has no shape"),
        (lambda: document.make_extended_surface(doc, base, "w0"), "no side 'w0'"),
        (lambda: document.make_extended_surface(doc, base, "u0", -1.0), "positive number"),
        (lambda: document.make_surface_intersection(doc, base, base), "two different objects"),
    ):
        with pytest.raises(ValueError, match=words):
            make()
    assert len(doc.Objects) == count


def test_what_is_missing_is_said(doc: Any) -> None:
    base = plane(doc)
    fit = document.make_fitted_surface(doc, wavy_cloud(doc, 500), base)
    doc.recompute()
    fit.Cloud = None
    doc.recompute()
    assert fit.Message == "The cloud is missing; choose one, or undo its deletion."
    solid = feature(doc, Part.makeBox(1, 1, 1))
    longer = document.make_extended_surface(doc, solid)
    doc.recompute()
    assert "has 6 faces and must have one" in longer.Message


def test_a_segment_inside_a_moved_part_is_seen_where_it_stands(doc: Any) -> None:
    segment = document.make_cloud_segment(doc, wavy_cloud(doc, 500), plane(doc))
    doc.recompute()
    before = document.points_of(segment)
    part = doc.addObject("App::Part", "Part")
    part.Placement.Base = V(100, 0, 0)
    part.addObject(segment)
    assert np.allclose(document.points_of(segment), before + np.array([100.0, 0, 0]))
