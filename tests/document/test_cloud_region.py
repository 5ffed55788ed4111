# SPDX-License-Identifier: LGPL-2.1-or-later
"""One face between the edges of a network, as a segment to which a surface is fitted."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402

PITCH, NOISE = 0.5, 0.03
SIZE = (24.0, 18.0, 12.0)
ON_TOP = (12.0, 9.0, 12.0)


@pytest.fixture(scope="module")
def network() -> Iterator[Any]:
    doc = FreeCAD.newDocument("Box")
    points = document.simulate_cloud(Part.makeBox(*SIZE), PITCH, NOISE).points
    made = document.make_edge_network(doc, document.make_cloud(doc, points))
    doc.recompute()
    yield made
    FreeCAD.closeDocument(doc.Name)


def points_of(segment: Any) -> np.ndarray:
    return np.array([tuple(point) for point in segment.Points.Points])


def test_the_points_of_one_face_are_taken_and_a_plane_is_fitted_to_them(network: Any) -> None:
    doc = network.Document
    segment = document.make_cloud_segment(doc, network.Cloud, network, inside=ON_TOP)
    doc.recompute()
    points = points_of(segment)
    every = points_of(network.Cloud)
    inner = np.all((every[:, :2] > 1.0) & (every[:, :2] < np.array(SIZE[:2]) - 1.0), axis=1)
    true = inner & (np.abs(every[:, 2] - SIZE[2]) < 6 * NOISE)
    # Every point of the face that is clear of its edges, and few of others.
    assert len(points) >= true.sum()
    assert np.mean(np.abs(points[:, 2] - SIZE[2]) < 6 * NOISE) > 0.95
    fitted = document.make_fitted_surface(doc, segment)
    doc.recompute()
    assert fitted.Shape.Faces
    middle = Part.Vertex(*ON_TOP)
    assert fitted.Shape.distToShape(middle)[0] < NOISE


def test_a_region_follows_its_network(network: Any) -> None:
    doc = network.Document
    segment = document.make_cloud_segment(doc, network.Cloud, network, inside=ON_TOP)
    doc.recompute()
    count = segment.PointCount
    network.Dropped = [FreeCAD.Vector(12.0, 0.0, 12.0)]
    doc.recompute()
    # A sharp edge parts two faces also where nobody wants the edge.
    assert segment.PointCount == pytest.approx(count, rel=0.1)
    network.Dropped = []
    doc.recompute()
    assert segment.PointCount == count


def test_what_cannot_work_is_refused_before_anything_is_made(network: Any) -> None:
    doc, cloud = network.Document, network.Cloud
    other = document.make_cloud(doc, points_of(cloud)[:1000])
    face = doc.addObject("Part::Feature", "Face")
    face.Shape = Part.makePlane(10, 10)
    count = len(doc.Objects)
    for given, word in (
        ({"cloud": other, "base": network, "inside": ON_TOP}, "not those of"),
        ({"cloud": cloud, "base": network}, "give both"),
        ({"cloud": cloud, "base": face, "inside": ON_TOP}, "give both"),
        ({"cloud": cloud, "base": network, "inside": (1.0, np.nan, 0.0)}, "three finite"),
    ):
        with pytest.raises(ValueError, match=word):
            document.make_cloud_segment(doc, **given)
    assert len(doc.Objects) == count


def test_a_place_away_from_the_cloud_and_centres_of_a_probe_are_said(network: Any) -> None:
    doc = network.Document
    away = document.make_cloud_segment(doc, network.Cloud, network, inside=(12.0, 9.0, 6.0))
    doc.recompute()
    assert "no face" in away.Message and away.PointCount == 0
    doc.removeObject(away.Name)
    segment = document.make_cloud_segment(doc, network.Cloud, network, inside=ON_TOP)
    network.Cloud.ProbeRadius = 1.0
    doc.recompute()
    assert "centres of a probe" in segment.Message
    network.Cloud.ProbeRadius = 0.0
    doc.recompute()
    assert segment.PointCount > 0
