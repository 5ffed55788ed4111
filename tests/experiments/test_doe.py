# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scanning the published experiments: errors are true, equal seeds are equal, nothing is lost."""

from __future__ import annotations

import csv
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import freecad_edgescan.experiments.doe_scan as doe_scan
from freecad_edgescan.experiments import run_doe
from freecad_edgescan.experiments.doe_comparison import compare_all
from freecad_edgescan.experiments.doe_design import trial
from freecad_edgescan.experiments.doe_pictures import draw_doe
from freecad_edgescan.experiments.doe_published import published_result
from freecad_edgescan.experiments.doe_scan import edge_errors, scan_trial, trial_cloud
from freecad_edgescan.experiments.doe_tables import summary
from freecad_edgescan.scanning import ScanError, ScannedEdge

PATCH = {"experiments": [1], "method": "patch"}
REFUSED = {**PATCH, "overrides": {"amplitude": "wide"}}  # quick: every run fails


@pytest.fixture(scope="module")
def two_rows():
    return run_doe(**PATCH, tests=[5, 2], jobs=2)


class Watcher:
    """Notes what it is told and cancels after so many objects."""

    def __init__(self, objects: float = np.inf) -> None:
        self.objects = objects
        self.told: list[tuple[float, int]] = []

    def update(self, fraction: float, so_far) -> bool:
        self.told.append((fraction, len(so_far)))
        return len(so_far) < self.objects


def test_an_edge_error_is_the_distance_to_the_true_circle() -> None:
    row = trial(6, 3)
    azimuth = np.linspace(0.1, 3.0, 50)
    x, z = row.edge_radius, -row.section_radius
    circle = np.column_stack([x * np.cos(azimuth), x * np.sin(azimuth), np.full(50, z)])
    away = np.random.default_rng(1).normal(size=(50, 3))
    points = circle + 0.3 * away
    nearest = row.object.edges[0].distance(points)
    np.testing.assert_allclose(edge_errors(row, points), nearest, atol=1e-5)


def test_processes_give_what_a_scan_of_the_same_object_gives_here(two_rows) -> None:
    row = trial(1, 5)
    edge = scan_trial(row, trial_cloud(row, seed=0), ("patch", 0), "patch")
    run = two_rows.runs[1]
    assert (run.experiment, run.test, run.pattern, run.degree) == (1, 5, "patch", 0)
    errors = edge_errors(row, edge.points)
    assert (run.avg_error, run.max_error) == (errors.mean(), errors.max())
    assert (run.points, run.completed, run.stop) == (len(edge), True, "GATE")
    assert run.points == pytest.approx(row.nominal_points, rel=0.05)


def test_another_seed_is_another_cloud_and_a_similar_error(two_rows) -> None:
    other = run_doe(**PATCH, tests=[2], jobs=1, seed=1)
    assert other.runs[0].avg_error != two_rows.runs[0].avg_error
    assert other.runs[0].avg_error == pytest.approx(two_rows.runs[0].avg_error, rel=1.0)


def test_half_the_amplitude_off_or_too_few_points_is_not_completed(monkeypatch) -> None:
    row = trial(1, 2)
    edge = scan_trial(row, trial_cloud(row, 0), ("patch", 0), "patch")

    def completes(changed) -> bool:
        monkeypatch.setattr(doe_scan, "scan_edge", lambda *args, **words: changed)
        (run,) = run_doe(**PATCH, tests=[2], jobs=1)
        return run.completed

    assert completes(edge)
    far = edge.points.copy()
    far[30, 2] += 0.51 * row.amplitude
    assert not completes(replace(edge, points=far))
    far[30, 2] -= 0.02 * row.amplitude
    assert completes(replace(edge, points=far))
    fewest = int(np.ceil(0.8 * row.nominal_points))

    def first(count: int) -> ScannedEdge:
        parts = ("points", "normals", "covariance")
        shorter = {name: getattr(edge, name)[:count] for name in parts}
        return replace(edge, single=None, **shorter)

    assert completes(first(fewest))
    assert not completes(first(fewest - 1))
    assert not completes(replace(edge, stops=(edge.stops[0], edge.stops[0])))
    assert not completes(first(0))


