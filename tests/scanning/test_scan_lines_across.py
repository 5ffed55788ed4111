# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clouds whose points are far apart along the edge: lines across it, or one side scanned coarsely.

A roof of 90° along the x axis, scanned with a noise of 0.02 mm in each coordinate.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from freecad_edgescan import PointCloud, scan_edge

LENGTH, WIDTH, NOISE = 50.0, 12.0, 0.02  # mm
SHIFT = np.array([10.0, 20.0, -40.0])  # mm
TURN = Rotation.random(random_state=21)


def roof(x, s):
    """Points at the places x along the edge and s across it, of either sign, mm."""
    return np.column_stack([x, s, -np.abs(s)]) * [1.0, np.sqrt(0.5), np.sqrt(0.5)]


def lines_across(spacing, pitch, seed):
    """Scan lines square to the edge, each with its points at another phase."""
    rng = np.random.default_rng(seed)
    lines = np.arange(0.5, LENGTH, spacing)
    s = np.arange(-WIDTH, WIDTH, pitch) + rng.uniform(0.0, pitch, (len(lines), 1))
    return noisy(roof(np.repeat(lines, s.shape[1]), s.ravel()), rng)


def uneven_sides(pitch, coarse, seed):
    """One side at a pitch, the other one coarser, a point at random in each cell of a grid."""
    rng = np.random.default_rng(seed)
    parts = []
    for sign, cell in ((1.0, pitch), (-1.0, coarse)):
        x, s = np.meshgrid(np.arange(0.0, LENGTH, cell), np.arange(0.0, WIDTH, cell))
        jitter = rng.uniform(0.0, cell, (2, x.size))
        parts.append(roof(x.ravel() + jitter[0], sign * (s.ravel() + jitter[1])))
    return noisy(np.vstack(parts), rng)


def noisy(points, rng):
    return PointCloud(TURN.apply(points + rng.normal(scale=NOISE, size=points.shape)) + SHIFT)


def scanned(cloud, x):
    """The edge found from a click 0.36 mm off it at x."""
    return scan_edge(cloud, TURN.apply([x, 0.2, -0.3]) + SHIFT)


def errors(edge):
    """Distances (m,) of the edge points from the true edge, mm."""
    return np.linalg.norm(TURN.inv().apply(edge.points - SHIFT)[:, 1:], axis=1)


SPACINGS = [
    (0.5, 0.1),
    (0.8, 0.1),
    (1.0, 0.1),
    (2.0, 0.1),
    (1.0, 0.2),
    (1.2, 0.2),
    (1.5, 0.2),
    (2.0, 0.2),
]
CLICKS = np.arange(5.0, 46.0, 13.1)  # at any phase of the lines


@pytest.mark.parametrize(("spacing", "pitch"), SPACINGS)
def test_one_click_finds_an_edge_across_scan_lines(spacing, pitch):
    cloud = lines_across(spacing, pitch, seed=0)
    for x in CLICKS:
        edge = scanned(cloud, x)
        assert edge.length > LENGTH - 3.0
        assert np.sqrt(np.mean(errors(edge) ** 2)) < 0.4 * NOISE


@pytest.mark.parametrize("coarse", [0.5, 1.0, 1.25])
def test_one_click_finds_an_edge_whose_sides_differ_in_density(coarse):
    cloud = uneven_sides(0.25, coarse, seed=0)
    for x in CLICKS:
        edge = scanned(cloud, x)
        assert edge.length > LENGTH - 3.0 * coarse
        assert np.sqrt(np.mean(errors(edge) ** 2)) < 1.5 * NOISE


@pytest.mark.parametrize(
    ("scan", "first", "second"),
    [(lines_across, 1.0, 0.1), (lines_across, 2.0, 0.2), (uneven_sides, 0.25, 1.0)],
)
def test_sigma_is_honest_where_points_are_far_apart_along_the_edge(scan, first, second):
    edges = [scanned(scan(first, second, seed), 20.3) for seed in range(1, 7)]
    share = np.concatenate([errors(edge) / edge.sigma for edge in edges])
    assert np.mean(share < 2.0) > 0.85
    assert np.median(share) > 0.3
