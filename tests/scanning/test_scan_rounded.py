# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges under roundings, and clouds of probe centres: the sharp edge is what is meant."""

import numpy as np
import pytest

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.scanning import ScanError, ScanParameters, Stop, scan_edge

NOISE = 0.02
DOWN, UP = (0, 0, -1), (0, 0, 1)


def probed(wedge, degrees, radius, fillet=0.0, convex=True, approach=True, **more):
    """The cloud of probe centres on a wedge with a fillet; the edge itself stays where it is."""
    sign = 1.0 if convex else -1.0
    return wedge(
        degrees,
        rounding=max(fillet + sign * radius, 0.0),
        raised=sign * radius / np.sin(np.radians(degrees) / 2),
        probe_radius=radius,
        approach=(DOWN if convex else UP) if approach else None,
        **more,
    )


FILLETS = [(degrees, radius) for degrees in (60, 90, 120) for radius in (1.0, 2.0, 3.0)]


@pytest.mark.parametrize(("degrees", "radius"), FILLETS)
def test_an_edge_under_a_fillet_is_found_within_a_few_noise_levels(wedge, degrees, radius):
    part = wedge(degrees, rounding=radius, width=16.0)
    edge = scan_edge(part.cloud, part.at(0.1, 0.3))
    assert np.ptp(part.place_along(edge.points)) > 0.9 * part.length
    assert part.distance(edge.points).mean() < 2 * NOISE
    assert part.distance(edge.points).max() < 6 * NOISE
    assert edge.angle == pytest.approx(np.full(len(edge), part.angle), abs=0.03)


@pytest.mark.parametrize("radius", [1.0, 2.0, 3.0])
@pytest.mark.parametrize("degrees", [90, 120])
def test_the_fillet_radius_is_measured(wedge, degrees, radius):
    share = []
    for seed in range(3):
        part = wedge(degrees, rounding=radius, width=16.0, seed=seed)
        edge = scan_edge(part.cloud, part.at(0.1, 0.3))
        measured = np.isfinite(edge.fillet_radius)
        share.append(measured.mean())
        assert np.array_equal(np.isfinite(edge.fillet_sigma), measured)
        allowed = 0.05 * radius + 3 * np.nanmedian(edge.fillet_sigma) / np.sqrt(measured.sum() / 5)
        assert np.nanmean(edge.fillet_radius) == pytest.approx(radius, abs=allowed)
    assert np.mean(share) > 0.9


@pytest.mark.parametrize(("degrees", "radius"), [(60, 1.0), (90, 1.0), (120, 2.0)])
def test_fillet_radii_scatter_as_their_sigma_says(wedge, degrees, radius):
    """Sections of one edge share most of what they know of it: each edge is one measurement."""
    away = []
    for seed in range(8):
        part = wedge(degrees, rounding=radius, width=14.0, length=24.0, seed=seed)
        edge = scan_edge(part.cloud, part.at(0.1, 0.3))
        away.append(np.nanmean(np.square((edge.fillet_radius - radius) / edge.fillet_sigma)))
    assert 0.6 < np.sqrt(np.mean(away)) < 1.5


def test_a_filleted_edge_ends_where_its_cloud_ends(wedge):
    part = wedge(60.0, rounding=2.0, width=16.0)
    edge = scan_edge(part.cloud, part.at(0.1, 0.3))
    assert edge.stops == (Stop.CLOUD_END, Stop.CLOUD_END)


def test_no_fillet_is_measured_on_a_sharp_edge(right_angle):
    edge = right_angle[1]
    assert np.isnan(edge.fillet_radius).all()
    assert np.isnan(edge.fillet_sigma).all()


def test_every_click_within_three_pitches_of_a_fillet_finds_its_edge(wedge):
    part = wedge(90.0, rounding=2.0, length=24.0, width=12.0)
    rng = np.random.default_rng(2)
    for _ in range(8):
        click = part.at(rng.uniform(-0.4, 0.4), rng.uniform(0.0, 1.5), rng.integers(2))
        edge = scan_edge(part.cloud, click)
        assert np.ptp(part.place_along(edge.points)) > 0.85 * part.length
        assert part.distance(edge.points).max() < 6 * NOISE


def test_points_under_a_fillet_scatter_about_as_their_covariance_says(wedge, sigmas_away):
    away = []
    for seed in range(5):
        part = wedge(100.0, 0.5, 0.02, rounding=1.5, length=24.0, width=12.0, seed=seed)
        away.append(sigmas_away(part, scan_edge(part.cloud, part.at(0.1, 0.4))))
    away = np.concatenate(away)
    assert 0.9 < np.median(away) < 2.0
    assert np.percentile(away, 95) < 4.5


