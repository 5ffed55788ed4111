# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces between edges: walls have two, and an edge that ends early parts them up to its corner."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import freecad_edgescan as es
from freecad_edgescan.experiments.regions_report import regions_report
from freecad_edgescan.scanning.network.regions import regions_between

from .test_find_edges import NOISE, PITCH, SIZE, box


@pytest.fixture(scope="module")
def network() -> es.EdgeNetwork:
    return es.find_edges(es.PointCloud(box()))


def face_of(points: np.ndarray) -> np.ndarray:
    """Number of the nearest of the box's six faces."""
    return np.abs(np.hstack([points, points - SIZE])).argmin(axis=1)


def test_the_two_faces_of_a_thin_wall_are_two_regions() -> None:
    """2.5 pitches apart: neighbours across the wall are nearer than some along it."""
    rng = np.random.default_rng(0)
    grid = np.stack(np.meshgrid(*2 * [np.arange(0.0, 30.0, PITCH)]), axis=-1).reshape(-1, 2)
    places = grid + rng.uniform(-0.4 * PITCH, 0.4 * PITCH, (2, *grid.shape))
    heights = np.array([[0.0], [2.5 * PITCH]]) + rng.normal(0.0, NOISE, places.shape[:2])
    cloud = es.PointCloud(np.concatenate([places, heights[..., None]], axis=2).reshape(-1, 3))
    regions = regions_between(cloud, [])
    assert len(regions) == 2
    for region in regions:
        assert np.ptp(cloud.points[region.mask, 2]) < 2.5 * PITCH


def test_edges_that_end_short_of_their_corner_part_its_faces_all_the_same(
    network: es.EdgeNetwork,
) -> None:
    pitch = network.cloud.pitch
    short = []
    for edge in network.edges:
        away = np.linalg.norm(edge.points[:, None] - edge.points[[0, -1]], axis=2).min(axis=1)
        kept = np.flatnonzero(away > 4.0 * pitch)
        part = slice(kept[0], kept[-1] + 1)
        cut = {
            name: getattr(edge, name)[part]
            for name in ("points", "tangents", "normals", "angle", "covariance", "overhang")
        }
        short.append(
            replace(edge, **cut, vertices=(None, None), stops=(es.Stop.CORNER, es.Stop.CORNER))
        )
    report = regions_report(regions_between(network.cloud, short), face_of(network.cloud.points))
    assert (report.regions, report.found) == (6, 6)


def test_faces_are_found_where_one_region_is_one_face(network: es.EdgeNetwork) -> None:
    labels = face_of(network.cloud.points)
    report = regions_report(network.regions, labels)
    assert (report.regions, report.faces, report.found, report.share) == (6, 6, 6, 1.0)
    merged = np.where(labels == 1, 0, labels)
    report = regions_report(network.regions, merged)
    assert (report.faces, report.found) == (5, 4)
    assert report.share == pytest.approx(np.mean(merged > 0))
