# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pitch and noise against clouds whose pitch and noise are known."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.cloud import PointCloud

PITCH = 0.4
SHARE = 0.15  # how far an estimate may be off


def sampling(kind: str, ratio: float = 1.0, side: float = 60.0) -> np.ndarray:
    """Places in a square, (n, 2), one for each PITCH², rows ``ratio`` times as far as columns."""
    rng = np.random.default_rng(5)
    if kind == "random":
        return rng.uniform(0, side * PITCH, (int(side**2), 2))
    step = PITCH * np.array([ratio**-0.5, ratio**0.5])
    i, j = np.meshgrid(np.arange(side * ratio**0.5), np.arange(side / ratio**0.5))
    places = np.column_stack([i.ravel(), j.ravel()])
    if kind == "jittered":
        places += rng.uniform(-0.3, 0.3, places.shape)
    return places * step


def plane(places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Points and normals of a tilted plane."""
    frame = np.linalg.qr(np.random.default_rng(9).normal(size=(3, 3)))[0]
    return places @ frame[:2], np.tile(frame[2], (len(places), 1))


def cylinder(places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A cylinder of 15 mm radius: curvature, but no cloud folded onto itself."""
    angle = places[:, 0] / 15.0
    normals = np.column_stack([np.cos(angle), np.sin(angle), np.zeros(len(places))])
    return normals * 15.0 + np.outer(places[:, 1], [0, 0, 1]), normals


def stairs(places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Plates of 15 pitches, each at a right angle to the next: an edge in most neighbourhoods."""
    width = 15 * PITCH
    plate = (places[:, 0] // width).astype(int)
    beyond = places[:, 0] - plate * width
    upright = plate % 2 == 1
    x = np.where(upright, (plate + 1) // 2 * width, plate // 2 * width + beyond)
    z = np.where(upright, plate // 2 * width + beyond, plate // 2 * width)
    normals = np.where(upright[:, None], [-1.0, 0, 0], [0, 0, 1.0])
    return np.column_stack([x, places[:, 1], z]), normals


def noisy(points, normals, sigma, law="gaussian"):
    """With noise whose standard deviation along the normal is sigma."""
    rng = np.random.default_rng(6)
    if law == "gaussian":
        return points + normals * rng.normal(0, sigma, (len(points), 1))
    return points + rng.uniform(-1, 1, points.shape) * sigma * 3**0.5


SAMPLINGS = [("grid", 1.0), ("jittered", 1.0), ("random", 1.0), ("grid", 4.0), ("jittered", 4.0)]
SURFACES = [plane, cylinder, stairs]


@pytest.mark.parametrize("surface", SURFACES)
@pytest.mark.parametrize(("kind", "ratio"), SAMPLINGS)
@pytest.mark.parametrize(
    ("share", "law"), [(0.01, "gaussian"), (0.1, "uniform"), (0.5, "gaussian"), (0.5, "uniform")]
)
def test_pitch_and_noise_are_those_the_cloud_was_made_with(surface, kind, ratio, share, law):
    cloud = PointCloud(noisy(*surface(sampling(kind, ratio)), share * PITCH, law))
    assert cloud.pitch == pytest.approx(PITCH, rel=SHARE)
    assert cloud.noise == pytest.approx(share * PITCH, rel=SHARE)


@pytest.mark.parametrize("share", [0.01, 0.1, 0.5])
def test_pitch_and_noise_of_a_sphere_are_those_it_was_made_with(share):
    rng = np.random.default_rng(3)
    normals = rng.normal(size=(5000, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    pitch = np.sqrt(4 * np.pi * 20.0**2 / 5000)
    cloud = PointCloud(noisy(20.0 * normals, normals, share * pitch))
    assert cloud.pitch == pytest.approx(pitch, rel=SHARE)
    assert cloud.noise == pytest.approx(share * pitch, rel=SHARE)


def test_a_small_cloud_is_not_taken_for_a_coarse_one_because_of_its_rim():
    cloud = PointCloud(noisy(*plane(sampling("random", side=20.0)), 0.04))
    assert cloud.pitch == pytest.approx(PITCH, rel=SHARE)
    assert cloud.noise == pytest.approx(0.04, rel=SHARE)


def test_exact_points_have_no_noise_near_the_origin_or_far_from_it():
    points, _ = stairs(sampling("random"))
    assert PointCloud(points).noise < 1e-12
    assert PointCloud(points + np.array([1e6, -2e6, 3e5])).noise < 1e-8


@pytest.mark.parametrize("outliers", [0.01, 0.03])
def test_outliers_are_not_taken_for_noise(outliers):
    points, normals = plane(sampling("random"))
    rng = np.random.default_rng(8)
    cloud = noisy(points, normals, 0.05)
    stray = rng.random(len(points)) < outliers
    cloud[stray] += normals[stray] * rng.normal(0, 1.0, (stray.sum(), 1))
    assert PointCloud(cloud).noise == pytest.approx(0.05, rel=SHARE)


@pytest.mark.parametrize("ratio", [1.0, 2.0, 4.0, 8.0])
@pytest.mark.parametrize("surface", [plane, cylinder])
def test_the_two_local_pitches_of_a_grid_are_its_two_spacings(surface, ratio):
    points, normals = surface(sampling("grid", ratio))
    middle = np.argsort(np.linalg.norm(points - points.mean(axis=0), axis=1))[:300]
    pitches = PointCloud(noisy(points, normals, 0.02)).local_pitch(points[middle])
    assert pitches.shape == (300, 2)
    assert (pitches[:, 0] >= pitches[:, 1]).all()
    expected = PITCH * np.array([ratio**0.5, ratio**-0.5])
    assert np.median(pitches, axis=0) == pytest.approx(expected, rel=SHARE)


def test_points_strewn_at_random_have_no_preferred_direction():
    points, normals = plane(sampling("random"))
    pitches = PointCloud(noisy(points, normals, 0.02)).local_pitch(points)
    assert np.median(pitches, axis=0) == pytest.approx([PITCH, PITCH], rel=SHARE)


def test_local_pitch_is_right_on_a_fold_and_at_the_rim():
    points, _ = stairs(sampling("grid"))
    on_fold = np.array([[15 * PITCH, 12.0, 0.0]])
    at_rim = np.array([[8 * PITCH, 0.0, 0.0]])
    for place in (on_fold, at_rim):
        areas = PointCloud(points).local_pitch(place).prod(axis=1)
        assert np.sqrt(areas) == pytest.approx(PITCH, rel=SHARE)


def test_local_pitch_follows_a_cloud_that_is_denser_on_one_side():
    coarse = sampling("grid")
    fine = sampling("grid") / 4 - [30.0, 0.0]
    cloud = PointCloud(np.pad(np.concatenate([coarse, fine]), ((0, 0), (0, 1))))
    assert cloud.local_pitch((12.0, 12.0, 0.0)) == pytest.approx(PITCH, rel=SHARE)
    assert cloud.local_pitch((-27.0, 3.0, 0.0)) == pytest.approx(PITCH / 4, rel=SHARE)


def test_estimates_are_repeatable_and_kept():
    points = noisy(*plane(sampling("random")), 0.02)
    first, second = PointCloud(points), PointCloud(points)
    assert (first.pitch, first.noise) == (second.pitch, second.noise)
    assert first.noise is first.noise


def test_hardly_any_points_give_no_estimate_but_no_failure_either():
    for points in ([[0, 0, 0]], [[0, 0, 0], [1, 0, 0]], np.eye(3), np.ones((40, 3))):
        cloud = PointCloud(points)
        assert not cloud.pitch < 0
        assert cloud.noise == 0.0
        assert cloud.local_pitch((0, 0, 0)).shape == (1, 2)
