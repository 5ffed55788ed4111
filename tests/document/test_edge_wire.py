# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wires of edges of a network, swept along and lofted through."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402

PITCH = 0.5
SIZE = (24.0, 18.0, 12.0)
BOTTOM_FRONT, RIGHT, BACK = (12.0, 0.0, 0.0), (24.0, 9.0, 0.0), (12.0, 18.0, 0.0)


@pytest.fixture(scope="module")
def cloud() -> Iterator[Any]:
    """A box's cloud in a document, which all tests share: its edges are found once."""
    doc = FreeCAD.newDocument("Box")
    yield document.make_cloud(doc, document.simulate_cloud(Part.makeBox(*SIZE), PITCH, 0.05).points)
    FreeCAD.closeDocument(doc.Name)


@pytest.fixture
def doc(cloud: Any) -> Any:
    return cloud.Document


@pytest.fixture
def network(doc: Any, cloud: Any) -> Any:
    made = document.make_edge_network(doc, cloud)
    doc.recompute()
    return made


def names(network: Any, *places: tuple[float, float, float]) -> list[str]:
    """Names of the edges at some places."""
    found = []
    for place in places:
        away = [edge.distToShape(Part.Vertex(*place))[0] for edge in network.Shape.Edges]
        assert min(away) < PITCH
        found.append(f"Edge{away.index(min(away)) + 1}")
    return found


def test_edges_that_follow_each_other_are_one_wire(doc: Any, network: Any) -> None:
    wire = document.make_edge_wire(doc, network, names(network, RIGHT, BACK, BOTTOM_FRONT))
    doc.recompute()
    assert wire.Shape.ShapeType == "Wire" and len(wire.Shape.OrderedEdges) == 3
    assert wire.Length.Value == pytest.approx(24 + 18 + 24, abs=0.5)
    assert not wire.Closed
    ends = sorted(vertex.Point.y for vertex in (wire.Shape.OrderedVertexes[k] for k in (0, -1)))
    assert ends == pytest.approx([0.0, 18.0], abs=0.5 * PITCH)


def test_a_wire_stays_on_its_edges_when_others_are_dropped_and_says_when_its_own_is(
    doc: Any, network: Any
) -> None:
    wire = document.make_edge_wire(doc, network, names(network, BOTTOM_FRONT, RIGHT))
    doc.recompute()
    network.Dropped = [FreeCAD.Vector(0.0, 9.0, 12.0), FreeCAD.Vector(0.0, 0.0, 6.0)]
    doc.recompute()
    assert network.EdgeCount == 10
    assert wire.Length.Value == pytest.approx(24 + 18, abs=0.5)
    network.Dropped = [FreeCAD.Vector(*RIGHT)]
    doc.recompute()
    assert "Invalid" in wire.State and "no edge any more" in wire.Message


def test_a_profile_is_swept_along_a_wire_of_two_edges(doc: Any, network: Any) -> None:
    wire = document.make_edge_wire(doc, network, names(network, BOTTOM_FRONT, RIGHT))
    profile = doc.addObject("Part::Feature", "Profile")
    doc.recompute()
    first = wire.Shape.OrderedEdges[0]
    along = first.tangentAt(first.FirstParameter)
    profile.Shape = Part.Wire(Part.makeCircle(1.0, wire.Shape.OrderedVertexes[0].Point, along))
    sweep = document.make_sweep(doc, profile, wire)
    doc.recompute()
    assert sweep.isValid() and not sweep.Shape.isNull()
    # A tube along both edges, mitred in the corner (Pappus).
    assert sweep.Shape.Area == pytest.approx(2 * np.pi * wire.Length.Value, rel=1e-3)


def test_a_skin_is_laid_through_two_wires(doc: Any, network: Any) -> None:
    wires = [
        document.make_edge_wire(doc, network, names(network, place))
        for place in (BOTTOM_FRONT, (12.0, 0.0, 12.0))
    ]
    doc.recompute()
    skin = document.make_loft(doc, wires)
    doc.recompute()
    assert skin.Shape.Area == pytest.approx(24.0 * 12.0, rel=0.02)


def test_edges_that_do_not_follow_each_other_are_refused(doc: Any, network: Any) -> None:
    count = len(doc.Objects)
    with pytest.raises(ValueError, match="2 separate chains"):
        document.make_edge_wire(doc, network, names(network, BOTTOM_FRONT, BACK))
    with pytest.raises(ValueError, match="Edge1 to Edge12"):
        document.make_edge_wire(doc, network, ["Edge13"])
    with pytest.raises(ValueError, match="separate chains"):
        document.make_edge_wire(doc, network)
    with pytest.raises(ValueError, match="no edges"):
        document.make_edge_wire(doc, network.Cloud, ["Edge1"])
    assert len(doc.Objects) == count


def test_a_boss_is_dropped_at_its_foot_and_swept_round_at_its_rim() -> None:
    doc = FreeCAD.newDocument("Boss")
    radius, rim = 5.0, 18.0
    part = Part.makeBox(*SIZE).fuse(
        Part.makeCylinder(radius, rim - SIZE[2], FreeCAD.Vector(12, 9, SIZE[2]))
    )
    cloud = document.make_cloud(doc, document.simulate_cloud(part, 0.4, 0.02).points)
    at_the_foot = (12.0 + radius, 9.0, SIZE[2])
    network = document.make_edge_network(doc, cloud, dropped=[at_the_foot])
    doc.recompute()
    foot, on_the_rim = Part.Vertex(*at_the_foot), (12.0, 9.0 + radius, rim)
    assert network.EdgeCount == 13
    assert network.Shape.distToShape(foot)[0] > radius - 0.4
    wire = document.make_edge_wire(doc, network, names(network, on_the_rim))
    doc.recompute()
    assert wire.Closed and wire.Length.Value == pytest.approx(2 * 3.1416 * radius, rel=0.01)
    profile = doc.addObject("Part::Feature", "Profile")
    first = wire.Shape.OrderedEdges[0]
    begin, along = first.valueAt(first.FirstParameter), first.tangentAt(first.FirstParameter)
    profile.Shape = Part.Wire(Part.makeCircle(0.5, begin, along))
    ring = document.make_sweep(doc, profile, wire)
    ring.Solid = True
    doc.recompute()
    # A torus (Pappus).
    assert ring.Shape.Volume == pytest.approx(2 * 3.1416**2 * radius * 0.5**2, rel=0.02)
    FreeCAD.closeDocument(doc.Name)
