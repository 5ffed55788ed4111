# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of how exact and how honest scans are: along edges, over all points, by experiment.

Whatever is drawn is drawn whole: axes reach to the farthest point, and every test of an experiment
has a mark beside the mean. Colours are Okabe and Ito's, told apart by everybody.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..cloud import TrueEdge
from ..scanning import ScannedEdge
from ..scanning.corner import across_axes
from .doe_comparison import both_completed, compare_experiment, compare_group, counterparts
from .doe_design import EXPERIMENTS
from .doe_result import DoeResult, Group
from .edge_report import EdgeReport
from .figures import new_figure, save_figure
from .honesty import TRUE_95, TRUE_MEDIAN, true_share

__all__ = ["across_errors", "draw_along", "draw_calibration", "draw_experiments", "shares_beyond"]

Array = NDArray[np.float64]

_WIDTH = 8.0  # inches
_FIRST, _SECOND, _BAND = "#0072B2", "#D55E00", "#BFDDF0"  # blue, vermilion, pale blue
_MICROMETRES = 1e3  # in a mm
_DIRECTIONS = ("out of the wedge", "from side to side")  # of `across_axes`
_TICKS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0)
_ALL = len(EXPERIMENTS) + 1.6  # where all experiments together are drawn


@dataclass(frozen=True)
class _RatioStyle:
    """How one statistic of the experiments is drawn, beside the other one."""

    statistic: str
    marker: str
    colour: str
    shift: float

    @property
    def ratio(self) -> str:
        """Its name in a `Comparison`."""
        return f"{self.statistic}_ratio"


_OF_RATIOS = {
    "average": _RatioStyle("avg", "o", _FIRST, -0.17),
    "maximum": _RatioStyle("max", "s", _SECOND, 0.17),
}


def across_errors(edge: ScannedEdge, truth: TrueEdge) -> tuple[Array, Array]:
    """Signed error of each edge point in the two directions across the edge, and its sigma.

    Returns
    -------
    (m, 2) and (m, 2) mm: along the normals' sum, out of the smaller wedge, and along their
    difference.
    """
    errors = np.einsum("mai,mi->ma", across_axes(edge.normals), truth.residuals(edge.points))
    return errors, np.sqrt(np.einsum("maa->ma", edge.covariance))


def draw_along(reports: Mapping[str, EdgeReport], path: str | Path) -> None:
    """Draw the signed errors along each edge, in both directions across it, on their ±2 sigma.

    Parameters
    ----------
    reports : by what to write above them
    path : picture file

    Raises
    ------
    ValueError: matplotlib is missing.
    """
    figure = new_figure(path, _WIDTH, 0.9 + 1.75 * len(reports))
    panels = figure.subplots(len(reports), 2, squeeze=False, sharey="row")
    for row, (name, report) in zip(panels, reports.items(), strict=True):
        if report.edge is None:
            _draw_refusal(row, name, report.refusal)
        else:
            _draw_components(row, name, report.edge, report.truth)
    for axes, direction in zip(panels[0], _DIRECTIONS, strict=True):
        axes.annotate(
            f"error {direction}",
            (0.0, 1.0),
            xytext=(0.0, 20.0),
            xycoords="axes fraction",
            textcoords="offset points",
        )
    for axes in panels[-1]:
        axes.set_xlabel("distance along the edge, mm")
    drawn = [axes for axes in panels.flat if axes.lines]
    panels[-1, 0].legend(
        *(drawn[0].get_legend_handles_labels() if drawn else ([], [])),
        loc="upper left",
        bbox_to_anchor=(-0.02, -0.33),
        ncols=3,
        frameon=False,
        fontsize="small",
        columnspacing=0.9,
        handlelength=1.3,
    )
    save_figure(figure, path)


