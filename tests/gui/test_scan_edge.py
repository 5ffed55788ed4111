# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scanning an edge by mouse: click, see, accept, undo."""

from __future__ import annotations

import gc
import time
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")

from freecad_edgescan import document  # noqa: E402
from freecad_edgescan.gui.background import running  # noqa: E402

ON_THE_RIDGE = (0.3, 2.0, 5.0)
ON_THE_SIDE = (8.0, 0.0, 5.0 - 0.8 * 8.0)


def scanned(window: Any) -> None:
    """Open the panel, click on the ridge and wait for the edge."""
    window.open_panel()
    window.click(ON_THE_RIDGE)
    window.found()


def test_the_panel_says_what_to_do(window: Any) -> None:
    window.open_panel()
    assert window.sentence.startswith("Click on the cloud")
    assert not window.button("Ok").isEnabled()
    window.picture("scan_edge_start")


@pytest.mark.parametrize("camera", ["Orthographic", "Perspective"])
def test_one_click_and_ok_make_one_edge_on_the_ridge(window: Any, camera: str) -> None:
    window.view.setCameraType(camera)
    window.view.fitAll()
    window.settle()
    undo_steps = window.doc.UndoCount
    scanned(window)
    window.picture(f"scan_edge_found_{camera.lower()}")
    window.button("Ok").click()
    window.settle()
    window.picture(f"scan_edge_made_{camera.lower()}")
    assert not Gui.Control.activeDialog()
    (edge,) = window.edges
    points = np.array([tuple(p) for p in edge.Shape.discretize(50)])
    assert np.abs(points[:, 0]).max() < 0.05
    assert np.abs(points[:, 2] - 5.0).max() < 0.05
    assert np.ptp(points[:, 1]) > 25.0
    assert window.doc.UndoCount == undo_steps + 1
    assert Gui.Selection.getSelection() == [edge]


