# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a scan costs, measured with a clock that only scans move on."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import freecad_edgescan.experiments.cost_figures as cost_figures
from freecad_edgescan.experiments.doe_design import Trial
from freecad_edgescan.experiments.doe_figures import make_figure
from freecad_edgescan.experiments.doe_scan import trial_cloud
from freecad_edgescan.experiments.scan_figures import printed_trial
from freecad_edgescan.scanning import ScanParameters
from freecad_edgescan.scanning.guidelines import check_possible

POINTS_PER_MM = 930  # of a cloud's width


class Cloud:
    """As many points as the real one of that width would have, and no point at all."""

    def __init__(self, width: float) -> None:
        self.width = width

    def __len__(self) -> int:
        return round(POINTS_PER_MM * self.width)


class Bench:
    """Stands for clouds, scans and clock: each scan takes the seconds it is told."""

    def __init__(self) -> None:
        self.now = 1000.0
        self.seconds: Callable[[Trial, Cloud], float] = lambda trial, _: 0.05 * trial.amplitude
        self.scans: list[tuple] = []
        self.builds = 0.7  # what a cloud's first scan takes in addition
        self.again = 0.3  # and its second one: something else was running
        self.clouds: list[Cloud] = []

    def cloud(self, trial: Trial, seed: int, width: float) -> Cloud:
        assert trial.experiment == 0
        self.now += 50.0  # the clock goes on, nobody is to count that
        self.clouds.append(Cloud(width))
        return self.clouds[-1]

    def scan(self, trial: Trial, cloud: Cloud, group: tuple[str, int], method: str) -> None:
        times = sum(each[:2] == (trial, cloud) for each in self.scans)
        self.scans.append((trial, cloud, group, method))
        extra = [self.builds, self.again, 0.0][min(times, 2)]
        self.now += self.seconds(trial, cloud) + extra


@pytest.fixture
def bench(monkeypatch) -> Bench:
    made = Bench()
    monkeypatch.setattr(cost_figures, "trial_cloud", made.cloud)
    monkeypatch.setattr(cost_figures, "scan_trial", made.scan)
    monkeypatch.setattr(cost_figures, "process_time", lambda: made.now)
    return made


class CancelsAfter:
    def __init__(self, scans: int) -> None:
        self.scans, self.told = scans, []

    def update(self, fraction: float, so_far: object) -> bool:
        self.told.append((fraction, so_far))
        return len(self.told) < self.scans


def number_before(words: str, note: str) -> float:
    return float(note.split(words)[0].split()[-1])


# ---------------------------------------------------------------- figure 5.37


def test_the_line_through_the_times_is_the_cost_of_a_millimetre(bench: Bench) -> None:
    """Schreve figure 5.37: proportional to the amplitude, when all else is the same."""
    bench.seconds = lambda trial, cloud: 0.25 + 0.0375 * trial.amplitude
    (figure,) = make_figure("5.37")
    scan, line = figure.curves
    assert len(scan.x) == 16  # as published
    assert scan.y == pytest.approx(0.25 + 0.0375 * scan.x)
    assert line.y == pytest.approx(scan.y)
    assert scan.measured
    assert not line.measured
    (note,) = figure.notes
    assert number_before(" s +", note) == 0.25
    assert number_before(" s/mm", note) == 0.0375
    assert "correlation 1.000" in note
    assert f"{len(bench.clouds[0])} points" in note
    assert "5.37" in figure.title
    assert figure.x_label == "amplitude, mm"


def test_a_cost_that_does_not_lie_on_a_line_has_the_least_squares_line(bench: Bench) -> None:
    bench.seconds = lambda trial, cloud: 0.1 + 1e-3 * trial.amplitude**2
    (figure,) = make_figure("5.37")
    scan, line = figure.curves
    system = np.column_stack([np.ones(16), scan.x])
    (offset, slope), *_ = np.linalg.lstsq(system, 0.1 + 1e-3 * scan.x**2, rcond=None)
    assert line.y == pytest.approx(offset + slope * scan.x)
    assert f"{slope:+.4f} s/mm" in figure.notes[0]
    middle = scan.x - scan.x.mean()
    height = scan.y - scan.y.mean()
    correlation = middle @ height / np.sqrt(middle @ middle * (height @ height))
    assert f"correlation {correlation:.3f}" in figure.notes[0]


