# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a rounding begins, seen by many lines together, against exact roundings of known radius."""

from dataclasses import dataclass

import numpy as np
import pytest

from freecad_edgescan.scanning.probed_rounding import rounding_begins

REACH, PITCH = 8.0, 0.4
TOLERANCE = 0.1
STEP = 0.6 * REACH / 23  # between two places that are tried


@dataclass(frozen=True)
class Side:
    """Half of a wedge with a rounding: the edge is the origin, the side leaves it along s.

    Attributes
    ----------
    curved : signed radius of the side, positive where its centre lies in the air (n > 0)
    rounding : radius; its centre lies on the bisector of the wedge, in the material
    """

    angle: float
    rounding: float = 0.0
    curved: float = np.inf

    @property
    def bisector(self):
        return np.array([np.cos(0.5 * self.angle), -np.sin(0.5 * self.angle)])

    @property
    def centre(self):
        """Centre of the rounding: where its circle and the side have one point in common."""
        r, side, sine = self.rounding, self.curved, -self.bisector[1]
        if np.isinf(side):
            return r / sine * self.bisector
        root = np.sqrt((side * sine) ** 2 + 2.0 * side * r + r**2)
        return (np.sign(side) * root - side * sine) * self.bisector

    @property
    def begins(self):
        """The common point, (2,)."""
        if np.isinf(self.curved):
            return self.centre * [1.0, 0.0]
        middle = np.array([0.0, self.curved])
        return middle + self.curved / (self.curved + self.rounding) * (self.centre - middle)

    def line(self, rng, noise):
        """Points (n, 2) of one line at the line pitch, with noise square to the surface."""
        along = np.arange(-2.0 * self.rounding, REACH, PITCH) + rng.uniform(0.0, PITCH)
        if np.isinf(self.curved):
            normals = np.tile([0.0, 1.0], (len(along), 1))
            points = self.begins + along[:, None] * [1.0, 0.0]
        else:
            turn = np.arcsin(self.begins[0] / self.curved) + along / self.curved
            normals = np.stack([-np.sin(turn), np.cos(turn)], axis=1)
            points = np.array([0.0, self.curved]) - self.curved * normals
        if self.rounding:
            x, y = self.begins - self.centre
            turn = np.arctan2(y, x) - along / self.rounding
            out = np.stack([np.cos(turn), np.sin(turn)], axis=1)
            rounded = (along < 0.0)[:, None]
            normals = np.where(rounded, out, normals)
            points = np.where(rounded, self.centre + self.rounding * out, points)
        # The other half of the wedge begins at the bisector.
        here = (along > 0.0) | (points @ [-self.bisector[1], self.bisector[0]] > 0.0)
        points = points + noise * rng.normal(size=(len(along), 1)) * normals
        return points[here & (points[:, 0] > 0.0)][::-1]

    def lines(self, noise, seed=0, count=40):
        rng = np.random.default_rng([seed, 5])
        return [self.line(rng, noise) for _ in range(count)]

    def stands_off(self, s):
        """How far the rounding stands off the side at s, to the second order."""
        bent = 1.0 / self.rounding + 1.0 / self.curved
        return 0.5 * bent * max(self.begins[0] - s, 0.0) ** 2


def found(side, noise, seeds=5, **more):
    return np.array(
        [rounding_begins(side.lines(noise, seed, **more), TOLERANCE) for seed in range(seeds)]
    )


def test_the_test_part_is_smooth_where_its_rounding_begins():
    for curved in (np.inf, 12.0, -12.0):
        side = Side(np.radians(100.0), 1.5, curved)
        points = side.line(np.random.default_rng(0), 0.0)
        steps = np.diff(points, axis=0)
        turns = np.diff(np.unwrap(np.arctan2(steps[:, 1], steps[:, 0])))
        assert np.linalg.norm(steps, axis=1) == pytest.approx(PITCH, rel=0.02)
        assert np.abs(turns).max() < 1.05 * PITCH / 1.5
        to_rounding = np.linalg.norm(points - side.centre, axis=1) - 1.5
        assert to_rounding.min() > -1e-9


@pytest.mark.parametrize("noise", [0.0, 0.005, 0.02])
@pytest.mark.parametrize("curved", [np.inf, 30.0, 12.0, -30.0])
@pytest.mark.parametrize(
    ("degrees", "rounding"), [(80.0, 1.0), (80.0, 2.5), (100.0, 2.0), (120.0, 3.0)]
)
def test_a_rounding_begins_where_its_circle_touches_the_side(degrees, rounding, curved, noise):
    """Up to where it stands out of the noise, and to the places that are tried."""
    side = Side(np.radians(degrees), rounding, curved)
    begin = np.median(found(side, noise))
    assert begin <= side.begins[0] + STEP
    assert side.stands_off(begin + STEP) < 4.0 * max(noise, 0.01 * TOLERANCE)
    assert begin > 0.5 * side.begins[0] - STEP


@pytest.mark.parametrize("noise", [0.0, 0.02])
def test_a_rounding_twice_as_large_begins_twice_as_far_away(noise):
    small, large = (np.median(found(Side(np.radians(90.0), r), noise)) for r in (1.25, 2.5))
    assert large == pytest.approx(2.0 * small, abs=2.0 * STEP)


@pytest.mark.parametrize("curved", [np.inf, 40.0, 9.0, -9.0, 6.0])
def test_no_rounding_begins_on_a_side_without_noise_however_curved(curved):
    assert (found(Side(np.radians(100.0), 0.0, curved), 0.0) == 0.0).all()


@pytest.mark.parametrize("noise", [0.002, 0.02])
@pytest.mark.parametrize("curved", [np.inf, 40.0, 9.0, -9.0, 6.0])
def test_no_rounding_is_seen_in_noise_on_a_sharp_edge_however_curved(curved, noise):
    """But for one line set in ten, whose scatter is smaller far from the edge by chance."""
    begins = found(Side(np.radians(100.0), 0.0, curved), noise, seeds=20)
    assert np.count_nonzero(begins) <= 4


def test_lines_too_short_to_tell_show_no_rounding():
    side = Side(np.radians(90.0), 2.0)
    assert rounding_begins([line[-4:] for line in side.lines(0.01)], TOLERANCE) == 0.0


def test_lines_of_different_length_are_seen_together():
    side, rng = Side(np.radians(90.0), 2.0), np.random.default_rng(3)
    lines = [line[rng.integers(0, 6) :] for line in side.lines(0.01)]
    assert rounding_begins(lines, TOLERANCE) == pytest.approx(
        np.median(found(side, 0.01)), abs=2.0 * STEP
    )


@pytest.mark.parametrize("tolerance", [0.01, 0.05, 0.2])
def test_what_is_far_below_the_tolerance_is_no_rounding(tolerance):
    """A rounding so small that it stands off by a hundredth of the tolerance is not seen."""
    side = Side(np.radians(100.0), 2.0)
    begins = rounding_begins(side.lines(0.0), tolerance)
    assert side.stands_off(begins + STEP) < 4.0 * 0.01 * tolerance
    assert rounding_begins(side.lines(0.0), 1e3) == 0.0
