# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed rims, edges that end in corners, and edges that bend."""

import numpy as np
import pytest

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.geometry import Circle
from freecad_edgescan.scanning import ScanParameters, Stop, scan_edge

NOISE = 0.02


@pytest.fixture(scope="module")
def rim(can):
    part = can()
    return part, scan_edge(part.cloud, part.on_rim(1.0))


def test_the_rim_of_a_cylinder_is_closed(rim):
    part, edge = rim
    assert edge.closed
    assert edge.stops == (Stop.CLOSED, Stop.CLOSED)
    assert part.distance(edge.points).max() < 4 * NOISE
    assert edge.length == pytest.approx(2 * np.pi * part.radius, rel=0.01)
    steps = np.linalg.norm(np.roll(edge.points, -1, axis=0) - edge.points, axis=1)
    assert steps == pytest.approx(np.full(len(edge), steps.mean()), rel=0.15)
    assert "closed" in edge.message


def test_the_rim_of_a_cylinder_is_a_circle(rim):
    part, edge = rim
    assert isinstance(edge.circle, Circle)
    assert edge.line is None
    assert edge.circle.radius == pytest.approx(part.radius, abs=NOISE)
    assert edge.circle.centre == pytest.approx(part.centre, abs=NOISE)
    assert abs(edge.circle.axis @ part.axis) > 1 - 1e-5


def test_the_curve_of_a_closed_rim_closes(rim):
    part, edge = rim
    curve = edge.curve()
    low, high = curve.parameter_range
    assert curve.evaluate(low) == pytest.approx(curve.evaluate(high), abs=1e-9)
    assert curve.tangent(low) == pytest.approx(curve.tangent(high), abs=1e-6)
    assert part.distance(curve.sample(200)).max() < 3 * NOISE
    assert curve.length() == pytest.approx(2 * np.pi * part.radius, rel=2e-3)


def test_normals_stay_alike_round_the_rim(rim):
    part, edge = rim
    radial = edge.points - part.centre
    radial -= (radial @ part.axis)[:, None] * part.axis
    radial /= np.linalg.norm(radial, axis=1, keepdims=True)
    wall = 0 if abs(edge.normals[0, 0] @ part.axis) < 0.5 else 1
    assert np.einsum("mi,mi->m", edge.normals[:, wall], radial).min() > 0.995
    assert (edge.normals[:, 1 - wall] @ part.axis).min() > 0.995


def test_every_click_on_the_rim_finds_the_whole_of_it(can):
    part = can(radius=7.0, seed=3)
    for turn in np.linspace(0, 6, 5):
        edge = scan_edge(part.cloud, part.on_rim(turn) + 0.6 * part.axis)
        assert edge.closed
        assert part.distance(edge.points).max() < 4 * NOISE


def test_a_point_as_gate_on_a_closed_rim_stops_the_walk_before_it_closes(rim):
    part, whole = rim
    edge = scan_edge(part.cloud, part.on_rim(1.0), gate=part.on_rim(3.0))
    assert not edge.closed
    assert edge.stops == (Stop.START, Stop.GATE)
    assert edge.length == pytest.approx(2.0 * part.radius, abs=2.0)
    assert np.linalg.norm(edge.points[-1] - part.on_rim(3.0)) < 1.1
    assert edge.length < 0.5 * whole.length


def test_a_chord_height_sets_the_distance_of_the_edge_points(rim):
    """A chord of length c deviates c²/8r from the rim."""
    part, usual = rim
    lengths = {}
    for height in (0.02, 0.05):
        edge = scan_edge(
            part.cloud, part.on_rim(1.0), parameters=ScanParameters(chord_height=height)
        )
        step = np.median(np.linalg.norm(np.diff(edge.points, axis=0), axis=1))
        assert step == pytest.approx(np.sqrt(8 * part.radius * height), rel=0.15)
        assert edge.closed
        lengths[height] = len(edge)
    assert lengths[0.05] < lengths[0.02]
    assert len(usual) > lengths[0.05]


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_an_edge_of_a_cube_runs_from_its_corner_to_the_end_of_the_cloud(cube, axis):
    cloud = cube()
    click = 10.0 * np.eye(3)[axis] + 0.3
    edge = scan_edge(cloud, click)
    assert set(edge.stops) == {Stop.CORNER, Stop.CLOUD_END}
    across = np.delete(edge.points, axis, axis=1)
    assert np.linalg.norm(across, axis=1).max() < 4 * NOISE
    along = edge.points[:, axis]
    at_corner = along[0] if edge.stops[0] is Stop.CORNER else along[-1]
    assert 0.0 <= at_corner < 2.0
    assert np.ptp(along) > 17.5
    assert "corner" in edge.message
    assert "end of the cloud" in edge.message


def test_a_scan_never_turns_round_a_corner(cube):
    cloud = cube(size=12.0, seed=4)
    edge = scan_edge(cloud, (1.5, 0.1, 0.1))
    assert np.hypot(edge.points[:, 1], edge.points[:, 2]).max() < 4 * NOISE


def wavy_edge(pitch=0.5, noise=0.02, seed=0):
    """Two surfaces over a sine in the plane: a floor, and a wall that stands on it."""
    rng = np.random.default_rng([seed, 11])
    x, y = rng.uniform(0, 60, 12_000), rng.uniform(-15, 15, 12_000)
    wave = 3.0 * np.sin(x / 8.0)
    floor = np.column_stack([x, y, np.zeros_like(x)])[y > wave]
    n = 2_800
    x, z = rng.uniform(0, 60, n), rng.uniform(0, 10, n)
    slope = 3.0 / 8.0 * np.cos(x / 8.0)
    keep = rng.random(n) * 1.07 < np.hypot(1, slope)
    wall = np.column_stack([x, 3.0 * np.sin(x / 8.0), z])[keep]
    points = np.vstack([floor, wall])
    return PointCloud(points + noise * rng.normal(size=points.shape))


def test_a_wavy_edge_is_followed_and_its_curve_lies_on_it():
    """Left of the wall the edge is convex in the plane, right of it concave, in turns."""
    cloud = wavy_edge()
    edge = scan_edge(cloud, (30.0, 3.0 * np.sin(30 / 8.0), 0.2))
    x = np.linspace(0, 60, 6001)
    truth = np.column_stack([x, 3 * np.sin(x / 8), np.zeros_like(x)])

    def away(points):
        return np.sqrt(((points[:, None] - truth[None]) ** 2).sum(axis=2).min(axis=1))

    assert np.ptp(edge.points[:, 0]) > 55.0
    assert away(edge.points).mean() < 0.03
    assert away(edge.points).max() < 0.12
    curve = edge.curve()
    assert away(curve.sample(300)).mean() < 0.025
    assert len(curve.poles) < 0.7 * len(edge)
    assert edge.line is None
