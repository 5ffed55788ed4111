# SPDX-License-Identifier: LGPL-2.1-or-later
"""Line and torus: the quartic against a dense march along the line."""

import numpy as np
import pytest
from scipy.optimize import brentq

from freecad_edgescan.geometry.ray_torus import ray_torus

TORI = [(10.0, 3.0, 1.0), (3.0, 3.0, 0.0), (2.0, 5.0, -4.0), (-1.5, 6.0, 2.0), (350.0, 40.0, 7.0)]


def marched(start, way, a, r, b, low, high):
    """Crossings of r − distance from the section's centre, found by sign changes."""

    def gap(u):
        p = start + u * way
        return np.hypot(np.hypot(p[0], p[1]) - a, p[2] - b) - r

    u = np.linspace(low, high, 4001)
    p = start + u[:, None] * way
    values = np.hypot(np.hypot(p[:, 0], p[:, 1]) - a, p[:, 2] - b) - r
    turns = np.flatnonzero(np.sign(values[:-1]) != np.sign(values[1:]))
    return np.array([brentq(gap, u[i], u[i + 1], xtol=1e-13) for i in turns])


@pytest.mark.parametrize(("a", "r", "b"), TORI)
def test_every_intersection_is_found(a, r, b):
    rng = np.random.default_rng(3)
    size = abs(a) + r
    met = 0
    for _ in range(150):
        aim = rng.normal(size=3) * [0.5 * size, 0.5 * size, 0.7 * r] + [0.0, 0.0, b]
        way = rng.normal(size=3)
        way /= np.linalg.norm(way)
        start = aim - 3.0 * size * way
        found, v, azimuth = ray_torus(start, way, a, r, b)
        truth = marched(start, way, a, r, b, 0.0, 6.0 * size)
        # A line that only grazes the torus may be missed by the march.
        assert len(found) >= len(truth)
        for u in truth:
            assert np.abs(found - u).min() < 1e-7 * size
        for u, angle, turn in zip(found, v, azimuth, strict=True):
            rho = a + r * np.cos(angle)
            place = [rho * np.cos(turn), rho * np.sin(turn), b + r * np.sin(angle)]
            assert start + u * way == pytest.approx(place, abs=1e-7 * size)
        met += len(truth)
    assert met > 100


def test_a_line_that_misses_meets_nothing():
    found, v, azimuth = ray_torus(np.array([0.0, 0.0, 20.0]), np.array([1.0, 0, 0]), 10.0, 3.0, 0.0)
    assert len(found) == len(v) == len(azimuth) == 0


def test_the_axis_meets_a_spindle_torus_on_its_two_tips():
    """With a < r the torus crosses the axis where r sin v = ±√(r² − a²); -a makes no others."""
    near_axis, off_axis = np.array([1e-4, 0.0, -20.0]), np.array([1.0, 0.0, -20.0])
    up = np.array([0.0, 0.0, 1.0])
    found, _, _ = ray_torus(near_axis, up, 3.0, 5.0, 0.0)
    assert found == pytest.approx([16.0, 24.0], abs=1e-3)
    inside, _, _ = ray_torus(near_axis, up, -3.0, 5.0, 0.0)
    assert inside == pytest.approx([16.0, 24.0], abs=1e-3)
    # Off the axis the two differ: the arcs of -a lie inside of those of a.
    outer, _, _ = ray_torus(off_axis, up, 3.0, 5.0, 0.0)
    inner, _, _ = ray_torus(off_axis, up, -3.0, 5.0, 0.0)
    assert outer == pytest.approx([20 - np.sqrt(21.0), 20 + np.sqrt(21.0)])
    assert inner == pytest.approx([17.0, 23.0])
