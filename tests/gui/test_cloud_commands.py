# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simulated, compensated and thinned clouds, and imports in other units, as a person makes them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")


def select(*items: Any) -> None:
    Gui.Selection.clearSelection()
    for item in items:
        Gui.Selection.addSelection(item)


def cloud_of(doc: Any) -> Any:
    return doc.findObjects("Points::Feature")[0]


@pytest.fixture
def answer(monkeypatch: pytest.MonkeyPatch) -> Callable[..., None]:
    """Answers the next dialog of a command: enters values by position, then OK."""
    from freecad_edgescan.gui.form_dialog import FormDialog
    from freecad_edgescan.gui.length_field import set_length
    from freecad_edgescan.gui.qt import QtWidgets

    def prepare(*values: float | int | None) -> None:
        def enter(dialog: Any) -> bool:
            dialog.show()
            role = QtWidgets.QFormLayout.FieldRole
            for row, value in enumerate(values):
                field = dialog.fields.itemAt(row, role).widget()
                if value is None:
                    continue
                if isinstance(field, QtWidgets.QComboBox):
                    field.setCurrentIndex(value)
                else:
                    set_length(field, value)
            dialog.close()
            dialog.deleteLater()
            return True

        monkeypatch.setattr(FormDialog, "asked", enter)

    return prepare


def test_a_selected_part_is_scanned_as_asked(window: Any, answer: Any) -> None:
    box = window.doc.addObject("Part::Box", "Box")
    window.doc.recompute()
    select(box)
    steps = window.doc.UndoCount
    answer(0, 0.5, 0.0, 0.0)
    Gui.runCommand("EdgeScan_SimulatedCloud")
    (cloud,) = Gui.Selection.getSelection()
    assert cloud.Source == box
    assert cloud.PointCount == pytest.approx(600 / 0.25, rel=0.1)
    assert cloud.ViewObject.DisplayMode == "Color"
    assert Path(cloud.ViewObject.Proxy.getIcon()).is_file()
    assert window.doc.UndoCount == steps + 1
    window.doc.undo()
    assert len(window.doc.findObjects("Points::Feature")) == 1


def test_without_a_document_the_core_box_makes_one(no_document: None, answer: Any) -> None:
    assert FreeCAD.ActiveDocument is None
    answer(0, 1.5)
    Gui.runCommand("EdgeScan_SimulatedCloud")
    doc = FreeCAD.ActiveDocument
    assert cloud_of(doc).ProbeRadius.Value == pytest.approx(1.0055)
    FreeCAD.closeDocument(doc.Name)


def test_a_pitch_that_leaves_no_points_is_said_and_nothing_made(
    window: Any, answer: Any, problems: list[str]
) -> None:
    box = window.doc.addObject("Part::Box", "Box")
    window.doc.recompute()
    select(box)
    before = window.trace()
    answer(0, 500.0)
    Gui.runCommand("EdgeScan_SimulatedCloud")
    assert "smaller pitch" in problems[0]
    assert window.trace() == before


def test_the_only_cloud_needs_no_selection_to_be_thinned(window: Any, answer: Any) -> None:
    from freecad_edgescan import document

    cloud = cloud_of(window.doc)
    select()
    threads = window.threads
    answer(1.0)
    Gui.runCommand("EdgeScan_ThinCloud")
    thin = window.doc.findObjects("Points::FeaturePython")[0]
    area = 30 * 20 * np.hypot(1, 0.8)
    assert np.sqrt(area / thin.PointCount) == pytest.approx(1.0, rel=0.1)
    assert not cloud.ViewObject.Visibility
    assert window.threads <= threads
    known = document.point_cloud(thin)
    thin.touch()
    window.doc.recompute()
    assert document.point_cloud(thin) is known


def test_a_cloud_of_centres_is_compensated(window: Any) -> None:
    from freecad_edgescan import document

    cloud = cloud_of(window.doc)
    cloud.ProbeRadius, cloud.Approach = 1.0, (0.0, 0.0, -1.0)
    select(cloud)
    Gui.runCommand("EdgeScan_CompensateCloud")
    part = window.doc.findObjects("Points::FeaturePython")[0]
    points = document.points_of(part)
    level = points[:, 2] + 0.8 * np.abs(points[:, 0])
    assert np.median(level) == pytest.approx(5.0 - np.hypot(1, 0.8), abs=0.01)


