# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scan all edges: watch, choose by figures and by clicks, keep in one undo step."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCADGui as Gui
import numpy as np
import Part
import pytest

from freecad_edgescan import document

from ..test_scan_panel_macro import replayed
from .steps import (
    PITCH,
    SIZE,
    TOP_FRONT,
    UPRIGHT,
    ended,
    enter,
    found,
    kept_and_left_out,
    networks,
    opened,
)


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
