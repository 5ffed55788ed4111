# SPDX-License-Identifier: LGPL-2.1-or-later
"""Swept surfaces as objects: they follow their rails, are fitted, and survive their file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402
from freecad_edgescan.document.native_surface import surface_of  # noqa: E402

V = FreeCAD.Vector
NOISE = 0.05


def feature(doc: Any, shape: Any, name: str) -> Any:
    made = doc.addObject("Part::Feature", name)
    made.Shape = shape
    return made


def arc(x: float, radius: float) -> Any:
    return Part.Arc(V(x, radius, 0), V(x, 0, -radius), V(x, -radius, 0)).toShape()


def half_pipe(doc: Any, length: float = 60.0, radius: float = 17.0) -> tuple[list, list]:
    """Rails and profiles of half a cylinder along x, open upwards."""
    rails = [
        feature(doc, Part.LineSegment(V(0, y, 0), V(length, y, 0)).toShape(), "Rail")
        for y in (radius, -radius)
    ]
    return rails, [feature(doc, arc(x, radius), "Profile") for x in (0.0, length)]


def on_half_pipe(count: int, radius: float, seed: int = 0) -> np.ndarray:
    rng = np.random.default_rng(seed)
    angle = rng.uniform(0.02, np.pi - 0.02, count)
    x = rng.uniform(0.5, 59.5, count)
    points = np.column_stack([x, radius * np.cos(angle), -radius * np.sin(angle)])
    return points + rng.uniform(-NOISE, NOISE, points.shape)


def test_a_sweep_between_arcs_is_the_cylinder(doc: Any) -> None:
    swept = document.make_swept_surface(doc, *half_pipe(doc))
    assert swept.Shape.isNull()
    doc.recompute()
    surface = surface_of(swept.Shape)
    points = surface.evaluate(np.linspace(0, 1, 20)[:, None], np.linspace(0, 1, 30))
    assert np.allclose(np.hypot(points[..., 1], points[..., 2]), 17.0, atol=2e-3)
    assert swept.ModelUsed == "rotate" and swept.PointCount == 0
    assert set(swept.Kinds) == {"pipe", "extrusion"}


def test_a_fitted_sweep_says_how_well_and_by_which_model(doc: Any) -> None:
    cloud = document.make_cloud(doc, on_half_pipe(3000, 17.2))
    swept = document.make_swept_surface(doc, *half_pipe(doc), cloud, control_points=(6, 7))
    doc.recompute()
    assert swept.State == [] or "Up-to-date" in swept.State
    assert swept.Average.Value < 1.3 * 0.025 and swept.Maximum.Value < 0.2
    assert swept.PointCount + swept.OutsideCount <= 3000
    assert swept.ModelUsed in ("blend", "rotate")
    assert "explains the points better" in swept.Message
    points = surface_of(swept.Shape).evaluate(0.5, np.linspace(0.02, 0.98, 30))
    assert np.allclose(np.hypot(points[:, 1], points[:, 2]), 17.2, atol=0.03)


def test_a_file_reopens_and_recomputes_without_change(doc: Any, tmp_path: Path) -> None:
    cloud = document.make_cloud(doc, on_half_pipe(1500, 17.1), name="Cloud")
    swept = document.make_swept_surface(
        doc, *half_pipe(doc), cloud, model="rotate", control_points=(6, 6)
    )
    doc.recompute()
    before = (swept.InputHash, swept.Average.Value, surface_of(swept.Shape).poles)
    file = tmp_path / "swept.FCStd"
    doc.saveAs(str(file))
    name = swept.Name
    FreeCAD.closeDocument(doc.Name)
    again = FreeCAD.openDocument(str(file))
    try:
        restored = again.getObject(name)
        brep = restored.Shape.exportBrepToString()
        for item in again.Objects:
            item.touch()
        again.recompute()
        assert restored.InputHash == before[0]
        assert restored.Average.Value == pytest.approx(before[1], rel=1e-12)
        assert restored.Shape.exportBrepToString() == brep
        assert np.allclose(surface_of(restored.Shape).poles, before[2], atol=1e-9)
    finally:
        FreeCAD.closeDocument(again.Name)


def test_the_surface_follows_a_rail_that_moves(doc: Any) -> None:
    rails, profiles = half_pipe(doc)
    swept = document.make_swept_surface(doc, rails, profiles)
    doc.recompute()
    area = swept.Shape.Area
    rails[0].Shape = Part.LineSegment(V(0, 17, 0), V(60, 17.6, 0.4)).toShape()
    doc.recompute()
    assert swept.Shape.Area != pytest.approx(area, rel=1e-4)
    corner = surface_of(swept.Shape).evaluate(1.0, 0.0)
    assert np.allclose(corner, (60, 17.6, 0.4), atol=1e-6)


def test_a_step_file_reopens_with_the_same_area(doc: Any, tmp_path: Path) -> None:
    swept = document.make_swept_surface(doc, *half_pipe(doc))
    doc.recompute()
    document.export_step([swept], tmp_path / "swept.step")
    read = Part.Shape()
    read.read(str(tmp_path / "swept.step"))
    assert read.Area == pytest.approx(swept.Shape.Area, rel=1e-6)


@pytest.mark.parametrize(
    "spoil, words",
    [
        ("gap", "Profiles and rails do not meet. Gaps at the first and second rail"),
        ("closed", "is closed"),
        ("crossing", "rails meet or cross near"),
        ("one profile", "needs 2 or more profiles, not 1"),
        ("few points", "need at least"),
        ("far cloud", "No point of the cloud"),
    ],
)
def test_what_cannot_be_swept_says_why_and_keeps_the_last_shape(
    doc: Any, spoil: str, words: str
) -> None:
    rails, profiles = half_pipe(doc)
    swept = document.make_swept_surface(doc, rails, profiles)
    doc.recompute()
    area = swept.Shape.Area
    if spoil == "gap":
        profiles[1].Shape = arc(66.0, 17.0)
    elif spoil == "closed":
        rails[0].Shape = Part.Circle(V(0, 0, 0), V(0, 0, 1), 17).toShape()
    elif spoil == "crossing":
        rails[0].Shape = Part.LineSegment(V(0, 17, 0), V(60, -50, 0)).toShape()
        swept.LargestGap = 100.0
    elif spoil == "one profile":
        swept.Profiles = profiles[:1]
    elif spoil == "few points":
        swept.Cloud = document.make_cloud(doc, on_half_pipe(30, 17.0))
    elif spoil == "far cloud":
        swept.Cloud = document.make_cloud(doc, on_half_pipe(300, 117.0))
    doc.recompute()
    assert "Invalid" in swept.State
    assert words in swept.Message
    assert swept.Shape.Area == pytest.approx(area)


def test_profiles_drawn_the_other_way_and_long_rails_are_mended_and_said(doc: Any) -> None:
    rails, profiles = half_pipe(doc)
    rails[1].Shape = Part.LineSegment(V(-5, -17, 0), V(68, -17, 0)).toShape()
    profiles[1].Shape = Part.Arc(V(60, -17, 0), V(60, 0, -17), V(60, 17, 0)).toShape()
    swept = document.make_swept_surface(doc, rails, profiles)
    doc.recompute()
    assert "Invalid" not in swept.State
    assert swept.Message == (
        "Profile 2 was turned round. Rail 2 was cut by 13 mm to end at the profiles."
    )
    assert swept.Shape.Area == pytest.approx(np.pi * 17 * 60, rel=1e-3)
    swept.CutRails = False
    doc.recompute()
    assert "Invalid" in swept.State and "(CutRails)" in swept.Message


def _over(swept: Any, share: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Parameters all over a swept object's face."""
    (u0, u1), (v0, v1) = surface_of(swept.Shape).parameter_range
    return u0 + share * (u1 - u0), (v0 + share * (v1 - v0)).T


