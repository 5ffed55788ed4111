# SPDX-License-Identifier: LGPL-2.1-or-later
"""Import, sweep and loft as a person uses them: select, run, undo."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")
Part = pytest.importorskip("Part")


@pytest.fixture
def answer_file_dialog(monkeypatch: pytest.MonkeyPatch) -> Any:
    """Chooses files in the file dialog, and answers the dialog about them."""
    from freecad_edgescan.gui.qt import QtWidgets

    def choose(*paths: Path, **entered: Any) -> None:
        from freecad_edgescan.gui.import_dialog import ImportDialog

        answer = ([str(path) for path in paths], "")
        monkeypatch.setattr(QtWidgets.QFileDialog, "getOpenFileNames", lambda *_: answer)
        monkeypatch.setattr(ImportDialog, "asked", lambda _: True)
        for name, value in entered.items():
            monkeypatch.setattr(ImportDialog, name, value)

    return choose


def add_edge(doc: Any, name: str, start: tuple[float, ...], end: tuple[float, ...]) -> Any:
    item = doc.addObject("Part::Feature", name)
    item.Shape = Part.makeLine(FreeCAD.Vector(*start), FreeCAD.Vector(*end))
    return item


def sweep_of(doc: Any) -> Any:
    """The only sweep of a document."""
    (sweep,) = (obj for obj in doc.Objects if hasattr(obj, "Spine"))
    return sweep


def select(*items: Any) -> None:
    Gui.Selection.clearSelection()
    for item in items:
        Gui.Selection.addSelection(item)


def test_import_makes_a_cloud_of_each_file_in_one_undo_step(
    window: Any, tmp_path: Path, answer_file_dialog: Any
) -> None:
    paths = [tmp_path / "a.xyz", tmp_path / "b c.csv"]
    for number, path in enumerate(paths, start=1):
        delimiter = "," if path.suffix == ".csv" else " "
        np.savetxt(path, np.random.default_rng(1).random((50 * number, 3)), delimiter=delimiter)
    answer_file_dialog(*paths)
    undo_steps = window.doc.UndoCount
    Gui.runCommand("EdgeScan_ImportCloud")
    clouds = window.doc.findObjects("Points::Feature")[1:]
    assert sorted(cloud.Points.CountPoints for cloud in clouds) == [50, 100]
    assert window.doc.UndoCount == undo_steps + 1
    assert Gui.Selection.getSelection() == clouds
    window.doc.undo()
    assert len(window.doc.findObjects("Points::Feature")) == 1


def test_an_imported_cloud_is_seen_as_a_whole(
    window: Any, tmp_path: Path, answer_file_dialog: Any
) -> None:
    np.savetxt(tmp_path / "far.xyz", 50 + 300 * np.random.default_rng(1).random((50, 3)))
    answer_file_dialog(tmp_path / "far.xyz")
    Gui.runCommand("EdgeScan_ImportCloud")
    window.pass_time(0.3)
    width, height = window.view.getSize()
    for corner in ((50.0, 50.0, 50.0), (350.0, 350.0, 350.0)):
        x, y = window.pixel_of(corner)
        assert 0 <= x < width
        assert 0 <= y < height


def test_import_without_a_document_makes_one(
    no_document: None, tmp_path: Path, answer_file_dialog: Any
) -> None:
    assert FreeCAD.ActiveDocument is None
    np.savetxt(tmp_path / "a.xyz", np.random.default_rng(1).random((50, 3)))
    answer_file_dialog(tmp_path / "a.xyz")
    Gui.runCommand("EdgeScan_ImportCloud")
    doc = FreeCAD.ActiveDocument
    assert doc.findObjects("Points::Feature")[0].Points.CountPoints == 50
    FreeCAD.closeDocument(doc.Name)


def test_a_file_that_cannot_be_read_is_said_and_leaves_nothing_behind(
    window: Any, tmp_path: Path, answer_file_dialog: Any, problems: list[str]
) -> None:
    before = window.trace()
    (tmp_path / "bad.xyz").write_text("1 2 3\nfour five six\n")
    np.savetxt(tmp_path / "good.xyz", np.random.default_rng(1).random((50, 3)))
    answer_file_dialog(tmp_path / "good.xyz", tmp_path / "bad.xyz")
    Gui.runCommand("EdgeScan_ImportCloud")
    assert len(problems) == 1
    assert "bad.xyz" in problems[0]
    assert window.trace() == before


def test_a_bad_file_without_a_document_leaves_no_document(
    no_document: None, tmp_path: Path, answer_file_dialog: Any, problems: list[str]
) -> None:
    answer_file_dialog(tmp_path / "missing.xyz")
    Gui.runCommand("EdgeScan_ImportCloud")
    assert "missing.xyz" in problems[0]
    assert not FreeCAD.listDocuments()


def test_sweep_moves_the_profile_along_the_rail(window: Any) -> None:
    profile = add_edge(window.doc, "Profile", (0, 0, 0), (3, 0, 0))
    rail = add_edge(window.doc, "Rail", (0, 0, 0), (0, 0, 10))
    window.doc.recompute()
    undo_steps = window.doc.UndoCount
    select(profile, rail)
    Gui.runCommand("EdgeScan_Sweep")
    sweep = sweep_of(window.doc)
    assert sweep.Shape.Area == pytest.approx(30.0)
    assert sweep.ViewObject.Proxy.claimChildren() == [profile]
    assert Path(sweep.ViewObject.Proxy.getIcon()).is_file()
    assert window.doc.UndoCount == undo_steps + 1


def test_a_scanned_edge_is_the_rail_in_whatever_order_it_is_selected(window: Any) -> None:
    from freecad_edgescan import document

    cloud = window.doc.findObjects("Points::Feature")[0]
    edge = document.make_scanned_edge(window.doc, cloud, at=(0.0, 0.0, 5.0))
    window.doc.recompute()
    start = edge.Shape.Vertexes[0].Point
    profile = add_edge(window.doc, "Profile", start, start + FreeCAD.Vector(0, 0, 2))
    select(edge, profile)
    Gui.runCommand("EdgeScan_Sweep")
    sweep = sweep_of(window.doc)
    assert sweep.Spine[0] == edge
    assert sweep.Shape.Area == pytest.approx(2 * edge.Shape.Length, rel=0.01)


def test_loft_joins_the_edges_in_the_order_of_selection(window: Any) -> None:
    lines = [add_edge(window.doc, f"Line{z}", (0, 0, z), (4, 0, z)) for z in (0, 2, 5)]
    window.doc.recompute()
    select(*lines)
    Gui.runCommand("EdgeScan_Loft")
    (loft,) = window.doc.findObjects("Part::Loft")
    assert loft.Sections == lines
    assert loft.Shape.Area == pytest.approx(20.0)


@pytest.mark.parametrize("name", ["EdgeScan_Sweep", "EdgeScan_Loft"])
def test_with_the_wrong_selection_one_sentence_says_what_to_select(
    window: Any, name: str, problems: list[str]
) -> None:
    add_edge(window.doc, "Rail", (0, 0, 0), (0, 0, 10))
    before = window.trace()
    select(window.doc.findObjects("Points::Feature")[0])
    Gui.runCommand(name)
    assert len(problems) == 1
    assert "Select two" in problems[0]
    assert window.trace() == before


def test_recorded_lines_mention_neither_screen_nor_mouse(
    window: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    lines: list[str] = []
    run = Gui.doCommand

    def record(line: str) -> None:
        lines.append(line)
        run(line)

    monkeypatch.setattr(Gui, "doCommand", record)
    select(
        add_edge(window.doc, "Profile", (0, 0, 0), (3, 0, 0)),
        add_edge(window.doc, "Rail", (0, 0, 0), (0, 0, 10)),
    )
    Gui.runCommand("EdgeScan_Sweep")
    area = sweep_of(window.doc).Shape.Area
    assert not any("Gui" in line for line in lines)
    window.doc.undo()
    exec("import FreeCAD\n" + "\n".join(lines), {})
    assert sweep_of(window.doc).Shape.Area == area
