# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sweeps round corners, held against Pappus: a mitre in a plane keeps area and volume."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402
from freecad_edgescan.document.sewn_sweep import sewn_sweep  # noqa: E402
from freecad_edgescan.document.sweep_shape import sweep_shape  # noqa: E402

V = FreeCAD.Vector
RADIUS = 0.5
SIZE = (24.0, 18.0, 12.0)
TOP = ((12.0, 0.0, 12.0), (24.0, 9.0, 12.0), (12.0, 18.0, 12.0), (0.0, 9.0, 12.0))


def polygon(*corners: tuple[float, ...]) -> Any:
    return Part.makePolygon([V(*corner) for corner in corners])


def frame(lift: float = 0.0) -> Any:
    """Four edges, one corner of them out of the plane of the others."""
    return polygon((0, 0, 0), (24, 0, 0), (24, 18, lift), (0, 18, 0), (0, 0, 0))


def ring(at: Any, along: Any, radius: float = RADIUS) -> Any:
    return Part.Wire(Part.makeCircle(radius, at, along))


def require_tube(profile: Any, rail: Any, radius: float = RADIUS, rel: float = 1e-6) -> None:
    """Circumference and area of the profile times the length of the rail (Pappus)."""
    for solid in (False, True):
        shape, _ = sweep_shape(profile, rail, solid)
        assert shape.isValid()
        if solid:
            assert shape.ShapeType == "Solid"
            truth = np.pi * radius**2 * rail.Length
            assert shape.Volume == pytest.approx(truth, rel=rel)
        else:
            truth = 2 * np.pi * radius * rail.Length
            assert shape.Area == pytest.approx(truth, rel=rel)


@pytest.mark.parametrize("at", [(0, 0, 0), (12, 0, 0), (24, 9, 0), (0, 18, 0)])
def test_a_tube_round_a_closed_frame_wherever_its_profile_stands(at: tuple[float, ...]) -> None:
    along = V(0, 1, 0) if at == (24, 9, 0) else V(1, 0, 0)
    require_tube(ring(V(*at), along), frame())


@pytest.mark.parametrize("turn", [1.0, 45.0, 90.0, 119.0])
@pytest.mark.parametrize("end", [0, 1, 2, 3])
def test_a_tube_along_an_open_rail_that_turns_both_ways(turn: float, end: int) -> None:
    tangents = [V(1, 0, 0), V(np.cos(np.radians(turn)), np.sin(np.radians(turn)), 0), V(1, 0, 0)]
    places = [V(0, 0, 0)]
    for tangent in tangents:
        places.append(places[-1] + tangent * 10.0)
    require_tube(ring(places[end], tangents[min(end, 2)]), Part.makePolygon(places))


@pytest.mark.parametrize("lift", [0.02, 0.3])
def test_corners_in_no_plane(lift: float) -> None:
    require_tube(ring(V(12, 0, 0), V(1, 0, 0)), frame(lift), rel=1e-3)


def test_a_flat_bar_in_no_plane_comes_round_to_where_it_began() -> None:
    rail = polygon((0, 0, 0), (10, 0, 0), (10, 9, 5), (0, 9, 9), (0, 0, 0))
    bar = polygon((5, 1, 0.5), (5, -1, 0.5), (5, -1, -0.5), (5, 1, -0.5), (5, 1, 0.5))
    shape, planar = sweep_shape(bar, rail, True)
    assert not planar and shape.isValid()
    # Ruled sides between ends that are turned by some degrees are a little narrower.
    assert shape.Volume == pytest.approx(2.0 * 1.0 * rail.Length, rel=1e-4)


@pytest.mark.parametrize("tilt", [1e-3, 1e-2, 5e-2])
@pytest.mark.parametrize("at", [0.0, 12.0])
def test_a_profile_off_square_leaves_a_tube_as_narrow_as_it_looks(tilt: float, at: float) -> None:
    profile = ring(V(at, 0, 0), V(np.cos(tilt), np.sin(tilt), 0))
    shape, _ = sweep_shape(profile, frame(), True)
    area = np.pi * RADIUS**2 * np.cos(tilt)
    assert shape.isValid()
    assert shape.Volume == pytest.approx(area * frame().Length, rel=1e-6)


def test_a_box_section_has_its_mitres_in_the_planes_that_halve_the_corners() -> None:
    section = polygon((12, -1, -1), (12, 1, -1), (12, 1, 1), (12, -1, 1), (12, -1, -1))
    shape, planar = sweep_shape(section, frame(), True)
    assert planar and len(shape.Faces) == 16
    outer, inner = Part.makeBox(26, 20, 2, V(-1, -1, -1)), Part.makeBox(22, 16, 2, V(1, 1, -1))
    truth = outer.cut(inner)
    assert shape.Volume == pytest.approx(truth.Volume, rel=1e-9)
    assert shape.common(truth).Volume == pytest.approx(truth.Volume, rel=1e-9)


def test_a_wall_that_stands_on_the_rail_keeps_upright() -> None:
    shape, _ = sweep_shape(polygon((3, 0, 0), (3, 0, 5)), frame())
    assert shape.Area == pytest.approx(5.0 * frame().Length, rel=1e-9)
    assert shape.BoundBox.ZLength == pytest.approx(5.0, abs=1e-6)


