# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thinned clouds: even, gapless, the same every time."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import cKDTree

import freecad_edgescan as es


def rippled(count=40_000, origin=(0.0, 0.0, 0.0), seed=0):
    rng = np.random.default_rng(seed)
    x, y = rng.random((2, count)) * 100
    points = np.column_stack([x, y, 3 * np.sin(x / 9)]) + origin
    return es.PointCloud(points, 1.0, (0, 0, -1))


@pytest.mark.parametrize("origin", [(0, 0, 0), (2e6, -3e5, 1e6)])
@pytest.mark.parametrize("pitch", [1.5, 4.0])
def test_thinned_points_are_as_far_apart_as_asked_and_leave_no_hole(pitch, origin):
    cloud = rippled(origin=origin)
    thin = es.thin_cloud(cloud, pitch)
    apart = cKDTree(thin.points).query(thin.points, k=2)[0][:, 1]
    assert apart.min() > 0.819 * pitch
    assert thin.tree.query(cloud.points)[0].max() <= 0.8201 * pitch
    assert thin.pitch == pytest.approx(pitch, rel=0.12)
    assert np.array_equal(cloud.points[thin.kept], thin.points)


def test_thinning_gives_the_same_points_every_time_and_keeps_what_is_known_of_the_cloud():
    first, second = (es.thin_cloud(rippled(), 2.0) for _ in range(2))
    assert np.array_equal(first.points, second.points)
    assert first.probe_radius == 1.0 and np.array_equal(first.approach, [0, 0, -1])


def test_rows_of_a_scanner_do_not_show_in_the_thinned_cloud():
    x, y = np.meshgrid(np.arange(0, 60, 2.0), np.arange(0, 60, 0.05))
    thin = es.thin_cloud(es.PointCloud(np.stack([x, y, 0 * x], -1).reshape(-1, 3)), 6.0)
    larger, smaller = np.median(thin.local_pitch(thin.points), axis=0)
    assert larger / smaller < 1.7


def test_a_coarser_cloud_stays_as_it_is():
    cloud = rippled(500)
    assert es.thin_cloud(cloud, 1e-3).kept.all()
    assert es.thin_cloud(es.PointCloud([[1.0, 2, 3]] * 5), 1.0).kept.sum() == 1


@pytest.mark.parametrize("pitch", [0.0, -1.0, np.nan, np.inf])
def test_a_pitch_that_is_none_is_refused(pitch):
    with pytest.raises(ValueError, match=r"The pitch is .* give the positive pitch"):
        es.thin_cloud(rippled(100), pitch)
