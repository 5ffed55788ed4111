# SPDX-License-Identifier: LGPL-2.1-or-later
"""A few rows of the published experiments with the probe; `edgescan doe` scans them all."""

from __future__ import annotations

import numpy as np
import pytest

import freecad_edgescan.experiments.cost_figures as cost_figures
from freecad_edgescan.experiments import DoeResult, run_doe
from freecad_edgescan.experiments.doe_comparison import compare_all, compare_group
from freecad_edgescan.experiments.doe_design import trial
from freecad_edgescan.experiments.doe_published import published_result
from freecad_edgescan.experiments.doe_scan import edge_errors, scan_trial, trial_cloud
from freecad_edgescan.experiments.tangent_figures import tangents_along

GROUPS = [("zigzag", 1), ("zigzag", 2), ("square", 1), ("square", 2)]


@pytest.fixture(scope="module")
def result() -> DoeResult:
    return run_doe([6], tests=[3, 5], jobs=2)


def test_every_scan_reaches_the_gate_with_the_published_number_of_edge_points(result) -> None:
    assert [run.group for run in result.runs[:4]] == GROUPS
    assert all(run.completed and run.stop == "GATE" for run in result)
    total = compare_all(result)
    assert total.nominal_points == pytest.approx(1.0, abs=0.05)
    assert total.published_points == pytest.approx(1.0, abs=0.1)


def test_errors_are_those_of_the_published_scans(result) -> None:
    for group in GROUPS:
        row = compare_group(result, group)
        assert row.tests == 2
        assert 0.3 < row.avg_ratio < 1.3
        assert 0.2 < row.max_ratio < 1.5


def test_one_process_gives_what_two_give(result) -> None:
    alone = run_doe([6], ["square"], [2], tests=[5], jobs=1)
    assert alone.runs == result.runs[-1:]


def test_the_chord_height_does_not_change_the_edge_pitch() -> None:
    row = trial(6, 5)
    edge = scan_trial(row, trial_cloud(row, 0), ("square", 2))
    assert edge.parameters.chord_height is None
    steps = np.linalg.norm(np.diff(edge.points, axis=0), axis=1)
    assert np.median(steps) == pytest.approx(row.edge_pitch, rel=0.05)
    assert edge_errors(row, edge.points).max() < row.amplitude / 2


def test_the_algorithm_as_printed_has_the_published_error() -> None:
    """Of experiment 6 the text says that all tests were successful."""
    printed = run_doe([6], ["square"], [2], tests=[5], jobs=1, literal=True)
    published = published_result().of_group(("square", 2))[6, 5]
    assert printed.runs[0].completed
    assert printed.runs[0].avg_error == pytest.approx(published.avg_error, rel=0.35)


def test_overrides_replace_a_value_of_the_design() -> None:
    row = {"patterns": ["square"], "degrees": [2], "tests": [5], "jobs": 1}
    (sparse,) = run_doe([6], **row, overrides={"edge_pitch": 7.0})
    assert sparse.points == pytest.approx(trial(6, 5).nominal_points * 5.0 / 7.0, rel=0.05)
    assert sparse.completed


def test_planes_lose_the_tangent_where_the_sides_bend() -> None:
    """Schreve 4.4.1.2 and figure 4.11."""
    bent = tangents_along("4.11", trial(4, 15), seed=0)
    interpolation, planes, polynomials = (np.median(curve.y) for curve in bent.curves)
    assert planes > 3.0 * polynomials
    assert polynomials < interpolation


def test_scans_are_timed_until_cancelled(monkeypatch) -> None:
    class Once:
        def update(self, fraction: float, so_far: object) -> bool:
            return False

    scanned = []
    monkeypatch.setattr(cost_figures, "scan_trial", lambda *scan: scanned.append(scan))
    seconds = list(cost_figures.timed([("row", "cloud")] * 3, "probe", Once(), 3))
    assert len(seconds) == 1
    assert seconds[0] >= 0.0
    assert set(scanned) == {("row", "cloud", ("square", 2), "probe")}
