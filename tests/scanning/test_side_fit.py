# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest

from freecad_edgescan.scanning.normal_equations import (
    BLOCK_EDGES,
    BLOCKS,
    block_moments,
    sum_stretches,
)
from freecad_edgescan.scanning.section import SectionPoints
from freecad_edgescan.scanning.side_fit import choose_stretches, fit_summed

REACH = 12.0
WIDEST = REACH * np.diff(BLOCK_EDGES).max()


def side_points(shape, noise=0.0, count=600, seed=0, width=1.5, reach=REACH):
    """Both sides of one section with the same shape: height(away, along)."""
    rng = np.random.default_rng([seed, 5])
    n = 2 * count
    away, along = rng.uniform(0, reach, n), rng.uniform(-width, width, n)
    height = shape(away, along) + noise * rng.normal(size=n)
    zero = np.zeros(n, dtype=int)
    return SectionPoints(np.arange(n), zero, along, np.repeat([0, 1], count), away, height)


def circle(radius, slope=0.0, level=0.0):
    """Height of a circle that leaves the edge at a level and a slope and bends upwards."""

    def height(away, along):
        turn = np.arctan(slope)
        s0, n0 = -radius * np.sin(turn), level + radius * np.cos(turn)
        return n0 - np.sign(radius) * np.sqrt(radius**2 - (away - s0) ** 2)

    return height


def coefficients_of_circle(radius, slope, level):
    """c0, c1, c2 of the circle through (0, level) with that slope there, in reaches."""
    turn = np.arctan(slope)
    s0, n0 = -radius * np.sin(turn), level + radius * np.cos(turn)
    return np.array([(s0**2 + n0**2 - radius**2) / (2 * n0) / REACH, -s0 / n0, REACH / n0])


def fitted(points, noise, **more):
    moments = block_moments(points, 1, REACH)
    return choose_stretches(moments, REACH, noise, np.zeros((1, 2)), **more)


@pytest.mark.parametrize("radius", [20.0, 60.0, -60.0, 1e4])
@pytest.mark.parametrize("slope", [0.0, 0.2])
def test_a_circle_is_recovered_exactly(radius, slope):
    points = side_points(circle(radius, slope, 0.1))
    fits = fitted(points, 1e-4, curvature_sigma=1.0)
    wanted = coefficients_of_circle(radius, slope, 0.1)
    for k in range(2):
        assert fits.coefficients[0, k, :3] == pytest.approx(wanted, abs=1e-6)
        assert fits.coefficients[0, k, 3] == pytest.approx(0.0, abs=1e-6)
    assert fits.accepted.all()
    assert np.abs(fits.residuals(points)).max() < 1e-5


def test_a_plane_that_drifts_along_the_edge_is_recovered_exactly():
    points = side_points(lambda s, u: 0.05 + 0.1 * s - 0.07 * u)
    fits = fitted(points, 1e-4)
    wanted = [0.05 / REACH, 0.1, 0.0, -0.07]
    assert fits.coefficients[0, 0] == pytest.approx(wanted, abs=1e-6)
    assert fits.stretch[0].tolist() == [[0, BLOCKS], [0, BLOCKS]]


@pytest.mark.parametrize("noise", [0.01, 0.05])
@pytest.mark.parametrize("touching", [1.0, 3.0])
@pytest.mark.parametrize(("count", "allowed"), [(600, 2.5), (5000, 1.5)])
def test_a_stretch_leaves_out_the_rounding_and_little_else(noise, touching, count, allowed):
    """What is left of the rounding moves the side, at the edge, by no more than a noise or two."""

    def rounded(s, u):
        within = np.maximum(touching - s, 0.0)
        return -touching + np.sqrt(touching**2 - within**2)

    for seed in range(6):
        points = side_points(rounded, noise, count, seed)
        fits = fitted(points, noise, slack=0.05, scatter=1.8)
        begins = fits.begins[0]
        # A rounding falls below the noise a little before it touches the side.
        hidden = np.sqrt(2 * touching * 2 * noise)
        assert (begins > touching - hidden - WIDEST / 2).all()
        assert (begins < touching + 2 * WIDEST).all()
        assert np.abs(fits.coefficients[0, :, 0] * REACH).max() < allowed * noise


def test_a_stretch_stops_where_a_second_surface_begins():
    def broken(s, u):
        return 0.5 * np.maximum(s - 7.0, 0.0)

    for seed in range(6):
        fits = fitted(side_points(broken, 0.02, seed=seed), 0.02)
        assert fits.accepted.all()
        assert (fits.ends[0] < 7.0 + 0.5 * WIDEST).all()
        assert (fits.begins[0] < 1.0).all()
        assert np.abs(fits.coefficients[0, :, 0] * REACH).max() < 0.02


def test_a_side_that_is_nowhere_smooth_is_not_accepted():
    fits = fitted(side_points(lambda s, u: 0.3 * np.sin(4 * s), 0.01), 0.01)
    assert not fits.accepted.any()


def test_the_stated_variance_is_the_scatter_of_the_fits():
    noise, c0, stated = 0.05, [], []
    for seed in range(300):
        points = side_points(lambda s, u: 0.0 * s, noise, count=150, seed=seed)
        summed = sum_stretches(block_moments(points, 1, REACH), np.array([[[2, BLOCKS]] * 2]))
        two = np.full((1, 2), noise)
        whole = np.array([[[2, BLOCKS]] * 2])
        fits = fit_summed(summed, REACH, two, whole, np.zeros((1, 2)), np.full((1, 2), 0.3))
        c0.extend(fits.coefficients[0, :, 0])
        stated.extend((noise / REACH) ** 2 * fits.inverse[0, :, 0, 0])
        assert fits.variance[0] == pytest.approx([(noise / REACH) ** 2] * 2, rel=0.6)
    assert np.std(c0) == pytest.approx(np.sqrt(np.mean(stated)), rel=0.1)


def test_a_bent_side_that_begins_far_from_the_edge_is_drawn_out_without_bias():
    """Noise moves the circle's own terms; its mean error shrinks with the points nevertheless."""
    noise, radius = 0.05, 30.0
    stretch = np.array([[[8, BLOCKS]] * 2])
    wanted = coefficients_of_circle(radius, 0.0, 0.0)
    expected, sigma = np.full((1, 2), wanted[2]), np.full((1, 2), 0.3)
    seen = []
    for seed in range(300):
        points = side_points(circle(radius), noise, seed=seed)
        summed = sum_stretches(block_moments(points, 1, REACH), stretch)
        fits = fit_summed(summed, REACH, np.full((1, 2), noise), stretch, expected, sigma)
        seen.extend(fits.coefficients[0, :, :3] - wanted)
    certain = np.std(seen, axis=0) / np.sqrt(len(seen))
    assert (np.abs(np.mean(seen, axis=0)) < 3.0 * certain).all()
    # That many see far less than what noise and bend have in common, three quarters of the noise.
    assert certain[0] * REACH < 0.1 * noise
