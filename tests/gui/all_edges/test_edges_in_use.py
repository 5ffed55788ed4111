# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a network and the faces between its edges are used for: wires, segments, sweeps, skins."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui as Gui
import numpy as np
import Part
import pytest

from .steps import PITCH, SIZE, TOP_FRONT


def edge_at(network: Any, place: tuple[float, float, float]) -> str:
    """Name of the edge at a place."""
    away = [edge.distToShape(Part.Vertex(*place))[0] for edge in network.Shape.Edges]
    return f"Edge{away.index(min(away)) + 1}"


def test_selected_edges_of_a_network_become_a_wire(
    known: Any, network: Any, recorded: list[str], problems: list[str]
) -> None:
    Gui.Selection.clearSelection()
    Gui.runCommand("EdgeScan_EdgeWire")
    assert "Select edges of one network" in problems.pop()
    for place in (TOP_FRONT, (24.0, 9.0, 12.0)):
        Gui.Selection.addSelection(network, edge_at(network, place))
    Gui.runCommand("EdgeScan_EdgeWire")
    (wire,) = Gui.Selection.getSelection()
    assert wire.Shape.ShapeType == "Wire"
    assert wire.Length.Value == pytest.approx(24 + 18, abs=0.5)
    assert any("make_edge_wire" in line for line in recorded)
    Gui.Selection.clearSelection()
    for place in (TOP_FRONT, (10.0, 18.0, 12.0)):
        Gui.Selection.addSelection(network, edge_at(network, place))
    Gui.runCommand("EdgeScan_EdgeWire")
    assert "separate chains" in problems.pop()


def test_a_click_takes_the_face_between_edges_as_a_segment(
    known: Any, network: Any, recorded: list[str]
) -> None:
    steps = known.doc.UndoCount
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(network)
    Gui.runCommand("EdgeScan_CloudSegment")
    known.settle()
    assert "face" in known.sentence and not known.button("Ok").isEnabled()
    known.click((8.0, 12.0, 12.0))
    known.wait_until(lambda: known.button("Ok").isEnabled())
    known.picture("region")
    known.ok()
    (segment,) = Gui.Selection.getSelection()
    points = np.array([tuple(point) for point in segment.Points.Points])
    assert np.mean(np.abs(points[:, 2] - SIZE[2]) < 0.3) > 0.9
    assert len(points) > 0.8 * SIZE[0] * SIZE[1] / PITCH**2
    assert known.doc.UndoCount == steps + 1
    name = segment.Name
    known.doc.undo()
    exec("import FreeCAD\n" + "\n".join(recorded), {})
    again = known.doc.getObject(name).Points.Points
    assert np.array_equal([tuple(point) for point in again], points)


def test_a_face_that_is_not_wanted_after_all_leaves_no_trace(known: Any, network: Any) -> None:
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(network)
    before = known.trace()
    Gui.runCommand("EdgeScan_CloudSegment")
    known.settle()
    known.click((8.0, 12.0, 12.0))
    known.press_escape()
    known.wait_until(lambda: not Gui.Control.activeDialog())
    known.wait_until(lambda: known.trace() == before)


def test_a_profile_is_swept_along_edges_picked_in_the_network(
    known: Any, network: Any, recorded: list[str]
) -> None:
    profile = known.doc.addObject("Part::Feature", "Profile")
    profile.Shape = Part.Wire(
        Part.makeCircle(0.5, FreeCAD.Vector(0, 0, 12), FreeCAD.Vector(1, 0, 0))
    )
    known.doc.recompute()
    steps = known.doc.UndoCount
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(profile)
    for place in (TOP_FRONT, (24.0, 9.0, 12.0)):
        Gui.Selection.addSelection(network, edge_at(network, place))
    Gui.runCommand("EdgeScan_Sweep")
    sweep = known.doc.Objects[-1]
    assert sweep.Spine[0].EdgeCount == 2
    # The lengths of both edges, mitred in the corner, times the profile's circumference; the
    # profile stands at the box's true corner, up to a tenth of the pitch before the rail begins.
    assert sweep.Shape.Area == pytest.approx(np.pi * sweep.Spine[0].Length.Value, rel=2e-3)
    assert known.doc.UndoCount == steps + 1
    area, name = sweep.Shape.Area, sweep.Name
    known.doc.undo()
    assert known.doc.Objects[-1].Name == "Profile"
    exec("import FreeCAD\n" + "\n".join(recorded), {})
    assert known.doc.getObject(name).Shape.Area == area


def test_a_skin_is_laid_through_edges_picked_in_the_network(known: Any, network: Any) -> None:
    Gui.Selection.clearSelection()
    for place in (TOP_FRONT, (10.0, 0.0, 0.0)):
        Gui.Selection.addSelection(network, edge_at(network, place))
    Gui.runCommand("EdgeScan_Loft")
    skin = known.doc.Objects[-1]
    assert skin.Shape.Area == pytest.approx(SIZE[0] * SIZE[2], rel=0.03)


def test_edges_picked_for_something_that_cannot_be_leave_no_trace(
    known: Any, network: Any, problems: list[str]
) -> None:
    before = known.trace()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(network, edge_at(network, TOP_FRONT))
    Gui.runCommand("EdgeScan_Sweep")
    assert "Select two" in problems[0]
    assert known.trace() == before
