# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures made of scans, and the comparisons that justify the defaults: by stubs, and reduced."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial

import numpy as np
import pytest

import freecad_edgescan.experiments.compensation_figures as compensation_figures
import freecad_edgescan.experiments.scan_figures as scan_figures
import freecad_edgescan.experiments.tangent_figures as tangent_figures
from freecad_edgescan.experiments import DoeResult, DoeRun, run_doe
from freecad_edgescan.experiments.doe_choices import compare_choices
from freecad_edgescan.experiments.doe_curves import Curves
from freecad_edgescan.experiments.doe_design import Trial, trial
from freecad_edgescan.experiments.doe_figures import make_figure
from freecad_edgescan.experiments.doe_published import published_result
from freecad_edgescan.experiments.doe_scan import RowTask
from freecad_edgescan.scanning.error_model import model_error

NOISES = (0.005, 0.05, 0.1)  # mm, of the published figures
WAYS = ("point", "curve", "intersection", "intersection_printed")


class CancelsAt:
    """A progress that says no from some share on."""

    def __init__(self, share: float = 2.0) -> None:
        self.share, self.told = share, []

    def update(self, fraction: float, so_far: object) -> bool:
        self.told.append(fraction)
        return fraction < self.share


# ---------------------------------------------------------------- figures 5.6 to 5.9, stubbed


def share_of(row: Trial) -> float:
    """s/r of a row, from its amplitude: A = 2s + df."""
    return (row.amplitude - row.object.rounding_length) / 2.0 / 50.0


def error_of(row: Trial, pattern: str) -> float:
    """What the stub finds: another number for each object and pattern."""
    return row.noise + share_of(row) + (10.0 if pattern == "zigzag" else 0.0)


class Scans:
    """Stands for the scans: answers a run for every task, and keeps the tasks."""

    def __init__(self, fails: Callable[[Trial], bool] = lambda row: False, count: int = 999):
        self.fails, self.count, self.tasks = fails, count, []

    def __call__(self, tasks: Sequence[RowTask], jobs: int, progress: object) -> Mapping:
        self.tasks, self.jobs = list(tasks), jobs
        return {
            number: tuple(
                DoeRun(
                    0,
                    task.trial.test,
                    *group,
                    avg_error=error_of(task.trial, group[0]),
                    max_error=99.0,
                    points=1,
                    completed=not self.fails(task.trial),
                )
                for group in task.groups
            )
            for number, task in enumerate(self.tasks[: self.count])
        }


@pytest.fixture
def scans(monkeypatch) -> Scans:
    stub = Scans()
    monkeypatch.setattr(scan_figures, "scan_rows", stub)
    return stub


FIGURES = [
    ("5.6", 2, ["square"], "square quadratic"),
    ("5.7", 1, ["square"], "square linear"),
    ("5.8", 2, ["zigzag", "square"], "zigzag and square quadratic"),
    ("5.9", 1, ["zigzag", "square"], "zigzag and square linear"),
]


@pytest.mark.parametrize(("number", "degree", "patterns", "words"), FIGURES)
def test_a_figure_shows_the_published_scans_beside_the_analytical_error(
    scans: Scans, number: str, degree: int, patterns: list[str], words: str
) -> None:
    (figure,) = make_figure(number)
    assert figure.title == f"Figure {number}: average error of {words} scans"
    assert "s/r" in figure.x_label
    assert "mm" in figure.y_label
    assert figure.logarithmic
    names = [f"{pattern}, η = {noise:g} mm" for pattern in patterns for noise in NOISES]
    assert [curve.name for curve in figure.curves] == ["analytical", *names]
    analytical, *found = figure.curves
    assert not analytical.measured
    exact = model_error(degree, 50.0 * analytical.x, 50.5, np.pi / 2, 0.0, 0.5)
    assert analytical.y == pytest.approx(exact)
    for curve in found:
        assert curve.measured
        pattern, noise = curve.name.split(",")[0], float(curve.name.split()[-2])
        assert curve.x == pytest.approx(analytical.x)
        assert curve.y == pytest.approx(noise + curve.x + (10.0 if pattern == "zigzag" else 0.0))
    assert figure.notes == ()
    assert {task.groups for task in scans.tasks} == {tuple((each, degree) for each in patterns)}


@pytest.mark.parametrize("literal", [False, True])
def test_seed_jobs_and_the_algorithm_are_handed_on(scans: Scans, literal: bool) -> None:
    make_figure("5.6", seed=5, jobs=1, literal=literal)
    assert scans.jobs == 1
    assert {(task.seed, task.literal, task.method) for task in scans.tasks} == {
        (5, literal, "probe")
    }
    # Each object has noise of its own.
    assert len({task.trial.test for task in scans.tasks}) == len(scans.tasks)


