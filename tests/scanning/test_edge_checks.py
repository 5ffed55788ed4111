# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is no edge is refused: faces that pass by each other, pieces of roundings, the unknown."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.scanning import ScanError, scan_edge

from .test_sides_beyond import DEPTH, NOISE, PITCH, RADIUS, bore_beside_a_face


def profile(corners, noise, seed, length=24.0, pitch=0.5):
    """Points on flat faces along x whose section has these corners (k, 2)."""
    rng = np.random.default_rng(seed)
    parts = []
    for begin, end in pairwise(corners):
        way = np.subtract(end, begin)
        count = rng.poisson(length * np.linalg.norm(way) / pitch**2)
        place = begin + rng.random((count, 1)) * way
        parts.append(np.column_stack([rng.uniform(-length / 2, length / 2, count), place]))
    points = np.vstack(parts)
    return PointCloud(points + rng.normal(0.0, noise, points.shape))


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("land", [1.2, 1.6, 2.1])
def test_over_a_narrow_step_no_face_meets_the_next_but_one(land, seed):
    """A floor, a land of so many pitches upwards, a face that leans back over it.

    Drawn out downwards that face meets the floor one to two pitches before the land.
    """
    up = np.array([[-9.0, 0.0], [0.0, 0.0], [0.0, 0.5 * land]])
    last = up[-1] + 9.0 * np.array([np.cos(np.radians(35)), np.sin(np.radians(35))])
    cloud = profile(np.vstack([up, last]), 0.01, seed)
    try:
        edge = scan_edge(cloud, at=(0.0, 0.0, 0.0))
    except ScanError as refusal:
        assert "Click" in str(refusal) or "click" in str(refusal)
        return
    away = [np.hypot(edge.points[:, 1] - y, edge.points[:, 2] - z) for y, z in up[1:]]
    assert np.median(away, axis=1).min() < 0.2 * PITCH


def test_a_face_that_goes_on_is_told():
    told = []
    for seed in range(4):
        last = [9.0 * np.cos(np.radians(35)), 0.6 + 9.0 * np.sin(np.radians(35))]
        corners = np.array([[-9.0, 0.0], [0.0, 0.0], [0.0, 0.6], last])
        try:
            scan_edge(profile(corners, 0.01, seed), at=(0.0, 0.0, 0.0))
        except ScanError as refusal:
            told.append(str(refusal))
    assert any("goes on beyond" in text for text in told)


def burred() -> np.ndarray:
    """A right angle with its edge on the x axis, and a burr of 0.3 mm along one of its sides."""
    rng = np.random.default_rng(6)
    cell = np.indices((125, 60)).reshape(2, -1).T + 0.5
    x, s = (0.4 * (cell + rng.uniform(-0.35, 0.35, cell.shape))).T - np.array([[0.0], [12.0]])
    up = 0.3 * np.exp(-((s / 0.8) ** 2)) * (s > 0.0)
    points = np.column_stack([x, (s + up) / np.sqrt(2.0), (up - np.abs(s)) / np.sqrt(2.0)])
    return points + rng.normal(scale=0.02, size=points.shape)


def test_a_burr_is_named_and_what_is_advised_helps():
    points = burred()
    with pytest.raises(ScanError, match="a burr or a bead stands along the edge: take its points"):
        scan_edge(PointCloud(points), at=(25.0, 0.0, -0.3))
    off = (points[:, 1] < 0.0) | (np.hypot(points[:, 1], points[:, 2]) > 1.6)
    edge = scan_edge(PointCloud(points[off]), at=(25.0, 0.0, -0.3))
    assert np.hypot(edge.points[:, 1], edge.points[:, 2]).max() < 0.05


@pytest.mark.parametrize("seed", [1, 2, 3])
@pytest.mark.parametrize("thickness", [2.0, 2.7])
def test_a_click_on_a_thin_wall_finds_no_edge_behind_it(thickness, seed):
    """Half-way up the wall between a face and a bore, above the bore's floor."""
    cloud = bore_beside_a_face(thickness, seed)
    try:
        edge = scan_edge(cloud, at=(0.0, 0.0, 0.5 * DEPTH))
    except ScanError:
        return
    away = np.hypot(edge.points[:, 0], edge.points[:, 1] - RADIUS - thickness * PITCH) - RADIUS
    assert np.median(np.hypot(away, edge.points[:, 2])) < 5.0 * NOISE


@pytest.mark.parametrize("seed", range(4))
def test_a_rounding_beside_a_land_of_two_pitches_is_no_side(seed):
    """Very little noise: a piece of the rounding bends by many times as much, and is long seen."""
    rng = np.random.default_rng(100 + seed)
    radius, count = 2.0, {"top": 4000, "land": 160, "round": 503}
    x, s = rng.uniform([-20.0, 0.0], [20.0, 25.0], (count["top"], 2)).T
    top = np.column_stack([x, -radius - s, np.zeros_like(x)])
    x, s = rng.uniform([-20.0, 0.0], [20.0, 1.0], (count["land"], 2)).T
    land = np.column_stack([x, np.zeros_like(x), -radius - s])
    x, turn = rng.uniform([-20.0, 0.0], [20.0, np.pi / 2], (count["round"], 2)).T
    round_ = np.column_stack([x, radius * (np.cos(turn) - 1.0), radius * (np.sin(turn) - 1.0)])
    points = np.vstack([top, land, round_])
    cloud = PointCloud(points + rng.normal(0.0, 0.005, points.shape))
    for at in ((0.0, -0.6, -0.6), (0.0, -3.0, 0.0), (0.0, 0.0, -2.4)):
        try:
            edge = scan_edge(cloud, at=at)
        except ScanError:
            continue
        away = np.hypot(edge.points[:, 1], edge.points[:, 2])
        assert np.median(away) < 0.25 * 0.5  # of the pitch


def test_an_edge_of_which_much_is_not_known_is_refused(wedge):
    """Noise as large as the pitch on sides of four pitches."""
    part = wedge(120.0, noise=0.6, width=2.0, length=30.0)
    with pytest.raises(ScanError):
        scan_edge(part.cloud, part.at(0.0, 0.2))
