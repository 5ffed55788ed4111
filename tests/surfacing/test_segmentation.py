# SPDX-License-Identifier: LGPL-2.1-or-later
"""Segments of clouds: exactly the points within the distance, however they are found."""

from __future__ import annotations

import numpy as np
import pytest

import freecad_edgescan as es


@pytest.mark.parametrize("distance", [0.05, 1.0, 3.0, 40.0])
def test_a_segment_is_all_points_whose_closest_point_is_near(wave, distance):
    rng = np.random.default_rng(0)
    points = rng.random((20_000, 3)) * [120, 80, 40] - [20, 15, 20]
    near = wave.closest(points)[2] <= distance
    assert np.array_equal(es.segment_cloud(es.PointCloud(points), wave, distance), near)


def test_far_from_the_origin_the_segment_is_the_same(pipe):
    move = np.array([3e6, -1e6, 2e6])
    moved = es.BSplineSurface(pipe.poles + move, pipe.knots, pipe.degree, pipe.weights)
    points = np.random.default_rng(1).random((20_000, 3)) * [80, 50, 40] - [10, 25, 30]
    here = es.segment_cloud(es.PointCloud(points), pipe, 2.0)
    assert 500 < here.sum() < 10_000
    assert np.array_equal(es.segment_cloud(es.PointCloud(points + move), moved, 2.0), here)


def trench(noise, pitch=0.5):
    """The half-pipe of radius 17 sunk into the plane z = 0; which points are the pipe's."""
    rng = np.random.default_rng(2)
    x = rng.random(int(60 * 53 / pitch**2)) * 60
    turn = rng.random(len(x)) * np.pi
    wall = np.stack([x, -17 * np.cos(turn), -17 * np.sin(turn)], axis=1)
    land = rng.random((int(2 * 60 * 15 / pitch**2), 3)) * [60, 15, 0] + [0, 17, 0]
    land[::2, 1] *= -1
    points = np.concatenate([wall, land]) + noise * rng.normal(size=(len(wall) + len(land), 3))
    return es.PointCloud(points), np.arange(len(points)) < len(wall)


def test_with_an_angle_the_other_side_of_an_edge_stays_out(pipe):
    cloud, of_pipe = trench(0.03)
    by_distance = es.segment_cloud(cloud, pipe, 3.0)
    assert by_distance[of_pipe].all() and by_distance[~of_pipe].sum() > 1000
    both = es.segment_cloud(cloud, pipe, 3.0, angle=np.pi / 4)
    assert both[of_pipe].mean() > 0.98
    wrong = np.flatnonzero(both & ~of_pipe)
    assert len(wrong) < 0.01 * of_pipe.sum()
    # and those are at the edge itself
    assert (np.abs(cloud.points[wrong, 1]) < 17.5).all()


def test_what_is_no_segment_is_refused(pipe):
    far = np.random.default_rng(0).random((100, 3))
    far[:, 2] += 50
    cloud = es.PointCloud(far)
    with pytest.raises(ValueError, match=r"No point .* within 3 mm .* about 5\d\.?\d* mm away"):
        es.segment_cloud(cloud, pipe)
    with pytest.raises(ValueError, match="distance is -1 mm"):
        es.segment_cloud(cloud, pipe, -1)
    with pytest.raises(ValueError, match="not degrees"):
        es.segment_cloud(cloud, pipe, 3.0, angle=45)
    with pytest.raises(ValueError, match="too few, or too much alike, to have local normals"):
        es.segment_cloud(es.PointCloud([[30.0, 0, -17]]), pipe, 3.0, angle=0.5)
