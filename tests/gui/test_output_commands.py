# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export and report by the mouse; what a right click offers; the guided first minute."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")
Part = pytest.importorskip("Part")


@pytest.fixture
def edge(window: Any) -> Any:
    from freecad_edgescan import document

    cloud = window.doc.findObjects("Points::Feature")[0]
    made = document.make_scanned_edge(window.doc, cloud, at=(0.0, 0.0, 5.0))
    window.doc.recompute()
    return made


@pytest.fixture
def save_as(monkeypatch: pytest.MonkeyPatch) -> Callable[[Path, str], list[Any]]:
    """Answers the file dialog; the pages that are opened in a browser are listed instead."""
    from freecad_edgescan.gui.qt import QtGui, QtWidgets

    opened: list[Any] = []
    monkeypatch.setattr(QtGui.QDesktopServices, "openUrl", lambda url: opened.append(url))

    def prepare(path: Path | str, kind: str = "") -> list[Any]:
        answer = (str(path), kind)
        monkeypatch.setattr(QtWidgets.QFileDialog, "getSaveFileName", lambda *_: answer)
        return opened

    return prepare


def test_everything_shown_is_exported_as_step(
    window: Any, edge: Any, tmp_path: Path, save_as: Any
) -> None:
    box = window.doc.addObject("Part::Box", "Box")
    window.doc.recompute()
    box.ViewObject.Visibility = False
    Gui.Selection.clearSelection()
    save_as(tmp_path / "all", "Edges and surfaces (*.step)")
    Gui.runCommand("EdgeScan_Export")
    written = Part.read(str(tmp_path / "all.step"))
    assert not written.Faces
    assert sum(own.Length for own in written.Edges) == pytest.approx(edge.Shape.Length, rel=1e-6)


def test_the_selected_edge_is_exported_as_a_table_with_sigma(
    window: Any, edge: Any, tmp_path: Path, save_as: Any
) -> None:
    Gui.Selection.addSelection(edge)
    save_as(tmp_path / "edge", "Edge points with sigma (*.csv)")
    Gui.runCommand("EdgeScan_Export")
    lines = (tmp_path / "edge.csv").read_text().splitlines()
    assert len(lines) == 1 + edge.PointCount
    assert "sigma_mm" in lines[0]


def test_a_cancelled_dialog_writes_nothing(window: Any, edge: Any, save_as: Any) -> None:
    before = window.trace()
    save_as("")
    Gui.runCommand("EdgeScan_Export")
    Gui.runCommand("EdgeScan_Report")
    assert window.trace() == before


def test_a_selected_cloud_has_no_shape_to_export(
    window: Any, edge: Any, problems: list[str]
) -> None:
    Gui.Selection.addSelection(edge.Cloud)
    Gui.runCommand("EdgeScan_Export")
    assert "Nothing with a shape" in problems[0]


def test_a_folder_that_does_not_exist_is_said(
    window: Any, edge: Any, tmp_path: Path, save_as: Any, problems: list[str]
) -> None:
    save_as(tmp_path / "missing" / "edge.step")
    Gui.runCommand("EdgeScan_Export")
    assert "cannot be written" in problems[0]


def test_the_report_is_written_and_opened(
    window: Any, edge: Any, tmp_path: Path, save_as: Any
) -> None:
    opened = save_as(tmp_path / "report.html")
    Gui.runCommand("EdgeScan_Report")
    assert edge.Label in (tmp_path / "report.html").read_text(encoding="utf-8")
    assert [Path(url.toLocalFile()) for url in opened] == [tmp_path / "report.html"]


def test_a_right_click_offers_what_goes_with_clouds_and_edges(window: Any, edge: Any) -> None:
    from freecad_edgescan.gui.commands import for_selection

    Gui.Selection.clearSelection()
    assert for_selection() == []
    Gui.Selection.addSelection(edge.Cloud)
    assert "EdgeScan_ScanEdge" in for_selection()
    assert "EdgeScan_Sweep" not in for_selection()
    Gui.Selection.addSelection(edge)
    assert {"EdgeScan_ScanEdge", "EdgeScan_Sweep"} <= set(for_selection())
    assert set(for_selection()) <= set(Gui.listCommands())
    Gui.activeWorkbench().ContextMenu("View")


def guides() -> list[Any]:
    from freecad_edgescan.gui.qt import QtWidgets
    from freecad_edgescan.gui.try_it import GUIDE_NAME

    return Gui.getMainWindow().findChildren(QtWidgets.QFrame, GUIDE_NAME)


def test_try_it_leads_from_the_core_box_to_its_first_edge_and_leaves_nothing(
    workbench: Any, panels: list[Any]
) -> None:
    from .conftest import Window

    Gui.runCommand("EdgeScan_TryIt")
    window = Window(FreeCAD.ActiveDocument, panels)
    window.settle()
    (guide,) = guides()
    window.picture("try_it_1")
    assert "Scan edge" in guide.sentence
    guide.action.click()
    window.wait_until(lambda: "rim" in guide.sentence)
    window.picture("try_it_2")
    from freecad_edgescan.cloud import CoreBox

    rim = CoreBox.small().edges[0].points
    place = rim[len(rim) // 3]
    window.click(tuple(place))
    window.wait_until(lambda: window.button("Ok").isEnabled())
    window.button("Ok").click()
    window.wait_until(lambda: "native curve" in guide.sentence)
    window.picture("try_it_3")
    (edge,) = window.edges
    assert edge.PointCount > 50
    FreeCAD.closeDocument(window.doc.Name)
    window.wait_until(lambda: not guides())


def test_the_guide_goes_away_when_it_is_closed(workbench: Any, panels: list[Any]) -> None:
    from .conftest import Window

    Gui.runCommand("EdgeScan_TryIt")
    first = FreeCAD.ActiveDocument.Name
    Gui.runCommand("EdgeScan_TryIt")
    window = Window(FreeCAD.ActiveDocument, panels)
    window.settle()
    (guide,) = guides()
    guide.finish.click()
    window.wait_until(lambda: not guides())
    for name in (first, window.doc.Name):
        FreeCAD.closeDocument(name)
    window.settle()
