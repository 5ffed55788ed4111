# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files become cloud objects, those of FreeCAD's own readers too."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan import PointCloud, document, write_cloud  # noqa: E402


def test_a_text_file_becomes_a_plain_points_object(doc: Any, tmp_path: Path) -> None:
    points = np.random.default_rng(0).random((50, 3))
    path = tmp_path / "bracket.xyz"
    np.savetxt(path, points)
    cloud = document.make_cloud(doc, path, probe_radius=2.0, approach=(0, 0, -1))
    assert (cloud.TypeId, cloud.Label) == ("Points::Feature", "bracket")
    assert cloud.SourceFile == str(path)
    assert cloud.ProbeRadius.Value == 2.0
    np.testing.assert_allclose(document.points_of(cloud), points, atol=1e-7)


@pytest.mark.parametrize("ending", ["stl", "obj"])
def test_a_mesh_file_gives_its_vertices(doc: Any, tmp_path: Path, ending: str) -> None:
    import MeshPart

    path = tmp_path / f"box.{ending}"
    MeshPart.meshFromShape(Part.makeBox(10, 20, 30), 0.1, 0.1).write(str(path))
    cloud = document.make_cloud(doc, path)
    corners = np.unique(np.round(document.points_of(cloud), 4), axis=0)
    expected = np.stack(np.meshgrid([0, 10], [0, 20], [0, 30], indexing="ij"), -1).reshape(-1, 3)
    np.testing.assert_allclose(corners, expected, atol=1e-4)


@pytest.mark.parametrize("name", ["missing.xyz", "missing.e57", "missing.stl"])
def test_a_missing_file_is_named_and_leaves_no_object(doc: Any, tmp_path: Path, name: str) -> None:
    with pytest.raises(ValueError, match=name):
        document.make_cloud(doc, tmp_path / name)
    assert not doc.Objects


@pytest.mark.parametrize("ending", ["e57", "stl", "obj"])
def test_a_damaged_file_is_named_and_leaves_nothing(doc: Any, tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"damaged.{ending}"
    path.write_bytes(b"this is no scan\n" * 20)
    with pytest.raises(ValueError, match=f"damaged.{ending}"):
        document.make_cloud(doc, path)
    assert not doc.Objects
    assert list(FreeCAD.listDocuments()) == [doc.Name]


def test_a_negative_probe_radius_leaves_no_object(doc: Any) -> None:
    with pytest.raises(ValueError, match="-1"):
        document.make_cloud(doc, np.zeros((30, 3)), probe_radius=-1.0)
    assert not doc.Objects


def test_rows_left_out_are_counted_in_the_cloud_without_a_python_warning(
    doc: Any, tmp_path: Path
) -> None:
    rows = np.random.default_rng(1).random((50, 3))
    rows[[3, 7]] = np.nan
    np.savetxt(tmp_path / "part.xyz", rows)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        cloud = document.make_cloud(doc, tmp_path / "part.xyz")
    assert cloud.DroppedRows == 2
    assert cloud.Points.CountPoints == 48
    assert cloud.getEditorMode("DroppedRows") == ["ReadOnly"] or "ReadOnly" in (
        cloud.getPropertyStatus("DroppedRows")
    )


@pytest.mark.parametrize("unit", ["mm", "inch"])
@pytest.mark.parametrize("form", ["file", "array", "mesh"])
def test_only_a_region_comes_into_the_document(
    doc: Any, tmp_path: Path, form: str, unit: str
) -> None:
    points = np.random.default_rng(0).integers(0, 80, (60, 3)) / 8.0
    length = {"mm": 1.0, "inch": 25.4}[unit]
    low, high = np.array([2.1, 1.1, -1.0]), np.array([8.1, 9.1, 7.1])
    source: Any = points
    if form == "file":
        source = tmp_path / "cloud.ply"
        write_cloud(PointCloud(points), source)
    elif form == "mesh":
        source = tmp_path / "cloud.obj"
        lines = [f"v {x} {y} {z}" for x, y, z in points]
        lines += [f"f {k} {k + 1} {k + 2}" for k in range(1, 58, 3)]
        source.write_text("\n".join(lines))
        points = document.points_of(document.make_cloud(doc, source))
    inside = points[((points >= low) & (points <= high)).all(axis=1)]
    cloud = document.make_cloud(doc, source, unit=unit, region=(length * low, length * high))
    assert 0 < len(inside) < len(points)
    assert np.allclose(document.points_of(cloud), length * inside, rtol=1e-6)


def test_a_region_without_points_makes_no_cloud(doc: Any) -> None:
    with pytest.raises(ValueError, match="No point of the cloud, which reaches from"):
        document.make_cloud(doc, np.eye(3), region=((5, 5, 5), (6, 6, 6)))
    with pytest.raises(ValueError, match="is no box"):
        document.make_cloud(doc, np.eye(3), region=((1, 1, 1), (0, 0, 0)))
    assert not doc.Objects
