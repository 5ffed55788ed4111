# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes interpolated and approximated by B-spline surfaces."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.geometry import BSplineSurface
from freecad_edgescan.geometry.knot_vectors import clamped_knots
from freecad_edgescan.geometry.surface_approximation import approximated_surface
from freecad_edgescan.geometry.surface_interpolation import interpolated_surface

ONE_SPAN = clamped_knots([0, 1], 3)


def dome(u, v):
    x, y = np.broadcast_arrays(4 * u - 2, 6 * v - 3)
    return np.stack([x, y, np.sqrt(30 - x**2 - y**2)], axis=-1)


def test_a_spline_over_its_own_knots_comes_back():
    rng = np.random.default_rng(1)
    knots = clamped_knots([0, 0.2, 0.7, 1], 3), clamped_knots([0, 0.4, 1], 2)
    surface = BSplineSurface(rng.normal(size=(6, 4, 3)), knots, (3, 2))
    again = interpolated_surface(surface.evaluate, knots, (3, 2))
    assert np.allclose(again.poles, surface.poles, atol=1e-12)
    assert approximated_surface(surface.evaluate, knots, (3, 2), 1e-9).poles.shape == (6, 4, 3)


@pytest.mark.parametrize("tolerance", [1e-1, 1e-3, 1e-5])
def test_the_tolerance_is_kept_between_the_points_too(tolerance):
    surface = approximated_surface(dome, (ONE_SPAN, ONE_SPAN), (3, 3), tolerance)
    u, v = np.linspace(0, 1, 77)[:, None], np.linspace(0, 1, 83)
    assert np.linalg.norm(surface.evaluate(u, v) - dome(u, v), axis=2).max() <= 1.1 * tolerance


def test_only_the_direction_that_bends_gets_more_knots():
    def bent(u, v):
        return np.stack(np.broadcast_arrays(10 * u, 5 * v, np.sin(9 * u)), axis=-1)

    surface = approximated_surface(bent, (ONE_SPAN, ONE_SPAN), (3, 3), 1e-5)
    assert surface.poles.shape[0] > 20 and surface.poles.shape[1] == 4


def test_what_no_spline_follows_is_refused_with_numbers():
    def cracked(u, v):
        return np.stack(np.broadcast_arrays(u, v, (u > 0.3) * 1.0), axis=-1)

    with pytest.raises(ValueError, match=r"above the tolerance of 0\.001 mm"):
        approximated_surface(cracked, (ONE_SPAN, ONE_SPAN), (3, 3), 1e-3)
    with pytest.raises(ValueError, match="tolerance is 0 mm"):
        approximated_surface(dome, (ONE_SPAN, ONE_SPAN), (3, 3), 0)
