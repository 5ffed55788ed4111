# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scanned edge shows its sigma and its scan lines on request, and offers it in its menu."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")
coin = pytest.importorskip("pivy.coin")

from freecad_edgescan import document  # noqa: E402
from freecad_edgescan.gui.qt import QtWidgets  # noqa: E402


@pytest.fixture
def edge(window: Any) -> Any:
    made = document.make_scanned_edge(window.doc, window.cloud, at=(0.0, 0.0, 5.0))
    window.doc.recompute()
    return made


def drawn(edge: Any) -> list[np.ndarray]:
    """Coordinates of all that is drawn besides the edge's own shape."""
    overlay = [
        child
        for child in edge.ViewObject.RootNode.getChildren()
        if child.getName() == "EdgeScanOverlay"
    ]
    if not overlay or overlay[0].whichChild.getValue() == -1:
        return []
    search = coin.SoSearchAction()
    search.setType(coin.SoCoordinate3.getClassTypeId())
    search.setInterest(coin.SoSearchAction.ALL)
    search.setSearchingAll(True)
    search.apply(overlay[0])
    found = []
    for path in search.getPaths():
        values = path.getTail().point.getValues()
        found.append(np.array([value.getValue() for value in values]).reshape(-1, 3))
    return [points for points in found if len(points)]


def test_an_edge_is_plain_until_something_else_is_asked_for(edge: Any) -> None:
    assert drawn(edge) == []
    assert not edge.ViewObject.ColourBySigma and not edge.ViewObject.ShowScanLines


def test_scan_lines_lie_on_the_roof_half_an_amplitude_to_each_side(window: Any, edge: Any) -> None:
    edge.ViewObject.ShowScanLines = True
    window.picture("edge_with_scan_lines")
    (lines,) = drawn(edge)
    assert len(lines) == 3 * edge.PointCount
    assert np.abs(lines[:, 2] - (5.0 - 0.8 * np.abs(lines[:, 0]))).max() < 0.15
    reach = np.linalg.norm(lines[0::3] - lines[1::3], axis=1)
    assert reach == pytest.approx(0.5 * edge.AmplitudeUsed.Value, rel=1e-5)
    assert np.all(np.sign(lines[0::3, 0]) == -np.sign(lines[2::3, 0]))


def test_colours_of_sigma_stand_on_the_edge_points(window: Any, edge: Any) -> None:
    edge.ViewObject.ColourBySigma = True
    window.picture("edge_by_sigma")
    shown = drawn(edge)
    assert len(shown) == 2
    for points in shown:
        assert points == pytest.approx(np.array([tuple(p) for p in edge.Points]), abs=1e-5)


def test_they_are_hidden_with_the_edge_and_follow_it(window: Any, edge: Any) -> None:
    edge.ViewObject.ColourBySigma = True
    edge.ViewObject.Visibility = False
    assert drawn(edge) == []
    edge.ViewObject.Visibility = True
    edge.EdgePitch = 2.0
    window.doc.recompute()
    assert len(drawn(edge)[0]) == edge.PointCount


def test_what_was_asked_for_is_there_after_save_and_reopen(edge: Any, tmp_path: Path) -> None:
    edge.ViewObject.ColourBySigma = True
    name, path = edge.Name, str(tmp_path / "roof.FCStd")
    edge.Document.saveAs(path)
    FreeCAD.closeDocument(edge.Document.Name)
    doc = FreeCAD.openDocument(path)
    again = doc.getObject(name)
    assert again.ViewObject.ColourBySigma and not again.ViewObject.ShowScanLines
    assert len(drawn(again)[0]) == again.PointCount
    FreeCAD.closeDocument(doc.Name)


def test_an_edge_from_an_older_file_gets_what_it_lacks(edge: Any, tmp_path: Path) -> None:
    for name in ("ColourBySigma", "ShowScanLines"):
        edge.ViewObject.removeProperty(name)
    name, path = edge.Name, str(tmp_path / "roof.FCStd")
    edge.Document.saveAs(path)
    FreeCAD.closeDocument(edge.Document.Name)
    doc = FreeCAD.openDocument(path)
    again = doc.getObject(name)
    again.ViewObject.ShowScanLines = True
    assert len(drawn(again)[0]) == 3 * again.PointCount
    FreeCAD.closeDocument(doc.Name)


def test_the_menu_offers_editing_and_both_looks(window: Any, edge: Any) -> None:
    menu = QtWidgets.QMenu()
    edge.ViewObject.Proxy.setupContextMenu(edge.ViewObject, menu)
    titles = [action.text() for action in menu.actions()]
    assert titles == ["Edit the scan", "Colour by sigma", "Show scan lines"]
    menu.actions()[1].trigger()
    assert edge.ViewObject.ColourBySigma
    menu.actions()[0].trigger()
    assert Gui.Control.activeDialog()
