# SPDX-License-Identifier: LGPL-2.1-or-later
"""All edges of a part as one object of native edges that share their vertices."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

import freecad_edgescan as es  # noqa: E402
from freecad_edgescan import document  # noqa: E402
from freecad_edgescan.document.known_parts import sharp_part  # noqa: E402
from freecad_edgescan.document.native_curve import curve_of  # noqa: E402
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
    assert shape.isValid() and all(edge.isValid() for edge in shape.Edges)
    assert all(curve_of(edge).length() == pytest.approx(edge.Length) for edge in shape.Edges)
    box = Part.makeBox(*SIZE)
    for vertex in shape.Vertexes:
        nearest = min(vertex.Point.distanceToPoint(other.Point) for other in box.Vertexes)
        assert nearest < 0.5 * PITCH


def test_the_wires_of_a_box_are_its_edges_for_three_of_them_meet_in_each_corner(
    network: es.EdgeNetwork,
) -> None:
    wires = document.network_wires(network)
    assert len(wires) == 12 and all(len(wire.Edges) == 1 for wire in wires)


def test_what_is_no_network_of_numbers_is_told_what_to_take(
    doc: Any, box_cloud: es.PointCloud
) -> None:
    made = document.make_edge_network(doc, document.make_cloud(doc, box_cloud))
    for function in (document.network_wires, document.network_shape):
        with pytest.raises(ValueError, match=r"'EdgeNetwork' is no EdgeNetwork.*make_edge_wire"):
            function(made)


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


@pytest.mark.parametrize(
    "wrong",
    [
        *({"min_angle": 4.0}, {"min_length": -1.0}, {"max_sigma": np.nan}),
        *({"dropped": [(1.0, 2.0)]}, {"kept": [(np.inf, 0.0, 0.0)]}, {"most_edges": -1}),
    ],
)
def test_numbers_that_cannot_work_are_refused_before_anything_is_made(
    doc: Any, box_cloud: es.PointCloud, wrong: dict[str, float]
) -> None:
    cloud = document.make_cloud(doc, box_cloud)
    with pytest.raises(ValueError, match="give"):
        document.make_edge_network(doc, cloud, **wrong)
    assert len(doc.Objects) == 1


TOP_FRONT = (12.0, 0.0, 12.0)  # the middle of an edge along x


@pytest.fixture(scope="module")
def searched_cloud(box_cloud: es.PointCloud) -> Iterator[Any]:
    """A cloud object in which all edges have been found."""
    doc = FreeCAD.newDocument("Searched")
    doc.UndoMode = 1
    cloud = document.make_cloud(doc, box_cloud)
    document.make_edge_network(doc, cloud, name="Found")
    doc.recompute()
    yield cloud
    FreeCAD.closeDocument(doc.Name)


class Counting:
    """Counts searches; it lets all of them go on."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        from freecad_edgescan.document import network_search

        self.count, self._find = 0, network_search.find_edges
        monkeypatch.setattr(network_search, "find_edges", self.find)

    def find(self, *given: Any) -> es.EdgeNetwork:
        self.count += 1
        return self._find(*given)


@pytest.fixture
def searches(monkeypatch: pytest.MonkeyPatch) -> Counting:
    return Counting(monkeypatch)


def true_distance(shape: Any) -> float:
    """Of the middle of each edge from the nearest edge of the box, mm, the largest."""
    truth = Part.Compound(Part.makeBox(*SIZE).Edges)
    middles = [Part.Vertex(edge.valueAt(0.5 * sum(edge.ParameterRange))) for edge in shape.Edges]
    return max(middle.distToShape(truth)[0] for middle in middles)


def test_choosing_other_edges_needs_no_other_search(
    searched_cloud: Any, searches: Counting
) -> None:
    doc = searched_cloud.Document
    made = document.make_edge_network(doc, searched_cloud)
    doc.recompute()
    assert made.EdgeCount == 12
    made.MinLength = 14.0
    doc.recompute()
    assert made.EdgeCount == 8 and made.CornerCount == 8
    made.MinAngle = 95.0
    doc.recompute()
    assert "None of the 12 edges" in made.Message and "Invalid" in made.State
    assert made.EdgeCount == 8  # what was made before stays
    made.MinAngle, made.MinLength = 15.0, 0.0
    made.MaxSigma = float(np.median(made.Sigmas))
    doc.recompute()
    assert 0 < made.EdgeCount < 12
    assert searches.count == 0
    made.MinAngle = 10.0  # blunter ones than were sought
    doc.recompute()
    assert searches.count == 1


def test_an_edge_dropped_by_hand_stays_away_when_the_cloud_is_scanned_anew(doc: Any) -> None:
    box = Part.makeBox(*SIZE)
    clouds = [
        document.make_cloud(doc, document.simulate_cloud(box, PITCH, NOISE, seed=seed).points)
        for seed in (1, 2)
    ]
    made = document.make_edge_network(doc, clouds[0], dropped=[TOP_FRONT])
    for cloud in clouds:
        made.Cloud = cloud
        doc.recompute()
        assert made.EdgeCount == 11 and len(made.Shape.Edges) == 11
        away = made.Shape.distToShape(Part.Vertex(*TOP_FRONT))[0]
        assert away > 10.0
        assert true_distance(made.Shape) < 0.5 * PITCH


def test_an_edge_is_kept_by_hand_whatever_its_length(searched_cloud: Any) -> None:
    doc = searched_cloud.Document
    made = document.make_edge_network(doc, searched_cloud, min_length=100.0, kept=[TOP_FRONT])
    doc.recompute()
    assert made.EdgeCount == 1
    assert made.Shape.distToShape(Part.Vertex(*TOP_FRONT))[0] < PITCH


