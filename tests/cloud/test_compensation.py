# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compensated clouds lie on the true surface: no farther from it than their noise, on average 0."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
from scipy.spatial import cKDTree

import freecad_edgescan as es


def off_the_torus(face, points):
    """Distances of points from a face, positive on its centre's far side, mm."""
    ring = np.hypot(points[:, 0], points[:, 1]) - face.major_radius
    return np.hypot(ring, points[:, 2] - face.centre_height) - face.section_radius


def off_the_wall(pipe, points):
    """Heights of points above a half-pipe's wall (its deepest sphere), mm."""
    spheres = pipe.spine(np.linspace(pipe.spine.t[0], pipe.spine.t[-1], 20_001))
    centres = np.column_stack([spheres[:, :2], np.zeros(len(spheres))])
    near = cKDTree(centres).query(points)[1]
    rows = np.clip(near[:, None] + np.arange(-300, 301, 4), 0, len(spheres) - 1)
    away = np.linalg.norm(points[:, None] - centres[rows], axis=2)
    return (spheres[rows, 2] - away).max(axis=1)


PARTS = [
    es.TorusObject(40, 35, np.pi / 2, 0.0, 1.0),
    es.TorusObject(15, 35, np.deg2rad(120), 1.0, 1.5),
    es.TorusObject(20, 60, np.deg2rad(150), 2.0, 1.0),
]


@pytest.mark.parametrize("noise", [0.01, 0.06])
@pytest.mark.parametrize("part", PARTS)
def test_points_of_tori_come_to_the_true_tori(part, noise):
    cloud = part.cloud(0.25, 10.0, noise)
    surface = es.compensate_cloud(cloud)
    labels = cloud.labels[surface.kept]
    sharp = es.TorusObject(part.section_radius, part.edge_radius, part.angle, part.fillet_radius)
    for number, face in enumerate(sharp.faces(6.0)):
        off = off_the_torus(face, surface.points[labels == number])
        assert abs(off.mean()) < 0.1 * cloud.noise
        assert off.std() < 1.05 * cloud.noise and np.abs(off).max() < 5 * cloud.noise
    for number in (0, 1):
        assert surface.kept[cloud.labels == number].mean() > 0.99
    assert surface.probe_radius == 0.0


@pytest.mark.parametrize("rim_radius", [0.0, 1.0])
def test_points_of_the_core_box_come_to_its_plane_and_walls(rim_radius):
    box = es.CoreBox(rim_radius)
    cloud = box.cloud(1.0)
    surface = es.compensate_cloud(cloud)
    labels = cloud.labels[surface.kept]
    off = [surface.points[labels == 0][:, 2]]
    off += [
        off_the_wall(pipe, surface.points[labels == 1 + k][::7]) for k, pipe in enumerate(box.pipes)
    ]
    for face in off:
        assert abs(face.mean()) < 0.1 * cloud.noise
        assert np.std(face) < 1.05 * cloud.noise and np.abs(face).max() < 5 * cloud.noise
    for number in range(3):
        assert surface.kept[cloud.labels == number].mean() > 0.98


def test_the_probe_rolling_over_a_sharp_rim_is_left_out():
    box = es.CoreBox.small()
    cloud = box.cloud(0.25, noise=0.01)
    surface = es.compensate_cloud(cloud)
    rolling = cloud.labels >= 2
    assert surface.kept[rolling].mean() < 0.2
    # what is left of it lies on plane or wall within the noise, at the rim
    left = surface.points[rolling[surface.kept]]
    assert np.minimum(np.abs(left[:, 2]), np.abs(off_the_wall(box.pipes[0], left))).max() < 0.05
    assert cKDTree(np.vstack([edge.points for edge in box.edges])).query(left)[0].max() < 0.3
    assert "rolling over a rim" in surface.message


@pytest.mark.parametrize("noise", [0.0, 0.03])
def test_a_plane_comes_out_exact_wherever_it_lies(noise):
    rng = np.random.default_rng(0)
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    local = np.column_stack([rng.random((4000, 2)) * 25, 1.5 + noise * rng.normal(size=4000)])
    origin = np.array([1e6, -2e6, 5e5])
    cloud = es.PointCloud(local @ turn.T + origin, 1.5, -turn[:, 2])
    surface = es.compensate_cloud(cloud)
    height = (surface.points - origin) @ turn[:, 2]
    assert surface.kept.mean() > 0.99
    assert np.abs(height - (local[surface.kept, 2] - 1.5)).max() < max(1e-8, 0.2 * noise)


def test_without_an_approach_the_rims_tell_where_the_air_is():
    part = PARTS[0]
    cloud = part.cloud(0.25, 10.0, 0.02)
    known = es.compensate_cloud(cloud)
    blind = es.compensate_cloud(es.PointCloud(cloud.points, part.probe_radius))
    assert np.array_equal(known.kept, blind.kept)
    assert np.allclose(known.points, blind.points)


def test_the_side_of_the_air_is_never_guessed():
    flat = np.random.default_rng(0).random((2000, 3)) * [30, 30, 0]
    with pytest.raises(ValueError, match="Give the direction the probe came along"):
        es.compensate_cloud(es.PointCloud(flat, 1.0))


def test_surface_points_are_all_kept_as_they_are():
    cloud = es.PointCloud(np.random.default_rng(0).random((50, 3)))
    surface = es.compensate_cloud(cloud)
    assert surface.kept.all() and np.array_equal(surface.points, cloud.points)


def test_a_cloud_that_is_no_surface_is_refused():
    with pytest.raises(ValueError, match="holds 3 points"):
        es.compensate_cloud(es.PointCloud(np.eye(3), 1.0, (0, 0, -1)))
    with pytest.raises(ValueError, match="are equal"):
        es.compensate_cloud(es.PointCloud(np.ones((50, 3)), 1.0, (0, 0, -1)))


def test_a_part_of_a_cloud_goes_through_a_pickle_and_has_a_mask_that_fits():
    part = es.PartOfCloud(np.eye(3)[:2], [True, False, True])
    again = pickle.loads(pickle.dumps(part))
    assert np.array_equal(again.kept, part.kept) and np.array_equal(again.points, part.points)
    with pytest.raises(ValueError, match="mask keeps 1 points, but there are 2"):
        es.PartOfCloud(np.eye(3)[:2], [True, False, False])
