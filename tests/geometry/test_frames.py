# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frames and curvature along helices and circles, whose truth is known."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.geometry.frames import (
    curvature_of_polyline,
    curvature_of_three_points,
    orthonormalise,
    rotate,
    rotation_minimising_frames,
)


def helix(turns, count, radius=10.0, climb=3.0):
    """Points, tangents and curvature vectors; climb is the height per radian."""
    a = np.linspace(0, 2 * np.pi * turns, count)
    points = np.column_stack([radius * np.cos(a), radius * np.sin(a), climb * a])
    tangents = np.column_stack([-radius * np.sin(a), radius * np.cos(a), climb + 0 * a])
    tangents /= np.hypot(radius, climb)
    inward = -np.column_stack([np.cos(a), np.sin(a), 0 * a])
    return points, tangents, inward * radius / (radius**2 + climb**2)


def test_a_quarter_turn_about_z_takes_x_to_y():
    assert np.allclose(rotate([[1, 0, 5]], [0, 0, 1], [np.pi / 2]), [[0, 1, 5]])


def test_orthonormalised_vectors_are_perpendicular_even_where_nothing_remains():
    t = np.array([[1.0, 0, 0], [0, 0, 1.0], [0.6, 0.8, 0]])
    v = orthonormalise(t, [[2.0, 2, 0], [0, 0, 3.0], [0, 0, 0]])
    assert np.allclose(v[0], [0, 1, 0])
    assert np.allclose(np.sum(t * v, axis=1), 0) and np.allclose(np.linalg.norm(v, axis=1), 1)


def test_frames_along_a_helix_turn_back_by_its_torsion():
    points, tangents, bend = helix(2, 400)
    normal = bend / np.linalg.norm(bend, axis=1)[:, None]
    frames = rotation_minimising_frames(points, tangents, normal[0])
    binormal = np.cross(tangents, normal)
    turned = np.unwrap(
        np.arctan2(np.sum(frames[:, 1] * binormal, axis=1), np.sum(frames[:, 1] * normal, axis=1))
    )
    torsion_times_length = 3.0 / np.hypot(10, 3) * 2 * np.pi * 2
    assert turned[-1] == pytest.approx(-torsion_times_length, abs=1e-4)


def test_frames_are_right_handed_and_survive_repeated_points():
    points, tangents, _ = helix(1, 50)
    twice = np.repeat(np.arange(50), 2)
    frames = rotation_minimising_frames(points[twice], tangents[twice])
    assert np.allclose(frames @ np.swapaxes(frames, 1, 2), np.eye(3))
    assert np.allclose(np.linalg.det(frames), 1)
    assert np.allclose(frames[::2], frames[1::2])


def test_frames_along_a_straight_line_do_not_turn():
    points = np.outer(np.arange(5.0), [1, 2, 2])
    frames = rotation_minimising_frames(points, np.tile([1 / 3, 2 / 3, 2 / 3], (5, 1)))
    assert np.allclose(frames, frames[0])


def test_three_points_of_a_circle_give_its_centre():
    a = np.array([0.1, 0.7, 2.0])
    p = 4.0 * np.column_stack([np.cos(a), np.sin(a), 0 * a])
    bend = curvature_of_three_points(*p)
    assert np.allclose(p[1] + bend / (bend @ bend), 0)
    assert np.allclose(curvature_of_three_points([0, 0, 0], [1, 1, 1], [3, 3, 3]), 0)


@pytest.mark.parametrize("closed", [False, True])
def test_curvature_of_a_noisy_circle_is_found(closed):
    rng = np.random.default_rng(1)
    a = np.linspace(0, 2 * np.pi, 120, endpoint=False)
    p = 20 * np.column_stack([np.cos(a), np.sin(a), 0 * a]) + rng.normal(size=(120, 3)) * 0.005
    tangents, bend = curvature_of_polyline(p, reach=7, closed=closed)
    assert np.abs(np.sum(tangents * bend, axis=1)).max() < 1e-12
    ends = slice(None) if closed else slice(7, -7)
    assert np.allclose(np.linalg.norm(bend, axis=1)[ends], 1 / 20, rtol=0.1)
    assert np.abs(np.sum(tangents * p, axis=1) / 20)[ends].max() < 0.01


def test_curvature_of_two_points_is_refused():
    with pytest.raises(ValueError, match="at least 3 points, not 2"):
        curvature_of_polyline(np.eye(3)[:2])
