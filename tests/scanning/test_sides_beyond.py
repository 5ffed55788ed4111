# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sides of an edge end at it: what meets only when it is drawn out through a wall is none."""

from __future__ import annotations

import numpy as np
import pytest

import freecad_edgescan as es
from freecad_edgescan.scanning.automatic import choose_parameters
from freecad_edgescan.scanning.parameters import ScanParameters
from freecad_edgescan.scanning.sides_beyond import sides_beyond

from .network.test_one_edge import LENGTH, NOISE, PITCH, WIDTH, wedge

RADIUS, DEPTH = 20.0 * PITCH, 11.0 * PITCH


@pytest.fixture(scope="module")
def edge() -> es.ScannedEdge:
    (edge,) = es.find_edges(wedge(), jobs=1).edges
    return edge


def floor_behind(first: float, last: float, gap: float, seed: int = 1) -> np.ndarray:
    """Points of the wedge's floor behind its edge, which runs along x: from a gap on."""
    rng = np.random.default_rng(seed)
    count = int((last - first) * (WIDTH - gap) / PITCH**2)
    x, y = rng.uniform([first, gap], [last, WIDTH], (count, 2)).T
    return np.column_stack([x, -y, rng.normal(0.0, NOISE, count)])


def beyond(edge: es.ScannedEdge, *more: np.ndarray) -> np.ndarray:
    cloud = es.PointCloud(np.vstack([wedge().points, *more]))
    settings = choose_parameters(wedge(), edge.points[0], ScanParameters(), 0.26).settings
    return sides_beyond(edge, cloud, settings)


def test_both_sides_of_an_edge_end_at_it(edge):
    assert not beyond(edge).any()


def test_a_side_that_goes_on_is_seen_all_along(edge):
    assert beyond(edge, floor_behind(0.0, LENGTH, 0.0)).all()


def test_a_side_that_goes_on_for_a_while_is_seen_there(edge):
    marked = beyond(edge, floor_behind(20.0, LENGTH, 0.0))
    x = edge.points[:, 0]
    assert marked[x > 20.0 + 5.0 * PITCH].all() and not marked[x < 20.0 - 5.0 * PITCH].any()


def test_the_same_surface_behind_a_wall_is_another_one(edge):
    assert not beyond(edge, floor_behind(0.0, LENGTH, 2.0 * PITCH)).any()


def bore_beside_a_face(thickness: float, seed: int) -> es.PointCloud:
    """A blind bore behind a level face, the wall between them of some pitches where it is thinnest.

    The face is y = 0 and the bore's floor z = 0; the rim between floor and bore is the only edge.
    """
    rng = np.random.default_rng(seed)
    noise = 0.2 * PITCH
    width, height = 70.0 * PITCH, 31.0 * PITCH
    count = int(width * height / PITCH**2)
    x, z = rng.uniform(0.0, 1.0, (2, count))
    face = np.column_stack(
        [(x - 0.5) * width, rng.normal(0.0, noise, count), z * height - height + DEPTH]
    )
    count = int(np.pi * RADIUS**2 / PITCH**2)
    radius = RADIUS * np.sqrt(rng.uniform(0.0, 1.0, count))
    angle = rng.uniform(0.0, 2.0 * np.pi, count)
    flat = rng.normal(0.0, noise, count)
    floor = np.column_stack([radius * np.cos(angle), radius * np.sin(angle), flat])
    count = int(2.0 * np.pi * RADIUS * DEPTH / PITCH**2)
    angle, radius = rng.uniform(0.0, 2.0 * np.pi, count), RADIUS + rng.normal(0.0, noise, count)
    up = rng.uniform(0.0, DEPTH, count)
    bore = np.column_stack([radius * np.cos(angle), radius * np.sin(angle), up])
    centre = np.array([0.0, RADIUS + thickness * PITCH, 0.0])
    return es.PointCloud(np.vstack([face, floor + centre, bore + centre]))


@pytest.mark.parametrize("thickness", [2.0, 2.7, 4.0])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_through_a_thin_wall_no_face_meets_the_floor_behind_it(thickness, seed):
    network = es.find_edges(bore_beside_a_face(thickness, seed), jobs=1)
    points = np.vstack([edge.points for edge in network.edges])
    away = np.hypot(points[:, 0], points[:, 1] - RADIUS - thickness * PITCH) - RADIUS
    assert np.hypot(away, points[:, 2]).max() < PITCH
    assert sum(edge.length for edge in network.edges) > 0.9 * 2.0 * np.pi * RADIUS
