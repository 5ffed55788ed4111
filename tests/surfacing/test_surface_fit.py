# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface fits of clouds whose true surface is known."""

from __future__ import annotations

import re

import numpy as np
import pytest
from scipy import sparse
from scipy.interpolate import BSpline

import freecad_edgescan as es
from freecad_edgescan.geometry.knot_vectors import clamped_knots
from freecad_edgescan.surfacing.tensor_system import TensorSystem


def cloud_of(surface, count=6000, noise=0.0, seed=0, keep=None):
    rng = np.random.default_rng(seed)
    u, v = (rng.uniform(*limits, count) for limits in surface.parameter_range)
    if keep is not None:
        inside = keep(u, v)
        u, v = u[inside], v[inside]
    return surface.evaluate(u, v) + noise * rng.normal(size=(len(u), 3))


def error_of(fit, truth, keep=None):
    """Distances of the truth's own points to the fitted surface, away from its rim."""
    u, v = np.meshgrid(np.linspace(0.03, 0.97, 40), np.linspace(0.03, 0.97, 40))
    if keep is not None:
        inside = keep(u, v)
        u, v = u[inside], v[inside]
    (u0, u1), (v0, v1) = truth.parameter_range
    points = truth.evaluate(u0 + u * (u1 - u0), v0 + v * (v1 - v0)).reshape(-1, 3)
    return fit.surface.closest(points)[2]


def test_points_of_a_spline_give_that_spline_back(wave):
    fit = es.fit_surface(cloud_of(wave), wave, knots=wave.knots)
    assert fit.maximum < 1e-9
    assert np.allclose(fit.surface.poles, wave.poles, atol=1e-6)
    assert fit.supported.all() and not fit.outside.any() and fit.message == ""


def test_the_normal_equations_are_those_of_dense_least_squares():
    rng = np.random.default_rng(0)
    u, v, x = rng.random(500), rng.random(500), rng.normal(size=(500, 3))
    knots = clamped_knots(np.linspace(0, 1, 4), 2), clamped_knots(np.linspace(0, 1, 6), 3)
    rows = BSpline.design_matrix(u, knots[0], 2).toarray()
    columns = BSpline.design_matrix(v, knots[1], 3).toarray()
    dense = np.einsum("mi,mj->mij", rows, columns).reshape(500, -1)
    expected = np.linalg.lstsq(dense, x, rcond=None)[0].reshape(5, 8, 3)
    poles = TensorSystem(u, v, x, knots, (2, 3)).solve(sparse.identity(40), 1e-13)
    assert np.allclose(poles, expected, atol=1e-8)
    swapped = TensorSystem(v, u, x, knots[::-1], (3, 2)).solve(sparse.identity(40), 1e-13)
    assert np.allclose(swapped.transpose(1, 0, 2), expected, atol=1e-8)


def test_a_rational_pipe_is_fitted_far_below_the_noise_from_a_rough_base(pipe):
    rough = es.BSplineSurface(
        [[[0, -18, 0], [60, -18, 0]], [[0, 0, -35], [60, 0, -35]], [[0, 18, 0], [60, 18, 0]]],
        (np.repeat([0.0, 1], 3), [0, 0, 1, 1]),
        (2, 1),
    )
    fit = es.fit_surface(cloud_of(pipe, 20_000, noise=0.02), rough, (12, 6))
    assert fit.surface.weights is None
    assert error_of(fit, pipe).mean() < 0.004
    # the mean absolute normal component of the noise, and no more
    assert fit.average == pytest.approx(0.02 * np.sqrt(2 / np.pi), rel=0.05)


def test_correcting_parameters_brings_the_surface_nearer(flat, wave):
    points = cloud_of(wave, 4000)
    rms = [es.fit_surface(points, flat, (7, 6), corrections=n).rms for n in (0, 4)]
    assert rms[1] < 0.95 * rms[0]


