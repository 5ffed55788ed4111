# SPDX-License-Identifier: LGPL-2.1-or-later
"""What cannot be scanned is said, in the edge or by the function, and nothing is lost."""

from __future__ import annotations

from typing import Any

import FreeCAD
import numpy as np
import pytest

from freecad_edgescan import document
from freecad_edgescan.document import bridge

from .box import box_cloud, is_valid


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


def test_only_scanned_edges_can_be_changed(doc: Any, cloud: Any) -> None:
    with pytest.raises(ValueError, match="not a scanned edge"):
        document.change_scanned_edge(cloud, (0, 0, 0))
