# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points go between numpy and FreeCAD's kernels unharmed."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402
from freecad_edgescan.cloud import PointCloud  # noqa: E402
from freecad_edgescan.document import bridge  # noqa: E402
from freecad_edgescan.experiments.peak_memory import memory_now  # noqa: E402

FAR = np.array([500000.0, 4500000.0, 120.0])


def some_points(count: int = 1000) -> np.ndarray:
    return np.random.default_rng(1).normal(size=(count, 3)) * 100.0


@pytest.mark.parametrize("count", [0, 1, 1000])
def test_the_archive_and_the_list_way_give_equal_kernels(count: int) -> None:
    points = some_points(count)
    fast, slow = bridge.kernel_from_array(points), bridge.kernel_from_array_by_list(points)
    assert fast.CountPoints == slow.CountPoints == count
    assert [tuple(p) for p in fast.Points] == [tuple(p) for p in slow.Points]


def test_the_archive_and_the_list_way_give_equal_arrays() -> None:
    points = some_points()
    kernel = bridge.kernel_from_array(points)
    fast, slow = bridge.array_from_kernel(kernel), bridge.array_from_kernel_by_list(kernel)
    np.testing.assert_array_equal(fast, points.astype(np.float32))
    np.testing.assert_array_equal(fast, slow)


def test_a_shifted_kernel_gives_its_own_points_both_ways() -> None:
    points = np.round(some_points())
    kernel = bridge.kernel_from_array(points)
    kernel.Placement = FreeCAD.Placement(FreeCAD.Vector(16, 0, -8), FreeCAD.Rotation())
    np.testing.assert_array_equal(bridge.array_from_kernel(kernel), points)
    np.testing.assert_array_equal(bridge.array_from_kernel_by_list(kernel), points)


def test_without_the_archive_the_list_serves(monkeypatch: pytest.MonkeyPatch) -> None:
    points = some_points(50).astype(np.float32)

    def broken(*_: Any) -> Any:
        raise bridge.zipfile.BadZipFile

    monkeypatch.setattr(bridge.zipfile, "ZipFile", broken)
    kernel = bridge.kernel_from_array(points)
    np.testing.assert_array_equal(bridge.array_from_kernel(kernel), points)


def test_placements_of_object_and_parent_part_both_count(doc: Any) -> None:
    points = some_points(30)
    cloud = document.make_cloud(doc, points)
    part = doc.addObject("App::Part", "Assembly")
    part.addObject(cloud)
    turn = FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90)
    cloud.Placement = FreeCAD.Placement(FreeCAD.Vector(10, 0, 0), turn)
    part.Placement = FreeCAD.Placement(FreeCAD.Vector(100, 5, 0), turn)
    quarter = np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1]])
    placed = (points @ quarter + np.array([10, 0, 0])) @ quarter + np.array([100, 5, 0])
    np.testing.assert_allclose(document.points_of(cloud), placed, atol=5e-5)


def test_a_cloud_far_from_the_origin_keeps_its_precision(doc: Any) -> None:
    points = some_points(200) + FAR
    cloud = document.make_cloud(doc, points)
    np.testing.assert_allclose(document.points_of(cloud), points, rtol=0, atol=2e-5)
    assert np.abs(document.point_cloud(cloud).points).max() < 1000.0


def test_a_far_cloud_keeps_its_precision_through_a_file(doc: Any, tmp_path: Any) -> None:
    points = some_points(200) + FAR
    name = document.make_cloud(doc, points).Name
    path = str(tmp_path / "far.FCStd")
    doc.saveAs(path)
    FreeCAD.closeDocument(doc.Name)
    again = FreeCAD.openDocument(path)
    read = document.points_of(again.getObject(name))
    np.testing.assert_allclose(read, points, rtol=0, atol=2e-5)


def test_a_near_cloud_stays_where_it_is(doc: Any) -> None:
    cloud = document.make_cloud(doc, some_points())
    assert cloud.Origin == FreeCAD.Vector(0, 0, 0)


def test_a_shape_is_not_a_cloud(doc: Any) -> None:
    box = doc.addObject("Part::Box", "Box")
    with pytest.raises(ValueError, match=r"'Box' is not a point cloud"):
        document.points_of(box)


def test_a_clouds_probe_goes_into_its_properties_and_back(doc: Any) -> None:
    numbers = PointCloud(some_points(), probe_radius=1.5, approach=(0, 0, -2))
    cloud = document.make_cloud(doc, numbers)
    back = document.point_cloud(cloud)
    assert cloud.TypeId == "Points::Feature"
    assert back.probe_radius == 1.5
    np.testing.assert_array_equal(back.approach, (0, 0, -1))


def test_what_a_kernel_was_made_from_does_not_stay_in_memory() -> None:
    points = np.zeros((1_000_000, 3), dtype=np.float32)
    bridge.kernel_from_array(points)
    before = memory_now()
    for _ in range(8):
        bridge.kernel_from_array(points)
    assert memory_now() - before < 4 * points.nbytes
