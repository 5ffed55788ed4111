# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scan all edges: watch, choose by figures and by clicks, keep in one undo step, edit again."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")
Part = pytest.importorskip("Part")

import freecad_edgescan as es  # noqa: E402
from freecad_edgescan import document  # noqa: E402
from freecad_edgescan.document.network_search import NetworkSearch, keep_network  # noqa: E402

from .test_scan_panel_macro import replayed  # noqa: E402
from .ways_out import by_cancel, by_escape, by_freecad, by_the_cross  # noqa: E402

SIZE = (24.0, 18.0, 12.0)
PITCH = 0.5
TOP_FRONT = (10.0, 0.0, 12.0)  # on an edge along x that is seen from the front
UPRIGHT = (24.0, 0.0, 6.0)


@pytest.fixture(scope="module")
def box_points() -> Any:
    return document.simulate_cloud(Part.makeBox(*SIZE), PITCH, 0.05).points


@pytest.fixture(scope="module")
def box_network(box_points: Any) -> es.EdgeNetwork:
    """Its edges, found once; points of documents have single precision."""
    return es.find_edges(es.PointCloud(box_points.astype(np.float32)))


@pytest.fixture
def box(window: Any, box_points: Any) -> Any:
    """A scanned box in place of the roof, whose edges nobody has looked for."""
    window.doc.UndoMode = 1
    window.doc.removeObject(window.cloud.Name)
    document.make_cloud(window.doc, box_points)
    window.doc.recompute()
    window.doc.clearUndos()
    window.view.fitAll()
    window.settle()
    return window


@pytest.fixture
def known(box: Any, box_network: es.EdgeNetwork) -> Any:
    """The same box, whose edges were found before, so that no test waits for that."""
    numbers = document.point_cloud(box.cloud)
    assert np.array_equal(numbers.points, box_network.cloud.points)
    keep_network(NetworkSearch(), replace(box_network, cloud=numbers))
    return box


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
    known: Any, recorded: list[str]
) -> None:
    found(known)
    known.ok()
    (network,) = networks(known)
    assert Gui.Selection.getSelection() == [network]
    assert len(network.Shape.Edges) == 12 and len(network.Shape.Vertexes) == 8
    true = Part.makeBox(*SIZE).Vertexes
    for vertex in network.Shape.Vertexes:
        assert min(vertex.Point.distanceToPoint(t.Point) for t in true) < 0.5 * PITCH
    assert known.doc.UndoCount == 1
    brep, name = network.Shape.exportBrepToString(), network.Name
    known.doc.undo()
    assert not networks(known)
    known.doc.redo()
    assert known.doc.getObject(name).EdgeCount == 12
    known.doc.undo()
    assert not any("Gui" in line for line in recorded)
    exec("import FreeCAD\n" + "\n".join(recorded), {})
    assert known.doc.getObject(name).Shape.exportBrepToString() == brep


def test_a_click_drops_an_edge_and_another_one_keeps_it(known: Any) -> None:
    panel = found(known)
    known.hover(TOP_FRONT)
    assert "Kept" in panel.form.edge and "turn 90" in panel.form.edge.replace("89.9", "90")
    known.picture("all_edges_hover")
    known.click(TOP_FRONT)
    assert kept_and_left_out(known) == (11, 1)
    assert "Left out" in panel.form.edge
    known.picture("all_edges_dropped")
    known.click(TOP_FRONT)
    assert kept_and_left_out(known) == (12, 0)
    known.click(TOP_FRONT)
    known.click(UPRIGHT)
    assert kept_and_left_out(known) == (10, 2)
    panel.form.forget.click()
    assert kept_and_left_out(known) == (12, 0)
    known.click((6.0, 6.0, 12.0))
    assert "no edge" in known.sentence


