# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scan all edges: watch, choose by figures and by clicks, keep in one undo step, edit again."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402

SIZE = (24.0, 18.0, 12.0)
PITCH = 0.5
TOP_FRONT = (10.0, 0.0, 12.0)  # on an edge along x that is seen from the front
UPRIGHT = (24.0, 0.0, 6.0)


@pytest.fixture(scope="module")
def box_points() -> Any:
    return document.simulate_cloud(Part.makeBox(*SIZE), PITCH, 0.05).points


@pytest.fixture
def box(window: Any, box_points: Any) -> Any:
    """A scanned box in place of the roof."""
    window.doc.UndoMode = 1
    window.doc.removeObject(window.cloud.Name)
    document.make_cloud(window.doc, box_points)
    window.doc.recompute()
    window.doc.clearUndos()
    window.view.fitAll()
    window.settle()
    return window


@pytest.fixture
def recorded(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Lines that FreeCAD records."""
    lines: list[str] = []
    run = Gui.doCommand
    monkeypatch.setattr(Gui, "doCommand", lambda line: (lines.append(line), run(line)))
    return lines


def opened(window: Any) -> Any:
    Gui.runCommand("EdgeScan_ScanAllEdges")
    window.settle()
    return window.panel


def found(window: Any) -> Any:
    panel = opened(window)
    ended(window)
    return panel


def ended(window: Any) -> None:
    """Wait until nothing is searched any more."""
    window.settle()
    window.wait_until(lambda: window.panel._work is None)


def kept_and_left_out(window: Any) -> tuple[int, int]:
    return window.panel._display.counts


def networks(window: Any) -> list[Any]:
    return [o for o in window.doc.Objects if "EdgeNetwork" in type(getattr(o, "Proxy", 0)).__name__]


def edit(window: Any, network: Any) -> None:
    """Double click on the network in the tree."""
    network.ViewObject.Proxy.doubleClicked(network.ViewObject)
    ended(window)


def enter(box: Any, value: float) -> None:
    """Enter a length in a field."""
    box.widget.setProperty("rawValue", value)


def test_edges_are_drawn_while_the_cloud_is_searched(box: Any) -> None:
    panel = opened(box)
    assert not box.button("Ok").isEnabled()
    seen = set()
    box.wait_until(lambda: seen.add(sum(kept_and_left_out(box))) or panel._work is None)
    assert len(seen) > 3 and max(seen) == 12
    assert "12 of 12" in panel.form.figures
    assert box.button("Ok").isEnabled()


def test_ok_makes_one_network_in_one_undo_step_and_a_macro_makes_it_again(
    box: Any, recorded: list[str]
) -> None:
    found(box)
    box.ok()
    (network,) = networks(box)
    assert Gui.Selection.getSelection() == [network]
    assert len(network.Shape.Edges) == 12 and len(network.Shape.Vertexes) == 8
    true = Part.makeBox(*SIZE).Vertexes
    for vertex in network.Shape.Vertexes:
        assert min(vertex.Point.distanceToPoint(t.Point) for t in true) < 0.5 * PITCH
    assert box.doc.UndoCount == 1
    brep, name = network.Shape.exportBrepToString(), network.Name
    box.doc.undo()
    assert not networks(box)
    box.doc.redo()
    assert box.doc.getObject(name).EdgeCount == 12
    box.doc.undo()
    assert not any("Gui" in line for line in recorded)
    exec("import FreeCAD\n" + "\n".join(recorded), {})
    assert box.doc.getObject(name).Shape.exportBrepToString() == brep


def test_a_click_drops_an_edge_and_another_one_keeps_it(box: Any) -> None:
    panel = found(box)
    box.hover(TOP_FRONT)
    assert "Kept" in panel.form.edge and "turn 90" in panel.form.edge.replace("89.9", "90")
    box.picture("all_edges_hover")
    box.click(TOP_FRONT)
    assert kept_and_left_out(box) == (11, 1)
    assert "Left out" in panel.form.edge
    box.picture("all_edges_dropped")
    box.click(TOP_FRONT)
    assert kept_and_left_out(box) == (12, 0)
    box.click(TOP_FRONT)
    box.click(UPRIGHT)
    assert kept_and_left_out(box) == (10, 2)
    panel.form.forget.click()
    assert kept_and_left_out(box) == (12, 0)
    box.click((6.0, 6.0, 12.0))
    assert "no edge" in box.sentence


def test_length_turn_and_sigma_choose_without_another_search(box: Any, recorded: list[str]) -> None:
    form = found(box).form
    enter(form._length, 14.0)
    assert kept_and_left_out(box) == (8, 4)
    box.click(UPRIGHT)  # kept all the same
    assert kept_and_left_out(box) == (9, 3)
    box.click(TOP_FRONT)
    assert kept_and_left_out(box) == (8, 4)
    box.picture("all_edges_filtered")
    form._turn.setValue(95.0)
    assert kept_and_left_out(box) == (1, 11)
    form._turn.setValue(45.0)
    assert kept_and_left_out(box) == (8, 4)
    assert box.panel._work is None
    box.ok()
    (network,) = networks(box)
    assert network.EdgeCount == 8
    assert network.MinLength.Value == 14.0 and network.MinAngle.Value == pytest.approx(45.0)
    assert len(network.Dropped) == len(network.Kept) == 1
    (line,) = [line for line in recorded if "make_edge_network" in line]
    assert all(word in line for word in ("min_angle=", "min_length=14.0", "dropped=", "kept="))


def test_sigma_is_limited_when_that_is_ticked(box: Any) -> None:
    form = found(box).form
    form._limits_sigma.click()
    assert kept_and_left_out(box) == (12, 0)
    sigma = [float(np.median(edge.sigma)) for edge in box.panel._known.edges]
    enter(form._sigma, float(np.median(sigma)))
    kept, left_out = kept_and_left_out(box)
    assert kept == sum(value <= np.median(sigma) for value in sigma) and left_out > 0
    form._limits_sigma.click()
    assert kept_and_left_out(box) == (12, 0)


def test_blunter_edges_than_were_sought_are_searched_for(box: Any) -> None:
    panel = found(box)
    panel.form._turn.setValue(10.0)
    assert panel._work is not None
    ended(box)
    assert kept_and_left_out(box)[0] >= 12
    assert panel._found.search.min_angle == pytest.approx(np.radians(10.0))


def test_without_any_kept_edge_there_is_no_ok(box: Any) -> None:
    panel = found(box)
    enter(panel.form._length, 100.0)
    assert kept_and_left_out(box) == (0, 12)
    assert not box.button("Ok").isEnabled()


def test_separate_edges_come_in_a_group_and_are_remembered(box: Any, recorded: list[str]) -> None:
    panel = found(box)
    enter(panel.form._length, 20.0)
    panel.form.choose_kind(one_network=False)
    box.ok()
    (group,) = box.doc.findObjects("App::DocumentObjectGroup")
    assert len(group.Group) == len(box.edges) == 4
    for edge in box.edges:
        points = np.array([tuple(point) for point in edge.Points])
        away = np.sort(np.minimum(np.abs(points), np.abs(points - SIZE)), axis=1)
        assert np.hypot(away[:, 0], away[:, 1]).max() < PITCH
        assert edge.Length.Value == pytest.approx(24.0, abs=1.0)
    assert box.doc.UndoCount == 1
    points = [tuple(point) for edge in box.edges for point in edge.Points]
    box.doc.undo()
    assert not box.edges
    exec("import FreeCAD\n" + "\n".join(recorded), {})
    assert [tuple(point) for edge in box.edges for point in edge.Points] == points
    assert not opened(box).form.one_network
    box.panel.form.choose_kind(one_network=True)
    ended(box)
    box.ok()


def test_stop_here_keeps_the_edges_so_far_and_a_macro_finds_as_many(
    box: Any, recorded: list[str]
) -> None:
    panel = opened(box)
    box.wait_until(lambda: len(panel._known.edges) >= 3)
    panel.form.stop.click()
    ended(box)
    assert "Stopped" in box.sentence
    count = kept_and_left_out(box)[0]
    assert 3 <= count < 12
    box.picture("all_edges_stopped")
    box.ok()
    (network,) = networks(box)
    assert network.EdgeCount == network.MostEdges == count
    brep, name = network.Shape.exportBrepToString(), network.Name
    box.doc.undo()
    document.cloud_cache.forget_clouds(box.doc.Name)  # nothing is remembered of the search
    exec("import FreeCAD\n" + "\n".join(recorded), {})
    assert box.doc.getObject(name).Shape.exportBrepToString() == brep


def test_a_stopped_search_can_be_begun_again(box: Any) -> None:
    panel = opened(box)
    panel.form.stop.click()
    ended(box)
    assert "before an edge was found" in box.sentence
    assert not box.button("Ok").isEnabled()
    panel.form.again.click()
    ended(box)
    assert kept_and_left_out(box) == (12, 0)


def test_a_smooth_sphere_has_no_edge_and_that_is_said(box: Any) -> None:
    rng = np.random.default_rng(0)
    normals = rng.normal(size=(6000, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    box.doc.removeObject(box.cloud.Name)
    document.make_cloud(box.doc, 10.0 * normals)
    box.doc.recompute()
    found(box)
    assert "No edge was found" in box.sentence
    assert not box.button("Ok").isEnabled()
    box.picture("all_edges_none")
    box.press_escape()
    box.wait_until(lambda: not Gui.Control.activeDialog())


def test_of_two_clouds_the_selected_one_is_searched(box: Any, problems: list[str]) -> None:
    second = document.make_cloud(
        box.doc, np.array(box.cloud.Points.Points) + np.array([40.0, 0, 0])
    )
    box.doc.recompute()
    Gui.runCommand("EdgeScan_ScanAllEdges")
    assert not Gui.Control.activeDialog()
    assert "2 clouds" in problems[0]
    Gui.Selection.addSelection(second)
    found(box)
    box.ok()
    assert networks(box)[0].Cloud is second


# Editing.


@pytest.fixture
def network(box: Any) -> Any:
    found(box)
    box.ok()
    return networks(box)[0]


def test_a_double_click_chooses_anew_in_one_undo_step(
    box: Any, network: Any, recorded: list[str]
) -> None:
    steps = box.doc.UndoCount
    edit(box, network)
    assert network.ViewObject.SwitchNode.whichChild.getValue() == -1
    box.click(TOP_FRONT)
    box.ok()
    assert network.EdgeCount == 11 and networks(box) == [network]
    assert network.ViewObject.SwitchNode.whichChild.getValue() != -1
    assert box.doc.UndoCount == steps + 1
    assert any("change_edge_network" in line for line in recorded)
    box.doc.undo()
    assert network.EdgeCount == 12 and network.Dropped == []
    box.doc.redo()
    assert network.EdgeCount == 11
    edit(box, network)
    assert kept_and_left_out(box) == (11, 1)
    box.click(TOP_FRONT)
    box.ok()
    assert network.EdgeCount == 12


def test_editing_without_a_change_makes_no_undo_step(box: Any, network: Any) -> None:
    before = box.trace()
    edit(box, network)
    box.ok()
    assert box.trace() == before


def test_editing_that_is_given_up_leaves_no_trace(box: Any, network: Any) -> None:
    before = box.trace()
    edit(box, network)
    box.click(TOP_FRONT)
    box.press_escape()
    box.wait_until(lambda: not Gui.Control.activeDialog())
    assert box.trace() == before and network.EdgeCount == 12


def test_a_network_deleted_while_it_is_edited_takes_the_panel_along(box: Any, network: Any) -> None:
    edit(box, network)
    box.doc.removeObject(network.Name)
    box.wait_until(lambda: not Gui.Control.activeDialog())


def test_a_network_whose_cloud_is_gone_says_so(box: Any, network: Any, problems: list[str]) -> None:
    box.doc.removeObject(box.cloud.Name)
    network.ViewObject.Proxy.doubleClicked(network.ViewObject)
    assert not Gui.Control.activeDialog()
    assert "is gone" in problems[0]


def test_a_network_can_be_edited_after_save_and_reopen(
    box: Any, network: Any, tmp_path: Path
) -> None:
    edit(box, network)
    box.click(TOP_FRONT)
    box.ok()
    name, path = network.Name, str(tmp_path / "box.FCStd")
    box.doc.saveAs(path)
    FreeCAD.closeDocument(box.doc.Name)
    doc = FreeCAD.openDocument(path)
    box.doc, box.view = doc, Gui.getDocument(doc.Name).ActiveView
    box.pass_time(0.3)
    edit(box, doc.getObject(name))
    assert kept_and_left_out(box) == (11, 1)
    box.ok()
    assert doc.UndoCount == 0
    FreeCAD.closeDocument(doc.Name)


# Trouble.


def before_the_first_report(box: Any) -> None:
    Gui.runCommand("EdgeScan_ScanAllEdges")


def while_it_searches(box: Any) -> None:
    panel = opened(box)
    box.wait_until(lambda: len(panel._known.edges) > 0)


def when_stopped(box: Any) -> None:
    while_it_searches(box)
    box.panel.form.stop.click()
    ended(box)


def when_found(box: Any) -> None:
    found(box)
    box.click(TOP_FRONT)


def by_escape(box: Any) -> None:
    box.press_escape()


def by_cancel(box: Any) -> None:
    box.button("Cancel").click()


def by_the_cross(box: Any) -> None:
    box.close_dock()


def by_freecad(box: Any) -> None:
    Gui.Control.closeDialog()


MOMENTS = [before_the_first_report, while_it_searches, when_stopped, when_found]


@pytest.mark.parametrize(
    ("way_out", "moment"),
    [
        *((by_escape, moment) for moment in MOMENTS),
        *((by_cancel, moment) for moment in (before_the_first_report, when_found)),
        *((by_the_cross, moment) for moment in (while_it_searches, when_found)),
        (by_freecad, while_it_searches),
    ],
)
def test_no_way_out_at_any_moment_leaves_a_trace(
    box: Any, moment: Callable[[Any], None], way_out: Callable[[Any], None]
) -> None:
    from freecad_edgescan.gui.background import running

    document.point_cloud(box.cloud)
    before, threads = box.trace(), box.threads
    moment(box)
    way_out(box)
    box.wait_until(lambda: not Gui.Control.activeDialog(), 20)
    box.wait_until(lambda: box.trace() == before and running() == 0, 20)
    if way_out is by_the_cross:
        box.pass_time(0.6)  # until the dock is back
    assert box.threads <= threads
    scene = box.view.getSceneGraph()
    assert not any(scene.getByName(n) for n in ("EdgeScanNetwork", "EdgeScanThinnedClouds"))


@pytest.mark.parametrize("moment", MOMENTS)
def test_a_document_may_be_closed_at_any_moment(box: Any, moment: Callable[[Any], None]) -> None:
    from freecad_edgescan.gui.background import running

    moment(box)
    FreeCAD.closeDocument(box.doc.Name)
    box.wait_until(lambda: not Gui.Control.activeDialog(), 20)
    box.wait_until(lambda: running() == 0, 20)


@pytest.mark.parametrize("moment", MOMENTS)
def test_a_cloud_may_be_deleted_at_any_moment_and_its_deletion_undone(
    box: Any, moment: Callable[[Any], None]
) -> None:
    moment(box)
    box.doc.openTransaction("Delete")
    box.doc.removeObject(box.cloud.Name)
    box.doc.commitTransaction()
    box.settle()
    assert "deleted" in box.sentence
    assert not box.button("Ok").isEnabled()
    assert kept_and_left_out(box) == (0, 0)
    box.doc.undo()
    ended(box)
    assert sum(kept_and_left_out(box)) > 0
    box.ok()
    assert len(networks(box)) == 1


@pytest.mark.parametrize("moment", [while_it_searches, when_found])
def test_a_cloud_that_is_moved_is_searched_again(box: Any, moment: Callable[[Any], None]) -> None:
    moment(box)
    box.cloud.Placement = FreeCAD.Placement(FreeCAD.Vector(0, 0, 70), FreeCAD.Rotation())
    box.settle()
    assert "has changed" in box.sentence
    assert not box.button("Ok").isEnabled()
    ended(box)
    box.ok()
    (network,) = networks(box)
    assert network.EdgeCount == 12
    assert network.Shape.BoundBox.ZMin == pytest.approx(70.0, abs=PITCH)


def test_looking_at_edges_does_not_change_the_document(box: Any, tmp_path: Path) -> None:
    box.doc.saveAs(str(tmp_path / "box.FCStd"))
    Gui.SendMsgToActiveView("Save")
    assert not Gui.getDocument(box.doc.Name).Modified
    when_found(box)
    by_cancel(box)
    box.settle()
    assert not Gui.getDocument(box.doc.Name).Modified


def test_a_large_cloud_is_drawn_with_fewer_points(
    box: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("freecad_edgescan.gui.thinned_clouds.MOST_POINTS", 1000)
    panel = opened(box)
    assert panel._display.clouds.count <= 1000
    assert "1,000 of" in panel.form._shown.text()
    ended(box)
    assert kept_and_left_out(box) == (12, 0)


# Wires.


def test_selected_edges_of_a_network_become_a_wire(
    box: Any, network: Any, recorded: list[str], problems: list[str]
) -> None:
    def name(place: tuple[float, float, float]) -> str:
        away = [edge.distToShape(Part.Vertex(*place))[0] for edge in network.Shape.Edges]
        return f"Edge{away.index(min(away)) + 1}"

    Gui.Selection.clearSelection()
    Gui.runCommand("EdgeScan_EdgeWire")
    assert "Select edges of one network" in problems.pop()
    for place in (TOP_FRONT, (24.0, 9.0, 12.0)):
        Gui.Selection.addSelection(network, name(place))
    Gui.runCommand("EdgeScan_EdgeWire")
    (wire,) = Gui.Selection.getSelection()
    assert wire.Shape.ShapeType == "Wire"
    assert wire.Length.Value == pytest.approx(24 + 18, abs=0.5)
    assert any("make_edge_wire" in line for line in recorded)
    Gui.Selection.clearSelection()
    for place in (TOP_FRONT, (10.0, 18.0, 12.0)):
        Gui.Selection.addSelection(network, name(place))
    Gui.runCommand("EdgeScan_EdgeWire")
    assert "separate chains" in problems.pop()
