# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sides fitted together with the rounding between them, where they tell little by themselves."""

import re
from dataclasses import replace

import numpy as np
import pytest

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.scanning import ScanError, scan_edge
from freecad_edgescan.scanning.rounded_fits import RoundedFits

PITCH = 0.5


def scans(wedge, count=5, **shape):
    """Parts of one shape with other points, and their scanned edges."""
    parts = [wedge(length=18.0, seed=seed, **shape) for seed in range(count)]
    return [(part, scan_edge(part.cloud, part.at(0.1, 0.3))) for part in parts]


NARROW = [(90, 2.0, 5.5), (115, 2.5, 5.1)]


@pytest.mark.parametrize(("degrees", "rounding", "width"), NARROW)
def test_a_rounding_half_as_wide_as_its_sides_in_much_noise_is_no_part_of_them(
    wedge, sigmas_away, degrees, rounding, width
):
    """Sides of 7 pitches beside a rounding of 4 to 5, noise of 0.3 pitches."""
    found = scans(wedge, degrees=degrees, rounding=rounding, width=width, noise=0.3 * PITCH)
    off = [np.sqrt(np.mean(sigmas_away(part, edge) ** 2)) for part, edge in found]
    assert np.median(off) < 2.0
    assert max(off) < 3.0
    errors = [np.sqrt(np.mean(part.distance(edge.points) ** 2)) for part, edge in found]
    assert np.median(errors) < 0.4 * PITCH
    angles = [np.median(edge.angle) for _, edge in found]
    assert np.median(angles) == pytest.approx(np.radians(degrees), abs=0.1)
    radii = [np.nanmedian(edge.fillet_radius) for _, edge in found]
    assert np.median(radii) == pytest.approx(rounding, rel=0.1)


def test_radii_are_off_by_what_is_stated(wedge):
    off = [
        (np.median(edge.fillet_radius) - 1.5) / np.median(edge.fillet_sigma)
        for _, edge in scans(wedge, count=10, degrees=90, rounding=1.5, noise=0.1)
    ]
    assert 0.5 < np.sqrt(np.mean(np.square(off))) < 2.0


def test_sides_without_a_rounding_are_fitted_by_themselves(wedge):
    for part, edge in scans(wedge, count=3, degrees=90, noise=0.1):
        assert not isinstance(edge.scan_lines.fits, RoundedFits)
        assert part.distance(edge.points).max() < 0.2


def chamfered(width, noise, seed=0):
    """Two planes at 90° whose edge, the x axis, is cut off by a third of a width."""
    rng = np.random.default_rng(seed)
    leg = width / np.sqrt(2.0)
    along, across = (rng.uniform(*span, 9000) for span in ((-12.0, 12.0), (leg, 12.0)))
    cut = rng.uniform(0.0, leg, 1200)
    planes = np.array([[0.0, -1.0, 0.0], [0.0, 0.0, -1.0]])
    parts = [
        np.array([1.0, 0.0, 0.0]) * along[k::2, None] + planes[k] * across[k::2, None]
        for k in range(2)
    ]
    parts.append(np.column_stack([rng.uniform(-12.0, 12.0, 1200), -cut, cut - leg]))
    out = [planes[1] * -1.0, planes[0] * -1.0, np.array([0.0, 1.0, 1.0]) / np.sqrt(2.0)]
    points = np.vstack(
        [
            part + noise * rng.normal(size=len(part))[:, None] * n
            for part, n in zip(parts, out, strict=True)
        ]
    )
    return PointCloud(points)


@pytest.mark.parametrize(("width", "noise"), [(1.0, 0.02), (1.5, 0.02), (1.5, 0.05)])
def test_a_chamfer_is_no_rounding(width, noise):
    """Its sides meet where they met before it was cut, and no radius is stated."""
    in_sigmas = []
    for seed in range(3):
        edge = scan_edge(chamfered(width, noise, seed), at=(0.3, 0.2, 0.2))
        assert not isinstance(edge.scan_lines.fits, RoundedFits)
        assert np.mean(np.isnan(edge.fillet_radius)) > 0.7
        in_sigmas.append(np.median(np.linalg.norm(edge.points[:, 1:], axis=1) / edge.sigma))
    assert np.median(in_sigmas) < 2.0
    assert max(in_sigmas) < 4.0


