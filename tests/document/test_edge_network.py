# SPDX-License-Identifier: LGPL-2.1-or-later
"""All edges of a part as one object of native edges that share their vertices."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

import freecad_edgescan as es  # noqa: E402
from freecad_edgescan import document  # noqa: E402
from freecad_edgescan.document.known_parts import sharp_part  # noqa: E402
from freecad_edgescan.document.network_bench import bench_part, parts_to_bench  # noqa: E402

PITCH, NOISE = 0.5, 0.05
SIZE = (24.0, 18.0, 12.0)


@pytest.fixture(scope="module")
def box_cloud() -> es.PointCloud:
    return es.PointCloud(document.simulate_cloud(Part.makeBox(*SIZE), PITCH, NOISE).points)


@pytest.fixture(scope="module")
def network(box_cloud: es.PointCloud) -> es.EdgeNetwork:
    return es.find_edges(box_cloud)


def test_a_box_is_twelve_native_lines_that_share_eight_vertices(network: es.EdgeNetwork) -> None:
    shape = document.network_shape(network)
    assert len(shape.Edges) == 12 and len(shape.Vertexes) == 8
    assert all(isinstance(edge.Curve, Part.Line) for edge in shape.Edges)
    box = Part.makeBox(*SIZE)
    for vertex in shape.Vertexes:
        nearest = min(vertex.Point.distanceToPoint(other.Point) for other in box.Vertexes)
        assert nearest < 0.5 * PITCH


def test_the_wires_of_a_box_are_its_edges_for_three_of_them_meet_in_each_corner(
    network: es.EdgeNetwork,
) -> None:
    wires = document.network_wires(network)
    assert len(wires) == 12 and all(len(wire.Edges) == 1 for wire in wires)


def test_the_object_finds_the_edges_and_computes_nothing_twice(
    doc: Any, box_cloud: es.PointCloud
) -> None:
    cloud = document.make_cloud(doc, box_cloud)
    made = document.make_edge_network(doc, cloud)
    doc.recompute()
    assert made.EdgeCount == 12 and made.CornerCount == 8
    assert made.Shape.Length == pytest.approx(4 * sum(SIZE), rel=0.01)
    assert "corner" not in made.Message and "12 edges" in made.Message
    before = made.InputHash
    made.touch()
    doc.recompute()
    assert made.InputHash == before and len(made.Shape.Edges) == 12


def test_a_cloud_without_edges_is_said_and_nothing_is_made_up(doc: Any) -> None:
    rng = np.random.default_rng(0)
    normals = rng.normal(size=(8000, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    made = document.make_edge_network(doc, document.make_cloud(doc, es.PointCloud(10.0 * normals)))
    doc.recompute()
    assert "No edge was found" in made.Message and made.Shape.isNull()


@pytest.mark.parametrize("wrong", [{"min_angle": 4.0}, {"min_length": -1.0}, {"max_sigma": np.nan}])
def test_numbers_that_cannot_work_are_refused_before_anything_is_made(
    doc: Any, box_cloud: es.PointCloud, wrong: dict[str, float]
) -> None:
    cloud = document.make_cloud(doc, box_cloud)
    with pytest.raises(ValueError, match="give"):
        document.make_edge_network(doc, cloud, **wrong)
    assert len(doc.Objects) == 1


def test_the_bench_measures_a_box_as_it_is() -> None:
    bench = bench_part(sharp_part("box", Part.makeBox(*SIZE)), PITCH)
    (report,) = bench.reports
    assert bench.regions is not None and bench.regions.found == bench.regions.faces == 6
    assert report.recall > 0.98 and report.precision > 0.99
    assert report.corners == (8, 8)
    assert report.rms < 0.5 * 0.2 * PITCH
    assert report.length[0] == pytest.approx(4 * sum(SIZE), rel=1e-6)


def test_without_files_the_bench_takes_a_part_of_its_own() -> None:
    part, pitch = next(parts_to_bench([], []))
    assert part.name == "block with bore" and 0.0 < pitch < 1.0
