# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pictures about accuracy draw what is true: every point, on the scale that it has."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from freecad_edgescan.cloud import TrueEdge
from freecad_edgescan.experiments import accuracy_pictures
from freecad_edgescan.experiments.accuracy_pictures import (
    across_errors,
    draw_along,
    draw_calibration,
    draw_experiments,
    shares_beyond,
)
from freecad_edgescan.experiments.doe_published import published_counterparts
from freecad_edgescan.experiments.doe_result import PATCH, DoeResult
from freecad_edgescan.experiments.honesty import true_share

TRUTH = TrueEdge("z axis", [[0, 0, 0], [0, 0, 40]], [[0, 0, 1], [0, 0, 1]], 0.5 * np.pi, True)
COUNT = 41


@pytest.fixture
def drawn(monkeypatch, tmp_path):
    """The figures that are written, and where to."""
    pytest.importorskip("matplotlib")
    figures: list = []
    save = accuracy_pictures.save_figure

    def keep(figure, path):
        figures.append(figure)
        save(figure, path)

    monkeypatch.setattr(accuracy_pictures, "save_figure", keep)
    return figures, tmp_path / "picture.png"


def an_edge(out: float, beside: float):
    """Points along the z axis, so far out of a right-angled wedge and to the first side's air."""
    half = np.sqrt(0.5)
    edge = SimpleNamespace(
        points=np.column_stack(
            [np.full(COUNT, out), np.full(COUNT, beside), np.linspace(0.0, 40.0, COUNT)]
        ),
        normals=np.tile([[half, half, 0.0], [half, -half, 0.0]], (COUNT, 1, 1)),
        covariance=np.tile(np.diag([4e-4, 1e-4]), (COUNT, 1, 1)),  # 0.02 and 0.01 mm
    )
    edge.unsmoothed = edge
    return edge


def rayleigh(count: int) -> np.ndarray:
    """Exactly the quantiles that true covariances give."""
    return np.sqrt(-2.0 * np.log1p(-(np.arange(count) + 0.5) / count))


def test_errors_have_the_sign_and_the_sigma_of_their_direction() -> None:
    errors, sigma = across_errors(an_edge(0.03, -0.01), TRUTH)
    np.testing.assert_allclose(errors, np.tile([0.03, -0.01], (COUNT, 1)), atol=1e-12)
    np.testing.assert_allclose(sigma, np.tile([0.02, 0.01], (COUNT, 1)))


def test_the_band_is_twice_sigma_in_micrometres_and_points_beyond_it_are_seen(drawn) -> None:
    figures, path = drawn
    report = SimpleNamespace(edge=an_edge(0.03, -0.025), truth=TRUTH, refusal="")
    draw_along({"wedge": report}, path)
    out, beside = figures[0].axes
    for axes, band, error, share in ((out, 40.0, 30.0, "100 %"), (beside, 20.0, -25.0, "0 %")):
        spread = axes.collections[0].get_paths()[0].vertices
        assert (spread[:, 1].min(), spread[:, 1].max()) == pytest.approx((-band, band))
        np.testing.assert_allclose(axes.lines[-1].get_ydata(), error)
        assert f"wedge: {share} within" in axes.get_title(loc="left")
        assert axes.get_ylim()[0] < -40.0
    assert path.stat().st_size > 5000


def test_an_edge_that_was_not_found_says_so_in_its_place(drawn) -> None:
    figures, path = drawn
    draw_along({"lost": SimpleNamespace(edge=None, truth=TRUTH, refusal="no edge here")}, path)
    assert "no edge here" in figures[0].axes[0].get_title(loc="left")


def test_true_distances_lie_on_the_curve_of_true_covariances(drawn) -> None:
    at, share = shares_beyond(rayleigh(1000)[::-1])
    np.testing.assert_allclose(share, 1.0 - true_share(at), atol=0.6e-3)
    figures, path = drawn
    draw_calibration({"true": (rayleigh(1000), 2.0 * rayleigh(500))}, path)
    for axes in figures[0].axes:
        many = [line.get_xydata() for line in axes.lines if len(line.get_xdata()) > 100]
        stated, *samples = many
        for sample, stretched in zip(samples, (1.0, 2.0), strict=True):
            at, share = sample.T
            seen = at / stretched < stated[-1, 0]
            wanted = np.interp(at / stretched, *stated.T)
            np.testing.assert_allclose(share[seen], wanted[seen], atol=0.5)


def test_the_farthest_point_is_on_the_picture(drawn) -> None:
    figures, path = drawn
    distances = np.append(rayleigh(20_000), 17.0)
    draw_calibration({"one astray": (distances, rayleigh(10)), "none": (np.zeros(0),) * 2}, path)
    beyond = figures[0].axes[2]
    assert beyond.get_xlim()[1] > 17.0
    assert beyond.get_ylim()[0] < 100.0 / 20_001


def test_every_test_and_the_mean_of_its_experiment_are_drawn(drawn) -> None:
    """A tenth of the published average, a fifth of the maximum, but one test at the double."""
    figures, path = drawn
    published = [run for run in published_counterparts(PATCH).values() if run.completed]
    runs = [
        replace(
            run,
            pattern="patch",
            degree=0,
            avg_error=run.avg_error / 10,
            max_error=run.max_error / 5,
        )
        for run in published
    ]
    runs[0] = replace(runs[0], max_error=2.0 * published[0].max_error)
    draw_experiments(DoeResult(tuple(runs)), PATCH, {"average": 0.18, "maximum": 0.3}, path)
    axes = figures[0].axes[0]
    marks = [line for line in axes.lines if line.get_marker() in ("o", "s")]
    each, means, each_maximum, mean_maximum = (line.get_ydata() for line in marks)
    assert len(each) == len(each_maximum) == len(published)
    np.testing.assert_allclose([*each, *means], 0.1)
    assert max(each_maximum) == pytest.approx(2.0)
    assert axes.get_ylim()[1] > 2.0
    np.testing.assert_allclose(mean_maximum[1:12], 0.2)
    assert mean_maximum[0] == pytest.approx(0.2 * 10 ** (1 / 16))
    levels = {line.get_ydata()[0] for line in axes.lines if len(set(line.get_ydata())) == 1}
    assert {0.18, 0.3, 1.0} <= levels
