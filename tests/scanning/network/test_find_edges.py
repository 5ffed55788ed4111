# SPDX-License-Identifier: LGPL-2.1-or-later
"""All edges of known clouds, found without a click."""

from __future__ import annotations

import numpy as np
import pytest

import freecad_edgescan as es

PITCH, NOISE = 0.5, 0.1
SIZE = np.array([24.0, 18.0, 12.0])


def face(rng, axis, level, pitch=PITCH):
    """Points strewn over one face of the box, one for each pitch²."""
    others = [k for k in range(3) if k != axis]
    count = int(np.prod(SIZE[others]) / pitch**2)
    points = np.zeros((count, 3))
    points[:, others] = rng.uniform(0.0, 1.0, (count, 2)) * SIZE[others]
    points[:, axis] = level + rng.normal(0.0, NOISE * pitch / PITCH, count)
    return points


def box(seed=0, pitch=PITCH):
    rng = np.random.default_rng(seed)
    return np.vstack([face(rng, k, level, pitch) for k in range(3) for level in (0.0, SIZE[k])])


def true_corners():
    return np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]) * SIZE


def off_the_box(points):
    """Distance of points from the nearest edge of the box."""
    away = np.minimum(np.abs(points), np.abs(points - SIZE))
    return np.hypot(*np.sort(away, axis=1)[:, :2].T)