@pytest.mark.parametrize("convex", [True, False], ids=["outer", "inner"])
@pytest.mark.parametrize("degrees", [60, 90, 130])
def test_the_probe_radius_is_taken_off_towards_the_part(wedge, degrees, convex):
    part = probed(wedge, degrees, 1.0, convex=convex)
    edge = scan_edge(part.cloud, part.at(0.1, 0.3))
    assert edge.convex is convex
    assert part.distance(edge.points).mean() < 2 * NOISE
    assert part.distance(edge.points).max() < 6 * NOISE
    assert edge.parameters.probe_radius == 1.0


def test_no_fillet_is_measured_where_only_the_probe_rolls_round_a_sharp_edge(wedge):
    part = probed(wedge, 90.0, 1.0)
    edge = scan_edge(part.cloud, part.at(0.1, 0.3))
    assert np.isnan(edge.fillet_radius).mean() > 0.9


def test_no_fillet_is_measured_in_a_sharp_inner_edge(wedge):
    part = probed(wedge, 90.0, 1.0, convex=False)
    edge = scan_edge(part.cloud, part.at(0.1, 0.3))
    assert np.isnan(edge.fillet_radius).mean() > 0.9


@pytest.mark.parametrize("convex", [True, False], ids=["outer", "inner"])
def test_a_fillet_is_measured_on_the_part_not_on_the_probe_centres(wedge, convex):
    """A ball rolls round a fillet R_f with R_f + R_p, in an inner one with R_f − R_p."""
    part = probed(wedge, 90.0, 0.8, fillet=2.5, convex=convex, width=16.0)
    edge = scan_edge(part.cloud, part.at(0.1, 0.3))
    assert part.distance(edge.points).max() < 6 * NOISE
    assert np.nanmedian(edge.fillet_radius) == pytest.approx(2.5, rel=0.05)


def test_without_an_approach_a_rim_rounded_by_the_probe_tells_an_outer_edge(wedge):
    part = probed(wedge, 90.0, 1.5, approach=False)
    edge = scan_edge(part.cloud, part.at(0.1, 0.3))
    assert edge.convex is True
    assert part.distance(edge.points).max() < 6 * NOISE
    assert "outer edge" in edge.message
    assert "1.5 mm" in edge.message


def test_without_an_approach_a_sharp_rim_of_probe_centres_tells_an_inner_edge(wedge):
    part = probed(wedge, 90.0, 1.5, convex=False, approach=False)
    edge = scan_edge(part.cloud, part.at(0.1, 0.3))
    assert edge.convex is False
    assert part.distance(edge.points).max() < 6 * NOISE
    assert "inner edge" in edge.message


def test_without_an_approach_a_rim_rounded_otherwise_is_never_guessed(wedge):
    part = probed(wedge, 90.0, 1.0, fillet=1.5, approach=False)
    with pytest.raises(ScanError) as refused:
        scan_edge(part.cloud, part.at(0.1, 0.3))
    sentence = str(refused.value)
    assert "probe radius 1 mm" in sentence
    assert "approach" in sentence


def test_a_probe_radius_among_the_parameters_counts_before_the_clouds_own(wedge):
    part = probed(wedge, 90.0, 1.0)
    surface = PointCloud(part.cloud.points, 0.0, part.cloud.approach)
    edge = scan_edge(surface, part.at(0.1, 0.3), parameters=ScanParameters(probe_radius=1.0))
    assert part.distance(edge.points).max() < 6 * NOISE
    seen = scan_edge(part.cloud, part.at(0.1, 0.3), parameters=ScanParameters(probe_radius=0.0))
    # What the sides of the cloud itself meet in lies R_p / sin(θ/2) farther out.
    assert part.distance(seen.points).mean() == pytest.approx(np.sqrt(2), abs=2 * NOISE)


def test_every_point_says_how_it_was_compensated(wedge, right_angle):
    part = probed(wedge, 90.0, 1.0)
    edge = scan_edge(part.cloud, part.at(0.1, 0.3))
    assert edge.compensation.shape == (len(edge),)
    assert len(set(edge.compensation)) == 1
    assert set(right_angle[1].compensation) == {"none"}
    assert edge.compensation[0] != "none"