def test_extrusions_and_revolutions_are_offered_as_what_they_are(doc: Any) -> None:
    pipe = document.make_swept_surface(doc, *half_pipe(doc))
    bend = [
        feature(doc, Part.makeCircle(radius, V(0, 0, 0), V(0, 0, 1), 0, 90), "Rail")
        for radius in (30, 50)
    ]
    ends = [
        feature(doc, Part.Arc(30 * way, 40 * way - V(0, 0, 10), 50 * way).toShape(), "Profile")
        for way in (V(1, 0, 0), V(0, 1, 0))
    ]
    turned = document.make_swept_surface(doc, bend, ends)
    doc.recompute()
    areas = [swept.Shape.Area for swept in (pipe, turned)]
    for swept in (pipe, turned):
        swept.Exact = True
    doc.recompute()
    assert pipe.Shape.Faces[0].Surface.TypeId == "Part::GeomSurfaceOfExtrusion"
    assert turned.Shape.Faces[0].Surface.TypeId in (
        "Part::GeomSurfaceOfRevolution",
        "Part::GeomToroid",
    )
    share = np.linspace(0, 1, 7)[:, None]
    x, y, z = np.moveaxis(surface_of(pipe.Shape).evaluate(*_over(pipe, share)), -1, 0)
    assert np.allclose(np.hypot(y, z), 17.0, atol=1e-7) and np.ptp(x) == pytest.approx(60)
    x, y, z = np.moveaxis(surface_of(turned.Shape).evaluate(*_over(turned, share)), -1, 0)
    assert np.allclose(np.hypot(np.hypot(x, y) - 40, z), 10.0, atol=1e-3)
    assert [swept.Shape.Area for swept in (pipe, turned)] == pytest.approx(areas, rel=1e-3)
    ends[1].Shape = Part.makeLine(V(0, 30, 0), V(0, 50, 0))
    doc.recompute()
    assert "neither an extrusion nor a revolution" in turned.Message