def test_a_scan_that_raises_is_a_failed_run_with_its_text(monkeypatch) -> None:
    def refuse(*args, **words):
        raise ScanError("There is no edge within reach of this test.")

    monkeypatch.setattr(doe_scan, "scan_edge", refuse)
    (run,) = run_doe(**PATCH, tests=[2], jobs=1)
    assert not run.completed
    assert np.isnan(run.avg_error)
    assert (run.points, run.stop) == (0, "ERROR")
    assert run.message == "There is no edge within reach of this test."
    assert "no edge within reach" in summary(run_doe(**PATCH, tests=[2], jobs=1))


@pytest.mark.parametrize("jobs", [1, 2])
def test_a_row_that_cannot_even_begin_is_a_failed_run_with_its_text(jobs: int) -> None:
    result = run_doe(**REFUSED, tests=[2, 5], jobs=jobs)
    assert [run.stop for run in result] == ["ERROR", "ERROR"]
    assert all("wide" in run.message for run in result)


@pytest.mark.parametrize("jobs", [1, 2])
def test_cancelling_keeps_the_rows_that_are_done(jobs: int) -> None:
    watcher = Watcher(objects=1)
    result = run_doe(**REFUSED, tests=range(1, 17), jobs=jobs, progress=watcher)
    assert result.cancelled
    assert 1 <= len(result) < 16
    assert watcher.told[-1] == (len(result) / 16, len(result))


def test_progress_is_told_after_each_object() -> None:
    watcher = Watcher()
    result = run_doe(**REFUSED, tests=[2, 5], jobs=1, progress=watcher)
    assert watcher.told == [(0.5, 1), (1.0, 2)]
    assert not result.cancelled


def test_the_table_has_one_row_for_each_run(two_rows, tmp_path: Path) -> None:
    two_rows.to_csv(tmp_path / "doe.csv")
    with (tmp_path / "doe.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["test"] for row in rows] == ["2", "5"]
    assert float(rows[0]["avg_error_mm"]) == pytest.approx(two_rows.runs[0].avg_error, abs=1e-6)
    assert rows[0]["completed"] == "1"


def test_columns_are_arrays(two_rows) -> None:
    assert two_rows.column("avg_error").shape == (2,)
    assert two_rows.column("avg_error").max() == max(run.avg_error for run in two_rows)


def test_the_patch_method_beats_the_published_scans_of_two_objects(two_rows) -> None:
    row = compare_all(two_rows)
    assert (row.runs, row.completed, row.published_completed, row.tests) == (2, 2, 2, 2)
    assert row.avg_ratio < 0.5
    assert row.nominal_points == pytest.approx(1.0, abs=0.05)


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"experiments": [0]}, "experiment is 0.*1 to 12"),
        ({"experiments": []}, "No experiment"),
        ({"tests": [17]}, "test is 17.*1 to 16"),
        ({"patterns": ["spiral"]}, "spiral.*zigzag, square"),
        ({"degrees": [4]}, "degree is 4"),
        ({"method": "laser"}, "laser.*probe, patch"),
        ({"jobs": 0}, "0 jobs"),
        ({"seed": -1}, "seed is -1"),
        ({"overrides": {"speed": 3}}, "speed"),
        ({"method": "patch", "literal": True}, "as printed"),
    ],
)
def test_what_there_is_not_is_refused_with_what_there_is(wrong: dict, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        run_doe(**wrong)


def test_pictures_are_drawn_of_whole_experiments(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    first = tuple(run for run in published_result() if run.experiment == 1)
    written = draw_doe(replace(published_result(), runs=first), tmp_path)
    assert [path.name for path in written] == ["ratios.png", "effects-1.png", "effects.csv"]
    assert all(path.stat().st_size > 10_000 for path in written[:2])
    with written[-1].open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 11 * 4 * 2
    assert all(row["ours"] == row["published"] for row in rows)