def test_a_single_face_is_a_shell_too() -> None:
    shape = sewn_sweep(polygon((0, 0, 0), (0, 0, 2)), polygon((0, 0, 0), (9, 0, 0)), False)
    assert shape.ShapeType == "Shell" and shape.isValid()
    assert shape.Area == pytest.approx(2.0 * 9.0, rel=1e-12)


def test_a_closed_smooth_rail_gives_a_torus() -> None:
    rail = Part.Wire(Part.makeCircle(5.0))
    shape = sewn_sweep(ring(V(5, 0, 0), V(0, 1, 0)), rail, True)
    assert shape.ShapeType == "Solid" and shape.isValid()
    assert shape.Volume == pytest.approx(2 * np.pi**2 * 5.0 * RADIUS**2, rel=1e-5)


def test_edges_drawn_against_each_other_are_one_rail() -> None:
    places = [V(0, 0, 0), V(24, 0, 0), V(24, 18, 0), V(40, 18, 0)]
    edges = [Part.makeLine(*pair) for pair in pairwise(places)]
    edges[1] = Part.makeLine(places[2], places[1])
    rail = Part.Wire(Part.sortEdges(edges)[0])
    require_tube(ring(V(24, 9, 0), V(0, 1, 0)), rail)


@pytest.mark.parametrize("away", [1.0, -1.0])
def test_arcs_with_a_corner_between_them(away: float) -> None:
    one = Part.Arc(V(0, 0, 0), V(10 - 10 * np.cos(0.8), 10 * np.sin(0.8), 0), V(10, 10, 0))
    other = Part.makeLine(V(10, 10, 0), V(10, 10 + 15 * away, 0))
    rail = Part.Wire([one.toShape(), other])
    # At the corner s = RADIUS is taken off the arc's inner side: RADIUS²/20 of it is off.
    require_tube(ring(V(0, 0, 0), V(0, 1, 0)), rail, rel=1e-3)


def test_a_spline_with_corners_is_mitred_in_them() -> None:
    curve = Part.BSplineCurve()
    corners = [V(0, 0, 0), V(24, 0, 0), V(24, 18, 0), V(40, 18, 0)]
    curve.buildFromPolesMultsKnots(corners, [2, 1, 1, 2], [0.0, 1.0, 2.0, 3.0], False, 1)
    require_tube(ring(V(24, 9, 0), V(0, 1, 0)), Part.Wire(curve.toShape()))


def test_the_volume_along_a_rail_that_bends_often_is_right_too() -> None:
    along = np.linspace(0.0, 60.0, 40)
    curve = Part.BSplineCurve()
    curve.interpolate(
        [V(x, 1.5 * np.sin(0.6 * x), np.cos(0.9 * x) + 0.3 * np.sin(2 * x)) for x in along]
    )
    rail = Part.Wire(curve.toShape())
    profile = ring(rail.Edges[0].valueAt(0.0), rail.Edges[0].tangentAt(0.0), 0.3)
    tube = sewn_sweep(profile, rail, True)
    assert tube.isValid()
    assert tube.Volume == pytest.approx(np.pi * 0.3**2 * rail.Length, rel=1e-3)


@pytest.mark.parametrize(
    ("rail", "radius", "sentence"),
    [
        (polygon((0, 0, 0), (10, 0, 0), (1, 3, 0)), 0.5, r"turns by 162° at \(10, 0, 0\)"),
        (polygon((0, 0, 0), (9, 0, 0), (9, 1, 0), (0, 1, 0)), 1.5, "too wide for the rail"),
    ],
)
def test_what_has_no_room_is_one_sentence(rail: Any, radius: float, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        sweep_shape(ring(V(0, 0, 0), V(1, 0, 0), radius), rail)


def test_a_profile_that_lies_along_the_rail_is_refused() -> None:
    with pytest.raises(ValueError, match="lies along the rail"):
        sweep_shape(polygon((2, 0, 0), (5, 0, 0)), frame())


def test_a_tube_round_scanned_edges_is_the_same_from_a_file(doc: Any, tmp_path: Path) -> None:
    points = document.simulate_cloud(Part.makeBox(*SIZE), 0.5, 0.05).points
    network = document.make_edge_network(doc, document.make_cloud(doc, points))
    doc.recompute()
    edges = network.Shape.Edges
    away = [[edge.distToShape(Part.Vertex(*place))[0] for edge in edges] for place in TOP]
    names = [f"Edge{row.index(min(row)) + 1}" for row in away]
    wire = document.make_edge_wire(doc, network, names)
    doc.recompute()
    first = wire.Shape.OrderedEdges[0]
    bead = doc.addObject("Part::Feature", "Bead")
    bead.Shape = ring(
        first.valueAt(first.FirstParameter), first.tangentAt(first.FirstParameter), 1.0
    )
    sweep = document.make_sweep(doc, bead, wire)
    doc.recompute()
    area, name, path = sweep.Shape.Area, sweep.Name, str(tmp_path / "frame.FCStd")
    assert sweep.isValid() and sweep.Shape.isValid()
    assert area == pytest.approx(2 * np.pi * wire.Length.Value, rel=1e-3)
    doc.saveAs(path)
    read = FreeCAD.openDocument(path)
    try:
        again = read.getObject(name)
        for item in (*again.Sections, again.Spine[0], again):
            item.touch()
        read.recompute()
        assert again.isValid() and again.Shape.isValid()
        assert again.Shape.Area == pytest.approx(area, rel=1e-6)
    finally:
        FreeCAD.closeDocument(read.Name)
