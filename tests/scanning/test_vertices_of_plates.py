# SPDX-License-Identifier: LGPL-2.1-or-later
"""Vertices of plates a few pitches thick: the end face is a strip, and the next face is near."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.scanning import scan_edge

LONG, WIDE = 30.0, 25.0


def plate(thick, noise, rng):
    """Noisy points of a plate's faces, one at random in each square of 1 mm."""
    sizes = np.array([LONG, WIDE, thick])
    faces = []
    for axis in range(3):
        others = [k for k in range(3) if k != axis]
        cells = np.stack(np.indices(sizes[others].astype(int)), axis=-1).reshape(-1, 2)
        for level in (0.0, sizes[axis]):
            points = np.empty((len(cells), 3))
            points[:, others] = cells + rng.random(cells.shape)
            points[:, axis] = level + rng.normal(0.0, noise, len(cells))
            faces.append(points)
    return np.vstack(faces)


@pytest.mark.parametrize("thick", [5.0, 7.0])
def test_their_errors_are_small_and_as_stated(thick):
    """A three-dimensional normal distribution: median 1.54, 95 % below 2.80."""
    along, in_sigmas = [], []
    for seed in range(10):
        rng = np.random.default_rng(seed)
        turned, moved = Rotation.random(random_state=seed).as_matrix(), rng.normal(size=3)
        cloud = PointCloud(plate(thick, 0.05, rng) @ turned.T + moved)
        edge = scan_edge(cloud, at=turned @ [0.5 * LONG, 0.1, thick] + moved)
        for vertex in edge.vertices:
            assert vertex is not None
            place, covariance = turned.T @ (vertex[0] - moved), turned.T @ vertex[1] @ turned
            off = place - [LONG if place[0] > 0.5 * LONG else 0.0, 0.0, thick]
            along.append(off[0] * np.sign(place[0] - 0.5 * LONG))
            in_sigmas.append(np.sqrt(off @ np.linalg.solve(covariance, off)))
    # The next face's points drew it 0.1 mm outwards.
    assert abs(np.mean(along)) < 0.04
    assert np.sqrt(np.mean(np.square(along))) < 0.07
    assert 1.1 < np.median(in_sigmas) < 2.0
    assert np.percentile(in_sigmas, 95) < 3.2


def test_a_click_that_finds_an_edge_far_from_it_is_told_how_far():
    cloud = PointCloud(plate(12.0, 0.05, np.random.default_rng(1)))
    near, beside = (scan_edge(cloud, at=(15.0, y, 12.0)) for y in (0.5, 4.0))
    assert "that was clicked" not in near.message
    assert "It is 4" in beside.message
    assert "mm from the place that was clicked." in beside.message