def test_every_object_is_the_one_printed_with_the_figures(scans: Scans) -> None:
    make_figure("5.6")
    for row in (task.trial for task in scans.tasks):
        assert (row.line_pitch, row.edge_pitch, row.cloud_pitch) == (2.0, 2.0, 1.0)
        assert row.tolerance == {0.005: 0.2, 0.05: 0.25, 0.1: 0.3}[row.noise]
        # 4.7.1.1: q + 1 points of a quadratic have to fit on a side.
        assert row.amplitude / 2.0 >= 3.0 * row.line_pitch


def test_scans_that_did_not_complete_leave_gaps_and_are_counted(scans: Scans) -> None:
    scans.fails = lambda row: row.noise == 0.1 and share_of(row) > 0.45
    (figure,) = make_figure("5.8")
    for curve in figure.curves[1:]:
        missing = np.isnan(curve.y)
        assert np.array_equal(missing, (curve.x > 0.45) & ("0.1 mm" in curve.name))
    lost = int(np.count_nonzero(figure.curves[0].x > 0.45))
    assert figure.notes == (f"{2 * lost} scans did not complete and are missing.",)


def test_what_was_scanned_until_somebody_cancelled_is_shown(scans: Scans) -> None:
    scans.count = 4
    (figure,) = make_figure("5.6")
    assert [np.count_nonzero(np.isfinite(curve.y)) for curve in figure.curves[1:]] == [4, 0, 0]
    scans.count = 0
    assert make_figure("5.6") == ()


# ---------------------------------------------------------------- figures 5.6 and 5.8, scanned


@pytest.mark.slow
def test_noise_rules_short_lines_and_the_model_rules_long_ones(monkeypatch) -> None:
    """Schreve 5.2.5: the error falls with s/r while noise rules, then grows with the model's.

    And 5.2.6: zigzag and square scans have the same trend.
    """
    monkeypatch.setattr(scan_figures, "_SHARES", {2: (0.16, 0.6)})
    monkeypatch.setattr(scan_figures, "TOLERANCES", {0.005: 0.2, 0.1: 0.3})
    (figure,) = make_figure("5.8")
    short, long = np.array([curve.y for curve in figure.curves]).T
    found, little, much = slice(1, None), [1, 3], [2, 4]  # zigzag and square each
    assert np.all(short[found] > 10.0 * short[0])
    assert np.all(short[much] > 10.0 * short[little])  # the noise is 20 times as much
    assert np.all(long[much] < 0.6 * short[much])
    assert np.all(long[little] > 5.0 * short[little])
    assert np.all((long[found] > 0.6 * long[0]) & (long[found] < 1.6 * long[0]))
    for error in (short, long):
        assert error[1:3] == pytest.approx(error[3:5], rel=0.3)


# ---------------------------------------------------------------- compensation


def runs_with(error: Callable[[int], float], group: tuple[str, int] = ("square", 2)) -> DoeResult:
    runs = [
        DoeRun(1, test, *group, error(test), 3.0 * error(test), 90, completed=test != 7)
        for test in range(1, 17)
    ]
    return DoeResult(tuple(runs))


class Experiments:
    """Stands for `run_doe`: errors that tell which way was asked for, and what was asked."""

    def __init__(self) -> None:
        self.calls: list[dict] = []

    def __call__(self, *where: object, progress: object, **asked: object) -> DoeResult:
        self.calls.append({"where": where, **asked})
        (way,) = asked["overrides"].values()
        result = runs_with(lambda test: 0.01 * test * (1 + ["", *WAYS, *TANGENTS].index(way)))
        cancelled = not progress.update(0.5, result)
        return DoeResult(result.runs, cancelled=cancelled)


TANGENTS = ("interpolation", "planes", "polynomials")


@pytest.fixture
def experiments(monkeypatch) -> Experiments:
    stub = Experiments()
    for module in (compensation_figures, tangent_figures):
        monkeypatch.setattr(module, "run_doe", stub)
    return stub


def test_compensations_are_compared_as_published(experiments: Experiments) -> None:
    """Over the 16 objects of experiment 1, square and quadratic (Schreve 4.5.5)."""
    progress = CancelsAt()
    figures = compare_choices("compensation", seed=3, jobs=1, progress=progress)
    assert [call["where"] for call in experiments.calls] == [([1], ["square"], [2])] * 4
    assert [call["overrides"] for call in experiments.calls] == [
        {"compensation": way} for way in WAYS
    ]
    assert {(call["seed"], call["jobs"]) for call in experiments.calls} == {(3, 1)}
    assert progress.told == pytest.approx([0.125, 0.375, 0.625, 0.875])
    assert [figure.title.split(" error")[0] for figure in figures] == [
        "Figure 4.18: average",
        "Figure 4.19: maximum",
    ]
    published = published_result().of_group(("square", 2))
    for figure, factor, statistic in zip(
        figures, (1.0, 3.0), ("avg_error", "max_error"), strict=True
    ):
        assert [curve.name for curve in figure.curves] == [
            *("point", "curve", "intersection", "intersection, printed"),
            "published",
        ]
        for number, curve in enumerate(figure.curves[:-1]):
            assert curve.x == pytest.approx(np.arange(1, 17))
            assert curve.y == pytest.approx(factor * 0.01 * curve.x * (2 + number))
        assert figure.curves[-1].y == pytest.approx(
            [getattr(published[1, test], statistic) for test in range(1, 17)]
        )
        middle = factor * 0.02 * float(np.prod(np.arange(1.0, 17.0) ** (1.0 / 16.0)))
        assert figure.notes[0] == f"point: geometric mean {middle:.4f} mm, 15 of 16 completed"
        assert "completed" not in figure.notes[-1]


