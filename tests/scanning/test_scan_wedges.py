# SPDX-License-Identifier: LGPL-2.1-or-later
"""Straight sharp edges, scanned from one click and compared with exact geometry."""

import numpy as np
import pytest

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.geometry import Line
from freecad_edgescan.scanning import Gate, ScanParameters, Start, Stop, scan_edge

PITCH = 0.5
NOISE = 0.02


def alike(edge, part, sign=1.0):
    """Largest angle of the edge's normals to the part's, whichever side comes first."""
    wanted = sign * part.outward
    if edge.normals[0, 0] @ wanted[0] < edge.normals[0, 0] @ wanted[1]:
        wanted = wanted[::-1]
    return np.arccos(np.clip(np.einsum("mki,ki->mk", edge.normals, wanted), -1, 1)).max()


def expected_sigma(degrees):
    """Two noise levels per side, in the worse direction across the edge: a generous bound."""
    return 2.0 * NOISE / min(np.sin(np.radians(degrees) / 2), np.cos(np.radians(degrees) / 2))


@pytest.mark.parametrize("degrees", [30, 60, 90, 120, 150, 160])
def test_one_click_traces_the_whole_edge_of_any_angle(wedge, degrees):
    part = wedge(degrees, PITCH, NOISE, seed=degrees)
    edge = scan_edge(part.cloud, part.at(0.15, 0.5))
    assert edge.stops == (Stop.CLOUD_END, Stop.CLOUD_END)
    assert not edge.closed
    place = part.place_along(edge.points)
    assert np.ptp(place) > 0.92 * part.length
    assert np.abs(place).max() < part.length / 2 + PITCH
    assert part.distance(edge.points).max() < expected_sigma(degrees)
    assert edge.angle == pytest.approx(np.full(len(edge), part.angle), abs=0.02)
    tilt = np.degrees(np.arccos(np.minimum(np.abs(edge.tangents @ part.along), 1.0)))
    assert np.median(tilt) < 1.0
    assert tilt.max() < 5.0
    assert np.diff(place) * np.sign(place[-1] - place[0]) == pytest.approx(
        np.full(len(edge) - 1, 2 * PITCH), rel=0.1
    )
    assert np.isnan(edge.fillet_radius).all()
    assert edge.supported.all()


def test_an_edge_barely_sharper_than_the_least_angle_is_found(wedge):
    part = wedge(165.0)
    edge = scan_edge(part.cloud, part.at(0.1, 0.4), min_angle=0.2)
    assert np.ptp(part.place_along(edge.points)) > 0.9 * part.length
    assert part.distance(edge.points).max() < expected_sigma(165)


@pytest.mark.parametrize(("degrees", "share"), [(160, -0.3), (163, 0.1), (164, -0.2)])
def test_every_edge_that_turns_by_the_least_angle_is_found(wedge, degrees, share):
    """The least angle is 0.26 rad, what an edge of 165.1° turns by."""
    part = wedge(degrees)
    edge = scan_edge(part.cloud, part.at(share, 0.3))
    assert np.ptp(part.place_along(edge.points)) > 0.9 * part.length


@pytest.mark.parametrize("degrees", [40, 100, 145])
def test_every_click_within_three_pitches_finds_the_edge(wedge, degrees):
    part = wedge(degrees, PITCH, NOISE, length=24.0, width=10.0)
    rng = np.random.default_rng(degrees)
    for _ in range(6):
        away = rng.normal(size=3)
        away *= rng.uniform(0, 3) * PITCH / np.linalg.norm(away)
        click = part.at(rng.uniform(-0.4, 0.4)) + away
        edge = scan_edge(part.cloud, click)
        assert np.ptp(part.place_along(edge.points)) > 0.85 * part.length
        assert part.distance(edge.points).max() < expected_sigma(degrees)


def test_from_start_to_gate_the_walk_goes_along_the_starts_direction(wedge):
    part = wedge(90.0)
    amplitude = 10.0
    for way in (1.0, -1.0):
        start = Start(part.at(-0.3 * way, 5.0), -part.sides[0], way * part.along)
        gate = Gate(part.at(0.3 * way, 5.0), -part.sides[0])
        edge = scan_edge(part.cloud, start, gate, ScanParameters(amplitude=amplitude))
        assert edge.stops == (Stop.START, Stop.GATE)
        place = way * part.place_along(edge.points)
        assert place[0] == pytest.approx(-12.0, abs=2 * PITCH)
        assert 12.0 <= place[-1] < 12.0 + 2.1 * PITCH
        assert (np.diff(place) > 0).all()
        assert (way * edge.tangents @ part.along > 0.999).all()
        assert part.distance(edge.points).max() < 3 * NOISE


def test_a_start_without_a_gate_is_walked_one_way_to_the_end(wedge):
    part = wedge(90.0)
    start = Start(part.at(-0.2, 5.0), -part.sides[0], part.along)
    edge = scan_edge(part.cloud, start, parameters=ScanParameters(amplitude=10.0))
    assert edge.stops == (Stop.START, Stop.CLOUD_END)
    place = part.place_along(edge.points)
    assert place[0] == pytest.approx(-8.0, abs=2 * PITCH)
    assert place[-1] > part.length / 2 - 2 * PITCH


