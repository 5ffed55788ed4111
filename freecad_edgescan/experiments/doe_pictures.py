# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of the experiments: effects beside the published ones, and the ratio of every test."""

from __future__ import annotations

import csv
import itertools
from pathlib import Path
from typing import Any

import numpy as np

from .doe_comparison import both_completed, counterparts, effects, published_effects
from .doe_design import EXPERIMENTS, PARAMETERS, TESTS
from .doe_result import DoeResult, Group, group_name
from .figures import new_figure, save_figure

__all__ = ["draw_doe", "draw_effects", "draw_ratios"]

STATISTICS = {"avg": "average error", "max": "maximum error"}
_OURS, _THEIRS = "C0", "0.75"  # colours
_TICKS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0)
_HEIGHT = 0.38  # of a bar, of the distance between parameters


def draw_doe(result: DoeResult, folder: Path) -> list[Path]:
    """Draw the effects of each experiment that was scanned whole, and the ratios of all tests.

    The effects are also written as numbers, into effects.csv.

    Returns
    -------
    The files written.

    Raises
    ------
    ValueError: matplotlib is missing.
    """
    written = [folder / "ratios.png"]
    draw_ratios(result, written[0])
    whole = [experiment for experiment in EXPERIMENTS if _is_whole(result, experiment)]
    for experiment in whole:
        written.append(folder / f"effects-{experiment}.png")
        draw_effects(result, experiment, written[-1])
    if whole:
        written.append(folder / "effects.csv")
        _write_effects(result, whole, written[-1])
    return written


def draw_effects(result: DoeResult, experiment: int, path: Path) -> None:
    """Bars of how much each parameter changes the errors of an experiment, ours and published."""
    groups = [
        group for group in result.groups if effects(result, experiment, group, "avg") is not None
    ]
    figure = new_figure(path, 1.6 + 2.6 * len(groups), 7.5)
    places = np.arange(len(PARAMETERS))
    panels = figure.subplots(2, len(groups), sharey=True, squeeze=False)
    for (statistic, row), (group, column) in itertools.product(
        zip(STATISTICS, panels, strict=True), zip(groups, range(len(groups)), strict=True)
    ):
        axes = row[column]
        ours = effects(result, experiment, group, statistic)
        theirs = published_effects(experiment, group, statistic)
        if ours is not None:
            axes.barh(places - _HEIGHT / 2, ours, _HEIGHT, color=_OURS, label="ours")
        if theirs is not None:
            axes.barh(places + _HEIGHT / 2, theirs, _HEIGHT, color=_THEIRS, label="published")
        axes.set_title(f"{group_name(group)}, {STATISTICS[statistic]}", fontsize="medium")
        axes.set_yticks(places, [name.replace("_", " ") for name in PARAMETERS])
        axes.grid(axis="x", color="0.9")
        axes.set_axisbelow(True)
    panels[0, 0].invert_yaxis()
    panels[0, -1].legend(loc="lower right", fontsize="small")
    figure.suptitle(f"Experiment {experiment}: effect of each parameter")
    save_figure(figure, path)


def draw_ratios(result: DoeResult, path: Path) -> None:
    """Our over the published error for every test, one panel for each pattern and degree."""
    figure = new_figure(path, 11.0, 0.6 + 2.3 * len(result.groups))
    panels = figure.subplots(len(result.groups), 1, sharex=True, squeeze=False)[:, 0]
    for axes, group in zip(panels, result.groups, strict=True):
        _draw_group(axes, result, group)
    panels[0].legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), frameon=False)
    experiments = np.array(EXPERIMENTS)
    panels[-1].set_xticks((experiments - 0.5) * len(TESTS), [f"{number}" for number in experiments])
    panels[-1].set_xlabel("experiment, each with its 16 tests")
    save_figure(figure, path)


def _draw_group(axes: Any, result: DoeResult, group: Group) -> None:
    pairs = counterparts(result, group)
    both = both_completed(pairs)
    place = [_place(ours.experiment, ours.test) for ours, _ in both]
    for statistic, marker, colour in (("max", "x", "C1"), ("avg", "o", _OURS)):
        name = f"{statistic}_error"
        ratios = [getattr(ours, name) / getattr(theirs, name) for ours, theirs in both]
        axes.plot(place, ratios, marker, ms=4, color=colour, label=STATISTICS[statistic])
    for failed, colour, label in (
        ([ours for ours, _ in pairs if not ours.completed], "C3", "ours not completed"),
        ([theirs for _, theirs in pairs if not theirs.completed], "0.6", "published not completed"),
    ):
        height = 0.94 if colour == "C3" else 0.86
        axes.plot(
            [_place(run.experiment, run.test) for run in failed],
            np.full(len(failed), height),
            "v",
            ms=5,
            color=colour,
            label=label,
            transform=axes.get_xaxis_transform(),
        )
    axes.axhline(1.0, color="0.5", lw=0.8)
    for edge in range(len(EXPERIMENTS) + 1):
        axes.axvline(edge * len(TESTS), color="0.9", lw=0.8, zorder=0)
    lowest, highest = _limits(axes)
    ticks = [tick for tick in _TICKS if lowest <= tick <= highest]
    axes.set_yscale("log")
    axes.set_yticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.minorticks_off()
    axes.set(ylim=(lowest, highest), xlim=(0, len(EXPERIMENTS) * len(TESTS)))
    axes.set_ylabel("ours / published")
    axes.set_title(group_name(group), loc="left", fontsize="medium")


def _limits(axes: Any) -> tuple[float, float]:
    """From below the smallest ratio to well above the largest, where failures are marked."""
    drawn = np.concatenate([line.get_ydata() for line in axes.get_lines()[:2]] + [[1.0]])
    spread = (drawn.max() / drawn.min()) ** 0.1
    return float(drawn.min() / 1.1 / spread), float(drawn.max() * 1.2 * spread**3)


def _place(experiment: int, test: int) -> float:
    return (experiment - 1) * len(TESTS) + test - 0.5


def _is_whole(result: DoeResult, experiment: int) -> bool:
    return any(effects(result, experiment, group, "avg") is not None for group in result.groups)


def _write_effects(result: DoeResult, experiments: list[int], path: Path) -> None:
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["experiment", "parameter", "group", "statistic", "ours", "published"])
        for experiment, group, statistic in itertools.product(
            experiments, result.groups, STATISTICS
        ):
            ours = effects(result, experiment, group, statistic)
            theirs = published_effects(experiment, group, statistic)
            if ours is None:
                continue
            for number, parameter in enumerate(PARAMETERS):
                other = "" if theirs is None else f"{theirs[number]:.4f}"
                name = group_name(group)
                writer.writerow(
                    [experiment, parameter, name, statistic, f"{ours[number]:.4f}", other]
                )