def test_a_search_that_ends_early_finds_the_same_edges_again(
    doc: Any, box_cloud: es.PointCloud
) -> None:
    from freecad_edgescan.document.network_search import NetworkSearch

    class StopsLater:
        def update(self, fraction: float, so_far: Any) -> bool:
            return len(so_far) < 5

    cloud = document.make_cloud(doc, box_cloud)
    numbers = es.PointCloud(document.point_cloud(cloud).points)
    stopped = NetworkSearch()(numbers, StopsLater())
    assert stopped.cancelled and 5 <= len(stopped) < 12
    search, kept = NetworkSearch().stopped_at(stopped)
    made = document.make_edge_network(doc, cloud, most_edges=search.most)
    doc.recompute()
    assert made.EdgeCount == len(kept) == search.most
    assert "ended after" in made.Message
    stopped_shape = document.network_shape(kept)
    assert [tuple(vertex.Point) for vertex in made.Shape.Vertexes] == [
        tuple(vertex.Point) for vertex in stopped_shape.Vertexes
    ]
    assert [edge.Length for edge in made.Shape.Edges] == [
        edge.Length for edge in stopped_shape.Edges
    ]


def test_a_network_is_changed_as_a_whole_and_what_is_not_given_is_as_usual(
    searched_cloud: Any,
) -> None:
    doc = searched_cloud.Document
    made = document.make_edge_network(doc, searched_cloud, min_length=14.0, dropped=[TOP_FRONT])
    doc.recompute()
    assert made.EdgeCount == 7
    document.change_edge_network(made, min_length=20.0)
    doc.recompute()
    assert made.EdgeCount == 4 and made.Dropped == []
    document.change_edge_network(made)
    doc.recompute()
    assert made.EdgeCount == 12
    with pytest.raises(ValueError, match="no network"):
        document.change_edge_network(made.Cloud)
    with pytest.raises(ValueError, match="give"):
        document.change_edge_network(made, min_length=-1.0)
    assert made.MinLength.Value == 0.0


def test_a_saved_network_is_as_it_was_and_follows_its_choice_again(
    doc: Any, box_cloud: es.PointCloud, tmp_path: Path, searches: Counting
) -> None:
    made = document.make_edge_network(
        doc, document.make_cloud(doc, box_cloud), min_length=14.0, dropped=[TOP_FRONT]
    )
    doc.recompute()
    path, name = str(tmp_path / "network.FCStd"), made.Name
    doc.saveAs(path)
    FreeCAD.closeDocument(doc.Name)
    again = FreeCAD.openDocument(path).getObject(name)
    count = searches.count
    again.touch()
    again.Document.recompute()
    assert again.EdgeCount == 7 and searches.count == count
    again.Dropped = []
    again.Document.recompute()
    assert again.EdgeCount == 8 and searches.count == count + 1


def test_a_network_can_be_undone_and_done_again(searched_cloud: Any) -> None:
    doc = searched_cloud.Document
    doc.openTransaction("Network")
    name = document.make_edge_network(doc, searched_cloud).Name
    doc.recompute()
    doc.commitTransaction()
    doc.undo()
    assert doc.getObject(name) is None
    doc.redo()
    assert doc.getObject(name).EdgeCount == 12


def test_scanned_edges_in_a_group_are_true_each_by_itself(searched_cloud: Any) -> None:
    doc, cloud = searched_cloud.Document, searched_cloud
    group = document.make_scanned_edges(doc, cloud, [TOP_FRONT, (24.0, 9.0, 0.0)])
    doc.recompute()
    assert [edge.Shape.Length for edge in group.Group] == pytest.approx([24.0, 18.0], abs=0.5)
    assert all(true_distance(edge.Shape) < 0.5 * PITCH for edge in group.Group)
    before = len(doc.Objects)
    for wrong in ([], [TOP_FRONT, (1.0, 2.0)]):
        with pytest.raises(ValueError):
            document.make_scanned_edges(doc, cloud, wrong)
    assert len(doc.Objects) == before


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


def test_a_network_is_exported_and_reported(searched_cloud: Any, tmp_path: Path) -> None:
    doc = searched_cloud.Document
    made = document.make_edge_network(doc, searched_cloud, min_length=20.0, name="LongEdges")
    doc.recompute()
    document.export_csv([made], tmp_path / "edges.csv")
    header, *rows = (tmp_path / "edges.csv").read_text().splitlines()
    angles = [float(row.split(",")[header.split(",").index("angle_deg")]) for row in rows]
    assert np.allclose(angles, 90.0, atol=6.0)  # noise of a tenth of the pitch
    along = np.abs([[float(value) for value in row.split(",")[5:8]] for row in rows])
    assert np.allclose(along, (1.0, 0.0, 0.0), atol=0.1)
    points = np.array([[float(value) for value in row.split(",")[1:4]] for row in rows])
    away = np.sort(np.minimum(np.abs(points), np.abs(points - SIZE)), axis=1)
    assert np.hypot(away[:, 0], away[:, 1]).max() < PITCH
    assert {row.split(",")[0] for row in rows} == {f"LongEdges {k}" for k in (1, 2, 3, 4)}
    document.export_step([made], tmp_path / "edges.step")
    again = Part.Shape()
    again.read(str(tmp_path / "edges.step"))
    assert [edge.Length for edge in again.Edges] == pytest.approx([24.0] * 4, abs=PITCH)
    document.write_report(doc, tmp_path / "report.html")
    page = (tmp_path / "report.html").read_text()
    assert "LongEdges" in page and "4 of 12 edges are kept" in page
