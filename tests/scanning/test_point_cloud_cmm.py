# SPDX-License-Identifier: LGPL-2.1-or-later
"""The virtual machine on clouds whose surfaces are known (Schreve 3.3)."""

import numpy as np
import pytest

from freecad_edgescan.cloud import PointCloud, TorusObject
from freecad_edgescan.scanning import (
    Cmm,
    Gate,
    PointCloudCmm,
    ScanError,
    ScanParameters,
    Start,
    Stop,
    scan_edge,
)

DOWN = np.array([0.0, 0.0, -1.0])
KINDS = ("closest", "ball", "triangle")


def grid(pitch=0.5, size=20.0):
    x = np.arange(-size / 2, size / 2 + pitch / 2, pitch)
    return np.array(np.meshgrid(x, x)).reshape(2, -1).T


def plane(pitch=0.5, slope=0.0, jitter=0.0):
    xy = grid(pitch) + np.random.default_rng(2).uniform(-jitter, jitter, (len(grid(pitch)), 2))
    return np.column_stack([xy, slope * xy[:, 0]])


@pytest.mark.parametrize("kind", KINDS)
def test_it_is_a_machine(kind):
    machine = PointCloudCmm(PointCloud(plane(), approach=(0, 0, -2)), kind)
    assert isinstance(machine, Cmm)
    assert machine.approach == pytest.approx([0, 0, -1])
    assert machine.pitch == pytest.approx(0.5, rel=0.1)
    assert "closest" in repr(machine) or kind in repr(machine)


def test_the_closest_kind_answers_a_point_of_the_cloud_within_a_pitch():
    points = plane(slope=0.3, jitter=0.1)
    machine = PointCloudCmm(PointCloud(points), pitch=0.5)
    rng = np.random.default_rng(5)
    for _ in range(50):
        start = np.array([*rng.uniform(-8, 8, 2), 6.0])
        contact = machine.touch(start, DOWN, 2.0, 20.0)
        aside = np.hypot(*(points - start)[:, :2].T)
        inside = points[aside <= 0.5]
        assert contact[2] == inside[:, 2].max()
        assert np.any(np.all(points == contact, axis=1))


def test_a_triangle_is_pierced_on_the_surface_itself():
    points = plane(slope=0.3, jitter=0.1)
    machine = PointCloudCmm(PointCloud(points), "triangle")
    rng = np.random.default_rng(6)
    for _ in range(50):
        start = np.array([*rng.uniform(-8, 8, 2), 6.0])
        contact = machine.touch(start, DOWN, 2.0, 20.0)
        assert contact == pytest.approx([start[0], start[1], 0.3 * start[0]], abs=1e-9)


def test_a_ball_rests_on_the_points_it_meets_first():
    points = plane(slope=0.3, jitter=0.1)
    machine = PointCloudCmm(PointCloud(points), "ball", probe_radius=3.0)
    assert machine.probe_radius == 3.0
    rng = np.random.default_rng(7)
    for _ in range(50):
        start = np.array([*rng.uniform(-5, 5, 2), 9.0])
        centre = machine.touch(start, DOWN, 2.0, 20.0)
        nearest = np.linalg.norm(points - centre, axis=1).min()
        assert nearest == pytest.approx(3.0, abs=1e-9)
        assert centre[:2] == pytest.approx(start[:2])


def test_a_ball_dips_between_points_as_deep_as_predicted_and_no_deeper():
    """Eq. 3.3.3.3 on a triangular lattice; the deepest place is the middle of a triangle."""
    d, radius = 0.8, 2.0
    i, j = np.meshgrid(np.arange(-20, 21), np.arange(-20, 21))
    points = np.column_stack(
        [d * (i + 0.5 * j).ravel(), d * np.sqrt(0.75) * j.ravel(), np.zeros(i.size)]
    )
    machine = PointCloudCmm(PointCloud(points), "ball", pitch=d, probe_radius=radius)
    deepest = radius - np.sqrt(radius**2 - d**2 / 3.0)

    def dip(x, y):
        return radius - machine.touch(np.array([x, y, 5.0]), DOWN, 2.0, 9.0)[2]

    assert dip(d / 2, d * np.sqrt(0.75) / 3) == pytest.approx(deepest, abs=1e-12)
    rng = np.random.default_rng(8)
    dips = [dip(*rng.uniform(-1.5, 1.5, 2)) for _ in range(300)]
    assert max(dips) <= deepest + 1e-12
    assert min(dips) >= -1e-12
    assert max(dips) > 0.9 * deepest


@pytest.mark.parametrize("kind", KINDS)
def test_in_a_valley_its_tops_are_not_touched(kind):
    """The tops of the walls lie nearer along the search line, but not near it (figure 3.6)."""
    x = np.arange(-6.0, 6.01, 0.25)
    xy = np.array(np.meshgrid(x, x)).reshape(2, -1).T
    points = np.column_stack([xy, 2.0 * np.abs(xy[:, 0])])
    machine = PointCloudCmm(PointCloud(points), kind, probe_radius=0.6 if kind == "ball" else None)
    contact = machine.touch(np.array([0.0, 0.1, 11.0]), DOWN, 2.0, 20.0)
    if kind == "ball":
        assert contact[2] == pytest.approx(0.6 * np.sqrt(5.0), abs=0.15)
    else:
        assert contact[2] < 0.8