@pytest.mark.parametrize("target", [0.3, -0.35])
def test_a_point_as_gate_ends_the_walk_from_the_click_nearest_to_it(wedge, target):
    part = wedge(90.0)
    towards = part.at(target, 1.0)
    edge = scan_edge(part.cloud, part.at(0.05, 0.3), gate=towards)
    assert edge.stops == (Stop.START, Stop.GATE)
    place = part.place_along(edge.points)
    assert place[0] == pytest.approx(0.05 * part.length, abs=2 * PITCH)
    assert place[-1] == pytest.approx(target * part.length, abs=PITCH + 0.01)
    assert np.linalg.norm(edge.points - towards, axis=1).argmin() == len(edge) - 1


def test_normals_stand_on_the_surfaces_out_of_the_smaller_wedge_when_the_air_is_unknown(
    right_angle,
):
    part, edge = right_angle
    assert edge.convex is None
    assert alike(edge, part) < 0.03
    assert (np.einsum("mki,mki->mk", edge.normals[1:], edge.normals[:-1]) > 0.99).all()


@pytest.mark.parametrize("degrees", [70, 130])
@pytest.mark.parametrize(("approach", "convex"), [((0, 0, -1), True), ((0, 0, 1), False)])
def test_with_an_approach_normals_point_into_the_air(wedge, degrees, approach, convex):
    part = wedge(degrees, approach=approach)
    edge = scan_edge(part.cloud, part.at(0.1, 0.4))
    assert edge.convex is convex
    assert alike(edge, part, 1.0 if convex else -1.0) < 0.04
    # An approach among the parameters counts as much as the cloud's own.
    other = scan_edge(
        PointCloud(part.cloud.points),
        part.at(0.1, 0.4),
        parameters=ScanParameters(approach=part.cloud.approach),
    )
    assert other.convex is convex
    assert np.array_equal(other.normals, edge.normals)


def test_the_angle_is_the_smaller_wedge_whatever_fills_it(wedge):
    for approach in (None, (0, 0, -1), (0, 0, 1)):
        part = wedge(70.0, approach=approach)
        edge = scan_edge(part.cloud, part.at(0.0, 0.4))
        assert np.degrees(edge.angle) == pytest.approx(np.full(len(edge), 70.0), abs=0.7)


@pytest.mark.parametrize(("degrees", "worse"), [(40, 0), (140, 1)])
def test_acute_edges_are_known_worst_along_their_bisector_obtuse_ones_across_it(
    wedge, degrees, worse
):
    """Two lines known equally well: the variances stand as cot² of half the angle."""
    part = wedge(degrees)
    edge = scan_edge(part.cloud, part.at(0.1, 0.4))
    assert edge.covariance == pytest.approx(np.swapaxes(edge.covariance, 1, 2), rel=1e-9, abs=1e-15)
    assert (np.linalg.eigvalsh(edge.covariance) > 0).all()
    ratio = edge.covariance[:, worse, worse] / edge.covariance[:, 1 - worse, 1 - worse]
    assert np.median(ratio) == pytest.approx(1 / np.tan(np.radians(20)) ** 2, rel=0.3)
    assert edge.sigma**2 == pytest.approx(np.linalg.eigvalsh(edge.covariance)[:, 1])


def test_edge_points_scatter_as_their_covariance_says(wedge, sigmas_away):
    """Over many scans: the median of a two-dimensional normal distribution is 1.18 sigma, 95 %
    lie within 2.45. So it is before the points are smoothed, and so it is after, by each point
    alone."""
    cases = [(60, (0, 0, 1)), (90, (0, 0, -1)), (135, None)]
    before, after = [], []
    for degrees, approach in cases:
        away = []
        for seed in range(12):
            part = wedge(degrees, 0.6, 0.03, length=24.0, width=10.0, seed=seed, approach=approach)
            edge = scan_edge(part.cloud, part.at(0.1, 0.4))
            away.append(sigmas_away(part, edge.unsmoothed))
            after.append(edge.reserve * sigmas_away(part, edge))
        away = np.concatenate(away)
        # Neighbours share points: so few scans know their own median to a tenth.
        assert 0.85 < np.median(away) < 1.6, degrees
        assert np.percentile(away, 95) < 3.2, degrees
        before.append(away)
    for away in (np.concatenate(before), np.concatenate(after)):
        assert 0.95 < np.median(away) < 1.5
        assert np.percentile(away, 95) < 3.2


def test_twice_the_noise_is_twice_the_sigma(wedge):
    """On average: how surely a side is a plane differs from cloud to cloud."""
    sigma = []
    for noise in (0.02, 0.04):
        parts = [wedge(90.0, noise=noise, seed=seed) for seed in range(6)]
        found = [scan_edge(part.cloud, part.at(0.1, 0.4)) for part in parts]
        sigma.append(np.mean([np.median(edge.sigma) for edge in found]))
    assert sigma[1] / sigma[0] == pytest.approx(2.0, rel=0.2)


