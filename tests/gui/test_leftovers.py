# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every command is activated; nothing of it stays behind, whatever was selected."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from typing import Any

import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")
Part = pytest.importorskip("Part")

NEED_A_PERSON = {"EdgeScan_ImportCloud", "EdgeScan_TryIt", "EdgeScan_SimulatedCloud"}
OPEN_A_PANEL = {
    *("EdgeScan_ScanEdge", "EdgeScan_ScanBoundary", "EdgeScan_ScanAllEdges"),
    "EdgeScan_RecommendParameters",
}


def commands() -> list[str]:
    from freecad_edgescan.gui.commands import menu

    return [name for name in menu() if name != "Separator"]


@pytest.fixture
def refused(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """All dialogs are cancelled."""
    from freecad_edgescan.gui.form_dialog import FormDialog
    from freecad_edgescan.gui.qt import QtWidgets

    monkeypatch.setattr(FormDialog, "asked", lambda dialog: bool(dialog.deleteLater()))
    for name in ("getOpenFileNames", "getSaveFileName"):
        monkeypatch.setattr(QtWidgets.QFileDialog, name, lambda *_: ([], ""))
    yield


def observers() -> int:
    """Document observers and panels of ours that are alive."""
    gc.collect()
    ours = (o for o in gc.get_objects() if type(o).__module__.startswith("freecad_edgescan.gui"))
    return sum(
        type(o).__name__.endswith(("Panel", "Background", "Preview", "Waiting")) for o in ours
    )


def test_every_command_on_every_wrong_selection_answers_and_leaves_nothing(
    window: Any, refused: None, problems: list[str]
) -> None:
    doc = window.doc
    line = doc.addObject("Part::Feature", "Line")
    line.Shape = Part.makeLine(FreeCAD.Vector(), FreeCAD.Vector(0, 0, 5))
    empty = doc.addObject("Part::Feature", "Empty")
    cloud = doc.findObjects("Points::Feature")[0]
    doc.recompute()
    before, threads, alive = window.trace(), window.threads, observers()
    for selected in ((), (cloud,), (line,), (empty,), (empty, cloud)):
        for name in commands():
            if name == "EdgeScan_TryIt":
                continue
            Gui.Selection.clearSelection()
            for item in selected:
                Gui.Selection.addSelection(item)
            problems.clear()
            steps = doc.UndoCount
            Gui.runCommand(name)
            window.settle()
            if name in OPEN_A_PANEL:
                assert Gui.Control.activeDialog()
                window.press_escape()
                window.wait_until(lambda: not Gui.Control.activeDialog())
            assert len(problems) <= 1, (name, problems)
            if problems:
                assert problems[0].rstrip().endswith((".", "?"))
                assert doc.UndoCount == steps, name
            while doc.UndoCount > steps:
                doc.undo()
    assert window.trace()[0] == before[0]
    assert window.trace()[2:] == before[2:]
    assert window.threads <= threads
    assert observers() <= alive


def test_in_an_empty_document_commands_are_off_or_work(
    workbench: Any, refused: None, problems: list[str]
) -> None:
    doc = FreeCAD.newDocument("Empty")
    active = {name for name in commands() if Gui.Command.get(name).isActive()}
    assert active == NEED_A_PERSON | {"EdgeScan_Report"}
    Gui.runCommand("EdgeScan_Report")
    Gui.runCommand("EdgeScan_SimulatedCloud")
    assert not doc.Objects
    FreeCAD.closeDocument(doc.Name)
