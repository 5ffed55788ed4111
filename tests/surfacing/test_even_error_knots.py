# SPDX-License-Identifier: LGPL-2.1-or-later
"""Knots stand close where a curve bends."""

from __future__ import annotations

import numpy as np

from freecad_edgescan.geometry.knot_vectors import clamped_knots
from freecad_edgescan.surfacing.even_error_knots import even_error_knots
from freecad_edgescan.surfacing.spline_poles import basis_values, poles_through

AT = np.linspace(0, 1, 500)


def largest_error(knots, samples):
    fitted = basis_values(knots, 3, AT) @ poles_through(knots, 3, AT, samples)
    return np.linalg.norm(samples - fitted, axis=1).max()


def test_a_tight_bend_between_straights_gets_most_knots():
    bend = np.stack([100 * AT, 20 * np.tanh((AT - 0.7) / 0.03), 0 * AT], axis=1)
    knots = even_error_knots(AT, bend, 12, 3)
    inner = knots[4:-4]
    assert np.sum(np.abs(inner - 0.7) < 0.15) >= 6
    assert largest_error(knots, bend) < 0.2 * largest_error(
        clamped_knots(np.linspace(0, 1, 10), 3), bend
    )


def test_a_curve_that_bends_evenly_keeps_even_knots():
    circle = np.stack([np.cos(2 * AT), np.sin(2 * AT), 0 * AT], axis=1)
    knots = even_error_knots(AT, circle, 9, 3)
    assert np.allclose(knots[3:-3], np.linspace(0, 1, 7), atol=0.05)


def test_rounding_is_no_error_to_share():
    at = np.linspace(0, 1, 600)
    rough = np.random.default_rng(0).normal(0, 1e-10, (600, 3))
    knots = even_error_knots(at, 60 * at[:, None] * [1.0, 0, 0] + rough, 11, 3)
    assert np.allclose(np.diff(np.unique(knots)), 1 / 8)


def test_a_straight_line_has_no_error_to_share():
    knots = even_error_knots(AT, np.outer(AT, [3.0, 4, 0]), 6, 3)
    assert np.all(np.diff(knots[3:-3]) > 0)
