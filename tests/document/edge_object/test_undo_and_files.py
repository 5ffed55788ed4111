# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scanned edge in undo and in files comes back as it was, without a scan."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD
import pytest

from freecad_edgescan import document
from freecad_edgescan.document import scanned_edge

from .box import is_valid


def test_undo_and_redo_take_the_edge_away_and_back_without_scanning(
    doc: Any, cloud: Any, scans: list[str]
) -> None:
    doc.openTransaction("Scan edge")
    name = document.make_scanned_edge(doc, cloud, at=(10, 0, 10)).Name
    doc.recompute()
    doc.commitTransaction()
    length = doc.getObject(name).Shape.Length
    doc.undo()
    assert doc.getObject(name) is None
    doc.redo()
    doc.recompute()
    assert doc.getObject(name).Shape.Length == length
    assert scans == [name]


def test_undo_of_a_change_brings_the_former_result_back(
    doc: Any, edge: Any, scans: list[str]
) -> None:
    count = edge.PointCount
    doc.openTransaction("Change")
    edge.EdgePitch = 2.0
    doc.recompute()
    doc.commitTransaction()
    assert edge.PointCount != count
    doc.undo()
    doc.recompute()
    assert edge.PointCount == len(edge.Points) == count
    assert len(scans) == 1


def test_a_file_opens_with_the_edge_as_it_was(
    doc: Any, edge: Any, tmp_path: Path, scans: list[str]
) -> None:
    name, length, points = edge.Name, edge.Shape.Length, list(edge.Points)
    path = str(tmp_path / "edge.FCStd")
    doc.saveAs(path)
    FreeCAD.closeDocument(doc.Name)
    again = FreeCAD.openDocument(path)
    read = again.getObject(name)
    read.touch()
    again.recompute()
    assert isinstance(read.Proxy, scanned_edge.ScannedEdgeProxy)
    assert read.Shape.Length == pytest.approx(length, abs=1e-12)
    assert list(read.Points) == points
    assert is_valid(read)
    assert not scans
    read.EdgePitch = 2.0
    again.recompute()
    assert scans == [name]


def test_a_property_added_since_is_given_to_an_edge_of_an_older_file(
    doc: Any, edge: Any, tmp_path: Path
) -> None:
    name = edge.Name
    edge.removeProperty("MinAngle")
    path = str(tmp_path / "old.FCStd")
    doc.saveAs(path)
    FreeCAD.closeDocument(doc.Name)
    read = FreeCAD.openDocument(path).getObject(name)
    assert read.MinAngle.Value == 0.0
