# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tangent and bend of an edge from its scattered edge points, against curves in a formula."""

import numpy as np
import pytest

from freecad_edgescan.scanning.probed_path import smooth_frames

LENGTH = 2.0
UPRIGHT = np.array([0.0, 0.0, 1.0])


class Line:
    """Along (2, 1, -2) / 3."""

    way = np.array([2.0, 1.0, -2.0]) / 3.0

    def at(self, s):
        """Points, unit tangents and curvature vectors (m, 3) at arc lengths (m,)."""
        return s[:, None] * self.way, np.tile(self.way, (len(s), 1)), np.zeros((len(s), 3))


class Helix:
    """Round the z axis; a circle when it does not rise."""

    def __init__(self, radius, rise=0.0):
        self.radius, self.rise = radius, rise

    def at(self, s):
        slant = np.hypot(1.0, self.rise)
        a = s / (self.radius * slant)
        out = np.stack([np.cos(a), np.sin(a), 0.0 * a], axis=1)
        round_it = np.stack([-np.sin(a), np.cos(a), 0.0 * a], axis=1)
        points = self.radius * out + (self.rise * s / slant)[:, None] * UPRIGHT
        tangents = (round_it + self.rise * UPRIGHT) / slant
        return points, tangents, -out / (self.radius * slant**2)


CURVES = {
    "line": Line(),
    "tight circle": Helix(8.0),
    "wide circle": Helix(100.0),
    "helix": Helix(15.0, 0.4),
}
curves = pytest.mark.parametrize("curve", CURVES.values(), ids=CURVES.keys())


def scattered(curve, s, noise=0.0, tangent_noise=0.0, seed=0):
    """Edge points and tangents as a walk finds them, with errors in all directions."""
    rng = np.random.default_rng([seed, 6])
    points, tangents, _ = curve.at(s)
    points = points + noise * rng.normal(size=points.shape)
    tangents = tangents + tangent_noise * rng.normal(size=points.shape)
    return points, tangents / np.linalg.norm(tangents, axis=1, keepdims=True)


def smoothed(points, tangents):
    sides = np.tile([[1.0, 0.3, 0.2], [-0.2, 0.4, 1.0]], (len(points), 1, 1))
    return smooth_frames(points, tangents, sides, LENGTH)


def angles(found, true):
    return np.arctan2(
        np.linalg.norm(np.cross(found, true), axis=1), np.einsum("mi,mi->m", found, true)
    )


def rms(values):
    return np.sqrt(np.mean(np.square(values)))


@curves
@pytest.mark.parametrize("uneven", [0.0, 0.4], ids=["even steps", "uneven steps"])
def test_without_noise_tangent_and_bend_are_those_of_the_curve(curve, uneven):
    s = np.arange(40.0) + uneven * np.random.default_rng(1).uniform(-1.0, 1.0, 40)
    points, tangents, bend = curve.at(s)
    frames = smoothed(points, tangents)
    wrong = angles(frames.tangent, tangents)
    curvature = np.linalg.norm(bend, axis=1).max()
    bend_off = np.linalg.norm(frames.bend - bend, axis=1)
    inner = slice(5, -5)
    assert wrong[inner].max() < 5e-3  # a parabola knows no torsion
    assert bend_off[inner].max() <= 0.04 * curvature + 1e-12
    # At the ends the parabola lies on one side only.
    assert wrong.max() < 0.02
    assert bend_off.max() <= 0.1 * curvature + 1e-12
    assert np.linalg.norm(frames.origin - points, axis=1).max() < 0.01


@curves
def test_frames_stand_across_the_smooth_course(curve):
    frames = smoothed(*scattered(curve, np.arange(30.0), 0.02, 0.02))
    assert np.linalg.norm(frames.tangent, axis=1) == pytest.approx(1.0, abs=1e-12)
    assert np.einsum("mki,mi->mk", frames.sides, frames.tangent) == pytest.approx(0.0, abs=1e-12)
    assert np.einsum("mi,mi->m", frames.bend, frames.tangent) == pytest.approx(0.0, abs=1e-9)


