# SPDX-License-Identifier: LGPL-2.1-or-later
"""The true edges of a shape are its sharp ones, with angle, side and room."""

from __future__ import annotations

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402
from freecad_edgescan.document.sharp_edges import smooth_faces  # noqa: E402
from freecad_edgescan.document.varied_parts import varied_parts  # noqa: E402

V = FreeCAD.Vector


def test_a_box_has_twelve_convex_right_angles() -> None:
    edges = document.true_edges(Part.makeBox(20, 15, 10))
    assert len(edges) == 12
    assert sorted(round(edge.length, 9) for edge in edges) == [10.0] * 4 + [15.0] * 4 + [20.0] * 4
    for edge in edges:
        np.testing.assert_allclose(edge.angle, np.pi / 2, atol=1e-12)
        assert edge.convex is True
        assert not edge.closed


def test_room_in_a_box_is_the_way_to_the_nearest_parallel_edge() -> None:
    for edge in document.true_edges(Part.makeBox(20, 15, 10)):
        expected = 15.0 if edge.length < 11.0 else 10.0
        np.testing.assert_allclose(edge.room, expected, atol=1e-6)


def test_a_cylinder_has_two_closed_rims_and_its_seam_is_no_edge() -> None:
    edges = document.true_edges(Part.makeCylinder(10, 12))
    assert [edge.closed for edge in edges] == [True, True]
    for edge in edges:
        assert edge.length == pytest.approx(20 * np.pi, rel=1e-5)
        np.testing.assert_allclose(edge.angle, np.pi / 2, atol=1e-9)
        np.testing.assert_allclose(edge.room, 12.0, rtol=1e-2)


def test_samples_are_dense_enough_for_the_curve() -> None:
    rim = document.true_edges(Part.makeCylinder(10, 12))[0]
    middles = (rim.points + np.roll(rim.points, -1, axis=0)) / 2
    assert np.abs(np.hypot(middles[:, 0], middles[:, 1]) - 10.0).max() < 1e-6 * rim.length
    expected = np.column_stack([-rim.points[:, 1], rim.points[:, 0], 0 * rim.points[:, 0]]) / 10
    assert np.abs(np.abs(np.einsum("ij,ij->i", rim.tangents, expected)) - 1).max() < 1e-12


def test_the_bottom_of_a_step_is_concave() -> None:
    step = Part.makeBox(10, 10, 2).fuse(Part.makeBox(5, 10, 6)).removeSplitter()
    concave = [edge for edge in document.true_edges(step) if edge.convex is False]
    assert len(concave) == 1
    np.testing.assert_allclose(concave[0].points[:, [0, 2]], [[5.0, 2.0]] * len(concave[0].points))


def test_a_rounded_edge_is_not_sharp() -> None:
    box = Part.makeBox(20, 15, 10)
    rounded = box.makeFillet(2.0, [box.Edges[0]])
    assert len(document.true_edges(rounded)) == 13  # two end arcs for one edge


def test_min_angle_decides_which_edges_count() -> None:
    wedge = Part.makePolygon([V(0, 0, 0), V(10, 0, 0), V(20, 1, 0), V(20, 10, 0), V(0, 10, 0)] * 1)
    wedge = Part.makePolygon([*(v.Point for v in wedge.Vertexes), V(0, 0, 0)])
    prism = Part.Face(wedge).extrude(V(0, 0, 5))
    turn = np.arctan(0.1)
    assert len(document.true_edges(prism, min_angle=turn + 0.01)) == 14
    assert len(document.true_edges(prism, min_angle=turn - 0.01)) == 15


def test_a_moved_and_turned_shape_has_moved_edges() -> None:
    box = Part.makeBox(20, 15, 10)
    box.Placement = FreeCAD.Placement(V(100, 0, 0), FreeCAD.Rotation(V(0, 0, 1), 90))
    edges = document.true_edges(box)
    assert len(edges) == 12
    assert all(edge.convex for edge in edges)
    assert min(edge.points[:, 0].min() for edge in edges) == pytest.approx(85.0)


def test_a_wire_has_no_faces_to_meet() -> None:
    with pytest.raises(ValueError, match="without faces"):
        document.true_edges(Part.makeCircle(3))


def test_faces_that_meet_without_an_edge_are_one_smooth_face() -> None:
    box = Part.makeBox(20, 15, 10)
    assert len(set(smooth_faces(box))) == 6
    rounded = box.makeFillet(2.0, [box.Edges[0]])
    labels = smooth_faces(rounded)
    assert len(labels) == 7 and len(set(labels)) == 5
    assert len(set(smooth_faces(Part.makeCylinder(10, 12)))) == 3


@pytest.mark.parametrize("name, shape", varied_parts())
def test_the_parts_to_try_edges_on_are_sound_solids(name: str, shape: Part.Shape) -> None:
    assert shape.isValid() and len(shape.Solids) == 1
    assert len(document.true_edges(shape)) >= 12