def test_deviations_are_signed_by_the_side_of_the_normal(flat):
    points = cloud_of(flat, 3000)
    bump = np.exp(-((points[:, 0] - 40) ** 2 + (points[:, 1] - 25) ** 2) / 2)
    points[:, 2] += bump
    fit = es.fit_surface(points, flat, (4, 4))
    assert flat.normal(0.5, 0.5)[2] > 0
    assert fit.deviation[np.argmax(bump)] > 0.5
    assert fit.maximum == np.abs(fit.deviation).max()


def test_a_missing_quarter_is_said_and_filled_from_the_base(wave):
    def there(u, v):
        return (u < 0.5) | (v < 0.5)

    points = cloud_of(wave, 8000, noise=0.02, keep=there)
    fit = es.fit_surface(points, wave, (16, 12))
    assert not fit.is_supported(0.8, 0.8) and fit.is_supported(0.3, 0.7)
    share = np.linspace(0, 1, 101)
    assert fit.is_supported(share[:, None], share).mean() == pytest.approx(0.75, abs=0.06)
    said = re.search(
        r"does not support (\d+) of the surface's (\d+) patches, (\d+) % of its area, the largest "
        r"piece from u = ([\d.]+) to ([\d.]+) and v = ([\d.]+) to ([\d.]+), near",
        fit.message,
    )
    patches, of, percent, *limits = (float(number) for number in said.groups())
    assert patches == (~fit.supported).sum() and of == fit.supported.size
    assert percent == pytest.approx(25, abs=6)
    assert limits == pytest.approx([0.5, 1.0, 0.5, 1.0], abs=0.08)
    assert error_of(fit, wave, keep=there).max() < 0.05
    # the base surface is the true one: only what the cloud's rim says of the gap is wrong
    assert error_of(fit, wave).max() < 0.5


def test_a_gap_far_from_a_wrong_base_does_not_explode(flat, wave):
    def there(u, v):
        return (np.abs(u - 0.5) > 0.15) | (np.abs(v - 0.5) > 0.2)

    fit = es.fit_surface(cloud_of(wave, 8000, keep=there), flat, (20, 16))
    poles = fit.surface.poles[..., 2]
    assert poles.min() > -7 and poles.max() < 7


def test_points_beyond_the_rim_are_left_out_and_said(flat):
    points = cloud_of(flat, 2000)
    beyond = points[:200] * [0, 1, 1] + [90.0, 0, 5]
    fit = es.fit_surface(np.concatenate([points, beyond]), flat, (6, 5))
    assert fit.outside.sum() == 200 and fit.outside[2000:].all()
    assert fit.maximum < 1e-9 and np.abs(fit.deviation[2000:]).min() > 10
    assert "200 of 2200 points lie beyond the rim" in fit.message


def test_a_tolerance_chooses_the_number_of_control_points(wave, flat):
    points = cloud_of(wave, 5000)
    coarse = es.fit_surface(points, flat, None, tolerance=1.0)
    fine = es.fit_surface(points, flat, None, tolerance=0.02)
    assert coarse.maximum <= 1.0 and fine.maximum <= 0.02
    assert coarse.surface.poles.size < fine.surface.poles.size


def test_without_a_tolerance_noise_is_not_followed(wave):
    fit = es.fit_surface(cloud_of(wave, 5000, noise=0.05), wave, control_points=None)
    assert fit.average == pytest.approx(0.05 * np.sqrt(2 / np.pi), rel=0.1)
    assert error_of(fit, wave).mean() < 0.02


def test_a_tolerance_below_the_noise_is_said_not_chased(wave):
    fit = es.fit_surface(cloud_of(wave, 5000, noise=0.05), wave, None, tolerance=0.01)
    assert "above the tolerance of 0.01 mm" in fit.message
    assert fit.surface.poles.shape[0] * fit.surface.poles.shape[1] < 500


def test_parameters_on_a_grid_still_give_knots(flat):
    x, y = np.meshgrid(np.linspace(1, 79, 8), np.linspace(1, 49, 60))
    fit = es.fit_surface(np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3), flat, (12, 6))
    assert np.all(np.diff(fit.surface.knots[0][3:-3]) > 0)
    assert fit.maximum < 1e-6