def test_a_cancelled_comparison_shows_the_ways_that_were_scanned(experiments) -> None:
    figures = compare_choices("compensation", progress=CancelsAt(0.5))
    for figure in figures:
        assert [curve.name for curve in figure.curves] == ["point", "curve", "published"]
    assert compare_choices("compensation", progress=CancelsAt(0.0)) == ()


@pytest.mark.slow
def test_the_default_compensation_is_better_than_the_printed_ones(monkeypatch) -> None:
    """Schreve figures 4.18 and 4.19; in tests 3 and 16 the edge bends most between two lines.

    The chord's sagitta ρe² κe / 2 is 0.0107 mm there and 0.006 mm in test 6, the noise level is
    0.01 mm in test 3 and 0.02 mm in the other two.
    """
    tests = [3, 6, 16]
    sagitta = [
        trial(1, test).edge_pitch ** 2 / (2.0 * trial(1, test).edge_radius) for test in tests
    ]
    assert sagitta == pytest.approx([0.0107, 0.006, 0.0107], abs=1e-4)
    monkeypatch.setattr(compensation_figures, "TESTS", tests)
    monkeypatch.setattr(compensation_figures, "run_doe", partial(run_doe, tests=tests))
    average, largest = compare_choices("compensation")
    errors = {curve.name: curve.y for curve in average.curves}
    default, printed = errors["intersection"], errors["intersection, printed"]
    for name in ("point", "curve", "intersection, printed"):
        assert np.all(default < errors[name]), name
        assert default.mean() < 0.85 * errors[name].mean(), name
    assert printed[0] - default[0] > 0.5 * sagitta[0]
    # The noise of every single point is in it, as told of test 6 and 16.
    assert np.all(errors["point"][1:] > printed[1:])
    assert np.all(printed < 2.0 * errors["published"])
    assert all(np.all(curve.y > errors[curve.name]) for curve in largest.curves)


# ---------------------------------------------------------------- tangents


def test_tangents_are_compared_on_two_edges_and_by_the_walks_that_complete(
    monkeypatch, experiments: Experiments
) -> None:
    along = []

    def one_edge(number: str, row: Trial, seed: int) -> Curves:
        along.append((number, row, seed))
        return Curves(f"Figure {number}", "scan line", "angle", (), (f"note of {number}",))

    monkeypatch.setattr(tangent_figures, "tangents_along", one_edge)
    progress = CancelsAt()
    figures = compare_choices("tangent", seed=2, jobs=1, progress=progress)
    assert [(number, seed) for number, _, seed in along] == [("4.9", 2), ("4.11", 2)]
    assert [figure.title for figure in figures] == ["Figure 4.9", "Figure 4.11"]
    assert figures[0].notes == ("note of 4.9",)
    own, walks = figures[1].notes
    assert own == "note of 4.11"
    for way in TANGENTS:
        assert f"{way} 15 of 16" in walks
    assert [call["overrides"] for call in experiments.calls] == [
        {"tangent": way} for way in TANGENTS
    ]
    # Nothing makes up for a bad tangent in the algorithm as printed.
    assert all(call["literal"] and call["seed"] == 2 for call in experiments.calls)
    assert progress.told == pytest.approx([1 / 6, 3 / 6, 5 / 6])


def test_a_cancelled_comparison_of_tangents_shows_nothing(experiments: Experiments) -> None:
    assert compare_choices("tangent", progress=CancelsAt(0.4)) == ()
    assert len(experiments.calls) == 2


def test_any_normals_tell_the_tangent_better_than_noisy_edge_points() -> None:
    """Schreve 4.4.1.2 and figure 4.9: on sides that are all but flat planes will do, too."""
    figure = tangent_figures.tangents_along("4.9", trial(2, 4), seed=0)
    assert [curve.name for curve in figure.curves] == list(TANGENTS)
    assert "4.9" in figure.title
    assert "degrees" in figure.y_label
    angles = [curve.y for curve in figure.curves]
    assert len({len(angle) for angle in angles}) == 1
    interpolation, planes, polynomials = (float(np.median(angle)) for angle in angles)
    assert planes < 0.5 * interpolation
    assert polynomials < 0.75 * interpolation
    largest = [float(angle.max()) for angle in angles]
    assert largest[0] == max(largest)
    for curve, note in zip(figure.curves, figure.notes, strict=True):
        assert note == (
            f"{curve.name}: median {np.median(curve.y):.2f}°, largest {curve.y.max():.2f}°"
        )
