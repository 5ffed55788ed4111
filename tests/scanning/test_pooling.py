# SPDX-License-Identifier: LGPL-2.1-or-later
"""A side is a plane, or bent, by evidence."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.ndimage import uniform_filter1d

from freecad_edgescan.scanning.normal_equations import PRIOR_SIGMA
from freecad_edgescan.scanning.pooling import _perhaps_plane, shared_curvature


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


def shared(true, scatter=0.6, seed=0):
    """Curvature that sections agree on, their sigma, and how many they mostly ask.

    Each of 300 sections has measured its sides with some scatter, and has pooled nine of them.
    """
    rng = np.random.default_rng(seed)
    own = true + scatter * rng.normal(size=true.shape)
    pooled = uniform_filter1d(own, 9, axis=0, mode="nearest")
    count, inverse = true.shape, np.zeros((*true.shape, 4, 4))
    inverse[..., 2, 2] = scatter**2 / 9.0
    coefficients = np.zeros((*count, 4))
    coefficients[..., 2] = pooled
    fits = SimpleNamespace(coefficients=coefficients, variance=np.ones(count), inverse=inverse)
    path = SimpleNamespace(closed=False, spacing=1.0)
    return shared_curvature(fits, path, 0.5)


PLACE = np.linspace(0.0, 1.0, 300)[:, None] * np.ones(2)


def test_sides_that_keep_their_curvature_share_it_with_many():
    error, stated = [], []
    for seed in range(30):
        mean, sigma, (_, asked) = shared(np.full(PLACE.shape, 0.5), seed=seed)
        assert asked > 8
        error.append((mean - 0.5)[20:-20])
        stated.append(sigma[20:-20])
    # The mean over 17 sections of pooled ones has the points of 25: it is a quarter worse at least.
    assert np.sqrt(np.mean(np.square(error))) < 0.75 * 0.6 / np.sqrt(25.0)
    assert np.mean(np.square(error)) == pytest.approx(np.mean(np.square(stated)), rel=0.4)


@pytest.mark.parametrize(
    "true",
    [0.9 * np.sin(2.0 * np.pi * 3.0 * PLACE), np.where(PLACE < 0.5, 0.0, 0.9)],
    ids=["waves", "from a plane to a bend"],
)
def test_sides_that_change_their_curvature_ask_fewer_and_say_how_much_it_changes(true):
    error, stated = [], []
    for seed in range(10):
        mean, sigma, _ = shared(true, seed=seed)
        error.append(mean - true)
        stated.append(sigma)
    error, stated = np.array(error), np.array(stated)
    assert np.sqrt(np.mean((error / stated) ** 2)) < 1.5
    # A mean over all that may be asked would be off by half a millimetre's bend and more.
    assert np.sqrt(np.mean(error**2)) < 0.25
