# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scanned edge lives in the document: it follows its inputs, its cloud, undo and files."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402
from freecad_edgescan.cloud import SimulatedCloud  # noqa: E402
from freecad_edgescan.document import bridge, scanned_edge  # noqa: E402
from freecad_edgescan.scanning import Gate, ScanParameters, Start  # noqa: E402

NOISE = 0.01


@cache
def box_cloud() -> SimulatedCloud:
    return document.simulate_cloud(Part.makeBox(20, 15, 10), 0.4, NOISE)


@cache
def cylinder_cloud() -> SimulatedCloud:
    return document.simulate_cloud(Part.makeCylinder(10, 12), 0.4, NOISE)


@pytest.fixture
def cloud(doc: Any) -> Any:
    return document.make_cloud(doc, box_cloud())


@pytest.fixture
def edge(doc: Any, cloud: Any) -> Any:
    made = document.make_scanned_edge(doc, cloud, at=(10, 0, 10))
    doc.recompute()
    return made


@pytest.fixture
def scans(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Names of the objects that were scanned."""
    names: list[str] = []
    scan_again = scanned_edge.scan_again

    def counted(obj: Any, *rest: Any) -> Any:
        names.append(obj.Name)
        return scan_again(obj, *rest)

    monkeypatch.setattr(scanned_edge, "scan_again", counted)
    return names


def is_valid(obj: Any) -> bool:
    return "Invalid" not in obj.State


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
    from freecad_edgescan.document.scanned_edge_properties import PROPERTIES

    for item in PROPERTIES:
        assert edge.getDocumentationOfProperty(item.name) == item.tooltip != ""
        assert edge.getGroupOfProperty(item.name) == item.group


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
    from freecad_edgescan.scanning import scan_edge

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


@pytest.mark.parametrize(
    ("name", "value", "said"),
    [
        ("Amplitude", -5.0, "The amplitude is -5.0; give a positive length"),
        ("EdgePitch", -1.0, "The edge pitch is -1.0; give a positive length"),
        ("ChordHeight", -0.1, "The chord height is -0.1; give a positive length"),
        ("ProbeRadius", -1.0, "The probe radius is -1.0; give 0 or a positive length"),
        ("MinAngle", -20.0, "The least angle is -0.349"),
    ],
)
def test_a_value_that_cannot_work_is_refused_and_not_taken_as_automatic(
    doc: Any, edge: Any, name: str, value: float, said: str
) -> None:
    setattr(edge, name, value)
    doc.recompute()
    assert not is_valid(edge)
    assert edge.Message.startswith(said)


def test_a_negative_probe_radius_of_the_cloud_is_refused(doc: Any, cloud: Any, edge: Any) -> None:
    cloud.ProbeRadius = -1.0
    doc.recompute()
    assert not is_valid(edge)
    assert "probe radius" in edge.Message


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


def test_start_gate_and_parameters_come_back_from_the_properties(doc: Any, cloud: Any) -> None:
    from freecad_edgescan.document.scan_inputs import read_inputs

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


def test_a_scan_that_fails_keeps_the_edge_and_says_why(doc: Any, edge: Any) -> None:
    length = edge.Shape.Length
    edge.At = FreeCAD.Vector(10, 7, 5)
    doc.recompute()
    assert not is_valid(edge)
    assert "(10, 7, 5)" in edge.Message
    assert "(10, 7, 5)" in edge.getStatusString()
    assert edge.Shape.Length == length
    edge.At = FreeCAD.Vector(10, 0, 10)
    doc.recompute()
    assert is_valid(edge)
    assert "edge points" in edge.Message


def test_a_deleted_cloud_is_said_and_the_edge_is_kept(doc: Any, cloud: Any, edge: Any) -> None:
    doc.removeObject(cloud.Name)
    doc.recompute()
    assert not is_valid(edge)
    assert "was deleted" in edge.Message
    assert edge.Shape.Length > 10


def test_an_emptied_cloud_is_said_and_the_edge_is_kept(doc: Any, cloud: Any, edge: Any) -> None:
    cloud.Points = bridge.kernel_from_array(np.zeros((0, 3)))
    doc.recompute()
    assert not is_valid(edge)
    assert "is empty" in edge.Message
    assert edge.Shape.Length > 10


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


def test_many_edges_share_one_tree(doc: Any, cloud: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    from freecad_edgescan.document import cloud_cache

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


def test_a_place_in_the_coordinates_of_the_file_is_told_to_subtract_the_origin(doc: Any) -> None:
    far = np.array([350000.0, 5600000.0, 150.0])
    cloud = document.make_cloud(doc, box_cloud().points + far)
    in_file = far + np.array([10, 0, 10])
    place = in_file - np.array(cloud.Origin)
    said = f"subtract the cloud's Origin.*which gives \\({', '.join(f'{x:g}' for x in place)}\\)"
    inside = far + np.array([10, 5, 10])
    for make in (
        lambda: document.make_scanned_edge(doc, cloud, at=in_file),
        lambda: document.make_scanned_edge(doc, cloud, at=place, gate=in_file),
        lambda: document.make_scanned_edges(doc, cloud, [place, in_file]),
        lambda: document.make_scanned_boundary(doc, cloud, at=in_file, inside=inside),
    ):
        with pytest.raises(ValueError, match=said):
            make()
    assert doc.Objects == [cloud]
    edge = document.make_scanned_edge(doc, cloud, at=place)
    with pytest.raises(ValueError, match=said):
        document.change_scanned_edge(edge, at=in_file)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"at": (1, 2)}, r"click is \(1, 2\)"),
        ({"at": (1, 2, float("nan"))}, "click is"),
        ({"at": (10, 0, 10), "gate": "there"}, "gate is 'there'"),
        ({"at": (10, 0, 10), "method": "guess"}, "method is 'guess'"),
    ],
)
def test_inputs_that_cannot_work_make_no_object(
    doc: Any, cloud: Any, given: dict[str, Any], said: str
) -> None:
    with pytest.raises(ValueError, match=said):
        document.make_scanned_edge(doc, cloud, **given)
    assert doc.Objects == [cloud]


def test_a_box_is_no_cloud_to_scan(doc: Any) -> None:
    box = doc.addObject("Part::Box", "Box")
    with pytest.raises(ValueError, match="'Box' is not a point cloud"):
        document.make_scanned_edge(doc, box, at=(0, 0, 0))


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


def test_only_scanned_edges_can_be_changed(doc: Any, cloud: Any) -> None:
    with pytest.raises(ValueError, match="not a scanned edge"):
        document.change_scanned_edge(cloud, (0, 0, 0))