def test_a_sweep_through_itself_is_made_and_said(doc: Any) -> None:
    a = np.linspace(-0.6, np.pi + 0.6, 60)[:, None]  # half a figure of eight
    path = np.hstack([80 * np.sin(a), 40 * np.sin(2 * a), a])
    way = np.hstack([80 * np.cos(a), 80 * np.cos(2 * a), 0 * a])
    left = np.cross([0.0, 0, 1], way) / np.linalg.norm(way, axis=1)[:, None]
    rails, ends = [], []
    for across in (-8.0, 8.0):
        curve = Part.BSplineCurve()
        curve.interpolate([V(*row) for row in path + across * left])
        rails.append(feature(doc, curve.toShape(), "Rail"))
        ends.append([rails[-1].Shape.valueAt(t) for t in rails[-1].Shape.ParameterRange])
    dishes = [
        feature(doc, Part.Arc(one, (one + two) * 0.5 - V(0, 0, 7), two).toShape(), "Dish")
        for one, two in zip(*ends, strict=True)
    ]
    swept = document.make_swept_surface(doc, rails, dishes, model="rotate")
    doc.recompute()
    assert "Invalid" not in swept.State
    assert "passes through itself near" in swept.Message


def test_a_missing_quarter_and_points_beyond_the_rim_are_said(doc: Any) -> None:
    angle, x = np.random.default_rng(0).uniform((0, -4), (np.pi, 60), (4000, 2)).T
    there = (x < 30) | (angle < np.pi / 2)
    points = np.column_stack([x, 17 * np.cos(angle), -17 * np.sin(angle)])[there]
    segment = document.make_cloud(doc, points)
    swept = document.make_swept_surface(
        doc, *half_pipe(doc), segment, "rotate", control_points=(11, 7), distance=5.0
    )
    free = document.make_fitted_surface(doc, segment, swept, (15, 13), distance=5.0)
    doc.recompute()
    for surface in (swept, free):
        assert "Invalid" not in surface.State
        assert "The cloud does not support" in surface.Message
        assert "of its area, the largest piece from u = " in surface.Message
        assert surface.Supported == pytest.approx(75, abs=12)
    beyond = document.make_deviation_map(doc, segment, swept)
    doc.recompute()
    outside = int((points[:, 0] < -0.1).sum())
    assert f"{len(points) - beyond.PointCount} points beyond the rim" in beyond.Message
    assert len(points) - beyond.PointCount >= outside


def test_fewer_points_than_unknowns_are_said(doc: Any) -> None:
    rails, profiles = half_pipe(doc)
    base = document.make_swept_surface(doc, rails, profiles)
    few = document.make_cloud(doc, on_half_pipe(40, 17.0))
    fit = document.make_fitted_surface(doc, few, base, (12, 6))
    doc.recompute()
    assert fit.Message.startswith("12 × 6 control points need at least 72 points, and only 40")
    assert "Invalid" in fit.State


def test_wrong_arguments_make_nothing(doc: Any) -> None:
    rails, profiles = half_pipe(doc)
    count = len(doc.Objects)
    with pytest.raises(ValueError, match="no sweep model 'twist'"):
        document.make_swept_surface(doc, rails, profiles, model="twist")
    with pytest.raises(ValueError, match="is not a point cloud"):
        document.make_swept_surface(doc, rails, profiles, rails[0])
    with pytest.raises(ValueError, match="The rail 'x' has no shape"):
        document.make_swept_surface(doc, ["x"], profiles)
    assert len(doc.Objects) == count