def test_a_reversed_edge_has_the_same_covariance_of_its_sides_positions(wedge):
    part = wedge(degrees=100, rounding=1.5, noise=0.05, length=18.0)
    fits = scan_edge(part.cloud, part.at(0.1, 0.3)).scan_lines.fits
    assert isinstance(fits, RoundedFits)
    terms = np.random.default_rng(0).normal(size=(len(fits.radius), 2, 4))
    turn = np.array([1.0, 1.0, 1.0, -1.0])
    here, there = (
        each.position_covariance(place)[0]
        for each, place in ((fits, terms), (fits.backward(), (terms * turn)[::-1]))
    )
    assert there[::-1] == pytest.approx(here)


def test_one_of_two_cases_is_known_as_badly_as_they_differ(wedge):
    part = wedge(degrees=100, rounding=1.5, noise=0.05, length=18.0)
    fits = scan_edge(part.cloud, part.at(0.1, 0.3)).scan_lines.fits
    same = fits.or_else(fits, 0.3)
    assert same.joint == pytest.approx(fits.joint)
    apart = replace(fits, coefficients=fits.coefficients + np.array([0.02, 0.0, 0.0, 0.0]))
    either = fits.or_else(apart, 0.5)
    # Half of the cases lie 0.01 to each side of the mean.
    assert either.joint[:, 0, 0] == pytest.approx(fits.joint[:, 0, 0] + 0.01**2)
    assert either.joint[:, 0, 4] == pytest.approx(fits.joint[:, 0, 4] + 0.01**2)
    assert either.coefficients[..., 0] == pytest.approx(fits.coefficients[..., 0] + 0.01)


def rounded_beside_a_narrow_side(land, seed, radius=2.5, noise=0.02):
    """Sides at 90° under a rounding between them, one of which ends a land beyond it.

    The edge is the x axis, PITCH apart on average; the narrow side is followed by a wall downwards.
    """
    rng = np.random.default_rng(seed)

    def strewn(length):
        count = int(24.0 * length / PITCH**2)
        return rng.uniform(-12.0, 12.0, count), rng.uniform(0.0, length, count)

    x, s = strewn(12.0 - radius)
    wide = np.column_stack([x, np.zeros_like(x), -radius - s])
    x, s = strewn(np.pi / 2.0 * radius)
    round_ = np.column_stack(
        [x, radius * (np.cos(s / radius) - 1.0), radius * (np.sin(s / radius) - 1.0)]
    )
    x, s = strewn(land)
    narrow = np.column_stack([x, -radius - s, np.zeros_like(x)])
    x, s = strewn(8.0)
    wall = np.column_stack([x, np.full_like(x, -radius - land), -s])
    points = np.vstack([wide, round_, narrow, wall])
    return PointCloud(points + rng.normal(0.0, noise, points.shape))


@pytest.mark.parametrize(
    ("land", "seed"),
    [(land, seed) for land in (0.0, 0.3) for seed in range(4)],
)
def test_no_edge_is_stated_beside_a_rounding_that_leaves_nothing_of_a_side(land, seed):
    """A piece of the rounding is no side: what that meets is not the edge.

    What is stated is where the rounding, or what is left of the side, meets the wall, or nothing.
    """
    try:
        edge = scan_edge(rounded_beside_a_narrow_side(land, seed), at=(0.3, -0.7, -0.7))
    except ScanError as refusal:
        assert "Click" in str(refusal)  # elsewhere, by whatever reason
        return
    off = np.hypot(edge.points[:, 1] + 2.5 + land, edge.points[:, 2])
    assert np.median(off) < 0.1 * PITCH


def test_what_is_refused_is_told_with_its_radius():
    told = []
    for land, seed in [(0.0, 0), (0.0, 2), (0.3, 0), (0.3, 2)]:
        try:
            scan_edge(rounded_beside_a_narrow_side(land, seed), at=(0.3, -0.7, -0.7))
        except ScanError as refusal:
            told += re.findall(r"rounding of radius (\S+) mm near .* of one side", str(refusal))
    assert len(told) >= 2  # others may be refused for other reasons, or be found
    assert np.array(told, dtype=float) == pytest.approx(2.5, rel=0.15)