def test_what_lies_behind_the_start_is_not_touched():
    points = np.vstack([plane(), plane() + np.array([0, 0, 10.0])])
    machine = PointCloudCmm(PointCloud(points), pitch=0.5)
    assert machine.touch(np.array([0.1, 0.1, 5.0]), DOWN, 2.0, 20.0)[2] == 0.0
    assert machine.touch(np.array([0.1, 0.1, 5.0]), -DOWN, 2.0, 20.0)[2] == 10.0


@pytest.mark.parametrize("kind", KINDS)
def test_a_gap_wider_than_the_pitch_is_fallen_through(kind):
    points = plane()
    points = points[np.hypot(points[:, 0], points[:, 1]) > 3.0]
    points = np.vstack([points, plane() - np.array([0, 0, 15.0])])
    machine = PointCloudCmm(
        PointCloud(points), kind, pitch=0.5, probe_radius=1.0 if kind == "ball" else None
    )
    contact = machine.touch(np.array([0.0, 0.0, 4.0]), DOWN, 2.0, 30.0)
    assert contact[2] == pytest.approx(-14.0 if kind == "ball" else -15.0, abs=0.1)
    assert machine.touch(np.array([0.0, 0.0, 4.0]), DOWN, 2.0, 10.0) is None


def test_a_wider_pitch_makes_surface_of_a_gap():
    """On steep walls points lie far apart (7.2); the pitch that closes them is the user's."""
    points = plane(pitch=2.0)
    start = np.array([1.0, 1.0, 4.0])
    assert PointCloudCmm(PointCloud(points), pitch=1.0).touch(start, DOWN, 2.0, 30.0) is None
    assert PointCloudCmm(PointCloud(points), pitch=1.5).touch(start, DOWN, 2.0, 30.0) is not None


@pytest.mark.parametrize("kind", KINDS)
def test_a_movement_through_a_surface_collides(kind):
    machine = PointCloudCmm(PointCloud(plane()), kind)
    above = np.array([0.2, 0.1, 9.0])
    collision = machine.move(above, np.array([0.4, 0.1, -9.0]))
    # A ball of four pitches, two millimetres, is stopped by its radius.
    assert collision[2] == pytest.approx(2.0 if kind == "ball" else 0.0, abs=0.15)
    assert machine.move(above, np.array([5.0, 3.0, 4.0])) is None
    assert machine.move(above, above) is None


def test_a_machine_can_leave_what_it_has_touched():
    machine = PointCloudCmm(PointCloud(plane()), pitch=0.5)
    assert machine.move(np.array([0.0, 0.0, 2.0]), np.array([0.0, 0.0, 5.0])) is None


@pytest.mark.parametrize(("kind", "bound"), [("closest", 0.05), ("ball", 0.05), ("triangle", 0.05)])
def test_every_kind_scans_the_edge_of_two_tori(kind, bound):
    torus = TorusObject(30.0, 60.0, np.radians(110.0))
    cloud = PointCloud(torus.cloud(0.2, 12.0, 0.005, 3).points)
    machine = PointCloudCmm(cloud, kind, probe_radius=1.0 if kind == "ball" else None)
    edge = scan_edge(
        machine,
        at=Start(*torus.start(10.0)),
        gate=Gate(*torus.gate(10.0, azimuth=1.0)),
        parameters=ScanParameters(amplitude=10.0, line_pitch=0.5, edge_pitch=1.0, tolerance=0.04),
    )
    assert edge.stops[1] is Stop.GATE
    rho = np.hypot(edge.points[:, 0], edge.points[:, 1])
    error = np.hypot(rho - 60.0, edge.points[:, 2] + 30.0)
    assert error.mean() < bound


@pytest.mark.parametrize("pitch", [0.0, -1.0, np.nan, np.inf, "fine"])
def test_a_pitch_that_is_no_length_is_refused(pitch):
    with pytest.raises(ScanError, match="pitch of the machine"):
        PointCloudCmm(PointCloud(plane()), pitch=pitch)


def test_other_mistakes_are_told():
    cloud = PointCloud(plane())
    with pytest.raises(ScanError, match="'farthest'"):
        PointCloudCmm(cloud, "farthest")
    with pytest.raises(ScanError, match="ndarray"):
        PointCloudCmm(plane())
    with pytest.raises(ScanError, match="has no ball"):
        PointCloudCmm(cloud, "closest", probe_radius=1.0)
    with pytest.raises(ScanError, match="centres of a ball"):
        PointCloudCmm(PointCloud(plane(), probe_radius=1.0), "ball")
    with pytest.raises(ScanError, match="probe radius of the machine"):
        PointCloudCmm(cloud, "ball", probe_radius=-1.0)