def test_one_cloud_of_the_published_size_is_scanned_with_every_amplitude(bench: Bench) -> None:
    make_figure("5.37")
    assert len(bench.clouds) == 1
    assert {id(cloud) for _, cloud, *_ in bench.scans} == {id(bench.clouds[0])}
    amplitudes = [trial.amplitude for trial, *_ in bench.scans]
    assert amplitudes[::3] == pytest.approx(cost_figures.AMPLITUDES)
    assert {scan[2:] for scan in bench.scans} == {(("square", 2), "probe")}


def test_the_cloud_has_as_many_points_as_the_published_one() -> None:
    """123 426 points (5.4)."""
    cloud = trial_cloud(cost_figures._trial(20.0), 0, cost_figures._WIDE)
    assert len(cloud) == pytest.approx(123_426, rel=0.02)


# ---------------------------------------------------------------- figure 5.38


def test_a_cost_that_the_cloud_does_not_change_is_flat(bench: Bench) -> None:
    """Schreve figure 5.38, which has one step where the octree gets another level."""
    (figure,) = make_figure("5.38")
    (scan,) = figure.curves
    assert scan.y == pytest.approx(np.ones(16))
    assert scan.x == pytest.approx([len(cloud) / 1000 for cloud in bench.clouds])
    assert np.all(np.diff(scan.x) > 0.0)
    (note,) = figure.notes
    assert number_before(" times", note) == round(scan.x[-1] / scan.x[0])
    assert number_before(" % of their mean", note) == 0.0
    assert {trial.amplitude for trial, *_ in bench.scans} == {20.0}


def test_a_cost_that_grows_with_the_cloud_is_told_as_share_of_its_mean(bench: Bench) -> None:
    bench.seconds = lambda trial, cloud: 2.0 + 0.001 * cloud.width
    (figure,) = make_figure("5.38")
    widths = np.array([cloud.width for cloud in bench.clouds])
    times = 2.0 + 0.001 * widths
    growth = 100.0 * (times[-1] - times[0]) / times.mean()
    assert number_before(" % of their mean", figure.notes[0]) == pytest.approx(growth, abs=0.51)
    assert figure.curves[0].y == pytest.approx(times)


# ---------------------------------------------------------------- both


@pytest.mark.parametrize("number", ["5.37", "5.38"])
def test_neither_building_a_cloud_nor_its_first_scan_counts(bench: Bench, number: str) -> None:
    (plain,) = make_figure(number)
    bench.builds = bench.again = 1000.0
    (figure,) = make_figure(number)
    assert figure.curves[0].y == pytest.approx(plain.curves[0].y)


@pytest.mark.parametrize("number", ["5.37", "5.38"])
def test_patches_are_timed_when_asked_for(bench: Bench, number: str) -> None:
    make_figure(number, method="patch")
    assert {scan[2:] for scan in bench.scans} == {(("patch", 0), "patch")}


@pytest.mark.parametrize("number", ["5.37", "5.38"])
def test_cancelled_times_are_shown_as_far_as_they_go(bench: Bench, number: str) -> None:
    progress = CancelsAfter(5)
    (figure,) = make_figure(number, progress=progress)
    assert [len(curve.x) for curve in figure.curves] == [5] * len(figure.curves)
    assert [fraction for fraction, _ in progress.told] == pytest.approx(np.arange(1, 6) / 16)
    assert progress.told[-1][1] == "5 scans"
    assert make_figure(number, progress=CancelsAfter(1)) == ()


def test_every_amplitude_can_be_scanned() -> None:
    """Inequality 4.7.1.1; the scans themselves are too long for a test."""
    trial = printed_trial(0.1, 0.005, section_radius=100.0)
    for amplitude in cost_figures.AMPLITUDES:
        check_possible(ScanParameters(float(amplitude), trial.line_pitch, degree=2))
