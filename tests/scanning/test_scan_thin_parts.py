# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plates hardly thicker than the cloud's pitch: found rightly, or refused, never wrongly."""

import numpy as np
import pytest

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.scanning import ScanError, scan_edge

PITCH, NOISE = 0.28, 0.05
LENGTH, WIDTH = 50.0, 30.0


def plate(thickness, seed=1):
    """A cloud of all six faces of a plate with one corner at the origin."""
    rng = np.random.default_rng(seed)
    size = np.array([LENGTH, WIDTH, thickness])
    faces = []
    for across in range(3):
        area = np.prod(np.delete(size, across))
        for side in (0.0, size[across]):
            face = rng.uniform(0, size, (int(area / PITCH**2), 3))
            face[:, across] = side
            faces.append(face)
    points = np.vstack(faces)
    return PointCloud(points + rng.normal(0, NOISE, points.shape))


def error(edge, thickness):
    """Distance to the straight edge y = 0, z = thickness."""
    return np.hypot(edge.points[:, 1], edge.points[:, 2] - thickness)


@pytest.mark.parametrize("thickness", [1.5, 2.0, 3.0])
def test_the_edge_of_a_plate_of_a_few_pitches_is_found(thickness):
    edge = scan_edge(plate(thickness), (LENGTH / 2, 0, thickness))
    assert error(edge, thickness).mean() < NOISE
    assert np.ptp(edge.points[:, 0]) > 0.95 * LENGTH
    assert edge.overhang.max() < 3 * PITCH
    assert "outside the points" not in edge.message


@pytest.mark.parametrize(
    ("thickness", "seed"),
    [
        *((thickness, 1) for thickness in (0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2)),
        *((0.8, 6), (0.9, 2), (1.0, 5), (1.0, 6), (1.0, 9)),
    ],
)
def test_the_two_faces_of_a_thin_plate_are_not_bent_into_an_edge(thickness, seed):
    try:
        edge = scan_edge(plate(thickness, seed), (LENGTH / 2, 0, thickness))
    except ScanError:
        return
    assert np.median(error(edge, thickness)) < 3 * np.median(edge.sigma)


def test_an_edge_far_outside_its_points_says_so(wedge):
    part = wedge(60.0, rounding=2.0, width=16.0)
    edge = scan_edge(part.cloud, part.at(0.1, 0.3))
    assert edge.overhang == pytest.approx(np.full(len(edge), 2.0), abs=0.3)
    assert "mm outside the points" in edge.message
