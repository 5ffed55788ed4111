# SPDX-License-Identifier: LGPL-2.1-or-later
"""One PointCloud serves all edges of a cloud object, until the object changes."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")

from freecad_edgescan import document  # noqa: E402
from freecad_edgescan.document import bridge, cloud_cache  # noqa: E402


def make_cloud(doc: Any, seed: int = 0) -> Any:
    return document.make_cloud(doc, np.random.default_rng(seed).random((100, 3)))


def test_an_unchanged_cloud_is_built_once(doc: Any) -> None:
    cloud = make_cloud(doc)
    tree = document.point_cloud(cloud).tree
    assert document.point_cloud(cloud).tree is tree


@pytest.mark.parametrize("change", ["points", "placement", "probe"])
def test_a_change_of_the_object_makes_a_new_cloud(doc: Any, change: str) -> None:
    cloud = make_cloud(doc)
    before = document.point_cloud(cloud)
    if change == "points":
        cloud.Points = bridge.kernel_from_array(before.points + 1.0)
    elif change == "placement":
        cloud.Placement.Base = FreeCAD.Vector(1, 0, 0)
    else:
        cloud.ProbeRadius = 0.5
    assert document.point_cloud(cloud) is not before


def test_only_a_few_clouds_are_kept(doc: Any) -> None:
    for seed in range(cloud_cache.MOST_CLOUDS + 3):
        document.point_cloud(make_cloud(doc, seed))
    assert len(cloud_cache._clouds) == cloud_cache.MOST_CLOUDS


def test_clouds_go_with_their_object_and_document(doc: Any) -> None:
    first, second = make_cloud(doc), make_cloud(doc)
    for cloud in (first, second):
        document.point_cloud(cloud)
    names = {(doc.Name, first.Name), (doc.Name, second.Name)}
    kept = (doc.Name, second.Name)
    doc.removeObject(first.Name)
    assert names & set(cloud_cache._clouds) == {kept}
    FreeCAD.closeDocument(doc.Name)
    assert not names & set(cloud_cache._clouds)


def test_an_empty_cloud_says_so(doc: Any) -> None:
    cloud = make_cloud(doc)
    cloud.Label = "Bracket"
    cloud.Points = bridge.kernel_from_array(np.zeros((0, 3)))
    with pytest.raises(ValueError, match="The cloud 'Bracket' is empty"):
        document.point_cloud(cloud)


@pytest.fixture
def readings(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Names of the objects whose points were read, one way or the other."""
    read: list[str] = []

    def counted(own: Any) -> Any:
        def reading(obj: Any) -> Any:
            read.append(obj.Name)
            return own(obj)

        return reading

    for name in ("document_points_of", "document_blocks_of"):
        monkeypatch.setattr(cloud_cache, name, counted(getattr(cloud_cache, name)))
    return read


def test_points_that_were_not_exchanged_are_not_read_again(doc: Any, readings: list[str]) -> None:
    cloud = make_cloud(doc)
    before = document.point_cloud(cloud)
    checksum = cloud_cache.cloud_checksum(cloud)
    cloud.Label = "Other"
    assert document.point_cloud(cloud) is before
    assert cloud_cache.cloud_checksum(cloud) == checksum
    assert readings == [cloud.Name]


def test_the_same_points_given_again_keep_the_cloud_and_its_tree(
    doc: Any, readings: list[str]
) -> None:
    cloud = make_cloud(doc)
    before = document.point_cloud(cloud)
    cloud.Points = cloud.Points
    assert document.point_cloud(cloud) is before
    assert document.point_cloud(cloud) is before
    assert len(readings) == 2
    cloud.touch()
    doc.recompute()
    assert document.point_cloud(cloud) is before


def test_points_that_undo_brings_back_are_noticed(doc: Any) -> None:
    cloud = make_cloud(doc)
    doc.openTransaction("Move points")
    before = document.point_cloud(cloud).points
    cloud.Points = bridge.kernel_from_array(before + 1.0)
    doc.commitTransaction()
    assert np.allclose(document.point_cloud(cloud).points, before + 1.0, atol=1e-6)
    doc.undo()
    assert np.array_equal(document.point_cloud(cloud).points, before)
    doc.redo()
    assert np.allclose(document.point_cloud(cloud).points, before + 1.0, atol=1e-6)


def test_a_part_that_moves_takes_its_cloud_along(doc: Any) -> None:
    cloud = make_cloud(doc)
    part = doc.addObject("App::Part", "Part")
    part.addObject(cloud)
    before = document.point_cloud(cloud).points
    part.Placement.Base = FreeCAD.Vector(5, 0, 0)
    assert np.allclose(document.point_cloud(cloud).points, before + np.array([5.0, 0.0, 0.0]))


def test_a_document_that_is_restored_has_clouds_of_its_own(doc: Any, tmp_path: Any) -> None:
    cloud = make_cloud(doc)
    name, before = cloud.Name, document.point_cloud(cloud).points
    doc.saveAs(str(tmp_path / "cloud.FCStd"))
    cloud.Points = bridge.kernel_from_array(before + 1.0)
    document.point_cloud(cloud)
    doc.restore()
    assert np.array_equal(document.point_cloud(doc.getObject(name)).points, before)


def test_a_cloud_larger_than_a_block_crosses_unharmed(
    doc: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(bridge, "_ROWS", 7)
    points = np.random.default_rng(0).integers(-99, 99, (100, 3)) / 8.0
    cloud = document.make_cloud(doc, points, unit="inch")
    assert np.array_equal(document.points_of(cloud), (25.4 * points).astype("f4"))
    cloud.Placement.Base = FreeCAD.Vector(1, 2, 3)
    moved = (25.4 * points).astype("f4") + np.array([1.0, 2.0, 3.0])
    assert np.allclose(document.point_cloud(cloud).points, moved, rtol=0, atol=1e-12)