@pytest.mark.parametrize("name", ["EdgeScan_CompensateCloud", "EdgeScan_ThinCloud"])
def test_what_is_wrong_with_the_selection_is_said(
    window: Any, name: str, problems: list[str]
) -> None:
    cloud = cloud_of(window.doc)
    again = window.doc.copyObject(cloud)
    box = window.doc.addObject("Part::Box", "Box")
    window.doc.recompute()
    before = window.trace()
    for selected, shown, word in (
        ((cloud, again), True, "2 clouds are selected"),
        ((box,), True, "Box is selected"),
        ((), True, "shows 2 clouds"),
        ((), False, "hidden"),
    ):
        cloud.ViewObject.Visibility = again.ViewObject.Visibility = shown
        select(*selected)
        Gui.runCommand(name)
        assert word in problems.pop()
    cloud.ViewObject.Visibility = again.ViewObject.Visibility = True
    assert window.trace() == before


def test_a_cloud_without_a_probe_is_not_compensated(window: Any, problems: list[str]) -> None:
    select(cloud_of(window.doc))
    Gui.runCommand("EdgeScan_CompensateCloud")
    assert "ProbeRadius" in problems[0]


@pytest.fixture
def choose(monkeypatch: pytest.MonkeyPatch) -> Callable[[Path], None]:
    from freecad_edgescan.gui.qt import QtWidgets

    def prepare(path: Path) -> None:
        answer = ([str(path)], "")
        monkeypatch.setattr(QtWidgets.QFileDialog, "getOpenFileNames", lambda *_: answer)

    return prepare


def test_a_file_in_inches_is_imported_in_inches(
    window: Any, tmp_path: Path, choose: Any, answer: Any
) -> None:
    from freecad_edgescan import document

    points = np.random.default_rng(1).random((50, 3))
    np.savetxt(tmp_path / "inch.xyz", points)
    choose(tmp_path / "inch.xyz")
    answer(2, None, 0.5)
    Gui.runCommand("EdgeScan_ImportCloud")
    (cloud,) = Gui.Selection.getSelection()
    assert document.points_of(cloud) == pytest.approx(25.4 * points, rel=1e-5)
    assert cloud.ProbeRadius.Value == 0.5


def test_the_dialog_offers_to_move_a_far_cloud_and_doubts_a_tiny_one(
    window: Any, tmp_path: Path
) -> None:
    from freecad_edgescan.cloud import PointCloud
    from freecad_edgescan.gui.import_dialog import ImportDialog

    points = np.random.default_rng(1).random((50, 3))
    near = ImportDialog({Path("near.xyz"): PointCloud(0.1 * points)})
    far = ImportDialog({Path("far.xyz"): PointCloud(100.0 * points + [5e6, 0, 0])})
    assert near.fields.rowCount() + 2 == far.fields.rowCount()
    assert "metres?" in near._size.text()
    assert "metres?" not in far._size.text()
    assert far.near_origin
    far._near.setChecked(False)
    assert not far.near_origin
    near.deleteLater()
    far.deleteLater()


def test_the_import_dialog_says_what_is_wrong_with_a_cloud(workbench: Any) -> None:
    from freecad_edgescan.cloud import PointCloud
    from freecad_edgescan.gui.import_dialog import ImportDialog

    points = np.random.default_rng(1).random((50, 3))
    points[3] = np.nan
    with pytest.warns(UserWarning, match="left out"):
        gappy = ImportDialog({Path("gappy.xyz"): PointCloud(points)})
    few = ImportDialog({Path("few.xyz"): PointCloud(points[:3])})
    assert gappy.sentence.text() == (
        "gappy.xyz: 49 points. Rows with nan or inf that are left out: 1."
    )
    assert "needs at least 20" in few.sentence.text()
    gappy.deleteLater()
    few.deleteLater()


def test_a_file_is_read_once(
    window: Any, tmp_path: Path, choose: Any, answer: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    from freecad_edgescan.document import cloud_source

    reads: list[Path] = []
    read = cloud_source.read_cloud
    monkeypatch.setattr(
        cloud_source, "read_cloud", lambda path, **more: (reads.append(path), read(path, **more))[1]
    )
    np.savetxt(tmp_path / "a.xyz", np.random.default_rng(1).random((50, 3)))
    choose(tmp_path / "a.xyz")
    answer()
    Gui.runCommand("EdgeScan_ImportCloud")
    assert len(reads) == 1
    assert Gui.Selection.getSelection()[0].Points.CountPoints == 50


def test_lengths_are_asked_for_and_shown_in_the_users_units(workbench: Any) -> None:
    from freecad_edgescan.gui.length_field import length_field, length_in
    from freecad_edgescan.gui.quantities import length_text

    usual = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units").GetInt("UserSchema", 0)
    try:
        FreeCAD.Units.setSchema(3)  # inches
        field = length_field(25.4)
        assert field.text().startswith("1.00")
        assert not field.text().endswith("mm")
        assert length_text(50.8).startswith("2.00")
        assert length_text(0.00587).startswith("0.000231")
        assert length_in(field) == pytest.approx(25.4)
    finally:
        FreeCAD.Units.setSchema(usual)
    field.deleteLater()