def _draw_components(row: Any, name: str, edge: ScannedEdge, truth: TrueEdge) -> None:
    (errors, sigma), (before, _) = across_errors(edge, truth), across_errors(edge.unsmoothed, truth)
    steps = np.linalg.norm(np.diff(edge.points, axis=0), axis=1)
    along = np.concatenate([[0.0], np.cumsum(steps)])
    for k, axes in enumerate(row):
        band, error = 2.0 * _MICROMETRES * sigma[:, k], _MICROMETRES * errors[:, k]
        axes.fill_between(along, -band, band, color=_BAND, lw=0, label="±2 stated sigma")
        axes.axhline(0.0, color="0.4", lw=0.7)
        single = _MICROMETRES * before[:, k]
        axes.plot(along, single, "+", ms=4, mew=0.8, color="0.55", label="one section")
        axes.plot(along, error, "o-", ms=2.4, lw=0.8, color=_FIRST, label="edge points")
        inside = np.mean(np.abs(error) <= band)
        share = f"{name}: {100.0 * inside:.0f} % within ±2 sigma"
        axes.set_title(share, loc="left", fontsize="small")
        axes.set_xlim(along[0], along[-1])
    row[0].set_ylabel("error, µm")
    farthest = max(np.abs(errors).max(), np.abs(before).max(), 2.0 * sigma.max())
    row[0].set_ylim(*(1.06 * _MICROMETRES * farthest * np.array([-1.0, 1.0])))


def _draw_refusal(row: Any, name: str, refusal: str) -> None:
    for axes in row:
        axes.set_axis_off()
    row[0].set_title(f"{name}: no edge was found ({refusal})", loc="left", fontsize="small")


def shares_beyond(distances: ArrayLike) -> tuple[Array, Array]:
    """Steps of the share of distances that are at least as large, from 1 down to 1/n.

    Returns
    -------
    The distances in ascending order (n,), and the share of them from each one on (n,).
    """
    ascending = np.sort(np.asarray(distances, dtype=np.float64))
    return ascending, 1.0 - np.arange(len(ascending)) / max(len(ascending), 1)


def draw_calibration(samples: Mapping[str, tuple[Array, Array]], path: str | Path) -> None:
    """Draw how many edge points are farther off than each number of stated standard deviations.

    Parameters
    ----------
    samples : Mahalanobis distances (m,) of edge points and (k,) of sections before smoothing, by
        what they are of
    path : picture file

    Raises
    ------
    ValueError: matplotlib is missing.
    """
    figure = new_figure(path, _WIDTH, 6.2)
    panels = figure.subplots(2, len(samples), squeeze=False, sharey="row")
    for (below, beyond), (name, sample) in zip(panels.T, samples.items(), strict=True):
        farthest = 1.05 * max(4.0, *(values.max(initial=0.0) for values in sample))
        below.set_title(f"{name}\n{len(sample[0])} edge points", fontsize="medium")
        below.set_xlim(0.0, 4.0)
        beyond.set(xlim=(0.0, farthest), xlabel="distance, stated sigma")
        _draw_true(below, beyond, farthest)
        _draw_shares(below, beyond, sample[0], "edge points", color=_FIRST, ls="-")
        _draw_shares(below, beyond, sample[1], "one section", color=_SECOND, ls="--")
    panels[0, 0].set(ylabel="share of points nearer, %", ylim=(0.0, 102.0))
    panels[0, 0].set_yticks([0.0, 25.0, 50.0, 75.0, 95.0])
    panels[0, 0].legend(loc="lower right", fontsize="small", handlelength=1.6)
    most = max(1, *(len(values) for sample in samples.values() for values in sample))
    panels[1, 0].set(ylabel="share of points farther, %", yscale="log")
    _set_log_ticks(panels[1, 0], (0.001, 0.01, 0.1, 1.0, 5.0, 50.0), 60.0 / most, 130.0)
    save_figure(figure, path)


def _draw_shares(below: Any, beyond: Any, distances: Array, what: str, **style: Any) -> None:
    at, share = shares_beyond(distances)
    below.step(at, 100.0 * (1.0 - share), where="post", lw=1.5, label=what, **style)
    beyond.step(at, 100.0 * share, where="pre", lw=1.5, **style)
    beyond.plot(at[-1:], 100.0 * share[-1:], "|", ms=9, color=style["color"])  # the farthest one


