# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scanned edges carry sweeps and lofts, and go into STEP files as curves."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402

V = FreeCAD.Vector


@pytest.fixture(scope="module")
def numbers() -> Any:
    return document.simulate_cloud(Part.makeCylinder(10, 12), 0.4, 0.01)


@pytest.fixture
def rim(doc: Any, numbers: Any) -> Any:
    made = document.make_scanned_edge(doc, document.make_cloud(doc, numbers), at=(10, 0, 12))
    doc.recompute()
    return made


def line(doc: Any, start: tuple[float, ...], end: tuple[float, ...]) -> Any:
    made = doc.addObject("Part::Feature", "Line")
    made.Shape = Part.makeLine(V(*start), V(*end))
    return made


def test_a_sweep_on_a_scanned_edge_follows_it_when_it_is_scanned_again(doc: Any, rim: Any) -> None:
    start = rim.Shape.Vertexes[0].Point
    profile = line(doc, tuple(start), tuple(start + V(0, 0, 2)))
    sweep = document.make_sweep(doc, profile, rim)
    doc.recompute()
    assert sweep.Frames == "at a fixed angle to the plane of the rail"
    assert sweep.Shape.isValid()
    assert sweep.Shape.Area == pytest.approx(20 * np.pi * 2, rel=0.01)
    rim.Cloud.Placement.Base = V(0, 0, 30)
    rim.At = rim.At + V(0, 0, 30)
    profile.Placement.Base = V(0, 0, 30)
    doc.recompute()
    assert sweep.Shape.CenterOfMass.z == pytest.approx(43.0, abs=0.1)


def wave(rise: float = 0.0) -> Any:
    """An almost straight B-spline that bends both ways, in z = 0 unless it rises."""
    x = np.linspace(0.0, 300.0, 16)
    places = np.column_stack([x, 1e-3 * x * np.sin(x / 40.0), rise * np.sin(x / 25.0)])
    curve = Part.BSplineCurve()
    curve.interpolate([V(*place) for place in places])
    return curve.toShape()


def rail_of(doc: Any, edge: Any) -> Any:
    made = doc.addObject("Part::Feature", "Rail")
    made.Shape = edge
    return made


def test_a_profile_keeps_its_angle_to_the_plane_of_a_rail_that_bends_both_ways(doc: Any) -> None:
    rail = rail_of(doc, wave())
    sweep = document.make_sweep(doc, line(doc, (0, 0, 0), (0, 0, 20)), rail)
    doc.recompute()
    assert sweep.Shape.Area == pytest.approx(20 * rail.Shape.Length, rel=1e-6)
    vertices, _ = sweep.Shape.tessellate(0.1)
    heights = np.array([vertex.z for vertex in vertices])
    assert heights.min() == pytest.approx(0.0, abs=1e-6)
    assert heights.max() == pytest.approx(20.0, abs=1e-6)


@pytest.mark.parametrize("rise", [1e-4, 3.0])
def test_along_a_rail_in_no_plane_a_sweep_stays_near_the_rail(doc: Any, rise: float) -> None:
    rail = rail_of(doc, wave(rise))
    sweep = document.make_sweep(doc, line(doc, (0, 0, 0), (0, 0, 20)), rail)
    doc.recompute()
    assert sweep.Frames == "turning least"
    # a ribbon that turns least is as long and as wide as its rail and its profile
    assert sweep.Shape.Area == pytest.approx(20 * rail.Shape.Length, rel=0.01)
    vertices, _ = sweep.Shape.tessellate(0.5)
    box = rail.Shape.BoundBox
    box.enlarge(21.0)
    assert all(box.isInside(vertex) for vertex in vertices)


def test_a_closed_profile_gives_a_solid_when_it_is_asked_for(doc: Any) -> None:
    rail = rail_of(doc, wave())
    profile = doc.addObject("Part::Feature", "Ring")
    profile.Shape = Part.makeCircle(5, V(0, 0, 0), rail.Shape.tangentAt(rail.Shape.FirstParameter))
    sweep = document.make_sweep(doc, profile, rail)
    sweep.Solid = True
    doc.recompute()
    assert sweep.Shape.ShapeType == "Solid"
    assert sweep.Shape.Volume == pytest.approx(25 * np.pi * rail.Shape.Length, rel=1e-4)


def test_a_sweep_follows_its_profile_and_is_found_again_in_the_file(
    doc: Any, tmp_path: Path
) -> None:
    profile = line(doc, (0, 0, 0), (0, 0, 20))
    sweep = document.make_sweep(doc, profile, rail_of(doc, wave()))
    doc.recompute()
    area, path = sweep.Shape.Area, str(tmp_path / "sweep.FCStd")
    doc.saveAs(path)
    read = FreeCAD.openDocument(path)
    try:
        assert read.Sweep.Shape.Area == pytest.approx(area)
        assert "surface" in read.Sweep.Message
        read.Line.Shape = Part.makeLine(V(0, 0, 0), V(0, 0, 10))
        read.recompute()
        assert read.Sweep.Shape.Area == pytest.approx(area / 2)
    finally:
        FreeCAD.closeDocument(read.Name)


