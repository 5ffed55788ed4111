# SPDX-License-Identifier: LGPL-2.1-or-later
"""The published experiments, scanned again (Schreve 5.3, appendix E).

Every object of the design is sampled as a cloud and scanned from azimuth 0.1 to π - 0.1 with the
design's parameters; the error of an edge point is its distance to the true edge. The adjustment
of the edge pitch by chord height is off. Equal seeds give equal results, whatever the jobs.
"""

from __future__ import annotations

import itertools
from collections.abc import Collection, Mapping, Sequence
from dataclasses import fields, replace
from typing import Any

from ..scanning import Progress, ScanParameters
from .doe_design import EXPERIMENTS, TESTS, trial
from .doe_result import PATCH, DoeResult, DoeRun
from .doe_scan import RowTask, scan_rows

__all__ = ["run_doe"]

_PATTERNS = ("zigzag", "square")
_DEGREES = (1, 2, 3)
_METHODS = ("probe", "patch")


def run_doe(
    experiments: Collection[int] = EXPERIMENTS,
    patterns: Sequence[str] = _PATTERNS,
    degrees: Sequence[int] = (1, 2),
    method: str = "probe",
    seed: int = 0,
    jobs: int = 2,
    literal: bool = False,
    tests: Collection[int] = TESTS,
    overrides: Mapping[str, Any] | None = None,
    progress: Progress | None = None,
) -> DoeResult:
    """Scan the objects of the published experiments.

    Parameters
    ----------
    experiments : which of 1 … 12
    patterns, degrees : ways of a probed scan; the patch method has none and takes no notice
    method : "probe", or "patch" for one run on each object (pattern "patch", degree 0)
    seed : of the clouds' noise, together with experiment and test
    jobs : number of processes; 1 works in this one
    literal : whether the probed scan is the algorithm as printed
    tests : which of 1 … 16 in each experiment
    overrides : values of ``ScanParameters`` that replace those of the design
    progress : told the result so far after each object; may cancel, and that result is returned

    Returns
    -------
    DoeResult. A scan that raises, or whose process dies, is a failed run with its text.

    Raises
    ------
    ValueError: an experiment, test, pattern, degree, method or parameter there is not.
    """
    _check("experiment", experiments, EXPERIMENTS)
    _check("test", tests, TESTS)
    _check("pattern", patterns, _PATTERNS)
    _check("degree", degrees, _DEGREES)
    _check("method", [method], _METHODS)
    _check("overridden parameter", overrides or (), [each.name for each in fields(ScanParameters)])
    if seed < 0:
        raise ValueError(f"The seed is {seed}; give 0 or more.")
    if jobs < 1:
        raise ValueError(f"There are {jobs} jobs; give 1 or more.")
    if literal and method == PATCH[0]:
        raise ValueError("The algorithm as printed is a probed scan; leave literal or patch out.")
    groups = (PATCH,) if method == PATCH[0] else tuple(itertools.product(patterns, degrees))
    tasks = [
        RowTask(trial(experiment, test), groups, method, seed, literal, dict(overrides or {}))
        for experiment in sorted(set(experiments))
        for test in sorted(set(tests))
    ]
    rows = scan_rows(tasks, jobs, progress, describe=lambda rows: _result(rows, seed))
    return replace(_result(rows, seed), cancelled=len(rows) < len(tasks))


def _result(rows: Mapping[int, tuple[DoeRun, ...]], seed: int) -> DoeResult:
    return DoeResult(tuple(run for number in sorted(rows) for run in rows[number]), seed)


def _check(name: str, given: Collection[Any], known: Collection[Any]) -> None:
    if not given and name != "overridden parameter":
        raise ValueError(f"No {name} is given; choose from {_listed(known)}.")
    for value in given:
        if value not in known:
            raise ValueError(f"The {name} is {value!r}; choose from {_listed(known)}.")


def _listed(known: Collection[Any]) -> str:
    return f"{known[0]} to {known[-1]}" if isinstance(known, range) else ", ".join(map(str, known))