def test_length_turn_and_sigma_choose_without_another_search(
    known: Any, recorded: list[str]
) -> None:
    form = found(known).form
    enter(form._length, 14.0)
    assert kept_and_left_out(known) == (8, 4)
    known.click(UPRIGHT)  # kept all the same
    assert kept_and_left_out(known) == (9, 3)
    known.click(TOP_FRONT)
    assert kept_and_left_out(known) == (8, 4)
    known.picture("all_edges_filtered")
    form._turn.setValue(95.0)
    assert kept_and_left_out(known) == (1, 11)
    form._turn.setValue(45.0)
    assert kept_and_left_out(known) == (8, 4)
    assert known.panel._work is None
    known.ok()
    (network,) = networks(known)
    assert network.EdgeCount == 8
    assert network.MinLength.Value == 14.0 and network.MinAngle.Value == pytest.approx(45.0)
    assert len(network.Dropped) == len(network.Kept) == 1
    (line,) = [line for line in recorded if "make_edge_network" in line]
    assert all(word in line for word in ("min_angle=", "min_length=14.0", "dropped=", "kept="))


def test_sigma_is_limited_when_that_is_ticked(known: Any) -> None:
    form = found(known).form
    form._limits_sigma.click()
    assert kept_and_left_out(known) == (12, 0)
    sigma = [float(np.median(edge.sigma)) for edge in known.panel._known.edges]
    enter(form._sigma, float(np.median(sigma)))
    kept, left_out = kept_and_left_out(known)
    assert kept == sum(value <= np.median(sigma) for value in sigma) and left_out > 0
    form._limits_sigma.click()
    assert kept_and_left_out(known) == (12, 0)


def test_blunter_edges_than_were_sought_are_searched_for(box: Any) -> None:
    panel = found(box)
    panel.form._turn.setValue(14.0)
    assert panel._work is not None
    ended(box)
    assert kept_and_left_out(box)[0] >= 12
    assert panel._found.search.min_angle == pytest.approx(np.radians(14.0))


def test_without_any_kept_edge_there_is_no_ok(known: Any) -> None:
    panel = found(known)
    enter(panel.form._length, 100.0)
    assert kept_and_left_out(known) == (0, 12)
    assert not known.button("Ok").isEnabled()


def test_separate_edges_come_in_a_group_and_are_remembered(known: Any, recorded: list[str]) -> None:
    panel = found(known)
    enter(panel.form._length, 20.0)
    panel.form.choose_kind(one_network=False)
    known.ok()
    (group,) = known.doc.findObjects("App::DocumentObjectGroup")
    assert len(group.Group) == len(known.edges) == 4
    for edge in known.edges:
        points = np.array([tuple(point) for point in edge.Points])
        away = np.sort(np.minimum(np.abs(points), np.abs(points - SIZE)), axis=1)
        assert np.hypot(away[:, 0], away[:, 1]).max() < PITCH
        assert edge.Length.Value == pytest.approx(24.0, abs=1.0)
    assert known.doc.UndoCount == 1
    points = [tuple(point) for edge in known.edges for point in edge.Points]
    known.doc.undo()
    assert not known.edges
    exec("import FreeCAD\n" + "\n".join(recorded), {})
    assert [tuple(point) for edge in known.edges for point in edge.Points] == points
    assert not opened(known).form.one_network
    known.panel.form.choose_kind(one_network=True)
    ended(known)
    known.ok()


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
    assert box.panel.form.figures == ""
    box.picture("all_edges_none")
    box.panel.form._turn.setValue(14.0)  # perhaps a blunter one
    assert box.panel._work is not None
    ended(box)
    box.press_escape()
    box.wait_until(lambda: not Gui.Control.activeDialog())


def test_of_two_clouds_the_selected_one_is_searched(known: Any, problems: list[str]) -> None:
    second = document.make_cloud(
        known.doc, np.array(known.cloud.Points.Points) + np.array([40.0, 0, 0])
    )
    known.doc.recompute()
    Gui.runCommand("EdgeScan_ScanAllEdges")
    assert not Gui.Control.activeDialog()
    assert "2 clouds" in problems[0]
    Gui.Selection.addSelection(second)
    found(known)
    known.ok()
    assert networks(known)[0].Cloud is second


# Editing.


@pytest.fixture
def network(known: Any) -> Any:
    found(known)
    known.ok()
    return networks(known)[0]


