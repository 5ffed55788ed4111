# SPDX-License-Identifier: LGPL-2.1-or-later
from __future__ import annotations

import pickle

import numpy as np
import pytest

from freecad_edgescan.cloud import PointCloud, require_surface


def corner(count: int = 400) -> np.ndarray:
    """Two faces that meet in a right angle, unit pitch."""
    u, v = np.meshgrid(np.arange(count // 20), np.arange(10.0))
    face = np.column_stack([u.ravel(), v.ravel(), np.zeros(u.size)])
    return np.concatenate([face, face[:, [0, 2, 1]]])


def test_the_points_cannot_be_changed_through_the_cloud_or_through_their_source():
    source = corner()
    cloud = PointCloud(source)
    with pytest.raises(ValueError):
        cloud.points[0] = 1.0
    with pytest.raises(AttributeError):
        cloud.points = source
    source[0] = 99.0
    assert cloud.points[0].tolist() == [0.0, 0.0, 0.0]
    assert cloud.points.dtype == np.float64
    assert cloud.points.flags.c_contiguous


def test_a_cloud_knows_its_length_size_and_approach():
    cloud = PointCloud(corner(), probe_radius=1.5, approach=(0, 0, -4))
    assert len(cloud) == 400
    assert cloud.size.tolist() == [19.0, 9.0, 9.0]
    assert cloud.probe_radius == 1.5
    assert cloud.approach.tolist() == [0.0, 0.0, -1.0]
    assert PointCloud(corner()).approach is None


def test_the_tree_is_built_once_and_finds_the_nearest_point():
    cloud = PointCloud(corner())
    assert cloud.tree is cloud.tree
    distance, index = cloud.tree.query([3.2, 4.0, 0.0])
    assert cloud.points[index].tolist() == [3.0, 4.0, 0.0]
    assert distance == pytest.approx(0.2)


def test_rows_that_are_not_finite_are_left_out_counted_and_told():
    points = corner()
    points[3, 1] = np.nan
    points[7, 2] = np.inf
    with pytest.warns(UserWarning, match="2 of 400 points"):
        cloud = PointCloud(points)
    assert cloud.dropped == 2
    assert len(cloud) == 398
    assert np.isfinite(cloud.points).all()


def test_a_cloud_survives_a_pickle_and_stays_immutable():
    cloud = pickle.loads(pickle.dumps(PointCloud(corner(), 0.5, (1, 0, 0))))
    assert np.array_equal(cloud.points, corner())
    assert cloud.probe_radius == 0.5
    assert not cloud.points.flags.writeable
    assert not cloud.approach.flags.writeable


def test_far_from_the_origin_nothing_is_lost_and_a_local_origin_is_offered():
    far = np.array([4.5e6, -5.2e6, 300.0])
    near = PointCloud(corner() * 0.01)
    cloud = PointCloud(corner() * 0.01 + far)
    assert near.origin_hint.tolist() == [0.0, 0.0, 0.0]
    assert np.array_equal(cloud.origin_hint, np.round(cloud.origin_hint))
    local = (cloud.points - cloud.origin_hint).astype(np.float32)
    assert np.allclose(local.astype(float) + cloud.origin_hint, cloud.points, atol=1e-6)
    assert cloud.pitch == pytest.approx(near.pitch, rel=1e-2)


@pytest.mark.parametrize(
    ("points", "said"),
    [
        ([], "no points"),
        (np.zeros((4, 2)), r"shape \(4, 2\)"),
        (np.zeros(3), r"shape \(3,\)"),
        ([["a", "b", "c"]], "not an array of numbers"),
        ([[1, 2, 3], [4, 5]], "not an array of numbers"),
        (np.full((5, 3), np.nan), "None of the 5 points"),
        (np.full((5, 3), 1e200), "1e\\+200"),
    ],
)
def test_what_is_no_cloud_is_refused_with_the_reason(points, said):
    with pytest.raises(ValueError, match=said):
        PointCloud(points)


@pytest.mark.parametrize("radius", [-1.0, np.nan, np.inf, "wide", None])
def test_a_probe_radius_that_is_none_is_refused(radius):
    with pytest.raises(ValueError, match="probe radius"):
        PointCloud(corner(), probe_radius=radius)


@pytest.mark.parametrize("approach", [(0, 0, 0), (1, 2), (np.nan, 0, 1), "down"])
def test_an_approach_without_direction_is_refused(approach):
    with pytest.raises(ValueError, match="approach"):
        PointCloud(corner(), approach=approach)


def plane(count: int) -> np.ndarray:
    rng = np.random.default_rng(1)
    return rng.uniform(0, 50, (count, 2)) @ rng.normal(size=(2, 3)) + 1000.0


@pytest.mark.parametrize(
    ("points", "said"),
    [
        (corner()[:19], "19 points"),
        (np.ones((30, 3)), "30 points of the cloud are equal"),
        (np.outer(np.linspace(0, 9, 30), [1, 2, 3]) + 77.7, "on one line"),
        (plane(100), "on one plane"),
    ],
)
def test_a_cloud_that_can_hold_no_edge_is_refused_where_an_edge_is_wanted(points, said):
    cloud = PointCloud(points)
    with pytest.raises(ValueError, match=said):
        require_surface(cloud)


def test_a_cloud_with_a_surface_is_let_through_however_thin():
    require_surface(PointCloud(corner()))
    lifted = plane(100)
    lifted[:, 2] += np.random.default_rng(2).normal(0, 0.01, 100)
    require_surface(PointCloud(lifted))