def test_progress_sees_the_fit_and_may_end_it(flat, wave):
    class Told:
        seen = ()

        def update(self, fraction, so_far):
            self.seen = (*self.seen, (fraction, so_far))
            return len(self.seen) < 3

    told = Told()
    fit = es.fit_surface(cloud_of(wave), flat, (9, 7), corrections=4, progress=told)
    assert [fraction for fraction, _ in told.seen] == pytest.approx([0.4, 0.52, 0.64])
    assert told.seen[-1][1] is fit


def test_what_cannot_be_fitted_is_refused_with_numbers(flat):
    points = cloud_of(flat, 60)
    with pytest.raises(ValueError, match="12 × 6 control points need at least 72 points"):
        es.fit_surface(points, flat)
    with pytest.raises(ValueError, match="3 control points in v are too few for degree 3"):
        es.fit_surface(points, flat, (6, 3))
    with pytest.raises(ValueError, match="give control_points=None"):
        es.fit_surface(points, flat, (4, 4), tolerance=0.1)
    with pytest.raises(ValueError, match="tolerance is -1 mm"):
        es.fit_surface(points, flat, None, tolerance=-1)
    with pytest.raises(ValueError, match="from 0 to 1; scale them"):
        es.fit_surface(points, flat, knots=(clamped_knots([0, 2], 3), clamped_knots([0, 2], 3)))
    with pytest.raises(ValueError, match=r"\(n, 3\) array"):
        es.fit_surface(points[:, :2], flat, (4, 4))
    with pytest.raises(ValueError, match="not a finite number"):
        es.fit_surface(points + np.nan, flat, (4, 4))
    with pytest.raises(ValueError, match="small positive number"):
        es.fit_surface(points, flat, (4, 4), smoothing=0)
    with pytest.raises(ValueError, match="0 or more"):
        es.fit_surface(points, flat, (4, 4), corrections=-1)


def test_over_a_whole_pipe_the_fit_is_closed_and_smooth_at_its_seam():
    rng = np.random.default_rng(0)
    angle, x = rng.uniform((0, 0), (2 * np.pi, 40), (6000, 2)).T
    radius = 10 + 0.3 * np.cos(3 * angle + 0.1 * x) + rng.normal(0, 0.02, 6000)
    points = np.column_stack([x, radius * np.cos(angle), radius * np.sin(angle)])
    base = es.base_surface(points, kind="cylinder").surface
    fit = es.fit_surface(points, base, (20, 8))
    assert fit.surface.closed == (True, False)
    assert fit.average == pytest.approx(0.02 * np.sqrt(2 / np.pi), rel=0.1)
    (first, last), (low, high) = fit.surface.parameter_range
    v = np.linspace(low, high, 11)
    for order in (0, 1, 2):
        sides = [fit.surface.derivative(u, v, order, 0) for u in (first, last)]
        assert np.allclose(*sides, atol=1e-8 * max(1.0, np.abs(sides[0]).max()))
    # beside the seam it is no farther from the truth than elsewhere
    at = fit.surface.evaluate(np.linspace(first, last, 201)[:, None], v)
    turn = np.arctan2(at[..., 2], at[..., 1])
    error = np.abs(
        np.hypot(at[..., 1], at[..., 2]) - 10 - 0.3 * np.cos(3 * turn + 0.1 * at[..., 0])
    )
    inner = error[:, 2:-2]
    assert inner[[*range(10), *range(-10, 0)]].max() < 1.5 * inner[10:-10].max()
    assert error.mean() < 0.01


def test_few_control_points_close_too():
    angle, x = np.random.default_rng(0).uniform((0, 0), (2 * np.pi, 40), (3000, 2)).T
    points = np.column_stack([x, 10 * np.cos(angle), 10 * np.sin(angle)])
    base = es.base_surface(points, kind="cylinder").surface
    fit = es.fit_surface(points, base, (7, 4))
    assert fit.surface.closed == (True, False) and fit.surface.poles.shape == (7, 4, 3)
    automatic = es.fit_surface(points, base, None, tolerance=0.01)
    assert automatic.surface.closed == (True, False) and automatic.maximum < 0.01