def test_a_double_click_chooses_anew_in_one_undo_step(
    known: Any, network: Any, recorded: list[str]
) -> None:
    steps = known.doc.UndoCount
    edit(known, network)
    assert network.ViewObject.SwitchNode.whichChild.getValue() == -1
    known.click(TOP_FRONT)
    known.ok()
    assert network.EdgeCount == 11 and networks(known) == [network]
    assert network.ViewObject.SwitchNode.whichChild.getValue() != -1
    assert known.doc.UndoCount == steps + 1
    assert any("change_edge_network" in line for line in recorded)
    known.doc.undo()
    assert network.EdgeCount == 12 and network.Dropped == []
    known.doc.redo()
    assert network.EdgeCount == 11
    edit(known, network)
    assert kept_and_left_out(known) == (11, 1)
    known.click(TOP_FRONT)
    known.ok()
    assert network.EdgeCount == 12


def test_editing_without_a_change_makes_no_undo_step(known: Any, network: Any) -> None:
    before = known.trace()
    edit(known, network)
    known.ok()
    assert known.trace() == before


def test_editing_that_is_given_up_leaves_no_trace(known: Any, network: Any) -> None:
    before = known.trace()
    edit(known, network)
    known.click(TOP_FRONT)
    known.press_escape()
    known.wait_until(lambda: not Gui.Control.activeDialog())
    assert known.trace() == before and network.EdgeCount == 12


def test_a_network_deleted_while_it_is_edited_takes_the_panel_along(
    known: Any, network: Any
) -> None:
    edit(known, network)
    known.doc.removeObject(network.Name)
    known.wait_until(lambda: not Gui.Control.activeDialog())


def test_a_network_whose_cloud_is_gone_says_so(
    known: Any, network: Any, problems: list[str]
) -> None:
    known.doc.removeObject(known.cloud.Name)
    network.ViewObject.Proxy.doubleClicked(network.ViewObject)
    assert not Gui.Control.activeDialog()
    assert "is gone" in problems[0]


def test_a_network_can_be_edited_after_save_and_reopen(
    known: Any, network: Any, tmp_path: Path
) -> None:
    edit(known, network)
    known.click(TOP_FRONT)
    known.ok()
    name, path = network.Name, str(tmp_path / "box.FCStd")
    known.doc.saveAs(path)
    FreeCAD.closeDocument(known.doc.Name)
    doc = FreeCAD.openDocument(path)
    known.doc, known.view = doc, Gui.getDocument(doc.Name).ActiveView
    known.pass_time(0.3)
    edit(known, doc.getObject(name))
    assert kept_and_left_out(known) == (11, 1)
    known.ok()
    assert doc.UndoCount == 0
    FreeCAD.closeDocument(doc.Name)


# Trouble.


def before_the_first_report(known: Any) -> None:
    Gui.runCommand("EdgeScan_ScanAllEdges")


def while_it_searches(known: Any) -> None:
    panel = opened(known)
    known.wait_until(lambda: len(panel._known.edges) > 0)


def when_stopped(known: Any) -> None:
    while_it_searches(known)
    known.panel.form.stop.click()
    ended(known)


def when_found(known: Any) -> None:
    found(known)
    known.click(TOP_FRONT)


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


def test_looking_at_edges_does_not_change_the_document(known: Any, tmp_path: Path) -> None:
    known.doc.saveAs(str(tmp_path / "box.FCStd"))
    Gui.SendMsgToActiveView("Save")
    assert not Gui.getDocument(known.doc.Name).Modified
    when_found(known)
    by_cancel(known)
    known.settle()
    assert not Gui.getDocument(known.doc.Name).Modified


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


# Faces between the edges.


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


@pytest.mark.slow
def test_a_macro_replays_without_a_window_bit_for_bit(
    known: Any, recorded: list[str], tmp_path: Path
) -> None:
    path, out = tmp_path / "box.FCStd", tmp_path / "network.brep"
    known.doc.saveAs(str(path))
    form = found(known).form
    enter(form._length, 14.0)
    known.click(TOP_FRONT)
    known.click(UPRIGHT)
    known.ok()
    (network,) = networks(known)
    macro = tmp_path / "recorded_by_clicking.py"
    told = [
        "import FreeCAD",
        f"FreeCAD.openDocument({str(path)!r})",
        *(line.replace(repr(known.doc.Name), "FreeCAD.ActiveDocument.Name") for line in recorded),
        f"open({str(out)!r}, 'w').write(network.Shape.exportBrepToString())",
        "import sys; sys.exit(0)",
    ]
    macro.write_text("\n".join(told), encoding="utf-8")
    replayed(macro, tmp_path / "home")
    assert out.read_text() == network.Shape.exportBrepToString()
