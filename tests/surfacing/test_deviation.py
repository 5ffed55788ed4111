# SPDX-License-Identifier: LGPL-2.1-or-later
"""Signed deviations of clouds whose distance from the surface is known."""

from __future__ import annotations

import numpy as np
import pytest

import freecad_edgescan as es


def test_points_of_a_larger_pipe_deviate_by_the_difference_of_the_radii(pipe):
    """The half-pipe of radius 17 round the x axis opens upwards."""
    angle = np.linspace(0.1, np.pi - 0.1, 50)
    ring = np.stack([0 * angle + 20, -17.25 * np.cos(angle), -17.25 * np.sin(angle)], axis=1)
    found = es.deviation(ring, pipe)
    outwards = -np.sign(pipe.normal(1.0, 0.5) @ [0, np.cos(1.0), np.sin(1.0)])
    assert np.allclose(found.deviation, 0.25 * outwards, atol=1e-9)
    assert found.average == pytest.approx(0.25) and found.maximum == pytest.approx(0.25)
    assert found.rms == pytest.approx(0.25) and not found.outside.any() and len(found) == 50


def test_points_beyond_the_rim_are_marked_and_left_out_of_the_figures(flat):
    cloud = es.PointCloud([[10, 10, 0.5], [30, 20, -0.25], [90.0, 25, 0]])
    found = es.deviation(cloud, flat)
    assert np.allclose(found.deviation, [0.5, -0.25, 10])
    assert found.outside.tolist() == [False, False, True]
    assert found.average == pytest.approx(0.375) and found.maximum == pytest.approx(0.5)
    counts, limits = found.histogram(4)
    assert counts.tolist() == [0, 1, 0, 1] and np.allclose(limits, [-0.5, -0.25, 0, 0.25, 0.5])
    assert found.histogram(2, limit=0.1)[0].tolist() == [1, 1]


def test_figures_of_points_that_are_all_beyond_the_rim_are_nan(flat):
    found = es.deviation([[200.0, 0, 0]], flat)
    assert np.isnan(found.average) and found.histogram()[0].sum() == 0


def test_progress_may_end_it_with_the_first_points(flat):
    class Stops:
        def update(self, fraction, so_far):
            return False

    points = np.random.default_rng(0).random((200_010, 3)) * [80, 50, 1]
    assert len(es.deviation(points, flat, progress=Stops())) == 200_000


def test_what_has_no_deviation_is_refused(flat):
    with pytest.raises(ValueError, match=r"ball of 1 mm radius.*compensate_cloud"):
        es.deviation(es.PointCloud(np.eye(3), 1.0), flat)
    with pytest.raises(ValueError, match=r"\(n, 3\) array"):
        es.deviation(np.zeros((0, 3)), flat)
    with pytest.raises(ValueError, match="not a finite number"):
        es.deviation([[np.nan, 0, 0]], flat)
    with pytest.raises(ValueError, match="0 bins"):
        es.deviation(np.eye(3), flat).histogram(0)
    with pytest.raises(ValueError, match="limit of the histogram is -1"):
        es.deviation(np.eye(3), flat).histogram(5, limit=-1)
