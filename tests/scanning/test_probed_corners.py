# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edge points of probed lines share what they know with neighbours, and say how much that is."""

import numpy as np
import pytest

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.scanning import PointCloudCmm, scan_edge
from freecad_edgescan.scanning.corner import across_axes
from freecad_edgescan.scanning.probed_corners import ProbedCorners
from freecad_edgescan.scanning.section import frames_from_sides

COUNT = 7


def leaning_frames():
    """Sections on a straight edge, whose sides are turned about it by some degrees at random."""
    rng = np.random.default_rng(2)
    turn = np.radians(rng.uniform(-8.0, 8.0, COUNT))
    origin = np.outer(np.arange(COUNT), (0.0, 1.0, 0.0))
    first = np.stack([-np.cos(turn), np.zeros(COUNT), -np.sin(turn)], axis=1)
    second = np.stack([np.sin(turn), np.zeros(COUNT), -np.cos(turn)], axis=1)
    tangent = np.tile((0.0, 1.0, 0.0), (COUNT, 1))
    return frames_from_sides(origin, tangent, np.stack([first, second], axis=1))


def corners_at(frames, offset, scatter=1e-4, systematic=0.0):
    """What lines know that all see the edge at the same offset (3,) from their origin."""
    axes = across_axes(frames.normals)
    every = np.tile(np.eye(2), (COUNT, 1, 1))
    return ProbedCorners(
        axes @ offset, frames.sides, scatter * every, systematic * every, np.ones(COUNT, dtype=bool)
    )


def test_a_mean_with_neighbours_does_not_depend_on_how_their_sections_lean():
    frames = leaning_frames()
    offset = np.array([0.3, 0.0, -1.2])
    points = corners_at(frames, offset).with_neighbours(frames).points(frames)
    assert points == pytest.approx(frames.origin + offset, abs=1e-12)


def test_neighbours_make_the_scatter_smaller_but_not_what_they_have_in_common():
    frames = leaning_frames()
    mean = corners_at(frames, np.zeros(3), 3e-4, 5e-5).with_neighbours(frames)
    inner = np.tile(np.eye(2), (COUNT - 2, 1, 1))
    assert mean.scatter[1:-1] == pytest.approx(1e-4 * inner)
    assert mean.systematic == pytest.approx(5e-5 * np.tile(np.eye(2), (COUNT, 1, 1)))
    assert mean.covariance[0] == pytest.approx(3.5e-4 * np.eye(2))


@pytest.mark.parametrize("lost", [0, 3, COUNT - 1])
def test_a_line_that_knows_nothing_takes_no_part(lost):
    frames = leaning_frames()
    offset = np.array([0.3, 0.0, -1.2])
    corners = corners_at(frames, offset)
    corners.found[lost], corners.shift[lost] = False, 50.0
    mean = corners.with_neighbours(frames)
    at_an_end = lost in (0, COUNT - 1)  # ends stand alone, and have no neighbours to ask
    assert mean.found[lost] == (not at_an_end)
    known = mean.found
    assert mean.points(frames)[known] == pytest.approx((frames.origin + offset)[known], abs=1e-12)
    assert np.all(np.trace(mean.covariance[known], axis1=1, axis2=2) > 0.0)


@pytest.mark.parametrize("strewn", [False, True])
def test_an_edge_of_a_noisy_cloud_lies_within_its_own_sigma(strewn):
    """A virtual probe meets the outermost of some points: all lines are off to the same side."""
    rng = np.random.default_rng(7)
    if strewn:
        flat = rng.uniform([0.0, 0.0], [40.0, 12.0], (6000, 2))
    else:
        flat = np.stack(np.meshgrid(np.arange(0, 40, 0.28), np.arange(0.14, 12, 0.28)), -1)
        flat = flat.reshape(-1, 2)
    sides = [np.column_stack([flat[:, 0], *rows]) for rows in _roof(flat[:, 1])]
    points = np.vstack(sides) + rng.normal(0.0, 0.03, (2 * len(flat), 3))
    edge = scan_edge(PointCloud(points), at=(20.0, 0.0, 0.0), method="probe")
    error = np.hypot(edge.points[:, 1], edge.points[:, 2])
    assert edge.length > 36.0
    assert np.mean(error < 2.0 * edge.sigma) > 0.9
    assert error.mean() > 0.2 * edge.sigma.mean()  # and it is not far too large, either


def _roof(away):
    half = np.radians(50.0)
    for sign in (1.0, -1.0):
        yield sign * away * np.sin(half), -away * np.cos(half)


def test_only_the_kind_that_takes_the_first_point_is_early():
    grid = np.stack(np.meshgrid(np.arange(0, 20, 0.5), np.arange(0, 20, 0.5), [0.0]), -1)
    points = grid.reshape(-1, 3) + np.random.default_rng(1).normal(0.0, 0.02, (1600, 3))
    cloud = PointCloud(points)
    assert PointCloudCmm(cloud, "ball").selection == PointCloudCmm(cloud, "triangle").selection == 0
    machine = PointCloudCmm(cloud, pitch=0.5)
    starts = np.column_stack([np.random.default_rng(2).uniform(3, 17, (400, 2)), np.full(400, 4.0)])
    heights = [machine.touch(p, np.array([0.0, 0.0, -1.0]), 4.0, 5.0)[2] for p in starts]
    early = np.mean(heights) / np.std(heights)
    assert machine.selection == pytest.approx(early, rel=0.15)
