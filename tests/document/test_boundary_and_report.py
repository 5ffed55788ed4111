# SPDX-License-Identifier: LGPL-2.1-or-later
"""All edges round one face as one object; tables and a page about what was scanned."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402

SIZE = (30.0, 20.0, 15.0)


@pytest.fixture(scope="module")
def block() -> Iterator[Any]:
    """A scanned block: its cloud, and the boundary of its upper face."""
    doc = FreeCAD.newDocument("Block")
    numbers = document.simulate_cloud(Part.makeBox(*SIZE), pitch=0.4, noise=0.01)
    cloud = document.make_cloud(doc, numbers)
    document.make_scanned_boundary(
        doc, cloud, at=(15.0, 0.0, 15.0), inside=(15.0, 6.0, 15.0), name="Upper"
    )
    document.make_scanned_edge(doc, cloud, at=(0.0, 0.0, 7.0), name="Upright")
    doc.recompute()
    yield doc
    FreeCAD.closeDocument(doc.Name)


def test_the_boundary_of_a_face_has_its_four_edges_where_they_are(block: Any) -> None:
    upper = block.Upper
    assert upper.EdgeCount == 4
    assert "close" in upper.Message
    assert upper.Length.Value == pytest.approx(2 * (SIZE[0] + SIZE[1]), abs=0.1)
    points = np.array([tuple(point) for point in upper.Points])
    off = np.minimum(
        np.minimum(np.abs(points[:, 0]), np.abs(points[:, 0] - SIZE[0])),
        np.minimum(np.abs(points[:, 1]), np.abs(points[:, 1] - SIZE[1])),
    )
    assert np.abs(points[:, 2] - SIZE[2]).max() < 0.05
    assert off.max() < 0.05
    assert sorted(set(upper.EdgeNumbers)) == [1, 2, 3, 4]


def test_a_boundary_is_not_scanned_again_without_a_change(block: Any) -> None:
    before = block.Upper.Shape.hashCode()
    block.Upper.touch()
    block.recompute()
    assert block.Upper.Shape.hashCode() == before


def test_places_far_from_the_cloud_are_refused_in_a_sentence(doc: Any) -> None:
    cloud = document.make_cloud(doc, np.random.default_rng(0).random((40, 3)))
    with pytest.raises(ValueError, match="inside"):
        document.make_scanned_boundary(doc, cloud, at=(0, 0, 0), inside=(0, 0, np.nan))
    boundary = document.make_scanned_boundary(doc, cloud, at=(0, 0, 0), inside=(90, 0, 0))
    doc.recompute()
    assert "Invalid" in boundary.State
    assert boundary.Message.endswith(".")


def test_a_table_holds_the_points_of_edges_and_boundaries_with_their_sigma(
    block: Any, tmp_path: Path
) -> None:
    document.export_csv([block.Upper, block.Upright], tmp_path / "edges.csv")
    with (tmp_path / "edges.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == len(block.Upper.Points) + len(block.Upright.Points)
    assert {row["edge"] for row in rows} == {*(f"Upper {n}" for n in (1, 2, 3, 4)), "Upright"}
    upright = [row for row in rows if row["edge"] == "Upright"]
    for row, point, sigma in zip(upright, block.Upright.Points, block.Upright.Sigma, strict=True):
        assert float(row["z_mm"]) == pytest.approx(point.z, abs=1e-6)
        assert float(row["sigma_mm"]) == pytest.approx(sigma, abs=1e-6)
    assert all(80 < float(row["angle_deg"]) < 100 for row in rows)


def test_a_table_of_nothing_is_refused(doc: Any, tmp_path: Path) -> None:
    box = doc.addObject("Part::Box", "Box")
    doc.recompute()
    with pytest.raises(ValueError, match="no edge points"):
        document.export_csv([box], tmp_path / "edges.csv")
    cloud = document.make_cloud(doc, np.random.default_rng(0).random((40, 3)))
    with pytest.raises(ValueError, match=r"es\.write_cloud"):
        document.export_csv([cloud], tmp_path / "edges.csv")
    assert not (tmp_path / "edges.csv").exists()


def test_the_report_has_every_object_with_its_figures_and_pictures_in_one_file(
    block: Any, tmp_path: Path
) -> None:
    pytest.importorskip("matplotlib")
    face = block.addObject("Part::Feature", "Face")
    face.Shape = Part.makePlane(SIZE[0], SIZE[1], FreeCAD.Vector(0, 0, SIZE[2]))
    face.Label = "Upper <face>"
    shown = document.make_deviation_map(block, block.Objects[0], face, reach=0.1)
    block.recompute()
    document.write_report(block, tmp_path / "report.html")
    text = (tmp_path / "report.html").read_text(encoding="utf-8")
    for label in (block.Upper.Label, block.Upright.Label, shown.Label, "Upper &lt;face&gt;"):
        assert label in text
    assert f"{shown.Average.Value:.4f}" in text
    assert text.count("<img") == text.count("data:image/png;base64,") == 1 + 2 + 1
    assert not re.findall(r"(?:src|href)=\"(?!data:)", text)


def test_a_report_on_nothing_says_so(doc: Any, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="Import a cloud"):
        document.write_report(doc, tmp_path / "report.html")
