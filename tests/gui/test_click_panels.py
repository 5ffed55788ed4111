# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scan boundary and Recommend parameters: click, see, keep, leave no trace."""

from __future__ import annotations

import gc
import threading
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402

from .conftest import roof  # noqa: E402

ON_THE_RIDGE = (0.0, 2.0, 5.0)


def opened(window: Any, name: str) -> Any:
    """The panel of a command, when a click is answered at once."""
    Gui.runCommand(name)
    window.settle()
    window.wait_until(lambda: window.panel._clicks.ready)
    return window.panel


@pytest.fixture
def block(window: Any) -> Any:
    """A scanned block in place of the roof."""
    window.doc.removeObject(window.cloud.Name)
    numbers = document.simulate_cloud(Part.makeBox(20, 16, 12), pitch=0.4, noise=0.01)
    document.make_cloud(window.doc, numbers)
    window.doc.recompute()
    window.view.fitAll()
    window.settle()
    return window


def test_two_clicks_give_the_boundary_of_a_face_in_one_undo_step(
    block: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    lines: list[str] = []
    run = Gui.doCommand
    monkeypatch.setattr(Gui, "doCommand", lambda line: (lines.append(line), run(line)))
    steps = block.doc.UndoCount
    shown = opened(block, "EdgeScan_ScanBoundary")
    assert not block.button("Ok").isEnabled()
    block.click((10.0, 0.2, 12.0))
    assert "2 of 2" in shown.form.sentence
    block.click((10.0, 8.0, 12.0))
    block.wait_until(lambda: block.button("Ok").isEnabled())
    assert "4 edges" in shown.form.text
    assert "closed" in shown.form.text
    block.picture("scan_boundary")
    block.button("Ok").click()
    block.settle()
    (boundary,) = Gui.Selection.getSelection()
    assert boundary.EdgeCount == 4
    assert boundary.ViewObject.DisplayMode == "Flat Lines"
    assert boundary.Length.Value == pytest.approx(72, abs=0.1)
    assert block.doc.UndoCount == steps + 1
    brep, name = boundary.Shape.exportBrepToString(), boundary.Name
    block.doc.undo()
    assert not any("Gui" in line for line in lines)
    exec("import FreeCAD\n" + "\n".join(lines), {})
    assert block.doc.getObject(name).Shape.exportBrepToString() == brep


def test_parameters_are_recommended_and_ok_scans_with_them(window: Any) -> None:
    shown = opened(window, "EdgeScan_RecommendParameters")
    window.click(ON_THE_RIDGE)
    window.wait_until(lambda: window.button("Ok").isEnabled())
    assert "Error to expect" in shown.form.text
    window.picture("recommend")
    window.button("Ok").click()
    window.settle()
    (edge,) = window.edges
    assert edge.Method == "probe"
    points = np.array([tuple(point) for point in edge.Points])
    assert np.abs(points[:, 0]).mean() < 0.05


@pytest.mark.parametrize("name", ["EdgeScan_ScanBoundary", "EdgeScan_RecommendParameters"])
def test_escape_cancel_and_a_miss_leave_no_trace(window: Any, name: str) -> None:
    from freecad_edgescan.gui import background

    before, threads = window.trace(), window.threads
    shown = opened(window, name)
    window.click_pixel(3, 3)
    assert "no point" in shown.form.sentence
    window.click(ON_THE_RIDGE)
    window.press_escape()
    window.wait_until(lambda: not Gui.Control.activeDialog())
    assert window.trace() == before
    shown = opened(window, name)
    window.click(ON_THE_RIDGE)
    window.button("Cancel").click()
    window.wait_until(lambda: not Gui.Control.activeDialog())
    assert window.trace() == before
    window.wait_until(lambda: background.running() == 0)
    assert window.threads <= threads
    del shown
    window.settle()
    gc.collect()
    assert [alive() for alive in window.panels] == [None, None]


@pytest.mark.parametrize("clicked", [False, True])
def test_the_cross_of_the_dock_ends_the_panel(window: Any, clicked: bool) -> None:
    before = window.trace()
    opened(window, "EdgeScan_ScanBoundary")
    if clicked:
        window.click(ON_THE_RIDGE)
    window.close_dock()
    window.wait_until(lambda: not Gui.Control.activeDialog())
    assert window.trace() == before
    window.pass_time(0.6)  # until the dock is back


def test_a_cloud_that_is_shown_later_can_be_clicked(window: Any) -> None:
    window.cloud.ViewObject.Visibility = False
    second = document.make_cloud(window.doc, roof() + np.array([0.0, 40.0, 0.0]))
    window.doc.recompute()
    window.view.fitAll()
    shown = opened(window, "EdgeScan_ScanBoundary")
    window.cloud.ViewObject.Visibility = True
    window.settle()
    window.wait_until(lambda: shown._clicks.ready)
    window.click(ON_THE_RIDGE)
    assert shown.cloud is window.cloud
    assert shown.cloud is not second


def test_a_click_before_the_index_is_ready_is_answered_later(
    window: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    from freecad_edgescan.gui import panel_clouds

    may_end = threading.Event()
    monkeypatch.setattr(panel_clouds, "_warm_up", lambda: may_end.wait(60))
    Gui.runCommand("EdgeScan_ScanBoundary")
    window.click(ON_THE_RIDGE)
    assert "your click will be answered" in window.sentence
    assert not window.panel.places
    may_end.set()
    window.wait_until(lambda: bool(window.panel.places))
    assert "2 of 2" in window.sentence


def test_a_cloud_that_is_moved_is_to_be_clicked_again(window: Any) -> None:
    shown = opened(window, "EdgeScan_ScanBoundary")
    window.click(ON_THE_RIDGE)
    window.cloud.Placement = FreeCAD.Placement(FreeCAD.Vector(0, 0, 7), FreeCAD.Rotation())
    window.settle()
    assert "has changed" in shown.form.sentence
    assert "1 of 2" in shown.form.sentence
    assert not shown.places


def test_a_place_without_an_edge_is_said_and_asked_for_again(window: Any) -> None:
    shown = opened(window, "EdgeScan_RecommendParameters")
    window.click((6.0, 0.0, 5.0 - 0.8 * 6.0))
    window.wait_until(lambda: "edge" in shown.form.sentence and not shown.places)
    assert not window.button("Ok").isEnabled()
    assert "Click on the cloud" in shown.form.sentence


def test_a_document_closed_or_a_cloud_deleted_under_the_panel(window: Any) -> None:
    shown = opened(window, "EdgeScan_ScanBoundary")
    window.click(ON_THE_RIDGE)
    window.doc.removeObject(window.doc.findObjects("Points::Feature")[0].Name)
    window.settle()
    assert "deleted" in shown.form.sentence
    assert "1 of 2" in shown.form.sentence
    FreeCAD.closeDocument(window.doc.Name)
    window.wait_until(lambda: not Gui.Control.activeDialog())


@pytest.mark.parametrize("name", ["EdgeScan_ScanBoundary", "EdgeScan_RecommendParameters"])
def test_a_hidden_cloud_is_said(window: Any, name: str, problems: list[str]) -> None:
    window.doc.findObjects("Points::Feature")[0].ViewObject.Visibility = False
    Gui.runCommand(name)
    assert not Gui.Control.activeDialog()
    assert "hidden one visible" in problems[0]