def test_a_sweep_of_an_older_file_gets_a_message(doc: Any, tmp_path: Path) -> None:
    sweep = document.make_sweep(doc, line(doc, (0, 0, 0), (0, 0, 20)), rail_of(doc, wave()))
    doc.recompute()
    sweep.removeProperty("Message")
    path = str(tmp_path / "older.FCStd")
    doc.saveAs(path)
    read = FreeCAD.openDocument(path)
    try:
        read.Sweep.touch()
        read.recompute()
        assert "surface" in read.Sweep.Message
    finally:
        FreeCAD.closeDocument(read.Name)


def test_a_surface_that_shoots_out_is_known() -> None:
    from freecad_edgescan.document.sweep_shape import is_within_reach

    upright, along = Part.makeLine(V(0, 0, 0), V(0, 0, 20)), V(300, 0, 0)
    profile, rail = Part.Wire(upright), Part.Wire(Part.makeLine(V(0, 0, 0), along))
    assert is_within_reach(upright.extrude(along), profile, rail)
    longer = Part.makeLine(V(0, 0, 0), V(0, 0, 40)).extrude(along)
    assert not is_within_reach(longer, profile, rail)


def test_an_open_profile_gives_no_solid_and_that_is_said(doc: Any) -> None:
    sweep = document.make_sweep(doc, line(doc, (0, 0, 0), (0, 0, 20)), rail_of(doc, wave()))
    sweep.Solid = True
    doc.recompute()
    assert "closed profile" in sweep.getStatusString()


def test_what_cannot_be_swept_is_said_and_the_last_sweep_stays(doc: Any) -> None:
    profile = line(doc, (0, 0, 0), (0, 0, 20))
    sweep = document.make_sweep(doc, profile, rail_of(doc, wave()))
    doc.recompute()
    area = sweep.Shape.Area
    profile.Shape = Part.Compound(
        [Part.makeLine(V(0, 0, 0), V(0, 0, 1)), Part.makeLine(V(0, 5, 0), V(0, 5, 1))]
    )
    doc.recompute()
    assert "2 wires" in sweep.Message and sweep.Message in sweep.getStatusString()
    assert sweep.Shape.Area == area


def test_a_loft_joins_two_rims(doc: Any, rim: Any) -> None:
    other = document.make_scanned_edge(doc, rim.Cloud, at=(10, 0, 0))
    loft = document.make_loft(doc, [rim, other])
    doc.recompute()
    assert loft.TypeId == "Part::Loft"
    assert loft.Shape.Area == pytest.approx(20 * np.pi * 12, rel=0.01)


@pytest.mark.parametrize("sections", [[], ["rim"], ["rim", "rim"]])
def test_a_loft_needs_two_different_sections(doc: Any, rim: Any, sections: list[str]) -> None:
    before = list(doc.Objects)
    with pytest.raises(ValueError, match=r"sections|follows itself"):
        document.make_loft(doc, [rim for _ in sections])
    assert doc.Objects == before


def test_profile_and_rail_must_differ_and_have_shapes(doc: Any, rim: Any) -> None:
    with pytest.raises(ValueError, match="both 'ScannedEdge'"):
        document.make_sweep(doc, rim, rim)
    with pytest.raises(ValueError, match="'Cloud' has no shape"):
        document.make_sweep(doc, rim.Cloud, rim)


def test_a_step_file_holds_the_native_circle(doc: Any, rim: Any, tmp_path: Path) -> None:
    path = tmp_path / "rim.step"
    document.export_step([rim], path)
    read = Part.Shape()
    read.read(str(path))
    (edge,) = read.Edges
    assert isinstance(edge.Curve, Part.Circle)
    assert edge.Curve.Radius == pytest.approx(rim.Shape.Curve.Radius, abs=1e-9)


def test_results_and_shapes_can_be_written_too(numbers: Any, tmp_path: Path) -> None:
    from freecad_edgescan.scanning import scan_edge

    path = tmp_path / "both.step"
    document.export_step([scan_edge(numbers, at=(10, 0, 12)), Part.makeBox(1, 1, 1)], path)
    read = Part.Shape()
    read.read(str(path))
    assert len(read.Edges) == 13


def test_a_far_edge_is_written_at_its_true_place(doc: Any, numbers: Any, tmp_path: Path) -> None:
    far = np.array([500000.0, 4500000.0, 0.0])
    cloud = document.make_cloud(doc, numbers.points + far)
    at = np.array([10, 0, 12]) + far - np.array(cloud.Origin)
    rim = document.make_scanned_edge(doc, cloud, at=at)
    doc.recompute()
    path = tmp_path / "far.step"
    document.export_step([rim], path)
    read = Part.Shape()
    read.read(str(path))
    np.testing.assert_allclose(
        tuple(read.Edges[0].Curve.Center), far + np.array([0, 0, 12]), atol=0.05
    )


def test_what_cannot_be_written_is_said_and_nothing_is_written(doc: Any, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="nothing to write"):
        document.export_step([], tmp_path / "nothing.step")
    box, failed = Part.makeBox(1, 1, 1), doc.addObject("Part::Feature", "Pipe")
    with pytest.raises(ValueError, match=r"'Pipe' has no shape yet"):
        document.export_step([box, failed], tmp_path / "both.step")
    with pytest.raises(ValueError, match="cannot be written"):
        document.export_step([box], tmp_path / "no" / "box.step")
    assert not list(tmp_path.iterdir())
