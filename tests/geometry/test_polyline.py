# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distances to a polyline, against asking every segment."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from freecad_edgescan.geometry.polyline import distance_to_polyline


def by_asking_every_segment(points, vertices, closed):
    if closed:
        vertices = np.vstack([vertices, vertices[:1]])
    best = np.full(len(points), np.inf)
    for a, b in pairwise(vertices):
        square = (b - a) @ (b - a)
        share = np.clip((points - a) @ (b - a) / square, 0, 1) if square else np.zeros(len(points))
        best = np.minimum(best, np.linalg.norm(points - a - share[:, None] * (b - a), axis=1))
    return best


@pytest.mark.parametrize("closed", [False, True])
def test_every_distance_is_the_least_over_all_segments(closed):
    rng = np.random.default_rng(1)
    vertices = np.cumsum(rng.normal(size=(80, 3)) * rng.choice([0, 0.1, 1, 20], (80, 1)), axis=0)
    points = vertices[rng.integers(80, size=2000)] + rng.normal(size=(2000, 3)) * 10
    distance, index, fraction = distance_to_polyline(points, vertices, closed)
    assert np.allclose(distance, by_asking_every_segment(points, vertices, closed))
    ring = np.vstack([vertices, vertices[:1]])
    foot = ring[index] + fraction[:, None] * (ring[index + 1] - ring[index])
    assert np.allclose(np.linalg.norm(points - foot, axis=1), distance)


def test_centre_of_a_circle_is_one_radius_from_it():
    turn = np.linspace(0, 2 * np.pi, 3000, endpoint=False)
    circle = np.column_stack([np.cos(turn), np.sin(turn), 0 * turn])
    assert distance_to_polyline([[0, 0, 0]], circle, closed=True)[0][0] == pytest.approx(
        np.cos(np.pi / 3000)
    )


def test_one_vertex_is_a_polyline_of_no_length():
    distance, index, fraction = distance_to_polyline([[3, 4, 0]], [[0, 0, 0]])
    assert (distance[0], index[0], fraction[0]) == (5.0, 0, 0.0)


def test_no_points_have_no_distances():
    assert all(len(part) == 0 for part in distance_to_polyline(np.zeros((0, 3)), np.eye(3)))


def test_a_polyline_in_the_plane_is_measured_in_the_plane():
    assert distance_to_polyline([[1, 2]], [[0, 0], [3, 0]])[0][0] == 2.0
    with pytest.raises(ValueError, match="2 coordinates"):
        distance_to_polyline([[1, 2]], np.eye(3))
