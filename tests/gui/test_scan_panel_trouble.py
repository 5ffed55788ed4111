# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever happens while the scan panel is open, nothing crashes and nothing is left behind."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")

from freecad_edgescan import document  # noqa: E402
from freecad_edgescan.gui.background import running  # noqa: E402
from freecad_edgescan.gui.qt import QtWidgets  # noqa: E402
from freecad_edgescan.gui.single_shot import call_later  # noqa: E402

from .conftest import roof  # noqa: E402
from .ways_out import by_cancel, by_escape, by_freecad, by_the_cross  # noqa: E402

ON_THE_RIDGE = (0.3, 2.0, 5.0)
PREVIEWS = ("EdgeScanPreview", "EdgeScanThinnedClouds")


@pytest.fixture
def observers(window: Any, monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """The document observers that are registered and not removed."""
    document.point_cloud(window.cloud)  # its own observer stays, once
    present: list[Any] = []
    add, remove = FreeCAD.addDocumentObserver, FreeCAD.removeDocumentObserver

    def note(observer: Any) -> None:
        present.append(observer)
        add(observer)

    def forget(observer: Any) -> None:
        if observer in present:
            present.remove(observer)
        remove(observer)

    monkeypatch.setattr(FreeCAD, "addDocumentObserver", note)
    monkeypatch.setattr(FreeCAD, "removeDocumentObserver", forget)
    return present


@pytest.fixture
def callbacks(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Kinds of events of the 3D view that are still listened to."""
    from freecad_edgescan.gui import view_clicks

    present: list[str] = []

    class Counting(view_clicks.ViewClicks):
        def __init__(self, view: Any, *answers: Any) -> None:
            super().__init__(view, *answers)
            present.extend(kind for kind, _ in self._callbacks)

        def close(self) -> None:
            if self._view is not None:
                for kind, _ in self._callbacks:
                    present.remove(kind)
            super().close()

    monkeypatch.setattr("freecad_edgescan.gui.cloud_clicks.ViewClicks", Counting)
    return present


def before_a_click(window: Any) -> None:
    window.open_panel()


def before_the_index(window: Any) -> None:
    Gui.runCommand("EdgeScan_ScanEdge")


def at_once_after_a_click(window: Any) -> None:
    window.open_panel()
    window.click(ON_THE_RIDGE)


def while_it_walks(window: Any) -> None:
    at_once_after_a_click(window)
    window.wait_until(lambda: len(window.panel._display.preview.edge.points) > 0)


def with_an_edge(window: Any) -> None:
    at_once_after_a_click(window)
    window.found()


def after_a_failure(window: Any) -> None:
    window.open_panel()
    window.click((8.0, 0.0, 5.0 - 0.8 * 8.0))
    window.wait_until(lambda: "being followed" not in window.sentence)


MOMENTS = [
    *(before_a_click, before_the_index, at_once_after_a_click),
    *(while_it_walks, with_an_edge, after_a_failure),
]


@pytest.mark.parametrize(
    ("way_out", "moment"),
    [
        *((by_escape, moment) for moment in MOMENTS),
        *((by_cancel, moment) for moment in (before_a_click, while_it_walks)),
        *((by_the_cross, moment) for moment in (before_the_index, while_it_walks, with_an_edge)),
        *((by_freecad, moment) for moment in (while_it_walks, with_an_edge)),
    ],
)
def test_no_way_out_at_any_moment_leaves_a_trace(
    window: Any,
    observers: list[Any],
    callbacks: list[str],
    moment: Callable[[Any], None],
    way_out: Callable[[Any], None],
) -> None:
    before = window.trace()
    threads = window.threads
    moment(window)
    assert observers and callbacks
    way_out(window)
    window.wait_until(lambda: not Gui.Control.activeDialog(), 20)
    window.wait_until(lambda: window.trace() == before and running() == 0, 20)
    if way_out is by_the_cross:
        window.pass_time(0.6)  # until the dock is back
    assert not observers and not callbacks
    assert window.threads <= threads
    scene = window.view.getSceneGraph()
    assert not any(scene.getByName(name) for name in PREVIEWS)


def test_the_cross_of_the_view_takes_the_panel_along(window: Any, observers: list[Any]) -> None:
    with_an_edge(window)
    answer_question(QtWidgets.QMessageBox.Discard)
    Gui.getMainWindow().centralWidget().currentSubWindow().close()
    window.wait_until(lambda: not Gui.Control.activeDialog(), 20)
    assert not observers


def test_a_view_that_stays_open_after_all_keeps_the_panel(window: Any) -> None:
    with_an_edge(window)
    answer_question(QtWidgets.QMessageBox.Cancel)
    Gui.getMainWindow().centralWidget().currentSubWindow().close()
    window.settle()
    assert Gui.Control.activeDialog()
    window.ok()
    assert len(window.edges) == 1


def answer_question(choice: Any, turns: int = 100) -> None:
    """Answer FreeCAD's question whether to save, as soon as it is asked."""
    question = QtWidgets.QApplication.activeModalWidget()
    if question is not None:
        question.button(choice).click()
    elif turns:
        call_later(lambda: answer_question(choice, turns - 1), 100)


def test_looking_at_an_edge_does_not_change_the_document(window: Any, tmp_path: Path) -> None:
    window.doc.saveAs(str(tmp_path / "roof.FCStd"))
    Gui.SendMsgToActiveView("Save")
    assert not Gui.getDocument(window.doc.Name).Modified
    with_an_edge(window)
    by_cancel(window)
    window.settle()
    assert not Gui.getDocument(window.doc.Name).Modified


@pytest.mark.parametrize("moment", MOMENTS)
def test_a_document_may_be_closed_at_any_moment(
    window: Any, observers: list[Any], moment: Callable[[Any], None]
) -> None:
    moment(window)
    FreeCAD.closeDocument(window.doc.Name)
    window.wait_until(lambda: not Gui.Control.activeDialog(), 20)
    window.wait_until(lambda: running() == 0)
    assert not observers


@pytest.mark.parametrize("moment", [at_once_after_a_click, while_it_walks, with_an_edge])
def test_a_cloud_may_be_deleted_at_any_moment_and_its_deletion_undone(
    window: Any, moment: Callable[[Any], None]
) -> None:
    window.doc.UndoMode = 1
    moment(window)
    window.doc.openTransaction("Delete")
    window.doc.removeObject(window.cloud.Name)
    window.doc.commitTransaction()
    window.settle()
    assert "deleted" in window.sentence
    assert not window.button("Ok").isEnabled()
    window.doc.undo()
    window.wait_until(lambda: window.panel._display.clouds.count > 0)
    window.wait_until(lambda: window.panel._clicks.ready)
    window.click(ON_THE_RIDGE)
    window.found()
    window.ok()
    assert len(window.edges) == 1


def test_a_cloud_that_is_moved_under_the_panel_is_to_be_clicked_again(window: Any) -> None:
    with_an_edge(window)
    window.cloud.Placement = FreeCAD.Placement(FreeCAD.Vector(0, 0, 7), FreeCAD.Rotation())
    window.settle()
    assert "has changed" in window.sentence
    assert not window.button("Ok").isEnabled()
    window.view.fitAll()
    window.settle()
    window.wait_until(lambda: window.panel._clicks.ready)
    window.click((0.3, 2.0, 12.0))
    window.found()
    window.ok()
    assert window.edges[0].Points[5].z == pytest.approx(12.0, abs=0.1)


def test_a_part_that_is_moved_takes_its_cloud_along(window: Any) -> None:
    part = window.doc.addObject("App::Part", "Part")
    part.addObject(window.cloud)
    window.doc.recompute()
    with_an_edge(window)
    part.Placement = FreeCAD.Placement(FreeCAD.Vector(0, 0, 7), FreeCAD.Rotation())
    window.settle()
    assert "has changed" in window.sentence
    assert not window.button("Ok").isEnabled()


def test_another_document_may_be_worked_in_meanwhile(window: Any) -> None:
    with_an_edge(window)
    other = FreeCAD.newDocument("Other")
    window.settle()
    other.addObject("Part::Box", "Box")
    other.recompute()
    window.panel.buttons.button(QtWidgets.QDialogButtonBox.Ok).click()
    window.wait_until(lambda: not Gui.Control.activeDialog())
    assert len(window.edges) == 1
    assert [item.Name for item in other.Objects] == ["Box"]
    FreeCAD.closeDocument(other.Name)


def test_another_document_may_be_closed_meanwhile(window: Any) -> None:
    other = FreeCAD.newDocument("Other")
    document.make_cloud(other, roof() + 100.0)
    area = Gui.getMainWindow().centralWidget()
    area.setActiveSubWindow(area.subWindowList()[0])
    window.settle()
    with_an_edge(window)
    FreeCAD.closeDocument(other.Name)
    window.settle()
    assert Gui.Control.activeDialog()
    window.ok()
    assert len(window.edges) == 1


def test_a_click_on_another_object_is_answered_by_its_name(window: Any) -> None:
    box = window.doc.addObject("Part::Box", "Box")
    box.Placement.Base = FreeCAD.Vector(30, 0, 0)
    window.doc.recompute()
    window.view.fitAll()
    window.settle()
    window.open_panel()
    window.click((35.0, 5.0, 10.0))
    assert "That is Box" in window.sentence


def test_of_two_clouds_the_one_clicked_on_is_scanned(window: Any) -> None:
    second = document.make_cloud(window.doc, roof() + np.array([0.0, 40.0, 0.0]))
    window.doc.recompute()
    window.view.fitAll()
    window.settle()
    with_an_edge(window)
    window.click((0.3, 42.0, 5.0))
    window.wait_until(lambda: "being followed" not in window.sentence)
    window.ok()
    assert window.edges[0].Cloud is second


def test_a_cloud_in_a_hidden_part_counts_as_hidden(window: Any, problems: list[str]) -> None:
    part = window.doc.addObject("App::Part", "Part")
    part.addObject(window.cloud)
    part.ViewObject.Visibility = False
    window.settle()
    Gui.runCommand("EdgeScan_ScanEdge")
    assert not Gui.Control.activeDialog()
    assert "visible" in problems[0]
