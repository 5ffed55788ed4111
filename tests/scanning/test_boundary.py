# SPDX-License-Identifier: LGPL-2.1-or-later
"""Vertices of a box, and the edges round its faces, beside the box itself."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.scanning import ScanError, ScannedEdge, Stop, scan_boundary, scan_edge

SIZE = np.array([20.0, 16.0, 12.0])  # mm
PITCH, NOISE = 0.5, 0.02


def grid(rng, a, b):
    """One point at random in each cell of a rectangle, (n, 2) mm."""
    n, m = round(a / PITCH), round(b / PITCH)
    i, j = np.indices((n, m)).reshape(2, -1)
    return (np.stack([i, j], axis=1) + rng.random((n * m, 2))) * [a / n, b / m]


def turned(seed):
    return Rotation.random(random_state=seed).as_matrix()


@cache
def box(seed, without=None, slanted=0.0, noise=NOISE):
    """A box in the first octant, turned; `slanted` moves its top edge in, mm; one face may lack."""
    rng = np.random.default_rng([seed, 5])
    faces = []
    for axis in range(3):
        for end in (0, 1):
            if (axis, end) == without:
                continue
            flat = np.zeros((0, 3))
            others = [k for k in range(3) if k != axis]
            at = grid(rng, *SIZE[others])
            flat = np.zeros((len(at), 3))
            flat[:, others], flat[:, axis] = at, end * SIZE[axis]
            flat[:, axis] += noise * rng.normal(size=len(at))
            faces.append(flat)
    points = np.vstack(faces)
    points[:, 0] *= 1.0 - slanted / SIZE[0] * points[:, 2] / SIZE[2]
    return PointCloud(points @ turned(seed).T + [4.0, -7.0, 2.0])


def place(seed, *xyz):
    return np.array(xyz, dtype=float) @ turned(seed).T + [4.0, -7.0, 2.0]


EDGES = [  # middle, start, end
    ((10, 0, 0), (0, 0, 0), (20, 0, 0)),
    ((0, 8, 12), (0, 0, 12), (0, 16, 12)),
    ((20, 16, 6), (20, 16, 0), (20, 16, 12)),
]


def ends(edge: ScannedEdge, seed, *corners):
    """For each known vertex its offset from the nearest corner (3,) mm, with its covariance."""
    true = np.array([place(seed, *corner) for corner in corners])
    for vertex in edge.vertices:
        assert vertex is not None
        off = vertex[0] - true
        yield off[np.linalg.norm(off, axis=1).argmin()], vertex[1]


def test_vertices_are_where_the_faces_meet_and_as_well_known_as_they_say():
    off, distance = [], []
    for seed in range(6):
        for middle, *corners in EDGES:
            edge = scan_edge(box(seed), at=place(seed, *middle))
            assert edge.stops == (Stop.CORNER, Stop.CORNER)
            for error, covariance in ends(edge, seed, *corners):
                off.append(np.linalg.norm(error))
                distance.append(np.sqrt(error @ np.linalg.solve(covariance, error)))
            length = float(np.linalg.norm(np.subtract(*corners)))
            # Both ends within three pitches, and none of them beyond its vertex.
            assert length - 6.0 * PITCH < edge.length < length + 0.1
    assert len(off) == 36
    assert np.sqrt(np.mean(np.square(off))) < 1.5 * NOISE
    assert max(off) < 5.0 * NOISE
    # Of three dimensions: median 1.54, 95 % below 2.80.
    assert 1.1 < np.median(distance) < 2.0
    assert np.quantile(distance, 0.95) < 3.6


def test_edges_end_within_a_pitch_of_their_vertices_in_much_noise_too():
    """In noise of a fifth of a pitch the last steps of a walk scatter, and bend it."""
    short = []
    for seed in range(6):
        for middle, *corners in EDGES:
            edge = scan_edge(box(seed, noise=0.2 * PITCH), at=place(seed, *middle))
            true = np.array([place(seed, *corner) for corner in corners])
            for end in edge.points[[0, -1]]:
                short.append(np.linalg.norm(true - end, axis=1).min())
    assert max(short) < PITCH


def test_where_the_cloud_ends_there_is_no_vertex():
    edge = scan_edge(box(1, without=(0, 1)), at=place(1, 10, 0, 0))
    at_end = [np.linalg.norm(point - place(1, 20, 0, 0)) < 3.0 for point in edge.points[[0, -1]]]
    assert sorted(at_end) == [False, True]
    for stop, vertex, third, here in zip(
        edge.stops, edge.vertices, edge.third_normals, at_end, strict=True
    ):
        assert stop is (Stop.CLOUD_END if here else Stop.CORNER)
        assert (vertex is None) == here
        assert (third is None) == here


def test_the_third_surface_is_the_slanted_one():
    slope = 6.0
    edge = scan_edge(box(2, slanted=slope), at=place(2, 8, 0, 12))
    slanted = turned(2) @ (np.array([SIZE[2], 0.0, slope]) / np.hypot(SIZE[2], slope))
    upright = turned(2) @ [1.0, 0.0, 0.0]
    for (vertex, _), third in zip(edge.vertices, edge.third_normals, strict=True):
        far = np.linalg.norm(vertex - place(2, 20.0 - slope, 0, 12)) < 1.0
        assert abs(third @ (slanted if far else upright)) > np.cos(0.02)
        assert np.linalg.norm(vertex - place(2, (20.0 - slope) * far, 0, 12)) < 5.0 * NOISE


FACES = [(axis, end) for axis in range(3) for end in (0, 1)]


@pytest.mark.parametrize(("axis", "end"), FACES)
def test_a_face_has_four_edges_in_order_that_share_their_vertices(axis, end):
    seed, inside = 3, SIZE / 2
    inside[axis] = end * SIZE[axis]
    first, _ = (k for k in range(3) if k != axis)
    click = inside.copy()
    click[first] = 0.0
    edges = scan_boundary(box(seed), place(seed, *click), place(seed, *inside))
    assert len(edges) == 4
    corners = []
    for edge, following in zip(edges, [*edges[1:], edges[0]], strict=True):
        (here, covariance), (there, _) = edge.vertices[1], following.vertices[0]
        assert here == pytest.approx(there)
        assert np.all(np.linalg.eigvalsh(covariance) > 0.0)
        # The next edge leaves where this one has come to.
        assert np.linalg.norm(edge.points[-1] - here) < 3.0 * PITCH
        assert np.linalg.norm(following.points[0] - here) < 3.0 * PITCH
        way = edge.vertices[1][0] - edge.vertices[0][0]
        assert edge.tangents @ (way / np.linalg.norm(way)) == pytest.approx(1.0, abs=0.01)
        corners.append((here - [4.0, -7.0, 2.0]) @ turned(seed))
    true = np.rint(np.array(corners) / SIZE)
    assert np.abs(corners - true * SIZE).max() < 5.0 * NOISE
    assert len({tuple(corner) for corner in true}) == 4
    assert set(true[:, axis]) == {float(end)}


def test_an_open_boundary_has_the_edges_that_can_be_followed():
    """Without one wall the top has three edges, from one end of the cloud to the other."""
    seed = 1
    edges = scan_boundary(box(seed, without=(0, 1)), place(seed, 10, 0, 12), place(seed, 10, 8, 12))
    assert len(edges) == 3
    assert edges[0].stops[0] is Stop.CLOUD_END
    assert edges[-1].stops[1] is Stop.CLOUD_END
    assert edges[0].vertices[0] is None
    assert edges[-1].vertices[1] is None
    middle = (edges[1].points.mean(axis=0) - [4.0, -7.0, 2.0]) @ turned(seed)
    assert middle == pytest.approx([0.0, 8.0, 12.0], abs=1.0)


@pytest.mark.parametrize(
    ("inside", "words"),
    [((0.0, np.nan, 1.0), "three finite coordinates"), ((0.0, 900.0, 0.0), "nearest point")],
)
def test_the_place_inside_must_be_one_on_the_cloud(inside, words):
    with pytest.raises(ScanError, match=words):
        scan_boundary(box(1), place(1, 10, 0, 12), inside)


class Until:
    """Cancels when it is told so many times, and goes on saying so."""

    def __init__(self, times) -> None:
        self.times, self.told = times, 0

    def update(self, fraction: float, so_far: object) -> bool:
        self.told += 1
        return self.told < self.times


@pytest.mark.parametrize("times", [1, 2, 4, 8])
def test_a_cancelled_boundary_keeps_what_was_found_and_looks_no_further(times):
    progress = Until(times)
    edges = scan_boundary(box(3), place(3, 10, 0, 12), place(3, 10, 8, 12), progress=progress)
    # Who has cancelled is not asked again, whichever edge it was in.
    assert progress.told == times
    assert 1 <= len(edges) <= (times + 3) // 2
    assert len(edges[0]) >= 1
    first = Until(1000)
    scan_edge(box(3), place(3, 10, 0, 12), progress=first)
    if times > first.told:
        whole = scan_boundary(box(3), place(3, 10, 0, 12), place(3, 10, 8, 12))
        assert edges[0].points == pytest.approx(whole[0].points)


def test_a_reversed_edge_is_the_same_edge():
    edge = scan_edge(box(3), at=place(3, 10, 0, 12))
    back = edge.reversed()
    assert back.points == pytest.approx(edge.points[::-1])
    assert back.tangents == pytest.approx(-edge.tangents[::-1])
    assert back.sides == pytest.approx(edge.sides[::-1])
    assert back.covariance_3d == pytest.approx(edge.covariance_3d[::-1])
    assert back.vertices[0] is edge.vertices[1]
    for j in range(len(edge)):
        one, other = edge.scan_lines[j], back.scan_lines[len(edge) - 1 - j]
        assert len(one.points) == len(other.points)
        assert np.sort(one.points[:, 1]) == pytest.approx(np.sort(other.points[:, 1]))
        assert one.removed.sum() == other.removed.sum()


def test_sides_lead_away_from_the_edge():
    edge = scan_edge(box(3), at=place(3, 10, 0, 12))
    expected = [turned(3) @ side for side in ([0.0, 1.0, 0.0], [0.0, 0.0, -1.0])]
    for sides in edge.sides:
        alike = sides @ np.array(expected).T
        assert alike.max(axis=1) == pytest.approx(1.0, abs=0.01)
        assert set(alike.argmax(axis=1)) == {0, 1}


@pytest.mark.parametrize("inside", [(10, 8, 0), (10, 16, 6), (3, 8, 0), (0, 8, 6), (10, 1, 0)])
def test_a_place_on_a_face_that_the_edge_does_not_bound_is_refused(inside):
    """Not taken for one on the face that lies more in its direction."""
    with pytest.raises(ScanError, match="does not bound; give a place on one of the two faces"):
        scan_boundary(box(3), place(3, 10, 0, 12), place(3, *inside))


def plate(thickness, hole=None):
    """A plate of 40 by 24 mm, its top in z = 0; of its top a strip of some width may lack, mm."""
    rng = np.random.default_rng(8)
    parts = []
    for z in (0.0, -thickness):
        at = grid(rng, 40.0, 24.0)
        if hole is not None and z == 0.0:
            at = at[np.abs(at[:, 1] - 8.0) > 0.5 * hole]
        parts.append(np.column_stack([at, np.full(len(at), z)]))
    for y in (0.0, 24.0):
        at = grid(rng, 40.0, thickness)
        parts.append(np.column_stack([at[:, 0], np.full(len(at), y), -at[:, 1]]))
    for x in (0.0, 40.0):
        at = grid(rng, 24.0, thickness)
        parts.append(np.column_stack([np.full(len(at), x), at[:, 0], -at[:, 1]]))
    points = np.vstack(parts)
    return PointCloud(points + NOISE * rng.normal(size=points.shape))


@pytest.mark.parametrize("inside", [(20, 12, -2), (20, 2, -2), (20, 22, -2)])
def test_a_place_on_the_other_side_of_a_thin_plate_is_refused(inside):
    with pytest.raises(ScanError, match="does not bound"):
        scan_boundary(plate(2.0), (20, 0, 0), inside)


def test_a_place_beyond_a_gap_in_the_face_is_on_it():
    edges = scan_boundary(plate(4.0, hole=5.0), (20, 0, 0), (20, 16, 0))
    assert np.abs(np.vstack([edge.points for edge in edges])[:, 2]).max() < 0.1


@pytest.mark.parametrize("share", [0.3, 0.6, 0.95])
def test_a_place_anywhere_on_a_bent_face_is_on_it(share):
    """Half a cylinder on a plane: at its far edge it has turned by 180 degrees."""
    rng = np.random.default_rng(9)
    round_, flat = grid(rng, 40.0, 12.0 * np.pi), grid(rng, 40.0, 24.0)
    turn = round_[:, 1] / 12.0
    points = np.vstack(
        [
            np.column_stack([round_[:, 0], -12.0 * np.cos(turn), 12.0 * np.sin(turn)]),
            np.column_stack([flat[:, 0], flat[:, 1] - 12.0, np.zeros(len(flat))]),
        ]
    )
    cloud = PointCloud(points + NOISE * rng.normal(size=points.shape))
    at = np.pi * share
    edges = scan_boundary(cloud, (20, -12, 0), (20, -12 * np.cos(at), 12 * np.sin(at)))
    assert len(edges) == 1
