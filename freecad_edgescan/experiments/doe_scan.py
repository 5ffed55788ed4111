# SPDX-License-Identifier: LGPL-2.1-or-later
"""One row of the experiments: make the object's cloud, scan it in every pattern and degree.

What counts as completed: the gate was passed, no edge point lies farther than half the amplitude
from the true edge, and at least 80 % of the expected edge points exist.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..cloud import SimulatedCloud
from ..scanning import Gate, Progress, ScannedEdge, ScanParameters, Start, Stop, scan_edge
from .collecting import collect
from .doe_design import Trial
from .doe_result import PATCH, DoeRun, Group
from .edge_bound import edge_bound
from .edge_report import root_mean_square
from .honesty import mahalanobis
from .processes import Failure

__all__ = ["RowTask", "edge_errors", "scan_row", "scan_rows", "scan_trial", "trial_cloud"]

Row = tuple[DoeRun, ...]

FEWEST_POINTS = 0.8  # of the expected number, in a completed run
FAILED = "ERROR"  # in place of a stop's name


@dataclass(frozen=True)
class RowTask:
    """What to scan on one object.

    Attributes
    ----------
    trial : the row of the design
    groups : patterns and degrees
    method : probe or patch
    seed : of the noise, together with experiment and test
    literal : whether the algorithm is taken as printed
    overrides : values of ``ScanParameters`` that replace the design's
    """

    trial: Trial
    groups: tuple[Group, ...]
    method: str = "probe"
    seed: int = 0
    literal: bool = False
    overrides: Mapping[str, Any] = field(default_factory=dict)


def scan_row(task: RowTask) -> Row:
    """All scans of one object, on one cloud; a scan that raises is a failed run with its text."""
    cloud = trial_cloud(task.trial, task.seed)
    return tuple(_run(task, group, cloud) for group in task.groups)


def _count(rows: Mapping[int, Row]) -> str:
    return f"{len(rows)} objects scanned"


def scan_rows(
    tasks: Sequence[RowTask],
    jobs: int,
    progress: Progress | None,
    describe: Callable[[Mapping[int, Row]], object] = _count,
) -> dict[int, Row]:
    """The runs of each task by its number; without those that are missing when cancelled.

    Parameters
    ----------
    tasks : objects to scan
    jobs : number of processes
    progress : told the share of objects done and what `describe` makes of their runs
    """

    def rows_of(done: Mapping[int, Row | Failure]) -> dict[int, Row]:
        return {
            number: failed_runs(tasks[number], row.text) if isinstance(row, Failure) else row
            for number, row in done.items()
        }

    return rows_of(collect(scan_row, tasks, jobs, progress, lambda done: describe(rows_of(done))))


def failed_runs(task: RowTask, text: str) -> Row:
    """The runs of an object that could not be scanned at all."""
    return tuple(_failed(task.trial, group, text) for group in task.groups)


def trial_cloud(trial: Trial, seed: int, amplitude: float | None = None) -> SimulatedCloud:
    """The cloud of an object, for scans of the design's amplitude or another one."""
    return trial.object.cloud(
        trial.cloud_pitch,
        amplitude or trial.amplitude,
        trial.noise,
        seed=[seed, trial.experiment, trial.test],
    )


def scan_trial(
    trial: Trial,
    cloud: SimulatedCloud,
    group: Group,
    method: str = "probe",
    literal: bool = False,
    overrides: Mapping[str, Any] | None = None,
    progress: Progress | None = None,
) -> ScannedEdge:
    """Scan an object's edge from azimuth 0.1 to π - 0.1 with the parameters of the design.

    Raises
    ------
    ScanError: there is nothing to scan, or the parameters cannot work.
    """
    values: dict[str, Any] = {"amplitude": trial.amplitude, "edge_pitch": trial.edge_pitch}
    if method != PATCH[0]:
        values["pattern"], values["degree"] = group
        values |= {
            "line_pitch": trial.line_pitch,
            "tolerance": trial.tolerance,
            "cloud_pitch": trial.cloud_pitch,
        }
    make = ScanParameters.literal if literal else ScanParameters
    return scan_edge(
        cloud,
        at=Start(*trial.object.start(trial.amplitude)),
        gate=Gate(*trial.object.gate(trial.amplitude)),
        parameters=make(**values | dict(overrides or {})),
        method=method,
        progress=progress,
    )


def edge_errors(trial: Trial, points: ArrayLike) -> NDArray[np.float64]:
    """Distance of edge points (m, 3) to the circle of the true edge, (m,) mm."""
    x, y, z = np.asarray(points, dtype=np.float64).T
    return np.hypot(np.hypot(x, y) - trial.edge_radius, z + trial.section_radius)


def off_the_edge(trial: Trial, points: ArrayLike) -> NDArray[np.float64]:
    """Vectors (m, 3) from the circle of the true edge to edge points (m, 3), mm."""
    points = np.asarray(points, dtype=np.float64)
    x, y, _ = points.T
    share = trial.edge_radius / np.hypot(x, y)
    return points - np.column_stack([share * x, share * y, np.full(len(x), -trial.section_radius)])


def _run(task: RowTask, group: Group, cloud: SimulatedCloud) -> DoeRun:
    trial = task.trial
    try:
        edge = scan_trial(trial, cloud, group, task.method, task.literal, task.overrides)
    except Exception as error:  # whatever it is, the other runs go on, and its text is kept
        return _failed(trial, group, str(error) or type(error).__name__)
    single, off = edge.unsmoothed, partial(off_the_edge, trial)
    errors = edge_errors(trial, edge.points) if len(edge) else np.array([np.nan])
    amplitude = edge.parameters.amplitude or trial.amplitude
    edge_pitch = edge.parameters.edge_pitch or trial.edge_pitch
    completed = (
        edge.stops[1] == Stop.GATE
        and errors.max() <= amplitude / 2
        and len(edge) >= FEWEST_POINTS * replace(trial, edge_pitch=edge_pitch).nominal_points
    )
    return DoeRun(
        *_place(trial, group),
        avg_error=float(errors.mean()),
        max_error=float(errors.max()),
        points=len(edge),
        completed=bool(completed),
        stop=edge.stops[1].name,
        message=edge.message,
        rms_error=root_mean_square(errors),
        bound=edge_bound(trial, cloud),
        mahalanobis=tuple(mahalanobis(edge, off).tolist()),
        unsmoothed_rms=root_mean_square(edge_errors(trial, single.points)),
        unsmoothed_mahalanobis=tuple(mahalanobis(single, off).tolist()),
    )


def _failed(trial: Trial, group: Group, text: str) -> DoeRun:
    return DoeRun(*_place(trial, group), np.nan, np.nan, 0, False, FAILED, text)


def _place(trial: Trial, group: Group) -> tuple[int, int, str, int]:
    return trial.experiment, trial.test, *group
