# SPDX-License-Identifier: LGPL-2.1-or-later
"""What ``edgescan doe`` prints: our runs beside the published ones."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from textwrap import shorten

import numpy as np
from numpy.typing import NDArray

from .doe_comparison import (
    LED_BY_FAILED_RUNS,
    MOST_LEADERS,
    Comparison,
    compare_all,
    compare_experiment,
    compare_group,
    effects,
    leaders,
    published_effects,
)
from .doe_design import EXPERIMENTS, PARAMETERS, trial
from .doe_published import published_counterparts
from .doe_result import DoeResult, DoeRun, Group, group_name
from .honesty import TRUE_95, TRUE_MEDIAN, median_and_95

__all__ = [
    "comparison_table",
    "effects_table",
    "experiments_table",
    "failures_table",
    "leaders_table",
    "seeds_table",
    "summary",
]

_EFFECTS_HEAD = (
    'Effect of each parameter on the average error ("sensitivity"), ours beside published\n'
    f"(* our {MOST_LEADERS} largest, and the largest published)"
)
_FEWEST_DIFFERENCE = 3  # completed runs by which seeds must differ to say that they do
_LARGEST_ARC = {1: 0.1, 2: 0.6, 3: 0.6, 0: 0.6}  # s·κ_s by degree (Schreve 5.3.4.6)


def summary(result: DoeResult) -> str:
    """All tables of one seed."""
    tables = [effects_table(result, experiment) for experiment in EXPERIMENTS]
    if any(tables):
        tables.insert(0, _EFFECTS_HEAD)
    tables += [leaders_table(result), failures_table(result), experiments_table(result)]
    tables += [comparison_table(result)]
    return "\n\n".join(filter(None, tables))


def comparison_table(result: DoeResult) -> str:
    """Completed runs, ratios of errors and numbers of edge points."""
    rows = [compare_group(result, group) for group in result.groups]
    if len(rows) > 1:
        rows.append(compare_all(result))
    head = (
        "            completed            error / published      edge points (median)",
        "          of   ours  published   average  maximum  tests   / published  / nominal",
    )
    return "\n".join([*head, *map(_comparison_line, rows)])


def effects_table(result: DoeResult, experiment: int) -> str:
    """How much each parameter changes the average error of an experiment; "" without all tests."""
    columns: dict[Group, tuple[NDArray, NDArray | None]] = {}
    for group in result.groups:
        ours = effects(result, experiment, group, "avg")
        if ours is not None:
            columns[group] = ours, published_effects(experiment, group, "avg")
    if not columns:
        return ""
    head = "".join(f"{group_name(group):>9} published" for group in columns)
    lines = [f"{f'experiment {experiment}':<18}{head}"]
    for row, parameter in enumerate(PARAMETERS):
        cells = "".join(_effect_cells(row, *pair) for pair in columns.values())
        lines.append(f"{_words(parameter):<18}{cells}")
    return "\n".join(line.rstrip() for line in lines)


def leaders_table(result: DoeResult) -> str:
    """Whether the parameter that leads in the published effects is among our three largest."""
    lines = []
    for group in result.groups:
        found = leaders(result, group)
        if not found:
            continue
        agreeing = sum(leader.agrees for leader in found)
        lines.append(
            f"{group_name(group):<6}{agreeing:3d} of {len(found)}" + _elsewhere(group, result)
        )
    if not lines:
        return ""
    head = f"Largest published effect (average error) among our {MOST_LEADERS} largest"
    listed = ", ".join(map(str, LED_BY_FAILED_RUNS))
    foot = f"The published effects of experiments {listed} are led by failed runs."
    return "\n".join([head, *lines, foot])


def failures_table(result: DoeResult) -> str:
    """The runs that did not complete, with what chapter 5 names as causes."""
    failed = [run for run in result if not run.completed]
    if not failed:
        return f"Stopped after {len(result)} runs." if result.cancelled else "Every run completed."
    head = (
        f"{'1 run' if len(failed) == 1 else f'{len(failed)} runs'} did not complete (* beyond its "
        "guideline: tolerance ratio and df/s at most 1, s·κ_s at most 0.1 for lines, else 0.6)",
        "                                               average maximum  edge points",
        "run        tolerance ratio     df/s    s·κ_s        mm      mm  of nominal   published"
        "  stop",
    )
    return "\n".join([*head, *(line for run in failed for line in _failure_lines(run))])


def experiments_table(result: DoeResult) -> str:
    """Each experiment's completed runs against the published, the possible and the stated errors.

    "" where no covariance is stated.
    """
    lines = []
    for group in result.groups:
        runs = [run for run in result.of_group(group).values() if run.completed and run.mahalanobis]
        for experiment in sorted({run.experiment for run in runs}):
            mine = [run for run in runs if run.experiment == experiment]
            ratios = compare_experiment(result, group, experiment)
            lines.append(_experiment_line(group, str(experiment), ratios, mine))
        if len({run.experiment for run in runs}) > 1:
            lines.append(_experiment_line(group, "all", compare_group(result, group), runs))
    if not lines:
        return ""
    head = (
        "Errors over the published ones, geometric mean; root mean square errors over the",
        "smallest ones possible for edge points that share nothing with their neighbours; and",
        "distances from the true edge in the standard deviations the scan states (Mahalanobis;",
        f"{TRUE_MEDIAN:.2f} and {TRUE_95:.2f} where they are true, less where they are too large). "
        "One section: before",
        "edge points are smoothed along the edge.",
        "             error / published     rms error / bound      distance in stated sigma",
        "                                  one     edge points     edge points   one section",
        "experiment   average  maximum  section  median  largest  median  95 %  median  95 %",
    )
    return "\n".join([*head, *lines])


def _experiment_line(
    group: Group, experiment: str, ratios: Comparison, runs: Sequence[DoeRun]
) -> str:
    single, smoothed = (
        [getattr(run, name) / run.bound for run in runs] for name in ("unsmoothed_rms", "rms_error")
    )
    median, most = median_and_95([d for run in runs for d in run.mahalanobis])
    before, most_before = median_and_95([d for run in runs for d in run.unsmoothed_mahalanobis])
    return (
        f"{group_name(group):<6}{experiment:>4} {ratios.avg_ratio:9.3f} {ratios.max_ratio:8.3f}"
        f" {np.median(single):8.3f} {np.median(smoothed):7.3f} {max(smoothed):8.3f}"
        f" {median:7.2f} {most:5.2f} {before:7.2f} {most_before:5.2f}"
    )


def seeds_table(results: Sequence[DoeResult]) -> str:
    """Completed runs and ratios of several seeds side by side."""
    lines = ["seed   completed   error / published: average  maximum   by pattern and degree"]
    for result in results:
        total = compare_all(result)
        groups = (compare_group(result, group) for group in result.groups)
        each = "  ".join(f"{row.name} {row.completed} {row.avg_ratio:.3f}" for row in groups)
        lines.append(
            f"{result.seed:4d} {total.completed:6d} of {total.runs:<4d}"
            f" {total.avg_ratio:21.3f} {total.max_ratio:8.3f}   {each}"
        )
    counts = [result.completed for result in results]
    if len({len(result) for result in results}) == 1:
        spread = max(counts) - min(counts)
        verdict = "fewer than" if spread < _FEWEST_DIFFERENCE else "not fewer than"
        lines.append(
            f"The seeds differ by {spread} completed runs, {verdict} {_FEWEST_DIFFERENCE}."
        )
    return "\n".join(lines)


def _comparison_line(row: Comparison) -> str:
    return (
        f"{row.name:<6}{row.runs:6d} {row.completed:6d} {row.published_completed:10d} "
        f"{row.avg_ratio:9.3f} {row.max_ratio:8.3f} {row.tests:6d} "
        f"{row.published_points:13.3f} {row.nominal_points:10.3f}"
    )


def _effect_cells(row: int, ours: NDArray, published: NDArray | None) -> str:
    mark = "*" if row in np.argsort(-ours, kind="stable")[:MOST_LEADERS] else " "
    cells = f"{ours[row]:8.3f}{mark}"
    if published is None:
        return f"{cells}{'-':>9} "
    return cells + f"{published[row]:9.3f}{'*' if row == np.argmax(published) else ' '}"


def _elsewhere(group: Group, result: DoeResult) -> str:
    """The experiments where another parameter leads."""
    others = [
        f"{leader.experiment}: {_words(leader.published)}, ours "
        + ", ".join(map(_words, leader.ours))
        for leader in leaders(result, group)
        if not leader.agrees
    ]
    return "".join(f"\n         not in {text}" for text in others)


def _failure_lines(run: DoeRun) -> Iterator[str]:
    row = trial(run.experiment, run.test)
    published = published_counterparts(run.group).get((run.experiment, run.test))
    done = "-" if published is None else "completed" if published.completed else "failed"
    causes = (
        f"{_marked(row.tolerance_ratio, 1.0):>10}{_marked(row.rounding_share, 1.0):>11}"
        f"{_marked(row.arc_share, _LARGEST_ARC[run.degree]):>9}"
    )
    yield (
        f"{run.name:<14}{causes}{run.avg_error:10.3f}{run.max_error:8.3f}"
        f"{run.points:7d} {row.nominal_points:5.0f}{done:>11}  {run.stop}"
    )
    if run.message:
        yield f"           {shorten(run.message, 240, placeholder=' …')}"


def _marked(value: float, limit: float) -> str:
    return f"{value:.3f}" + ("*" if value > limit else " ")


def _words(parameter: str) -> str:
    return parameter.replace("_", " ")
