# SPDX-License-Identifier: LGPL-2.1-or-later
"""Deviations from any shape are those of its exact faces, and are mapped in colour."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402
from freecad_edgescan.document.deviation_map import deviation_colours  # noqa: E402

V = FreeCAD.Vector
rng = np.random.default_rng(0)


def parts() -> dict[str, Any]:
    box = Part.makeBox(20, 15, 10)
    drilled = box.cut(Part.makeCylinder(3, 20, V(8, 7, -5)))
    moved = box.copy()
    moved.Placement = FreeCAD.Placement(V(1, 2, 3), FreeCAD.Rotation(V(1, 1, 0), 40))
    return {
        "box": box,
        "drilled": drilled,
        "moved": moved,
        "cylinder": Part.makeCylinder(5, 12),
        "cone": Part.makeCone(6, 2, 12),
        "filleted": box.makeFillet(2.0, box.Edges[:4]),
    }


@pytest.mark.parametrize("name", parts())
def test_distances_are_opencascades_and_signs_tell_inside(name: str) -> None:
    part = parts()[name]
    box = part.BoundBox
    low, high = (box.XMin, box.YMin, box.ZMin), (box.XMax, box.YMax, box.ZMax)
    points = rng.uniform(np.array(low) - 3, np.array(high) + 3, (120, 3))
    found = document.shape_deviation(points, part)
    exact = np.array([part.Shells[0].distToShape(Part.Vertex(V(*p)))[0] for p in points])
    assert np.allclose(np.abs(found.deviation), exact, atol=1e-5)
    inside = np.array([part.isInside(V(*p), 1e-7, True) for p in points])
    assert np.array_equal(found.deviation < 0.0, inside)
    assert not found.outside.any()


def test_points_beyond_a_free_rim_are_told() -> None:
    face = Part.makePlane(10, 10).Faces[0]
    disc = Part.Face(Part.Wire(Part.makeCircle(4, V(5, 5, 0))))
    points = np.array([[5, 5, 1.0], [-2, 5, 0], [5, 8.5, -1], [5, 9.5, -1]])
    assert document.shape_deviation(points, face).deviation == pytest.approx([1, 2, -1, -1])
    assert document.shape_deviation(points, face).outside.tolist() == [False, True, False, False]
    assert document.shape_deviation(points, disc).outside.tolist() == [False, True, False, True]


def test_a_map_has_colours_figures_and_a_histogram(doc: Any) -> None:
    count = 4000
    x, y = rng.uniform(0.1, 29.9, (2, count))
    height = rng.normal(0, 0.05, count)
    cloud = document.make_cloud(
        doc, np.vstack([np.column_stack([x, y, height]), rng.uniform(50, 60, (100, 3))])
    )
    plane = doc.addObject("Part::Feature", "Plane")
    plane.Shape = Part.makePlane(30, 30)
    made = document.make_deviation_map(doc, cloud, plane)
    doc.recompute()
    assert made.PointCount == len(made.Color) == len(made.Deviations) == count
    assert made.Average.Value == pytest.approx(np.abs(height).mean(), rel=1e-4)
    assert made.RootMeanSquare.Value == pytest.approx(height.std(), rel=1e-2)
    assert sum(made.Histogram) == count
    assert "100 points" in made.Message
    red = np.array([colour[0] - colour[2] for colour in made.Color])
    assert np.corrcoef(red, made.Deviations)[0, 1] > 0.8
    plane.Placement.Base = V(0, 0, 0.2)
    doc.recompute()
    assert made.Mean.Value == pytest.approx(-0.2, abs=0.01)
    plane.Placement.Base = V(0, 0, 20)
    doc.recompute()
    assert "within 3 mm" in made.Message and "Invalid" in made.State


def test_colours_are_blue_white_and_red() -> None:
    blue, white, red = deviation_colours([-9.0, 0.0, 9.0], 1.0)
    assert blue[2] > blue[0] and red[0] > red[2] and white.min() > 0.9


def test_a_table_holds_each_point(tmp_path: Path) -> None:
    points = rng.uniform(0, 10, (50, 3))
    found = document.shape_deviation(points, Part.makePlane(20, 20))
    document.write_deviations(points, found, tmp_path / "deviation.csv")
    table = np.loadtxt(tmp_path / "deviation.csv", delimiter=",", skiprows=1)
    assert np.allclose(table[:, 3], found.deviation, atol=1e-6)


def test_what_cannot_be_measured_is_refused(doc: Any) -> None:
    cloud = document.make_cloud(doc, rng.random((50, 3)))
    with pytest.raises(ValueError, match="no face"):
        document.shape_deviation(rng.random((5, 3)), Part.makeLine(V(0, 0, 0), V(1, 0, 0)))
    with pytest.raises(ValueError, match="has no shape"):
        document.make_deviation_map(doc, cloud, cloud)
    plane = doc.addObject("Part::Feature", "Plane")
    with pytest.raises(ValueError, match="reach is -1"):
        document.make_deviation_map(doc, cloud, plane, reach=-1.0)


def test_what_has_no_face_is_refused_before_anything_is_made(doc: Any) -> None:
    cloud = document.make_cloud(doc, rng.random((40, 3)))
    line, box = doc.addObject("Part::Line", "Line"), doc.addObject("Part::Box", "Box")
    document.make_deviation_map(doc, cloud, box)  # has no shape yet, and gets one
    doc.recompute()
    count = len(doc.Objects)
    with pytest.raises(ValueError, match=r"'Line' has no face; .* choose another"):
        document.make_deviation_map(doc, cloud, line)
    assert len(doc.Objects) == count
