# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scanned edge follows its inputs and its cloud, and is scanned only when one has changed."""

from __future__ import annotations

from typing import Any

import FreeCAD
import numpy as np
import Part
import pytest

from freecad_edgescan import document
from freecad_edgescan.document import bridge, cloud_cache, scanned_edge
from freecad_edgescan.document.scan_inputs import read_inputs
from freecad_edgescan.scanning import Gate, ScanParameters, Start, scan_edge

from .box import NOISE, box_cloud


def test_making_an_edge_computes_nothing(doc: Any, cloud: Any, scans: list[str]) -> None:
    document.make_scanned_edge(doc, cloud, at=(10, 0, 10))
    assert not scans


def test_a_recompute_without_a_change_does_not_scan(doc: Any, edge: Any, scans: list[str]) -> None:
    edge.touch()
    doc.recompute()
    assert not scans


def test_a_changed_input_scans_again(doc: Any, edge: Any, scans: list[str]) -> None:
    before = edge.PointCount
    edge.EdgePitch = 2.0 * edge.EdgePitchUsed.Value
    doc.recompute()
    assert scans == [edge.Name]
    assert edge.PointCount < 0.7 * before


def test_a_moved_cloud_moves_the_edge(doc: Any, cloud: Any, edge: Any) -> None:
    cloud.Placement.Base = FreeCAD.Vector(0, 0, 1)
    doc.recompute()
    assert edge.Shape.CenterOfMass.z == pytest.approx(11.0, abs=3 * NOISE)


def test_other_points_in_the_cloud_scan_again(
    doc: Any, cloud: Any, edge: Any, scans: list[str]
) -> None:
    shifted = box_cloud().points + np.array([0.0, 0.0, 0.5])
    cloud.Points = bridge.kernel_from_array(shifted)
    doc.recompute()
    assert scans == [edge.Name]
    assert edge.Shape.CenterOfMass.z == pytest.approx(10.5, abs=3 * NOISE)


def test_a_result_computed_elsewhere_is_not_computed_twice(
    doc: Any, cloud: Any, scans: list[str]
) -> None:
    found = scan_edge(document.point_cloud(cloud), at=(10, 0, 10))
    made = document.make_scanned_edge(doc, cloud, at=(10, 0, 10))
    scanned_edge.write_result(made, found)
    doc.recompute()
    assert not scans
    assert made.PointCount == len(found.points)


def test_the_probe_radius_is_the_clouds_and_read_only_until_the_edge_has_its_own(
    doc: Any, cloud: Any, edge: Any
) -> None:
    cloud.ProbeRadius = 0.1
    cloud.Approach = FreeCAD.Vector(0, 0, -1)
    doc.recompute()
    assert edge.ProbeRadius.Value == edge.ProbeRadiusUsed.Value == 0.1
    assert edge.getEditorMode("ProbeRadius") == ["ReadOnly"]
    edge.ProbeRadius = 0.2
    assert edge.OwnProbeRadius
    assert edge.getEditorMode("ProbeRadius") == []
    doc.recompute()
    assert edge.ProbeRadiusUsed.Value == 0.2
    edge.OwnProbeRadius = False
    doc.recompute()
    assert edge.ProbeRadius.Value == edge.ProbeRadiusUsed.Value == 0.1


def test_start_gate_and_parameters_come_back_from_the_properties(doc: Any, cloud: Any) -> None:
    start = Start((3, 4, 10), (0, -1, 0), (1, 0, 0))
    gate = Gate((15, 4, 10), (0, -1, 0))
    parameters = ScanParameters(
        amplitude=8.0, degree=2, pattern="zigzag", probe_radius=0.0, approach=(0, 0, -1)
    )
    made = document.make_scanned_edge(doc, cloud, at=start, gate=gate, parameters=parameters)
    inputs = read_inputs(made)
    assert isinstance(inputs.at, Start)
    assert isinstance(inputs.gate, Gate)
    np.testing.assert_array_equal(inputs.at.point, start.point)
    np.testing.assert_array_equal(inputs.gate.across, gate.across)
    given = inputs.parameters.given()
    np.testing.assert_array_equal(given.pop("approach"), (0, 0, -1))
    wanted = parameters.given()
    wanted.pop("approach")
    assert given == wanted


def test_changed_inputs_are_scanned_and_what_is_not_given_is_automatic_again(
    doc: Any, edge: Any, scans: list[str]
) -> None:
    document.change_scanned_edge(
        edge, at=(10, 0, 10), parameters=ScanParameters(edge_pitch=1.5, approach=(0, 0, -1))
    )
    doc.recompute()
    assert edge.EdgePitchUsed.Value == 1.5
    document.change_scanned_edge(edge, at=(20, 7, 10))
    doc.recompute()
    assert edge.EdgePitch.Value == 0.0
    assert tuple(edge.Approach) == (0, 0, 0)
    ends = Part.makeLine(FreeCAD.Vector(20, 0, 10), FreeCAD.Vector(20, 15, 10))
    assert all(ends.distToShape(vertex)[0] < 3 * NOISE for vertex in edge.Shape.Vertexes)
    assert scans == [edge.Name] * 2


def test_the_same_inputs_given_again_change_nothing(doc: Any, cloud: Any, scans: list[str]) -> None:
    start = Start.from_points((10, 3, 10), (10, 0, 10), (14, 3, 10))
    gate = Gate.from_points((16, 3, 10), (16, 0, 10))
    given = ScanParameters(amplitude=6.0, probe_radius=0.0)
    edge = document.make_scanned_edge(doc, cloud, start, gate, given)
    doc.recompute()
    document.change_scanned_edge(edge, start, gate, given)
    assert "Touched" not in edge.State
    document.change_scanned_edge(edge, (10, 0, 10))
    doc.recompute()
    assert scans == [edge.Name] * 2
    assert not edge.UseGate and not edge.OwnProbeRadius
    assert tuple(edge.Across) == tuple(edge.GateAcross) == (0, 0, 0)


def test_many_edges_share_one_tree(doc: Any, cloud: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    built = []
    PointCloud = cloud_cache.PointCloud

    def counted(*values: Any) -> Any:
        built.append(1)
        return PointCloud(*values)

    monkeypatch.setattr(cloud_cache, "PointCloud", counted)
    for at in ((10, 0, 10), (10, 15, 10), (0, 7, 10)):
        document.make_scanned_edge(doc, cloud, at=at)
    doc.recompute()
    assert len(built) == 1
