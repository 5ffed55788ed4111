# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simulated clouds lie on the exact shape, as dense as asked, with the noise asked for."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.spatial import cKDTree

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402

V = FreeCAD.Vector


def drilled_plate() -> Any:
    """A plate 20 x 15 x 4 mm with a hole of radius 4."""
    return Part.makeBox(20, 15, 4).cut(Part.makeCylinder(4, 4, V(10, 7, 0)))


def test_points_lie_on_the_exact_faces_they_are_labelled_with() -> None:
    plate = drilled_plate()
    cloud = document.simulate_cloud(plate, 0.3, 0.0)
    for label, face in enumerate(plate.Faces):
        for point in cloud.points[cloud.labels == label][:20]:
            assert face.distToShape(Part.Vertex(*point))[0] < 0.01 * 0.3 + 1e-9
    hole = np.hypot(cloud.points[:, 0] - 10, cloud.points[:, 1] - 7)
    on_hole = [isinstance(face.Surface, Part.Cylinder) for face in plate.Faces].index(True)
    np.testing.assert_allclose(hole[cloud.labels == on_hole], 4.0, atol=1e-9)


def test_every_face_gets_one_point_for_each_pitch_squared() -> None:
    plate = drilled_plate()
    cloud = document.simulate_cloud(plate, 0.2, 0.0)
    for label, face in enumerate(plate.Faces):
        expected = face.Area / 0.2**2
        assert np.count_nonzero(cloud.labels == label) == pytest.approx(expected, rel=0.1)
    assert len(cloud) == pytest.approx(plate.Area / 0.2**2, rel=0.03)
    assert cloud.pitch == pytest.approx(0.2, rel=0.1)


def test_density_is_even_on_a_sphere_and_a_free_form_face() -> None:
    sphere = document.simulate_cloud(Part.makeSphere(10), 0.4, 0.0)
    np.testing.assert_allclose(np.linalg.norm(sphere.points, axis=1), 10.0, atol=1e-7)
    heights = np.sort(sphere.points[:, 2])  # by Archimedes evenly spread
    assert np.abs(heights - np.linspace(-10, 10, len(heights))).max() < 0.3
    flat = Part.BSplineSurface()
    poles = [[V(x * x, y, 0) for y in (0, 5, 10)] for x in (0, 1, 2, 4)]
    flat.buildFromPolesMultsKnots(poles, [4, 4], [3, 3], [0, 1], [0, 1], False, False, 3, 2)
    uneven = document.simulate_cloud(flat.toShape(), 0.2, 0.0)
    across = np.sort(uneven.points[:, 0])
    assert np.abs(across - np.linspace(0, 16, len(across))).max() < 0.3


def test_no_two_points_are_closer_than_half_a_pitch() -> None:
    cloud = document.simulate_cloud(drilled_plate(), 0.3, 0.0)
    nearest = cKDTree(cloud.points).query(cloud.points, k=2)[0][:, 1]
    assert nearest.min() >= 0.15


def test_noise_is_gaussian_along_the_normal() -> None:
    cloud = document.simulate_cloud(Part.makeCylinder(10, 20), 0.3, 0.05)
    wall = cloud.points[cloud.labels == 0]
    off = np.hypot(wall[:, 0], wall[:, 1]) - 10.0
    assert off.std() == pytest.approx(0.05, rel=0.05)
    assert abs(off.mean()) < 0.003
    assert cloud.noise == pytest.approx(0.05, rel=0.15)


def test_the_same_seed_gives_the_same_cloud() -> None:
    box = Part.makeBox(5, 5, 5)
    first, second, other = (document.simulate_cloud(box, 0.3, 0.02, seed=s) for s in (3, 3, 4))
    np.testing.assert_array_equal(first.points, second.points)
    assert len(first) != len(other) or not np.array_equal(first.points, other.points)


def test_a_ball_on_a_box_keeps_its_radius_from_faces_edges_and_corners() -> None:
    cloud = document.simulate_cloud(Part.makeBox(6, 5, 4), 0.2, 0.0, probe_radius=1.0)
    assert cloud.probe_radius == 1.0
    inside = np.clip(cloud.points, 0, (6, 5, 4))
    np.testing.assert_allclose(np.linalg.norm(cloud.points - inside, axis=1), 1.0, atol=2e-3)
    area = 148.0 + 4 * 15 * np.pi / 2 + 4 * np.pi  # faces, 12 quarter tubes, 8 eighths of a ball
    assert len(cloud) == pytest.approx(area / 0.2**2, rel=0.04)


def test_a_ball_does_not_reach_into_a_narrow_corner() -> None:
    step = Part.makeBox(10, 10, 2).fuse(Part.makeBox(5, 10, 6)).removeSplitter()
    cloud = document.simulate_cloud(step, 0.2, 0.0, probe_radius=1.0)
    x, y, z = cloud.points.T
    near = (y > 0) & (y < 10) & (x > 5.2) & (x < 8) & (z > 2.2) & (z < 5)
    assert np.count_nonzero(near) > 100
    assert x[near].min() > 6.0 - 0.03
    assert z[near].min() > 3.0 - 0.03


def test_a_ball_that_fits_nowhere_is_refused() -> None:
    ball = Part.makeSphere(3)
    ball.reverse()
    with pytest.raises(ValueError, match="radius 5 mm fits nowhere"):
        document.simulate_cloud(ball, 0.3, 0.0, probe_radius=5.0)


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ({"pitch": 0.0, "noise": 0.0}, "pitch is 0; give"),
        ({"pitch": 0.3, "noise": -1.0}, "noise is -1; give"),
        ({"pitch": 50.0, "noise": 0.0}, "pitch of 50 mm leaves only"),
        ({"pitch": 0.3, "noise": 0.0, "probe_radius": -2.0}, "probe radius is -2; give"),
    ],
)
def test_values_that_cannot_work_are_named(values: dict[str, float], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        document.simulate_cloud(Part.makeBox(5, 5, 5), **values)