@pytest.mark.parametrize("seed", range(2))
def test_beside_a_rounding_that_leaves_eight_pitches_of_a_side_the_edge_is_found(seed):
    edge = scan_edge(rounded_beside_a_narrow_side(4.0, seed), at=(0.3, -0.7, -0.7))
    off = np.linalg.norm(edge.points[:, 1:], axis=1)
    assert np.mean(off) < 0.1 * PITCH
    assert np.median(edge.fillet_radius) == pytest.approx(2.5, rel=0.05)


@pytest.mark.parametrize(
    "click", [(0.3, -0.6, -0.6), (0.3, -2.5, 0.0), (0.3, -3.5, 0.0), (0.3, 0.0, -4.0)]
)
def test_beside_wide_sides_every_click_finds_the_edge_of_a_wide_rounding(click):
    """Little noise: the radii that are tried fit badly, and say nothing of where the sides end."""
    cloud = rounded_beside_a_narrow_side(20.0, 0, radius=2.0, noise=0.01)
    edge = scan_edge(cloud, at=click)
    off = np.linalg.norm(edge.points[:, 1:], axis=1)
    assert np.mean(off) < 0.02
    assert np.median(edge.fillet_radius) == pytest.approx(2.0, rel=0.03)


@pytest.mark.parametrize("noise", [0.003, 0.005, 0.01])
def test_a_rounding_is_found_however_little_noise_there_is(noise):
    """None of the radii that are tried explains a point then, unless it is the true one."""
    for seed in range(2):
        cloud = rounded_beside_a_narrow_side(4.0, seed, radius=1.9, noise=noise)
        edge = scan_edge(cloud, at=(0.3, -0.5, -0.5))
        assert isinstance(edge.scan_lines.fits, RoundedFits)
        assert np.median(edge.fillet_radius) == pytest.approx(1.9, rel=0.02)
        assert np.median(np.linalg.norm(edge.points[:, 1:], axis=1)) < 2.0 * noise


def between_two_roundings(land, seed, noise=0.02):
    """Three faces along x with a land between two roundings, and the two edges (2, 2)."""
    rng = np.random.default_rng(seed)
    pieces = [(10.0, 0.0), (2.1, 1 / 1.5), (land, 0.0), (3.0, -1 / 2.0), (10.0, 0.0)]
    place, way, edges, parts = -10.0 + 0.0j, 1.0 + 0.0j, [], []
    for length, bend in pieces:  # places and directions in the section as complex numbers
        s = rng.uniform(0.0, length, round(24.0 * length / PITCH**2))
        turned, last = np.exp(1j * bend * s), np.exp(1j * bend * length)
        run, whole = (turned - 1.0, last - 1.0) if bend else (s, length)
        lasting = 1j * bend if bend else 1.0
        if bend:
            edges.append(place + way * np.tan(0.5 * abs(bend) * length) / abs(bend))
        at = place + way * (run / lasting + noise * rng.normal(size=len(s)) * 1j * turned)
        parts.append(np.column_stack([rng.uniform(-12.0, 12.0, len(s)), at.real, at.imag]))
        place, way = place + way * whole / lasting, way * last
    return PointCloud(np.vstack(parts)), np.array([[edge.real, edge.imag] for edge in edges])


@pytest.mark.parametrize("land", [1.5, 2.5])
def test_a_side_that_ends_in_the_next_rounding_is_known_as_far_as_that_lets_it(land):
    """The next rounding begins within the scatter, and the land turns towards it."""
    in_sigmas = []
    for seed in range(4):
        cloud, edges = between_two_roundings(land, seed)
        edge = scan_edge(cloud, at=(0.3, *edges[0]))
        off = np.linalg.norm(edge.points[:, 1:] - edges[0], axis=1)
        in_sigmas.append(np.median(off / edge.sigma))
    assert np.median(in_sigmas) < 2.0
    assert max(in_sigmas) < 4.0
