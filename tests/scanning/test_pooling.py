# SPDX-License-Identifier: LGPL-2.1-or-later
"""A side is a plane, or bent, by evidence."""

import numpy as np
import pytest

from freecad_edgescan.scanning.pooling import _perhaps_plane
from freecad_edgescan.scanning.side_fit import PRIOR_SIGMA


def averaged(mean, sigma):
    shrunk, left = _perhaps_plane(np.array([mean]), np.array([sigma**2]))
    return float(shrunk[0]), float(left[0])


def test_what_is_surely_bent_stays_as_it_is():
    assert averaged(0.5, 0.02) == pytest.approx((0.5, 0.02), rel=1e-2)


def test_the_better_a_plane_is_known_the_more_it_is_one():
    mean, sigma = averaged(0.0005, 0.001)
    assert abs(mean) < 0.1 * 0.0005
    assert sigma < 0.2 * 0.001


def test_where_nothing_is_known_the_evidence_is_even():
    """Half a plane, half bent: the variance is half of the bent one."""
    mean, sigma = averaged(0.0, 100.0)
    assert mean == 0.0
    assert sigma == pytest.approx(100.0 * np.sqrt(0.5), rel=1e-3)


@pytest.mark.parametrize("sigma", [0.01, 0.03, 0.1])
def test_stated_sigmas_are_true_for_planes_and_bent_sides_together(sigma):
    """Drawn as the models say: half planes, half bent; the average is calibrated."""
    rng = np.random.default_rng(5)
    true = np.where(rng.random(40_000) < 0.5, 0.0, PRIOR_SIGMA[2] * rng.normal(size=40_000))
    seen = true + sigma * rng.normal(size=len(true))
    mean, stated = _perhaps_plane(seen, np.full(len(true), sigma**2))
    error = mean - true
    assert np.mean(error**2 / stated**2) == pytest.approx(1.0, abs=0.1)
    # And better than what was seen.
    assert np.mean(error**2) < 0.75 * sigma**2
