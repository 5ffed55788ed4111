# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cleaning of one side of a scan line: what lies on a rounding is given up, and nothing else."""

import numpy as np
import pytest

from freecad_edgescan.scanning.line_section import clean

DEGREES = [1, 2, 3]


def rounded_side(straight=12, pitch=0.5, radius=3.0, turn=0.9):
    """Points along a straight side and on along the exact rounding, the last nearest the edge."""
    a = np.arange(1, int(turn * radius / pitch) + 1) * pitch / radius
    end = (straight - 1) * pitch
    side = np.stack([np.arange(straight) * pitch, np.zeros(straight)], axis=1)
    bend = np.stack([end + radius * np.sin(a), -radius * (1.0 - np.cos(a))], axis=1)
    return np.vstack([side, bend])


def distances(curve, points):
    """Distances of points from a curve, by looking at very many of its points."""
    dense = curve.at(np.linspace(-0.3, 1.3, 16001))
    return np.array([np.sqrt(((dense - p) ** 2).sum(axis=1).min()) for p in points])


def worst_of_own_fit(points, degree):
    """Largest distance of points from the curve of Schreve eq. 4.3.4.1 through them."""
    if degree == 1:
        centred = points - points.mean(axis=0)
        return np.abs(centred @ np.linalg.svd(centred)[2][1]).max()
    u = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
    u /= u[-1]
    dense = np.linspace(-0.2, 1.2, 14001)
    curve = np.stack([np.polyval(np.polyfit(u, axis, degree), dense) for axis in points.T], axis=1)
    return max(np.sqrt(((curve - p) ** 2).sum(axis=1).min()) for p in points)


@pytest.mark.parametrize("degree", DEGREES)
def test_a_small_tolerance_leaves_the_straight_side_and_nothing_of_the_rounding(degree):
    points = rounded_side(straight=12)
    curve, count = clean(points, degree, 1e-5)
    assert count == 12
    assert curve.at(np.array([0.0, 0.5, 1.0, 1.4]))[:, 1] == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("tolerance", [0.002, 0.01, 0.03, 0.07])
@pytest.mark.parametrize("degree", DEGREES)
def test_as_many_points_are_kept_as_lie_within_the_tolerance(degree, tolerance):
    points = rounded_side(turn=1.4)
    curve, count = clean(points, degree, tolerance)
    assert distances(curve, points[:count]).max() <= tolerance + 1e-5
    assert 12 <= count < len(points)
    assert worst_of_own_fit(points[: count + 1], degree) > tolerance


@pytest.mark.parametrize("degree", DEGREES)
def test_a_side_without_a_rounding_is_kept_whole(degree):
    rng = np.random.default_rng(7)
    points = np.stack([np.arange(14) * 0.5, 0.01 * rng.uniform(-1.0, 1.0, 14)], axis=1)
    assert clean(points, degree, 0.03)[1] == 14


@pytest.mark.parametrize("spare", [False, True])
@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("degree", DEGREES)
def test_never_fewer_points_are_kept_than_the_curve_needs(degree, seed, spare):
    """One more than the degree (erratum: Schreve 4.3.3 says as many as the degree)."""
    rng = np.random.default_rng(seed)
    points = np.stack([np.arange(10) * 0.5, 0.2 * rng.normal(size=10)], axis=1)
    curve, count = clean(points, degree, 1e-7, spare)
    assert count >= degree + 1
    assert curve.degree == degree
    if not spare:
        assert count == degree + 1
        assert distances(curve, points[:count]).max() < 1e-3


@pytest.mark.parametrize("degree", DEGREES)
def test_spare_changes_nothing_where_the_tolerance_can_be_held(degree):
    points = rounded_side()
    assert clean(points, degree, 0.01, True)[1] == clean(points, degree, 0.01, False)[1]


@pytest.mark.parametrize("rounded", [False, True])
@pytest.mark.parametrize("degree", DEGREES)
def test_spare_points_are_kept_where_the_tolerance_is_below_the_noise(degree, rounded):
    """Noise that is the same everywhere: giving up good points never makes the curve fit better."""
    points = rounded_side(12) if rounded else rounded_side(17, turn=0.0)
    points = points + 0.03 * np.outer((-1.0) ** np.arange(17), [0.0, 1.0])
    count = clean(points, degree, 0.001, True)[1]
    assert (8 <= count <= 14) if rounded else (count >= 8)
