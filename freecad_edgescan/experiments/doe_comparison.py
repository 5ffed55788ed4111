# SPDX-License-Identifier: LGPL-2.1-or-later
"""Our runs of the experiments beside the published ones: numbers only, tables are made elsewhere.

Ratios are taken over the tests that both completed and summarised as geometric means.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from .doe_design import EXPERIMENTS, PARAMETERS, TESTS, trial
from .doe_published import main_effects, published_counterparts
from .doe_result import DoeResult, DoeRun, Group, group_name

__all__ = [
    "LED_BY_FAILED_RUNS",
    "Comparison",
    "Leader",
    "compare_all",
    "compare_experiment",
    "compare_group",
    "effects",
    "leaders",
    "published_effects",
]

Array = NDArray[np.float64]
Pair = tuple[DoeRun, DoeRun]

LED_BY_FAILED_RUNS = (5, 7, 11)  # experiments whose published effects are those of failed runs
MOST_LEADERS = 3  # of our effects that may hold the largest published one


@dataclass(frozen=True)
class Comparison:
    """Runs of one pattern and degree, or of all, beside the published ones.

    Attributes
    ----------
    name : Z1, Z2, S1, S2, patch or all
    runs : number of our runs
    completed, published_completed : how many of these we, and the published scans, completed
    tests : how many both completed
    avg_ratio, max_ratio : geometric mean of our over the published error; nan without any
    published_points, nominal_points : median of our number of edge points over the published
        one, and over the nominal (π - 0.2)x/ρ_e; of completed runs
    """

    name: str
    runs: int
    completed: int
    published_completed: int
    tests: int
    avg_ratio: float
    max_ratio: float
    published_points: float
    nominal_points: float


@dataclass(frozen=True)
class Leader:
    """Which parameters change the average error most, in one experiment.

    Attributes
    ----------
    experiment : 1 … 12
    group : pattern and degree
    published : the parameter with the largest published effect
    ours : our three largest, largest first
    """

    experiment: int
    group: Group
    published: str
    ours: tuple[str, ...]

    @property
    def agrees(self) -> bool:
        """Whether the largest published one is among our three largest."""
        return self.published in self.ours


def compare_group(result: DoeResult, group: Group) -> Comparison:
    """The runs of one pattern and degree beside the published ones."""
    return _compare(group_name(group), result.of_group(group).values(), counterparts(result, group))


def compare_experiment(result: DoeResult, group: Group, experiment: int) -> Comparison:
    """The runs of one pattern and degree and one experiment beside the published ones."""
    mine = tuple(run for run in result if run.experiment == experiment)
    return compare_group(replace(result, runs=mine), group)


def compare_all(result: DoeResult) -> Comparison:
    """All runs beside the published ones."""
    pairs = [pair for group in result.groups for pair in counterparts(result, group)]
    return _compare("all", result.runs, pairs)


def counterparts(result: DoeResult, group: Group) -> list[Pair]:
    """Our runs of a pattern and degree, each with the published one it is compared with."""
    published = published_counterparts(group)
    return [
        (run, published[key]) for key, run in result.of_group(group).items() if key in published
    ]


def both_completed(pairs: Iterable[Pair]) -> list[Pair]:
    """Those that can be compared."""
    return [(ours, theirs) for ours, theirs in pairs if ours.completed and theirs.completed]


def effects(result: DoeResult, experiment: int, group: Group, statistic: str) -> Array | None:
    """Our main effects, (11,); None unless all 16 tests of the experiment were scanned.

    Parameters
    ----------
    statistic : avg or max
    """
    return _effects(result.of_group(group), experiment, statistic)


def published_effects(experiment: int, group: Group, statistic: str) -> Array | None:
    """Main effects of the published results, (11,), by the same formula.

    They agree with the printed ones to rounding, without the printed slips and gaps.
    """
    return _effects(published_counterparts(group), experiment, statistic)


def leaders(result: DoeResult, group: Group) -> list[Leader]:
    """Which parameters lead in each experiment that was scanned whole."""
    found = []
    for experiment in EXPERIMENTS:
        ours = effects(result, experiment, group, "avg")
        theirs = published_effects(experiment, group, "avg")
        if ours is not None and theirs is not None and np.isfinite(ours).all():
            best = np.argsort(-ours, kind="stable")[:MOST_LEADERS]
            names = tuple(PARAMETERS[number] for number in best)
            found.append(Leader(experiment, group, PARAMETERS[int(np.argmax(theirs))], names))
    return found


def _compare(name: str, runs: Iterable[DoeRun], pairs: Sequence[Pair]) -> Comparison:
    runs = list(runs)
    both = both_completed(pairs)
    counted = [(ours, theirs) for ours, theirs in both if theirs.points]
    return Comparison(
        name=name,
        runs=len(runs),
        completed=sum(run.completed for run in runs),
        published_completed=sum(theirs.completed for _, theirs in pairs),
        tests=len(both),
        avg_ratio=_geometric_mean(ours.avg_error / theirs.avg_error for ours, theirs in both),
        max_ratio=_geometric_mean(ours.max_error / theirs.max_error for ours, theirs in both),
        published_points=_median(ours.points / theirs.points for ours, theirs in counted),
        nominal_points=_median(
            run.points / trial(run.experiment, run.test).nominal_points
            for run in runs
            if run.completed
        ),
    )


def _effects(runs: dict[tuple[int, int], DoeRun], experiment: int, statistic: str) -> Array | None:
    keys = [(experiment, test) for test in TESTS]
    if not all(key in runs for key in keys):
        return None
    return main_effects([getattr(runs[key], f"{statistic}_error") for key in keys])


def _geometric_mean(ratios: Iterable[float]) -> float:
    logarithms = np.log(list(ratios))
    return float(np.exp(logarithms.mean())) if len(logarithms) else np.nan


def _median(ratios: Iterable[float]) -> float:
    values = list(ratios)
    return float(np.median(values)) if values else np.nan
