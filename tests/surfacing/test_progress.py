# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tasks on large clouds tell how far they are, and end when told to, with what they have."""

from __future__ import annotations

import numpy as np
import pytest

import freecad_edgescan as es
from freecad_edgescan.geometry import BSplineSurface

PROBE = 1.0


class Heard:
    """Progress that is cancelled at an update, counted from 1; 0: never."""

    def __init__(self, cancel_at: int = 0) -> None:
        self.shares: list[float] = []
        self.cancel_at = cancel_at

    def update(self, fraction: float, so_far: object) -> bool:
        self.shares.append(fraction)
        return not 0 < self.cancel_at <= len(self.shares)


@pytest.fixture(scope="module")
def plane() -> BSplineSurface:
    corners = np.array([[[0, 0, 0], [0, 40, 0]], [[60, 0, 0], [60, 40, 0.0]]])
    return BSplineSurface(corners, (np.array([0.0, 0, 1, 1]),) * 2, (1, 1))


@pytest.fixture(scope="module")
def centres() -> es.PointCloud:
    x, y = np.random.default_rng(0).uniform((0, 0), (60, 40), (30_000, 2)).T
    height = PROBE + np.random.default_rng(1).normal(0, 0.01, len(x))
    return es.PointCloud(np.column_stack([x, y, height]), PROBE, (0, 0, -1))


@pytest.fixture
def small_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    """Clouds of the tests are looked at in as many pieces as a million points are."""
    from freecad_edgescan.cloud import compensation, local_normals, local_quadrics
    from freecad_edgescan.surfacing import parameterised, segmentation

    for module in (compensation, local_normals, parameterised, segmentation):
        name = "AT_ONCE" if hasattr(module, "AT_ONCE") else "_AT_ONCE"
        monkeypatch.setattr(module, name, 5000)
    monkeypatch.setattr(local_quadrics, "AT_ONCE", 20_000)


def tasks(centres, plane):
    surface = es.PointCloud(centres.points - (0, 0, PROBE))
    return {
        "compensate_cloud": lambda heard: es.compensate_cloud(centres, progress=heard),
        "thin_cloud": lambda heard: es.thin_cloud(surface, 1.0, progress=heard),
        "segment_cloud": lambda heard: es.segment_cloud(surface, plane, 1.0, 0.5, progress=heard),
        "base_surface": lambda heard: es.base_surface(surface, progress=heard),
        "fit_surface": lambda heard: es.fit_surface(surface.points, plane, progress=heard),
    }


NAMES = ("compensate_cloud", "thin_cloud", "segment_cloud", "base_surface", "fit_surface")


@pytest.mark.parametrize("name", NAMES)
def test_shares_grow_to_the_whole_and_change_nothing(name, centres, plane, small_pieces):
    task, heard = tasks(centres, plane)[name], Heard()
    told, untold = task(heard), task(None)
    shares = np.array(heard.shares)
    shares = shares[np.isfinite(shares)]
    assert len(shares) >= 3 and 0.0 <= shares[0] < 1.0
    assert np.all(np.diff(shares) >= 0.0) and shares[-1] == pytest.approx(1.0)
    if isinstance(told, np.ndarray):
        assert np.array_equal(told, untold)
    elif isinstance(told, es.PointCloud):
        assert np.array_equal(told.points, untold.points)
    else:
        assert np.array_equal(told.surface.poles, untold.surface.poles)


def test_a_stopped_compensation_holds_right_points_and_says_so(centres, small_pieces):
    whole, part = es.compensate_cloud(centres), es.compensate_cloud(centres, Heard(cancel_at=3))
    assert 0 < len(part) < len(whole)
    assert np.abs(part.points[:, 2]).max() < 0.06
    assert "stopped" in part.message and "stopped" not in whole.message


def test_points_of_a_stopped_thinning_keep_their_distance(centres):
    part = es.thin_cloud(centres, 1.0, Heard(cancel_at=1))
    assert 1 < len(part) < len(es.thin_cloud(centres, 1.0))
    near = part.tree.query(part.points, k=2)[0][:, 1]
    assert near.min() > 0.8 and "stopped" in part.message


def test_a_stopped_segment_is_a_part_of_the_whole(centres, plane, small_pieces):
    whole = es.segment_cloud(centres, plane, 2.0)
    part = es.segment_cloud(centres, plane, 2.0, progress=Heard(cancel_at=2))
    assert 0 < part.sum() < whole.sum()
    assert np.all(whole[part])


def test_a_base_surface_is_the_best_so_far(centres):
    cylinder = es.base_surface(_half_pipe())
    stopped = es.base_surface(_half_pipe(), progress=Heard(cancel_at=4))
    assert cylinder.kind == "cylinder" and stopped.kind in ("plane", "sphere")


def test_a_fit_stopped_early_fits_the_points_it_has(centres, plane, small_pieces):
    fit = es.fit_surface(centres.points, plane, progress=Heard(cancel_at=1))
    assert len(fit.deviation) == 5000
    assert fit.surface.evaluate(0.5, 0.5)[2] == pytest.approx(PROBE, abs=0.01)


def test_a_stopped_comparison_of_models_has_one(plane):
    from freecad_edgescan.surfacing import compare_sweep_models

    a, b, c, d = plane.poles.reshape(4, 3)
    base = es.SweptSurface((_segment(a, c), _segment(b, d)), (_segment(a, b), _segment(c, d)))
    x, y = np.random.default_rng(0).uniform((1, 1), (59, 39), (3000, 2)).T
    points = np.column_stack([x, y, 0.1 * np.sin(x / 9)])
    assert len(compare_sweep_models(points, base, (6, 6), Heard(cancel_at=2))) == 1
    assert len(compare_sweep_models(points, base, (6, 6), Heard())) == 2


def _segment(start, end) -> es.BSplineCurve:
    return es.BSplineCurve(np.array([start, end]), np.array([0.0, 0, 1, 1]), 1)


def _half_pipe() -> es.PointCloud:
    angle, x = np.random.default_rng(0).uniform((0, 0), (np.pi, 60), (4000, 2)).T
    return es.PointCloud(np.column_stack([x, 17 * np.cos(angle), -17 * np.sin(angle)]))
