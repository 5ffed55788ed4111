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
