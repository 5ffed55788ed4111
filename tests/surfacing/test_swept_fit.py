# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sweeps fitted to clouds of half-pipes whose walls are known exactly."""

from __future__ import annotations

import numpy as np
import pytest

import freecad_edgescan as es
from freecad_edgescan.cloud.core_box import PIPE_2
from freecad_edgescan.cloud.half_pipe import HalfPipe
from freecad_edgescan.geometry import Circle, fit_curve
from freecad_edgescan.geometry.exact_surfaces import circular_arc
from freecad_edgescan.surfacing import compare_sweep_models

NOISE = 0.05  # mm, level of each coordinate
NORMAL = NOISE / np.sqrt(3) * np.sqrt(2 / np.pi)  # about its mean absolute normal component


class Pipe:
    """The part of the core box's second pipe inside the scanned window."""

    def __init__(self):
        self.pipe = HalfPipe(PIPE_2)
        u = self.pipe.parameters
        rims = [self.pipe.rim(u, side)[0] for side in (1.0, -1.0)]
        rows = np.flatnonzero(np.all([(rim >= 0).all(axis=1) for rim in rims], axis=0))
        self.u = u[rows[0] : rows[-1] + 1]

    def wall(self, u, angle):
        left, right = (self.pipe.rim(u, side)[0] for side in (1.0, -1.0))
        middle, half = (left + right) / 2, (left - right) / 2
        plane = middle + np.cos(angle)[:, None] * half
        return np.column_stack([plane, -np.linalg.norm(half, axis=1) * np.sin(angle)])

    def base(self, model):
        rims = [
            np.column_stack([self.pipe.rim(self.u, side)[0], 0 * self.u]) for side in (1.0, -1.0)
        ]
        profiles = []
        for end in (0, -1):
            left, right = rims[0][end], rims[1][end]
            centre, radius = (left + right) / 2, np.linalg.norm(left - right) / 2
            zero = (left - centre) / radius
            axis = np.cross(zero, [0, 0, -1.0])
            profiles.append(circular_arc(Circle(centre, axis, radius, zero), 0.0, np.pi))
        some = np.linspace(0, len(self.u) - 1, 200).astype(int)
        return es.SweptSurface([fit_curve(rim[some], 1e-3) for rim in rims], profiles, model)

    def cloud(self, count=5000, seed=0):
        rng = np.random.default_rng(seed)
        u = rng.uniform(self.u[0], self.u[-1], count)
        points = self.wall(u, rng.uniform(0.02, np.pi - 0.02, count))
        return points + rng.uniform(-NOISE, NOISE, (count, 3))

    def error_of(self, surface):
        """Distances of the true wall's points to a surface, away from its rims."""
        u = np.linspace(*np.quantile(self.u, [0.02, 0.98]), 150)
        angle = np.linspace(0.03, np.pi - 0.03, 25)
        grid = np.repeat(u, 25), np.tile(angle, 150)
        return surface.closest(self.wall(*grid))[2]


@pytest.fixture(scope="module")
def pipe():
    return Pipe()


def test_the_rotating_sweep_explains_a_bent_pipe_down_to_the_noise(pipe):
    fit = es.fit_swept_surface(pipe.cloud(), pipe.base("rotate"), (14, 7))
    assert fit.average < 1.3 * NORMAL and fit.maximum < 0.2
    error = pipe.error_of(fit.surface)
    assert error.mean() < 0.03 and error.max() < 0.2
    assert fit.sweep.model == "rotate"
    assert len(fit.sweep.rails[0].poles) == 14 and len(fit.sweep.profiles[0].poles) == 7


def test_the_blended_sweep_misses_a_bent_pipe_as_published(pipe):
    fit = es.fit_swept_surface(pipe.cloud(), pipe.base("blend"), (14, 7))
    assert 5 * NORMAL < fit.average < 0.384
    assert fit.average < np.abs(pipe.base("blend").to_bspline().closest(pipe.cloud())[2]).mean()


def test_the_model_that_explains_the_cloud_better_is_said(pipe):
    fits = compare_sweep_models(pipe.cloud(3000), pipe.base("blend"))
    assert list(fits) == ["rotate", "blend"]
    assert fits["rotate"].rms < fits["blend"].rms
    assert fits["rotate"].message.startswith("The rotate model explains the points better")


def test_the_surface_of_a_fit_is_the_one_of_its_sweep(pipe):
    fit = es.fit_swept_surface(pipe.cloud(), pipe.base("rotate"))
    share = np.linspace(0, 1, 30)
    grid = share[:, None], share
    off = np.linalg.norm(fit.surface.evaluate(*grid) - fit.sweep.evaluate(*grid), axis=2)
    assert off.max() < 0.2 * fit.rms
    assert fit.supported.all() and fit.supported.shape == fit.surface.patches.shape
    assert fit.rms == pytest.approx(np.sqrt(np.mean(fit.deviation[~fit.outside] ** 2)))


def test_a_blend_fitted_to_points_of_a_blend_is_exact(pipe):
    base = pipe.base("blend")
    u, v = np.random.default_rng(1).random((2, 4000))
    fit = es.fit_swept_surface(base.evaluate(u, v), base, (40, 20))
    assert fit.maximum < 0.02


def test_progress_may_end_the_fit(pipe):
    class Told:
        fits = ()

        def update(self, fraction, so_far):
            self.fits = (*self.fits, *([so_far] if so_far is not None else []))
            return not self.fits

    told = Told()
    fit = es.fit_swept_surface(pipe.cloud(1000), pipe.base("rotate"), (8, 5), progress=told)
    assert told.fits == (fit,)


def test_what_cannot_be_fitted_is_refused_with_numbers(pipe):
    base = pipe.base("rotate")
    with pytest.raises(ValueError, match="need at least 114 points, and only 90 of the 90"):
        es.fit_swept_surface(pipe.wall(np.linspace(*pipe.u[[5, -5]], 90), np.full(90, 1.5)), base)
    with pytest.raises(ValueError, match="3 control points are too few for the profiles"):
        es.fit_swept_surface(pipe.cloud(500), base, (14, 3))
    one = es.SweptSurface(base.rails[:1], base.profiles[:1], "rotate")
    with pytest.raises(ValueError, match="Only sweeps along two rails"):
        es.fit_swept_surface(pipe.cloud(500), one)


@pytest.mark.parametrize("model", ["blend", "rotate"])
def test_a_segment_that_misses_a_quarter_is_said(model):
    x = np.linspace(0, 60, 6)
    knots = np.r_[[0.0] * 4, 0.3, 0.6, [1.0] * 4]
    rails = [
        es.BSplineCurve(np.stack([x, 0 * x + y, np.sin(x / 20)], axis=1), knots) for y in (0.0, 25)
    ]
    profiles = [
        es.BSplineCurve(
            [rails[0].evaluate(t), [60 * t, 12, -9], rails[1].evaluate(t)], [0, 0, 0, 1, 1, 1], 2
        )
        for t in (0.0, 1.0)
    ]
    sweep = es.SweptSurface(rails, profiles, model)
    u, v = np.random.default_rng(0).random((2, 6000))
    there = (u < 0.5) | (v < 0.5)
    fit = es.fit_swept_surface(sweep.evaluate(u, v)[there], sweep, (8, 6))
    assert "does not support" in fit.message and "% of its area, the largest piece" in fit.message
    assert fit.supported.mean() == pytest.approx(0.75, abs=0.2)
    assert fit.average < 0.02