def test_ok_does_not_scan_a_second_time(window: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    from freecad_edgescan.document import scanned_edge

    scanned(window)
    monkeypatch.setattr(scanned_edge, "scan_edge", None)
    window.button("Ok").click()
    window.settle()
    assert window.edges[0].Shape.Length > 25.0


def test_the_recorded_lines_make_the_same_edge_bit_for_bit(
    window: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    lines: list[str] = []
    run = Gui.doCommand
    monkeypatch.setattr(Gui, "doCommand", lambda line: (lines.append(line), run(line)))
    scanned(window)
    window.button("Ok").click()
    window.settle()
    points, brep = window.edges[0].Points, window.edges[0].Shape.exportBrepToString()
    window.doc.undo()
    assert not any("Gui" in line for line in lines)
    exec("import FreeCAD\n" + "\n".join(lines), {})
    assert window.edges[0].Points == points
    assert window.edges[0].Shape.exportBrepToString() == brep


def test_a_cloud_in_a_moved_part_is_clicked_and_scanned_where_it_is_seen(window: Any) -> None:
    part = window.doc.addObject("App::Part", "Part")
    part.addObject(window.doc.findObjects("Points::Feature")[0])
    turn = FreeCAD.Rotation(FreeCAD.Vector(1, 2, 3), 40)
    part.Placement = FreeCAD.Placement(FreeCAD.Vector(100, -50, 20), turn)
    window.doc.recompute()
    window.view.fitAll()
    window.open_panel()
    window.click(tuple(part.Placement.multVec(FreeCAD.Vector(*ON_THE_RIDGE))))
    window.found()
    window.button("Ok").click()
    window.settle()
    back = part.Placement.inverse()
    points = np.array([tuple(back.multVec(p)) for p in window.edges[0].Shape.discretize(20)])
    assert np.abs(points[:, [0, 2]] - [0.0, 5.0]).max() < 0.05


def test_clicking_as_the_panel_says_works_in_every_navigation_style(window: Any) -> None:
    usual = window.view.getNavigationType()
    deaf = []
    for style in window.view.listNavigationTypes():
        window.view.setNavigationType(style)
        window.open_panel()
        window.click_pixel(3, 3, ctrl="Ctrl" in window.sentence)
        end = time.monotonic() + 2.0  # some styles hold clicks back for a while
        window.wait_until(lambda end=end: "no point" in window.sentence or time.monotonic() > end)
        if "no point" not in window.sentence:
            deaf.append(style)
        window.button("Cancel").click()
        window.settle()
    window.view.setNavigationType(usual)
    assert not deaf


def test_undo_takes_the_edge_away_in_one_step_and_redo_brings_it_back(window: Any) -> None:
    scanned(window)
    window.button("Ok").click()
    window.settle()
    length = window.edges[0].Shape.Length
    window.doc.undo()
    window.settle()
    assert not window.edges
    window.doc.redo()
    window.settle()
    (edge,) = window.edges
    assert edge.Shape.Length == length
    assert edge.ViewObject.Proxy.getIcon().endswith("ScannedEdge.svg")


def test_escape_leaves_no_trace(window: Any) -> None:
    before = window.trace()
    scanned(window)
    assert window.trace() != before
    window.press_escape()
    window.wait_until(lambda: not Gui.Control.activeDialog())
    assert window.trace() == before


def test_cancel_during_the_scan_leaves_no_trace(window: Any) -> None:
    before = window.trace()
    threads = window.threads
    window.open_panel()
    window.click(ON_THE_RIDGE)
    window.button("Cancel").click()
    window.wait_until(lambda: not Gui.Control.activeDialog())
    assert window.trace() == before
    window.wait_until(lambda: running() == 0)
    assert window.threads <= threads


def test_a_click_on_the_background_is_answered_by_a_sentence(window: Any) -> None:
    window.open_panel()
    window.click_pixel(3, 3)
    window.settle()
    assert "no point of a visible cloud" in window.sentence
    assert Gui.Control.activeDialog()
    assert not window.button("Ok").isEnabled()


def test_a_click_where_there_is_no_edge_is_answered_by_a_sentence(window: Any) -> None:
    window.open_panel()
    window.click(ON_THE_SIDE)
    assert "being followed" in window.sentence
    window.wait_until(lambda: "being followed" not in window.sentence)
    window.picture("scan_edge_no_edge")
    assert window.sentence.endswith(".")
    assert not window.button("Ok").isEnabled()
    assert not window.edges


def test_a_second_click_scans_again_instead(window: Any) -> None:
    scanned(window)
    window.click((0.0, -6.0, 5.0))
    window.found()
    window.button("Ok").click()
    window.settle()
    assert len(window.edges) == 1


def test_nothing_is_selected_by_clicking_and_selecting_works_again_afterwards(window: Any) -> None:
    scanned(window)
    assert not Gui.Selection.getSelection()
    window.button("Cancel").click()
    window.settle()
    points = document.points_of(window.cloud)
    aim = points[np.argmin(np.linalg.norm(points - [6.0, 0.0, 5.0 - 0.8 * 6.0], axis=1))]
    window.click(tuple(aim))
    assert [item.TypeId for item in Gui.Selection.getSelection()] == ["Points::Feature"]


def test_the_panel_is_not_left_behind_when_freecad_closes_it_by_itself(window: Any) -> None:
    before = window.trace()
    scanned(window)
    Gui.Control.closeDialog()
    window.wait_until(lambda: window.trace() == before)


def test_a_document_closed_under_the_panel_takes_the_panel_along(window: Any) -> None:
    scanned(window)
    FreeCAD.closeDocument(window.doc.Name)
    window.wait_until(lambda: not Gui.Control.activeDialog())


def test_nothing_of_a_closed_panel_stays_alive(window: Any) -> None:
    from freecad_edgescan.gui.background import Background
    from freecad_edgescan.gui.scan_edge_panel import ScanEdgePanel

    scanned(window)
    window.button("Cancel").click()
    window.wait_until(lambda: running() == 0)
    window.settle()
    gc.collect()
    leftover = [o for o in gc.get_objects() if isinstance(o, (ScanEdgePanel, Background))]
    assert not leftover, gc.get_referrers(*leftover)


def test_a_cloud_deleted_under_the_panel_is_said(window: Any) -> None:
    scanned(window)
    window.doc.removeObject(window.doc.findObjects("Points::Feature")[0].Name)
    window.settle()
    assert "deleted" in window.sentence
    assert not window.button("Ok").isEnabled()


def test_without_a_cloud_the_command_says_what_is_missing(window: Any, problems: list[str]) -> None:
    for item in window.doc.Objects:
        item.ViewObject.Visibility = False
    Gui.runCommand("EdgeScan_ScanEdge")
    assert not Gui.Control.activeDialog()
    assert len(problems) == 1
    assert "Import" in problems[0]
