# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is scanned is a native edge with its results beside it."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import FreeCAD
import numpy as np
import Part
import pytest

from freecad_edgescan import document
from freecad_edgescan.cloud import SimulatedCloud
from freecad_edgescan.document.scanned_edge_properties import PROPERTIES
from freecad_edgescan.scanning import Gate, ScanParameters, Start

from .box import NOISE, box_cloud, is_valid


@cache
def cylinder_cloud() -> SimulatedCloud:
    return document.simulate_cloud(Part.makeCylinder(10, 12), 0.4, NOISE)


def test_the_edge_of_a_box_is_one_straight_native_edge(edge: Any) -> None:
    assert edge.TypeId == "Part::FeaturePython"
    assert edge.Shape.ShapeType == "Edge"
    assert isinstance(edge.Shape.Curve, Part.Line)
    truth = Part.makeLine(FreeCAD.Vector(0, 0, 10), FreeCAD.Vector(20, 0, 10))
    for vertex in edge.Shape.Vertexes:
        assert truth.distToShape(vertex)[0] < 3 * NOISE
    assert edge.Length.Value == pytest.approx(20.0, abs=3.5)


def test_the_rim_of_a_cylinder_is_one_circle(doc: Any) -> None:
    cloud = document.make_cloud(doc, cylinder_cloud())
    rim = document.make_scanned_edge(doc, cloud, at=(10, 0, 12))
    doc.recompute()
    assert rim.Closed
    assert rim.Stops == ["CLOSED", "CLOSED"]
    assert isinstance(rim.Shape.Curve, Part.Circle)
    assert rim.Shape.Curve.Radius == pytest.approx(10.0, abs=3 * NOISE)


def test_results_and_what_automatic_chose_are_shown_read_only(edge: Any) -> None:
    assert edge.PointCount == len(edge.Points) == len(edge.Sigma) == len(edge.Tangents) > 10
    assert edge.MeanAngle.Value == pytest.approx(90.0, abs=1.0)
    assert 0.0 < edge.MeanSigma.Value <= edge.LargestSigma.Value
    assert edge.Stops == ["CORNER", "CORNER"]
    assert edge.Message
    assert edge.Amplitude.Value == 0.0
    assert edge.AmplitudeUsed.Value > 0.0
    for name in ("Message", "Length", "AmplitudeUsed", "Points", "InputHash"):
        assert "ReadOnly" in edge.getPropertyStatus(name) or "ReadOnly" in edge.getEditorMode(name)


def test_every_input_has_a_tooltip(edge: Any) -> None:
    for item in PROPERTIES:
        assert edge.getDocumentationOfProperty(item.name) == item.tooltip != ""
        assert edge.getGroupOfProperty(item.name) == item.group


def test_what_only_a_probed_scan_reads_is_shown_with_that_method(
    doc: Any, edge: Any, tmp_path: Path
) -> None:
    def hidden(obj: Any, name: str) -> bool:
        return "Hidden" in obj.getEditorMode(name)

    for name in ("LinePitch", "Degree", "Pattern", "Compensation"):
        assert hidden(edge, name)
        assert hidden(edge, f"{name}Used")
    assert not hidden(edge, "Amplitude")
    edge.Method = "probe"
    for name in ("LinePitch", "Degree", "Pattern", "Compensation"):
        assert edge.getEditorMode(name) == []
        assert edge.getEditorMode(f"{name}Used") == ["ReadOnly"]
    path = str(tmp_path / "probed.FCStd")
    doc.saveAs(path)
    opened = FreeCAD.openDocument(path)
    again = opened.getObject(edge.Name)
    assert again.getEditorMode("LinePitch") == []
    again.Method = "patch"
    assert hidden(again, "LinePitch")


def test_an_edge_is_probed_line_by_line(doc: Any, cloud: Any, edge: Any) -> None:
    probed = document.make_scanned_edge(doc, cloud, at=(10, 0, 10), method="probe")
    doc.recompute()
    assert is_valid(probed)
    assert probed.PatternUsed == "square"
    assert probed.LinePitchUsed.Value >= 0.4
    assert any(reason.startswith("tolerance: ") for reason in probed.Reasons)
    assert set(probed.Compensated) == {"none"}
    off = np.array([(p.y, p.z - 10.0) for p in probed.Points])
    assert np.hypot(*off.T).mean() < 3.0 * NOISE  # the true edge is y = 0, z = 10
    before = probed.PointCount
    probed.Pattern, probed.LinePitch = "zigzag", 1.0
    doc.recompute()
    assert (probed.PatternUsed, probed.LinePitchUsed.Value) == ("zigzag", 1.0)
    probed.Method = "patch"
    doc.recompute()
    assert is_valid(probed)
    assert probed.PointCount != before


def test_an_edge_scanned_to_a_gate_ends_there(doc: Any, cloud: Any) -> None:
    start = Start((4, 4, 10), (0, -1, 0), (1, 0, 0))
    made = document.make_scanned_edge(
        doc,
        cloud,
        at=start,
        gate=Gate((15, 4, 10), (0, -1, 0)),
        parameters=ScanParameters(amplitude=8.0),
    )
    doc.recompute()
    assert made.Stops[1] == "GATE"
    assert made.Shape.BoundBox.XMax == pytest.approx(15.0, abs=1.0)


def test_a_far_cloud_is_scanned_as_well_as_a_near_one(doc: Any) -> None:
    far = np.array([500000.0, 4500000.0, 0.0])
    cloud = document.make_cloud(doc, box_cloud().points + far)
    origin = np.array(cloud.Origin)
    made = document.make_scanned_edge(doc, cloud, at=np.array([10, 0, 10]) + far - origin)
    doc.recompute()
    local = Part.makeLine(FreeCAD.Vector(0, 0, 10), FreeCAD.Vector(20, 0, 10))
    local.translate(FreeCAD.Vector(*(far - origin)))
    for vertex in made.Shape.Vertexes:
        assert local.distToShape(vertex)[0] < 3 * NOISE
    np.testing.assert_array_equal(made.Origin, origin)