def test_far_from_the_origin_the_edge_is_the_same(wedge):
    far = np.array([5e5, 4.5e6, 120.0])
    near = wedge(100.0, approach=(0, 0, -1))
    there = PointCloud(near.cloud.points + far, 0.0, near.cloud.approach)
    one = scan_edge(near.cloud, near.at(0.1, 0.4))
    other = scan_edge(there, near.at(0.1, 0.4) + far)
    assert len(other) == len(one)
    assert other.points - far == pytest.approx(one.points, abs=1e-6)
    assert other.tangents == pytest.approx(one.tangents, abs=1e-6)
    assert other.normals == pytest.approx(one.normals, abs=1e-6)
    assert other.covariance == pytest.approx(one.covariance, rel=1e-3)
    assert other.stops == one.stops


def test_the_same_scan_gives_the_same_edge(right_angle):
    part, edge = right_angle
    again = scan_edge(PointCloud(part.cloud.points), part.at(0.1, 0.4))
    assert np.array_equal(again.points, edge.points)
    assert np.array_equal(again.covariance, edge.covariance)


def test_the_order_of_the_points_does_not_matter(right_angle):
    part, edge = right_angle
    mixed = np.random.default_rng(1).permutation(part.cloud.points)
    again = scan_edge(PointCloud(mixed), part.at(0.1, 0.4))
    one, other = (np.sort(part.place_along(e.points)) for e in (edge, again))
    assert other[[0, -1]] == pytest.approx(one[[0, -1]], abs=2 * PITCH)
    assert part.distance(again.points).max() < 3 * NOISE


def test_units_do_not_matter(right_angle):
    """A part ten times as large, of ten times the pitch, has its edge points ten times as far."""
    part, edge = right_angle
    large = scan_edge(PointCloud(10 * part.cloud.points), 10 * part.at(0.1, 0.4))
    assert large.points == pytest.approx(10 * edge.points, abs=0.2 * NOISE)


def test_a_straight_edge_is_a_line(right_angle):
    part, edge = right_angle
    assert isinstance(edge.line, Line)
    assert edge.circle is None
    assert np.abs(edge.line.direction @ part.along) > 1 - 1e-5
    assert part.distance(edge.line.evaluate([-10.0, 10.0])).max() < 0.5 * NOISE


def test_a_cloud_of_two_pitches_is_no_obstacle(wedge):
    """Lines close together across, points far apart along the edge."""
    part = wedge(100.0, 0.25, NOISE)
    rows = np.round(part.place_along(part.cloud.points) / 0.25).astype(int) % 4 == 0
    edge = scan_edge(PointCloud(part.cloud.points[rows]), part.at(0.1, 0.4))
    assert np.ptp(part.place_along(edge.points)) > 0.85 * part.length
    assert part.distance(edge.points).max() < 4 * NOISE


def test_stray_points_are_left_out(wedge):
    part = wedge(90.0)
    rng = np.random.default_rng(3)
    stray = part.middle + rng.uniform(-12, 12, (len(part.cloud) // 20, 3))
    cloud = PointCloud(np.vstack([part.cloud.points, stray]))
    edge = scan_edge(cloud, part.at(0.1, 0.4))
    assert np.ptp(part.place_along(edge.points)) > 0.9 * part.length
    assert part.distance(edge.points).max() < 5 * NOISE


def test_a_noiseless_edge_is_exact(wedge):
    part = wedge(90.0, noise=0.0)
    edge = scan_edge(part.cloud, part.at(0.1, 0.4))
    assert part.distance(edge.points).max() < 1e-6


def test_every_point_of_a_noiseless_edge_is_supported(wedge):
    part = wedge(90.0, noise=0.0)
    assert scan_edge(part.cloud, part.at(0.1, 0.4)).supported.all()


def test_given_amplitude_and_edge_pitch_are_kept(wedge):
    part = wedge(90.0)
    asked = ScanParameters(amplitude=8.0, edge_pitch=1.6)
    edge = scan_edge(part.cloud, part.at(0.1, 0.4), parameters=asked)
    assert edge.parameters.amplitude == 8.0
    assert edge.parameters.edge_pitch == 1.6
    assert np.diff(part.place_along(edge.points)) == pytest.approx(
        np.full(len(edge) - 1, 1.6 * np.sign(part.place_along(edge.points)[-1])), rel=0.1
    )
    touched = part.distance(part.cloud.points[edge.scan_lines.points.index])
    assert touched.max() < 4.0 * 1.02


def test_every_automatic_value_has_a_reason(right_angle):
    edge = right_angle[1]
    for name in ("amplitude", "edge_pitch", "probe_radius", "cloud_pitch"):
        assert getattr(edge.parameters, name) is not None
        assert edge.reasons[name]
