# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ways to take the probe radius off, compared: figures 4.18 and 4.19.

As published: the average and the maximum error over the 16 objects of experiment 1, scanned
square and quadratic.
"""

from __future__ import annotations

import numpy as np

from ..scanning import Progress
from ..scanning.parameters import Compensation
from .doe import run_doe
from .doe_curves import Curve, Curves
from .doe_design import TESTS
from .doe_published import published_result
from .doe_result import DoeResult, Group
from .partial_progress import PartialProgress

__all__ = ["compare_compensation"]

_EXPERIMENT = 1
_GROUP: Group = ("square", 2)


def compare_compensation(
    seed: int = 0, jobs: int = 2, progress: Progress | None = None
) -> tuple[Curves, ...]:
    """Average and maximum error of each compensation over experiment 1."""
    found: dict[str, DoeResult] = {}
    for number, way in enumerate(Compensation):
        part = PartialProgress(progress, number, len(Compensation))
        result = run_doe(
            [_EXPERIMENT],
            [_GROUP[0]],
            [_GROUP[1]],
            seed=seed,
            jobs=jobs,
            overrides={"compensation": way.value},
            progress=part,
        )
        if result.cancelled:
            break
        found[way.value.replace("_", ", ")] = result
    if not found:
        return ()
    return (
        _errors("Figure 4.18: average", "avg_error", found),
        _errors("Figure 4.19: maximum", "max_error", found),
    )


def _errors(title: str, statistic: str, found: dict[str, DoeResult]) -> Curves:
    curves = [
        Curve.of(name, TESTS, result.column(statistic), measured=True)
        for name, result in found.items()
    ]
    published = published_result().of_group(_GROUP)
    printed = [getattr(published[_EXPERIMENT, test], statistic) for test in TESTS]
    curves.append(Curve.of("published", TESTS, printed, measured=True))
    notes = [
        f"{curve.name}: geometric mean {np.exp(np.nanmean(np.log(curve.y))):.4f} mm"
        + (f", {found[curve.name].completed} of 16 completed" if curve.name in found else "")
        for curve in curves
    ]
    full = f"{title} error by compensation, experiment 1, square, quadratic"
    return Curves(full, "test", "error, mm", tuple(curves), tuple(notes))
