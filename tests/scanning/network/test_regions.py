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


def sheet(rng: np.random.Generator, size: float, height: float) -> np.ndarray:
    """Points of a level square, a jittered grid with noise."""
    x, y = np.meshgrid(*2 * [np.arange(0.0, size, PITCH)])
    flat = np.column_stack([x.ravel(), y.ravel()])
    flat += rng.uniform(-0.4 * PITCH, 0.4 * PITCH, flat.shape)
    return np.column_stack([flat, height + rng.normal(0.0, NOISE, len(flat))])


def test_the_two_faces_of_a_thin_wall_are_two_regions() -> None:
    """2.5 pitches apart: neighbours across the wall are nearer than some along it."""
    rng = np.random.default_rng(0)
    wall = [sheet(rng, 24.0, height) for height in (0.0, 2.5 * PITCH)]
    cloud = es.PointCloud(np.vstack([*wall, sheet(rng, 60.0, 30.0)]))
    regions = regions_between(cloud, [])
    assert len(regions) == 3
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
