# SPDX-License-Identifier: LGPL-2.1-or-later
"""The published results of the experiments, and the sensitivities printed with them.

Schreve appendix E: 768 runs, of which 705 completed (the text counts 62 failures; test 2S1.14 is
marked as one in the table only).
"""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .doe_design import coded_levels, published_table
from .doe_result import PATCH, DoeResult, DoeRun, Group

__all__ = ["main_effects", "printed_effects", "published_counterparts", "published_result"]

_SCALE = float(np.sqrt(1.6))  # to the numbers appendix E prints, whatever their unit


@cache
def published_result() -> DoeResult:
    """All published runs; `points` is 0 where a failed run has none."""
    return DoeResult(
        tuple(
            DoeRun(
                experiment=int(row["experiment"]),
                test=int(row["test"]),
                pattern=row["pattern"],
                degree=int(row["degree"]),
                avg_error=float(row["avg_error_mm"]),
                max_error=float(row["max_error_mm"]),
                points=int(row["points"] or 0),
                completed=row["completed"] == "1",
            )
            for row in published_table("doe_results.csv")
        )
    )


@cache
def published_counterparts(group: Group) -> dict[tuple[int, int], DoeRun]:
    """The published run that each of ours is compared with, by experiment and test.

    It is the run of the same pattern and degree; for the patch method the completed quadratic run,
    zigzag or square, with the smaller average error (where neither completed the square one).
    """
    if group != PATCH:
        return published_result().of_group(group)
    zigzag, square = (published_result().of_group((name, 2)) for name in ("zigzag", "square"))
    return {
        key: min((square[key], zigzag[key]), key=lambda run: (not run.completed, run.avg_error))
        for key in square
    }


def main_effects(errors: ArrayLike) -> NDArray[np.float64]:
    """How much each parameter changes the errors of an experiment ("sensitivity").

    √1.6·|Σ xᵢyᵢ| over all 16 tests with their coded levels x: what appendix E prints, to rounding.

    Parameters
    ----------
    errors : (16,) mm, of tests 1 … 16, failed ones included

    Returns
    -------
    (11,) in the order of ``PARAMETERS``; nan when an error is.
    """
    return np.asarray(_SCALE * np.abs(coded_levels().T @ np.asarray(errors, dtype=np.float64)))


def printed_effects() -> dict[tuple[int, str, str, int, str], float]:
    """The printed sensitivities by experiment, parameter, pattern, degree and statistic.

    The statistic is "avg" or "max". Six cells are not legible and absent. The cells of cloud pitch,
    zigzag, linear are a slip: they repeat the first test's error.
    """
    return {
        (
            int(row["experiment"]),
            row["parameter"],
            row["pattern"],
            int(row["degree"]),
            row["statistic"],
        ): float(row["value"])
        for row in published_table("doe_sensitivity.csv")
        if row["value"]
    }
