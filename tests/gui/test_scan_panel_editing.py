# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scan panel opened again on an edge that is in the document."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")

ON_THE_RIDGE = (0.3, 2.0, 5.0)


@pytest.fixture
def edge(window: Any) -> Any:
    window.doc.UndoMode = 1
    window.open_panel()
    window.click(ON_THE_RIDGE)
    window.found()
    window.ok()
    return window.edges[0]


def edit(window: Any, edge: Any) -> None:
    """Double click on the edge in the tree."""
    edge.ViewObject.Proxy.doubleClicked(edge.ViewObject)
    window.settle()
    window.found()


def test_a_double_click_edits_an_edge_in_one_undo_step(window: Any, edge: Any) -> None:
    steps, count = window.doc.UndoCount, edge.PointCount
    edit(window, edge)
    assert edge.ViewObject.SwitchNode.whichChild.getValue() == -1
    row = window.panel.form.parameters.row("edge_pitch")
    row.tick.click()
    row.box.widget.setProperty("rawValue", 2.0)
    window.wait_until(lambda: not window.button("Ok").isEnabled())
    window.found()
    window.picture("scan_edge_edited")
    window.ok()
    assert window.edges == [edge]
    assert edge.EdgePitch.Value == 2.0 and edge.PointCount < count
    assert edge.ViewObject.SwitchNode.whichChild.getValue() != -1
    assert window.doc.UndoCount == steps + 1
    window.doc.undo()
    assert edge.EdgePitch.Value == 0.0 and edge.PointCount == count


def test_editing_without_a_change_makes_no_undo_step(window: Any, edge: Any) -> None:
    before = window.trace()
    edit(window, edge)
    window.ok()
    assert window.trace() == before


def test_editing_that_is_given_up_leaves_no_trace(window: Any, edge: Any) -> None:
    before, points = window.trace(), list(edge.Points)
    edit(window, edge)
    window.click((0.3, -6.0, 5.0))
    window.press_escape()
    window.wait_until(lambda: not Gui.Control.activeDialog())
    window.wait_until(lambda: window.trace() == before)
    assert edge.Points == points


def test_an_edge_deleted_while_it_is_edited_takes_the_panel_along(window: Any, edge: Any) -> None:
    edit(window, edge)
    window.doc.removeObject(edge.Name)
    window.wait_until(lambda: not Gui.Control.activeDialog())


def test_an_edge_whose_cloud_is_gone_says_so(window: Any, edge: Any, problems: list[str]) -> None:
    window.doc.removeObject(window.cloud.Name)
    edge.ViewObject.Proxy.doubleClicked(edge.ViewObject)
    assert not Gui.Control.activeDialog()
    assert "was deleted" in problems[0]


def test_undo_and_redo_under_the_panel(window: Any, edge: Any) -> None:
    window.open_panel()
    window.doc.undo()
    window.settle()
    window.doc.redo()
    window.settle()
    window.click(ON_THE_RIDGE)
    window.found()
    window.ok()
    assert len(window.edges) == 2


def test_an_edge_can_be_edited_after_save_and_reopen(
    window: Any, edge: Any, tmp_path: Path
) -> None:
    name, path = edge.Name, str(tmp_path / "roof.FCStd")
    points = [tuple(point) for point in edge.Points]
    edge.Document.saveAs(path)
    FreeCAD.closeDocument(edge.Document.Name)
    doc = FreeCAD.openDocument(path)
    window.doc, window.view = doc, Gui.getDocument(doc.Name).ActiveView
    window.pass_time(0.3)
    again = doc.getObject(name)
    edit(window, again)
    assert np.allclose(window.panel._found.edge.points, points, atol=1e-9)
    window.ok()
    assert doc.UndoCount == 0
    FreeCAD.closeDocument(doc.Name)