def _draw_true(below: Any, beyond: Any, farthest: float) -> None:
    """What the shares are where covariances are true, and where half and 95 % of them are."""
    at = np.linspace(0.0, farthest, 500)
    words = {"color": "black", "lw": 1.0, "ls": ":", "label": "as stated (Rayleigh)"}
    below.plot(at, 100.0 * true_share(at), **words)
    beyond.plot(at, 100.0 * (1.0 - true_share(at)), **words)
    for axes in (below, beyond):
        axes.grid(color="0.92")
        axes.set_axisbelow(True)
        for distance in (TRUE_MEDIAN, TRUE_95):
            axes.axvline(distance, color="0.75", lw=0.8)


def draw_experiments(
    result: DoeResult, group: Group, wanted: Mapping[str, float], path: str | Path
) -> None:
    """Draw the errors over the published ones by experiment, with every test of it.

    Parameters
    ----------
    result : the runs
    group : pattern and degree that is drawn
    wanted : the largest ratio that is wanted of "average" and of "maximum"
    path : picture file

    Raises
    ------
    ValueError: matplotlib is missing.
    """
    figure = new_figure(path, _WIDTH, 4.6)
    axes = figure.subplots()
    _draw_level(axes, 1.0, "published", color="black", ls="-")
    for name, limit in wanted.items():
        style = _OF_RATIOS[name]
        _draw_ratios(axes, result, group, name, style)
        _draw_level(axes, limit, f"{name}\n wanted: {limit:.2f}", color=style.colour, ls="--")
    axes.set_xticks([*EXPERIMENTS, _ALL], [*map(str, EXPERIMENTS), "all"])
    axes.set(xlim=(0.4, _ALL + 0.7), xlabel="experiment, each with its 16 tests")
    axes.set_ylabel("our error / published error")
    lowest, highest = axes.dataLim.intervaly
    axes.set_yscale("log")
    _set_log_ticks(axes, _TICKS, 0.85 * lowest, 1.25 * max(highest, 1.0))
    axes.grid(axis="y", color="0.92")
    axes.set_axisbelow(True)
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2, frameon=False)
    save_figure(figure, path)


def _draw_ratios(axes: Any, result: DoeResult, group: Group, name: str, style: _RatioStyle) -> None:
    """Each test small, the mean of each experiment large, and that of all."""
    pairs = both_completed(counterparts(result, group))
    error = f"{style.statistic}_error"
    axes.plot(
        [ours.experiment + style.shift for ours, _ in pairs],
        [getattr(ours, error) / getattr(theirs, error) for ours, theirs in pairs],
        style.marker,
        ms=3.6,
        mew=0,
        color=style.colour,
        alpha=0.4,
    )
    means = [compare_experiment(result, group, experiment) for experiment in EXPERIMENTS]
    axes.plot(
        np.array([*EXPERIMENTS, _ALL]) + style.shift,
        [getattr(mean, style.ratio) for mean in [*means, compare_group(result, group)]],
        style.marker,
        ms=8,
        mec="white",
        color=style.colour,
        label=f"{name} error: geometric mean, and each test",
    )


def _draw_level(axes: Any, level: float, name: str, **style: Any) -> None:
    axes.axhline(level, lw=1.1, **style)
    axes.annotate(
        f" {name}",
        (1.0, level),
        xycoords=axes.get_yaxis_transform(),
        color=style["color"],
        va="center",
        fontsize="small",
    )


def _set_log_ticks(axes: Any, ticks: Sequence[float], lowest: float, highest: float) -> None:
    shown = [tick for tick in ticks if lowest <= tick <= highest]
    axes.set_ylim(lowest, highest)
    axes.set_yticks(shown, [f"{tick:g}" for tick in shown])
    axes.minorticks_off()