def sphere(rng, count, radius):
    normals = rng.normal(size=(count, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    return normals * radius, normals


def smooth_part(kind, seed):
    """Points of a surface without an edge, a fifth of the pitch of noise along the normal."""
    rng = np.random.default_rng(seed)
    pitch = 0.5
    if kind == "sphere":
        points, normals = sphere(rng, int(4 * np.pi * 9.0**2 / pitch**2), 9.0)
    elif kind == "torus":
        major, minor = 11.0, 4.0
        u, v, share = rng.uniform(0, 1, (3, 3 * int(4 * np.pi**2 * major * minor / pitch**2)))
        u, v = 2 * np.pi * u, 2 * np.pi * v
        kept = share < (major + minor * np.cos(v)) / (major + minor)
        u, v = u[kept][: len(u) // 3], v[kept][: len(u) // 3]
        normals = np.column_stack([np.cos(u) * np.cos(v), np.sin(u) * np.cos(v), np.sin(v)])
        points = major * np.column_stack([np.cos(u), np.sin(u), 0 * u]) + minor * normals
    else:
        x, y = rng.uniform(-15, 15, (2, int(30 * 30 / pitch**2)))
        points = np.column_stack([x, y, 2 * np.sin(x / 6) * np.cos(y / 8)])
        normals = np.column_stack(
            [-np.cos(x / 6) * np.cos(y / 8) / 3, np.sin(x / 6) * np.sin(y / 8) / 4, np.ones_like(x)]
        )
        normals /= np.linalg.norm(normals, axis=1)[:, None]
    return es.PointCloud(points + normals * rng.normal(0, 0.2 * pitch, len(points))[:, None])


@pytest.fixture(scope="module")
def network():
    return es.find_edges(es.PointCloud(box()))


def test_a_box_has_twelve_edges_that_meet_in_eight_corners(network):
    assert len(network) == 12 and len(network.corners) == 8
    lengths = [
        np.linalg.norm(np.diff(edge.vertex_to_vertex[[0, -1]], axis=0)) for edge in network.edges
    ]
    assert sum(lengths) == pytest.approx(4 * SIZE.sum(), rel=0.01)
    assert off_the_box(np.vstack([edge.points for edge in network.edges])).max() < PITCH
    assert all(isinstance(end, int) for ends in network.ends for end in ends)
    assert all(len(network.edges_at(corner)) == 3 for corner in range(8))


def test_corners_lie_within_half_a_pitch_and_within_what_is_stated(network):
    apart = np.linalg.norm(network.corners[:, None] - true_corners(), axis=2)
    assert apart.min(axis=1).max() < 0.5 * PITCH
    assert len(set(apart.argmin(axis=1))) == 8
    residual = network.corners - true_corners()[apart.argmin(axis=1)]
    inside = np.einsum("ki,kij,kj->k", residual, np.linalg.inv(network.corner_covariance), residual)
    assert np.median(inside) < 7.8  # 95 % of chi-square with three degrees of freedom


def test_edges_end_in_the_corner_they_share(network):
    for edge, ends in zip(network.edges, network.ends, strict=True):
        for vertex, end in zip(edge.vertices, ends, strict=True):
            assert np.array_equal(vertex[0], network.corners[end])


def test_the_regions_of_a_box_are_its_six_faces_with_four_edges_each(network):
    regions = network.regions
    assert len(regions) == 6
    assert all(len(region.edges) == 4 for region in regions)
    points = network.cloud.points
    for region in regions:
        spread = np.std(points[region.mask], axis=0)
        assert spread.min() < 2.0 * NOISE
    assert sum(len(region) for region in regions) > 0.98 * len(points)


def test_filters_need_no_new_scan(network):
    long = network.filtered(min_length=15.0)
    assert len(long) == 8
    # The corners stay where all twelve edges have told.
    assert {tuple(corner) for corner in long.corners} <= {tuple(c) for c in network.corners}
    for edge, ends in zip(long.edges, long.ends, strict=True):
        for vertex, end in zip(edge.vertices, ends, strict=True):
            assert np.array_equal(vertex[0], long.corners[end])
    assert len(network.filtered(min_angle=np.radians(100.0))) == 0
    assert len(network.filtered(keep=lambda edge: abs(edge.tangents[0, 0]) > 0.9)) == 4


SMOOTH = {"sphere": 10, "torus": 5, "freeform": 10}  # clouds of each


@pytest.mark.parametrize(
    ("kind", "seed"), [(kind, seed) for kind, count in SMOOTH.items() for seed in range(count)]
)
def test_on_a_smooth_part_nothing_is_found(kind, seed):
    network = es.find_edges(smooth_part(kind, seed))
    assert len(network) == 0 and "No edge was found" in network.message


def test_the_rim_of_a_cylinder_is_one_closed_edge():
    rng = np.random.default_rng(0)
    count = int(np.pi * 15.0**2 / PITCH**2)
    angle, radius = rng.uniform(0, 2 * np.pi, count), 15.0 * np.sqrt(rng.uniform(0, 1, count))
    disc = np.column_stack([radius * np.cos(angle), radius * np.sin(angle), np.zeros(count)])
    disc[:, 2] += rng.normal(0, NOISE, count)
    count = int(2 * np.pi * 15.0 * 12.0 / PITCH**2)
    angle, r = rng.uniform(0, 2 * np.pi, count), 15.0 + rng.normal(0, NOISE, count)
    wall = np.column_stack([r * np.cos(angle), r * np.sin(angle), -rng.uniform(0, 12, count)])
    network = es.find_edges(es.PointCloud(np.vstack([disc, wall])))
    (edge,) = network.edges
    assert edge.closed and len(network.corners) == 0
    off = np.hypot(np.hypot(*edge.points[:, :2].T) - 15.0, edge.points[:, 2])
    assert np.sqrt(np.mean(off**2)) < 0.5 * NOISE


class Cancelling:
    """Says no after some edges."""

    def __init__(self, after):
        self.after, self.told = after, []

    def update(self, fraction, so_far):
        self.told.append(fraction)
        return len(so_far) < self.after


def test_cancelled_half_way_the_edges_so_far_are_kept():
    progress = Cancelling(4)
    network = es.find_edges(es.PointCloud(box()), progress=progress)
    assert network.cancelled and 4 <= len(network) < 12
    assert "cancelled" in network.message and "kept" in network.message
    assert progress.told == sorted(progress.told)


def test_a_region_of_interest_is_all_that_is_searched():
    network = es.find_edges(es.PointCloud(box()), region=((-1, -1, -1), (11, 30, 30)))
    assert len(network) > 0 and max(edge.points[:, 0].max() for edge in network.edges) < 12.0


def test_an_empty_region_is_one_sentence():
    with pytest.raises(es.ScanError, match=r"reaches from .* Take a region that overlaps"):
        es.find_edges(es.PointCloud(box()), region=((90, 90, 90), (91, 91, 91)))


@pytest.mark.parametrize("wrong", [{"min_angle": 0.0}, {"min_length": -1.0}, {"region": 3}])
def test_wrong_numbers_are_one_sentence(wrong):
    with pytest.raises(es.ScanError, match=r"[Gg]ive"):
        es.find_edges(es.PointCloud(box()), **wrong)


def test_pure_noise_has_no_edges_and_says_why():
    rng = np.random.default_rng(0)
    network = es.find_edges(es.PointCloud(rng.uniform(0, 10, (20000, 3))))
    assert len(network) == 0 and "scatter" in network.message


def test_a_lattice_has_no_edges():
    grid = np.stack(np.meshgrid(*3 * [np.arange(24.0)], indexing="ij"), axis=-1).reshape(-1, 3)
    assert len(es.find_edges(es.PointCloud(grid))) == 0


def test_two_scans_that_do_not_match_do_not_double_the_edges():
    points = np.vstack([box(0), box(1) + 3.0 * PITCH * np.array([0.6, 0.6, 0.52])])
    network = es.find_edges(es.PointCloud(points))
    assert network.message
    for edge in network.edges:  # what is found is near an edge of the one or the other
        one = off_the_box(edge.points)
        other = off_the_box(edge.points - 3.0 * PITCH * np.array([0.6, 0.6, 0.52]))
        assert min(np.median(one), np.median(other)) < 2.0 * PITCH
