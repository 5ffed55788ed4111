# SPDX-License-Identifier: LGPL-2.1-or-later
"""What scans of the published experiments gave: one run for each scan."""

from __future__ import annotations

import csv
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

__all__ = ["DoeResult", "DoeRun", "Group", "group_name"]

Group = tuple[str, int]  # pattern and degree
PATCH: Group = ("patch", 0)
_LENGTHS = ("avg_error", "max_error", "rms_error", "bound", "unsmoothed_rms")
_DISTANCES = ("mahalanobis", "unsmoothed_mahalanobis")
_SHARES = (50, 95)  # per cent of the edge points


@dataclass(frozen=True)
class DoeRun:
    """One scan of one object.

    Attributes
    ----------
    experiment, test : 1 … 12, 1 … 16
    pattern : zigzag or square of a probed scan; patch
    degree : of the curves of a probed scan; 0 for patch
    avg_error, max_error : distance of the edge points to the true edge, mm; nan without any
    points : number of edge points; 0 where none are stated
    completed : whether the scan reached the gate along the edge
    stop : name of the reason why it ended, ERROR when there is no edge at all
    message : what the scan says about it
    rms_error : root mean square of the distances, mm
    bound : the smallest one that is possible for unbiased edge points (see `edge_bound`), mm
    mahalanobis : of each edge point's error, by the covariance that the scan states for it
    unsmoothed_rms, unsmoothed_mahalanobis : the same of the sections by themselves, before they
        were smoothed along the edge
    """

    experiment: int
    test: int
    pattern: str
    degree: int
    avg_error: float
    max_error: float
    points: int
    completed: bool
    stop: str = ""
    message: str = ""
    rms_error: float = np.nan
    bound: float = np.nan
    mahalanobis: tuple[float, ...] = ()
    unsmoothed_rms: float = np.nan
    unsmoothed_mahalanobis: tuple[float, ...] = ()

    @property
    def group(self) -> Group:
        """Pattern and degree."""
        return self.pattern, self.degree

    @property
    def name(self) -> str:
        """The run as the published text names it, such as 5Z2.11; 5P.11 of the patch method."""
        group = "P" if self.group == PATCH else group_name(self.group)
        return f"{self.experiment}{group}.{self.test}"


@dataclass(frozen=True)
class DoeResult:
    """Runs of one seed, ordered by experiment, test, pattern (as it was asked for) and degree.

    Attributes
    ----------
    runs : one for each scan
    seed : of the clouds' noise
    cancelled : whether runs are missing because somebody cancelled
    """

    runs: tuple[DoeRun, ...]
    seed: int = 0
    cancelled: bool = False

    def __len__(self) -> int:
        return len(self.runs)

    def __iter__(self) -> Iterator[DoeRun]:
        return iter(self.runs)

    def __repr__(self) -> str:
        return f"DoeResult({len(self)} runs, {self.completed} completed, seed {self.seed})"

    @property
    def completed(self) -> int:
        """Number of completed runs."""
        return sum(run.completed for run in self.runs)

    @property
    def groups(self) -> tuple[Group, ...]:
        """Patterns and degrees that occur, in the order of the published tables."""
        order = {"zigzag": 0, "square": 1}
        found = {run.group for run in self.runs}
        return tuple(sorted(found, key=lambda group: (order.get(group[0], 2), group[1])))

    def column(self, name: str) -> NDArray:
        """One attribute of all runs as an array, such as ``result.column("avg_error")``."""
        return np.array([getattr(run, name) for run in self.runs])

    def of_group(self, group: Group) -> dict[tuple[int, int], DoeRun]:
        """The runs of one pattern and degree, by experiment and test."""
        return {(run.experiment, run.test): run for run in self.runs if run.group == group}

    def to_csv(self, path: str | Path) -> None:
        """Write one row for each run; errors in mm."""
        write_csv([self], path)


def write_csv(results: Sequence[DoeResult], path: str | Path) -> None:
    """Write the runs of one or more seeds into one table."""
    names = [field.name for field in fields(DoeRun) if field.name not in _DISTANCES]
    titles = [f"{name}_mm" if name in _LENGTHS else name for name in names]
    with Path(path).open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        honesty = [f"{name}_{share}" for name in _DISTANCES for share in _SHARES]
        writer.writerow(["seed", *titles, *honesty])
        for result in results:
            for run in result:
                values = (getattr(run, name) for name in names)
                shares = [
                    share
                    for name in _DISTANCES
                    for share in np.percentile(getattr(run, name) or [np.nan], _SHARES)
                ]
                writer.writerow([result.seed, *map(_text, values), *map(_text, shares)])


def group_name(group: Group) -> str:
    """The name of pattern and degree in published tables: Z1, Z2, S1, S2."""
    pattern, degree = group
    return pattern if group == PATCH else f"{pattern[0].upper()}{degree}"


def _text(value: object) -> object:
    if isinstance(value, bool):
        return int(value)
    return f"{value:.6f}" if isinstance(value, float) else value
