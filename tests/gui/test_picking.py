# SPDX-License-Identifier: LGPL-2.1-or-later
"""A click means the point a person would point at."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import cKDTree

from freecad_edgescan.gui.picking import DEPTH_SHARE, Hit, ViewRay, front_hit, nearest_to_ray

DOWN = np.array([0.0, 0.0, -1.0])


def sheet(height: float, pitch: float = 0.5, slant: float = 0.0, size: float = 20.0) -> np.ndarray:
    """A square sheet of points round the z axis that rises by `slant` per mm of x."""
    side = np.arange(-size / 2, size / 2 + pitch / 2, pitch)
    x, y = (axis.ravel() for axis in np.meshgrid(side, side))
    return np.column_stack([x, y, height + slant * x])


def looking_down(x: float, y: float, radius: float = 0.6, slope: float = 0.0) -> ViewRay:
    return ViewRay(np.array([x, y, 1000.0]), DOWN, radius, slope)


def test_the_point_under_the_cursor_is_met() -> None:
    points = sheet(0.0)
    hit = nearest_to_ray(cKDTree(points), looking_down(3.1, -4.05))
    assert hit is not None
    assert points[hit.index] == pytest.approx([3.0, -4.0, 0.0])
    assert hit.depth == pytest.approx(1000.0)
    assert hit.distance == pytest.approx(np.hypot(0.1, 0.05))


def test_a_sheet_in_front_hides_the_sheet_behind_it() -> None:
    points = np.vstack([sheet(0.0, pitch=0.3), sheet(2.0, pitch=0.29)])
    for x, y in np.random.default_rng(1).uniform(-8, 8, (50, 2)):
        hit = nearest_to_ray(cKDTree(points), looking_down(x, y))
        assert hit is not None
        assert points[hit.index, 2] == 2.0


@pytest.mark.parametrize("slant", [0.0, 1.0, 3.0])
def test_on_a_slanting_sheet_the_nearest_to_the_ray_wins(slant: float) -> None:
    points = sheet(0.0, pitch=0.1, slant=slant)
    for x, y in np.random.default_rng(2).uniform(-8, 8, (20, 2)):
        hit = nearest_to_ray(cKDTree(points), looking_down(x, y))
        assert hit is not None
        assert hit.distance <= 2 * 0.1


def test_perspective_widens_the_pick_radius_with_depth() -> None:
    tree = cKDTree(np.vstack([sheet(0.0, pitch=2.0)]))
    narrow = ViewRay(np.array([0.9, 0.0, 1000.0]), DOWN, 0.0, 0.0005)
    wide = ViewRay(np.array([0.9, 0.0, 1000.0]), DOWN, 0.0, 0.001)
    assert nearest_to_ray(tree, narrow) is None
    assert nearest_to_ray(tree, wide) is not None


def test_between_the_points_of_a_magnified_cloud_the_least_radius_helps() -> None:
    tree = cKDTree(sheet(0.0, pitch=1.0))
    ray = looking_down(0.5, 0.5, radius=1e-3)
    assert nearest_to_ray(tree, ray) is None
    assert nearest_to_ray(tree, ray, least_radius=1.5) is not None


def test_nothing_is_met_beside_or_behind_the_eye() -> None:
    tree = cKDTree(sheet(0.0))
    assert nearest_to_ray(tree, looking_down(12.0, 0.0)) is None
    assert nearest_to_ray(tree, ViewRay(np.array([0.0, 0.0, -5.0]), DOWN, 1.0)) is None


def test_a_random_cloud_gives_what_looking_at_every_point_gives() -> None:
    random = np.random.default_rng(3)
    points = random.normal(size=(20000, 3)) * [30, 20, 10] + [1000, -2000, 500]
    tree = cKDTree(points)
    for _ in range(40):
        eye = points.mean(axis=0) + random.normal(size=3) * 60
        aim = points[random.integers(len(points))] + random.normal(size=3)
        ray = ViewRay(eye, (aim - eye) / np.linalg.norm(aim - eye), 0.2, 0.01)
        away = points - eye
        depth = away @ ray.direction
        distance = np.linalg.norm(np.cross(away, ray.direction), axis=1)
        meant = (depth >= 0) & (distance <= np.maximum(0.2 + 0.01 * depth, 0.5))
        score = np.where(meant, distance + DEPTH_SHARE * depth, np.inf)
        hit = nearest_to_ray(tree, ray, least_radius=0.5)
        assert (hit is None) == (not meant.any())
        if hit is not None:
            assert hit.index == int(np.argmin(score))


def test_of_two_clouds_the_front_one_is_meant() -> None:
    assert front_hit([None, Hit(0, 50.0, 0.0), Hit(0, 10.0, 0.1), None]) == 2
    assert front_hit([None, None]) is None


def test_of_several_lines_the_nearest_one_in_front_is_meant() -> None:
    from freecad_edgescan.gui.edge_picking import LinePicker

    down = np.array([0.0, 0.0, -1.0])
    lines = [
        np.array([[-5.0, 0.0, 0.0], [5.0, 0.0, 0.0]]),  # in front
        np.array([[-5.0, 0.0, -8.0], [5.0, 0.0, -8.0]]),  # right behind it
        np.array([[-5.0, 0.6, -1.0], [0.0, 0.6, -1.0], [0.0, 9.0, -1.0]]),
        np.array([[3.0, 3.0, -1.0]]),  # a point is no line
    ]
    picker = LinePicker(lines)

    def under(x: float, y: float, radius: float = 0.5) -> int | None:
        return picker.under(ViewRay(np.array([x, y, 10.0]), down, radius))

    assert under(2.0, 0.2) == 0
    assert under(-3.0, 0.5) == 2
    assert under(0.3, 6.0) == 2  # between two of its points
    assert under(3.0, 3.0) is None and under(-8.0, 0.0) is None
    assert picker.under(ViewRay(np.array([2.0, 0.0, -20.0]), down, 0.5)) is None  # all behind
    assert LinePicker().under(ViewRay(np.zeros(3), down, 1.0)) is None


def test_a_line_far_away_is_met_by_a_cone_that_has_widened_till_there() -> None:
    from freecad_edgescan.gui.edge_picking import LinePicker

    line = np.array([[-50.0, 1.0, -100.0], [50.0, 1.0, -100.0]])
    eye, down = np.zeros(3), np.array([0.0, 0.0, -1.0])
    assert LinePicker([line]).under(ViewRay(eye, down, 0.1, slope=0.02)) == 0
    assert LinePicker([line]).under(ViewRay(eye, down, 0.1)) is None
