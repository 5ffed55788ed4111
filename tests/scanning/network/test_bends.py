# SPDX-License-Identifier: LGPL-2.1-or-later
"""A rim that bends with its wall has no corner; one whose walls meet has, also above a low wall."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import cKDTree

import freecad_edgescan as es

PITCH, NOISE = 0.5, 0.1
HALF, STEP, WIDE = 32.0, 0.01, 24.0  # pitches: half a rim's length, of its line, and of the top
SWEPT = 7.0  # pitches from the middle, within which a wall is curved


def rim(turn: float, radius: float, curvature: float) -> tuple[np.ndarray, np.ndarray]:
    """A line in a plane (k, 2) and its normals, pitches; its middle is at the origin.

    Parameters
    ----------
    turn : rad, in the middle; sudden where the radius is 0
    radius : the least one there, pitches
    curvature : besides, of the walls on both sides of the middle, 1/pitches
    """
    s = np.arange(-HALF, HALF, STEP)
    bend = curvature * (np.abs(s) < SWEPT)
    if radius:
        width = turn * radius / np.sqrt(2.0 * np.pi)
        bend = bend + np.exp(-0.5 * np.square(s / width)) / radius
    angle = np.cumsum(bend) * STEP + (turn * (s > 0.0) if not radius else 0.0)
    line = np.cumsum(np.column_stack([np.cos(angle), np.sin(angle)]), axis=0) * STEP
    return line - line[len(line) // 2], np.column_stack([-np.sin(angle), np.cos(angle)])


def under(line: np.ndarray, normals: np.ndarray, height: float, seed: int) -> es.PointCloud:
    """Points of a wall of some height (pitches) below a rim, and of the level top outside of it."""
    rng = np.random.default_rng(seed)
    low, high = line.min(axis=0) - WIDE, line.max(axis=0) + WIDE
    flat = rng.uniform(low, high, (int(np.prod(high - low)), 2))
    away, near = cKDTree(line).query(flat)
    outside = np.einsum("ni,ni->n", flat - line[near], normals[near]) < 0.0
    flat = flat[outside & (away < WIDE) & (near > 0) & (near < len(line) - 1)]
    top = np.column_stack([flat, np.zeros(len(flat))])
    count = int(2.0 * HALF * height)
    place = rng.integers(0, len(line), count)
    wall = np.column_stack([line[place], -rng.uniform(0.0, height, count)])
    noise = rng.normal(0.0, NOISE, (len(top) + count, 1))
    across = np.vstack(
        [
            np.tile([0.0, 0.0, 1.0], (len(top), 1)),
            np.column_stack([normals[place], np.zeros(count)]),
        ]
    )
    return es.PointCloud(PITCH * np.vstack([top, wall]) + noise * across)


def test_where_a_wall_bends_its_rim_has_no_corner():
    """Two edges and no third one; with some noise the bend is found as an edge, a rounded one."""
    line, normals = rim(1.3, 2.5, 1.0 / 20.0)
    networks = [es.find_edges(under(line, normals, 16.0, seed), jobs=1) for seed in (0, 1, 3, 5)]
    for network in networks:
        assert len(network.corners) == 0 or len(network.edges_at(0)) == 3
        assert sum(edge.length for edge in network.edges) > 0.85 * 2.0 * HALF * PITCH
    bent = [network for network in networks if len(network.edges) == 2]
    assert len(bent) >= 2
    for network in bent:
        assert len(network.corners) == 0
        assert all(es.Stop.LOST in ends for ends in network.ends)


@pytest.mark.parametrize("height", [7.0, 12.0])
@pytest.mark.parametrize("seed", range(3))
def test_where_walls_meet_is_a_corner_though_their_edge_is_short(seed, height):
    line, normals = rim(0.5 * np.pi, 0.0, 0.0)
    network = es.find_edges(under(line, normals, height, seed), jobs=1)
    (corner,) = network.corners
    assert np.linalg.norm(corner) < 0.5 * PITCH
    # An edge of seven pitches is shorter than those that are found.
    assert len(network.edges_at(0)) == (2 if height < 8.0 else 3)
