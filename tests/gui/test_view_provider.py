# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges show their icon and colour, wherever they were made."""

from __future__ import annotations

import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")


@pytest.fixture
def edge(window: Any) -> Any:
    from freecad_edgescan import document

    cloud = window.doc.findObjects("Points::Feature")[0]
    edge = document.make_scanned_edge(window.doc, cloud, at=(0.0, 0.0, 5.0))
    window.doc.recompute()
    return edge


def icon_of(edge: Any) -> str:
    return Path(edge.ViewObject.Proxy.getIcon()).name


def saved_without_a_window(doc: Any, folder: Path) -> Path:
    """The document's file without what only the window writes; the document is closed."""
    path, bare = folder / "roof.FCStd", folder / "bare.FCStd"
    doc.saveAs(str(path))
    FreeCAD.closeDocument(doc.Name)
    with zipfile.ZipFile(path) as full, zipfile.ZipFile(bare, "w") as stripped:
        for member in full.namelist():
            if member != "GuiDocument.xml" and "Color" not in member:
                stripped.writestr(member, full.read(member))
    return bare


def test_an_edge_made_by_a_script_is_dressed(edge: Any) -> None:
    assert icon_of(edge) == "EdgeScan_ScannedEdge.svg"
    assert edge.ViewObject.Visibility
    assert edge.ViewObject.LineWidth == 3.0


def test_an_edge_is_dressed_after_save_and_reopen_and_keeps_its_colour(
    edge: Any, tmp_path: Path
) -> None:
    edge.ViewObject.LineColor = (0.0, 0.0, 1.0)
    name, path = edge.Name, str(tmp_path / "roof.FCStd")
    edge.Document.saveAs(path)
    FreeCAD.closeDocument(edge.Document.Name)
    doc = FreeCAD.openDocument(path)
    again = doc.getObject(name)
    assert icon_of(again) == "EdgeScan_ScannedEdge.svg"
    assert again.ViewObject.LineColor[:3] == (0.0, 0.0, 1.0)
    FreeCAD.closeDocument(doc.Name)


def test_an_edge_from_a_file_written_without_a_window_is_dressed_and_seen(
    window: Any, edge: Any, tmp_path: Path
) -> None:
    name = edge.Name
    doc = FreeCAD.openDocument(str(saved_without_a_window(edge.Document, tmp_path)))
    again = doc.getObject(name)
    assert icon_of(again) == "EdgeScan_ScannedEdge.svg"
    assert again.ViewObject.Visibility
    assert again.Cloud.ViewObject.Visibility
    window.view = Gui.getDocument(doc.Name).ActiveView
    window.pass_time(0.3)
    width, height = window.view.getSize()
    x, y = window.pixel_of((0.0, 15.0, 5.0))
    left, low = window.pixel_of((0.0, -15.0, 5.0))
    assert np.hypot(x - left, y - low) > 0.2 * min(width, height)
    assert 0 <= min(x, left) <= max(x, left) < width
    assert 0 <= min(y, low) <= max(y, low) < height
    FreeCAD.closeDocument(doc.Name)


def test_an_edge_comes_back_dressed_when_its_deletion_is_undone(edge: Any) -> None:
    doc, name = edge.Document, edge.Name
    doc.openTransaction("Delete")
    doc.removeObject(name)
    doc.commitTransaction()
    doc.undo()
    assert icon_of(doc.getObject(name)) == "EdgeScan_ScannedEdge.svg"


def test_a_sweep_from_a_file_written_without_a_window_stands_above_its_profile(
    edge: Any, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    import Part

    from freecad_edgescan import document

    curve = edge.Shape.Edges[0]
    begin, along = curve.valueAt(curve.FirstParameter), curve.tangentAt(curve.FirstParameter)
    bead = edge.Document.addObject("Part::Feature", "Bead")
    bead.Shape = Part.Wire(Part.makeCircle(0.5, begin, along))
    name = document.make_sweep(edge.Document, bead, edge).Name
    edge.Document.recompute()
    doc = FreeCAD.openDocument(str(saved_without_a_window(edge.Document, tmp_path)))
    Gui.updateGui()
    sweep = doc.getObject(name)
    assert icon_of(sweep) == "EdgeScan_Sweep.svg"
    assert sweep.ViewObject.Proxy.claimChildren() == [doc.Bead]
    FreeCAD.closeDocument(doc.Name)
    assert "Traceback" not in "".join(capfd.readouterr())