@curves
@pytest.mark.parametrize("noise", [0.02, 0.1])
def test_many_points_know_tangent_and_bend_better_than_the_next_ones(curve, noise):
    """Better than the chord and the circle of an edge point and its two neighbours."""
    s, inner = np.arange(60.0), slice(5, -5)
    points, tangents = scattered(curve, s, noise, 0.05)
    exact, true_tangents, true_bend = curve.at(s)
    frames = smoothed(points, tangents)

    ahead, behind = np.diff(points, axis=0)[1:], np.diff(points, axis=0)[:-1]
    chords = angles(ahead + behind, true_tangents[1:-1])
    wrong = angles(frames.tangent, true_tangents)
    assert rms(wrong[inner]) < 0.6 * rms(chords)
    assert rms(wrong) < 0.05  # the walk's own tangents have √2 times this

    three_points = ahead - behind  # second differences, at steps of 1 mm
    bend_off = np.linalg.norm(frames.bend - true_bend, axis=1)
    assert rms(bend_off[inner]) < 0.15 * rms(np.linalg.norm(three_points - true_bend[1:-1], axis=1))
    assert rms(np.linalg.norm(frames.origin - exact, axis=1)[inner]) < 0.85 * np.sqrt(3.0) * noise


@curves
def test_both_ends_are_known_alike_and_look_forward(curve):
    wrong = []
    for seed in range(20):
        points, tangents = scattered(curve, np.arange(40.0), 0.05, 0.05, seed)
        frames = smoothed(points, tangents)
        true = curve.at(np.arange(40.0))[1]
        assert (np.einsum("mi,mi->m", frames.tangent, true) > 0.9).all()
        wrong.append(angles(frames.tangent, true))
    first, middle, last = (rms(part) for part in np.array(wrong)[:, [0, 20, 39]].T)
    assert first == pytest.approx(last, rel=0.6)
    assert middle < first < 0.1


def test_a_walk_the_other_way_has_the_same_course():
    points, tangents = scattered(CURVES["helix"], np.arange(25.0), 0.05, 0.03)
    there, back = smoothed(points, tangents), smoothed(points[::-1], -tangents[::-1])
    assert back.tangent[::-1] == pytest.approx(-there.tangent, abs=1e-9)
    assert back.origin[::-1] == pytest.approx(there.origin, abs=1e-9)
    assert back.bend[::-1] == pytest.approx(there.bend, abs=1e-9)


# ---------------------------------------------------------------- few points, and dense ones


@curves
def test_two_points_have_the_direction_from_one_to_the_other_and_no_bend(curve):
    points, tangents, _ = curve.at(np.array([3.0, 4.0]))
    frames = smoothed(points, tangents)
    chord = (points[1] - points[0]) / np.linalg.norm(points[1] - points[0])
    assert frames.tangent == pytest.approx(np.array([chord, chord]), abs=1e-3)
    assert np.array_equal(frames.bend, np.zeros((2, 3)))
    assert frames.origin == pytest.approx(points, abs=1e-3)


def test_one_point_keeps_the_tangent_of_the_walk():
    points, tangents, _ = CURVES["helix"].at(np.array([3.0]))
    frames = smoothed(points, tangents)
    assert frames.origin == pytest.approx(points)
    assert frames.tangent == pytest.approx(tangents)
    assert np.array_equal(frames.bend, np.zeros((1, 3)))


@pytest.mark.parametrize("count", [3, 4, 6])
@curves
def test_a_few_points_already_tell_the_bend(curve, count):
    points, tangents, bend = curve.at(np.arange(float(count)))
    frames = smoothed(points, tangents)
    size = np.linalg.norm(bend[0])
    assert np.linalg.norm(frames.bend - bend, axis=1).max() <= 0.15 * size + 1e-12
    assert angles(frames.tangent, tangents).max() < 0.02


@pytest.mark.parametrize(("step", "noise"), [(0.1, 0.02), (0.1, 0.1), (0.1, 0.2)])
@pytest.mark.parametrize("curve", [CURVES["line"], Helix(20.0)], ids=["line", "circle"])
def test_points_closer_together_than_they_scatter_do_not_spoil_the_direction(curve, step, noise):
    """The walk's own tangents hold it."""
    s, inner, known = np.arange(60.0) * step, slice(5, -5), 0.05
    wrong, walked = [], []
    for seed in range(5):
        points, tangents = scattered(curve, s, noise, known, seed)
        true = curve.at(s)[1]
        wrong.append(angles(smoothed(points, tangents).tangent, true)[inner])
        walked.append(angles(tangents, true)[inner])
    assert rms(wrong) < rms(walked)
