# SPDX-License-Identifier: LGPL-2.1-or-later
"""The comparisons that justify the defaults of a probed scan: figures 9, 11, 18, 19 of chapter 4.

Compensation is compared as published: over the 16 objects of experiment 1, square and quadratic.
The edge of the published comparison of tangents is not stated; it has about 50 edge points.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..scanning import Progress, ScanError
from ..scanning.parameters import Compensation, Tangent
from .doe import run_doe
from .doe_curves import Curve, Curves
from .doe_design import TESTS, trial
from .doe_published import published_result
from .doe_result import DoeResult, Group
from .doe_scan import scan_trial, trial_cloud

__all__ = ["compare_choices"]

_EXPERIMENT = 1
_GROUP: Group = ("square", 2)
_EDGE = trial(3, 13)  #


def compare_choices(
    choice: str, seed: int = 0, jobs: int = 2, progress: Progress | None = None
) -> tuple[Curves, ...]:
    """Compare the ways of a probed scan; those that were tried when `progress` cancels.

    Parameters
    ----------
    choice : compensation, or tangent
    seed : of the noise
    jobs : number of processes

    Raises
    ------
    ValueError: a choice there is not.
    """
    if choice == "compensation":
        return compare_compensation(seed, jobs, progress)
    if choice == "tangent":
        return compare_tangents(seed, progress)
    raise ValueError(f"There is no comparison of {choice!r}; choose compensation or tangent.")


def compare_compensation(
    seed: int = 0, jobs: int = 2, progress: Progress | None = None
) -> tuple[Curves, ...]:
    """Average and maximum error of each compensation over experiment 1."""
    found: dict[str, DoeResult] = {}
    for number, way in enumerate(Compensation):
        part = _Part(progress, number, len(Compensation))
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


def compare_tangents(seed: int = 0, progress: Progress | None = None) -> tuple[Curves, ...]:
    """Angle between the tangent as found and the true one, along an edge."""
    cloud = trial_cloud(_EDGE, seed)
    curves, notes = [], []
    for number, way in enumerate(Tangent):
        try:
            edge = scan_trial(_EDGE, cloud, _GROUP, overrides={"tangent": way.value})
        except ScanError as error:
            notes.append(f"{way.value}: {error}")
            continue
        angles = tangent_errors(edge.points, edge.tangents)
        curves.append(Curve.of(way.value, np.arange(len(angles)), angles, measured=True))
        notes.append(
            f"{way.value}: {len(edge)} edge points, median {np.median(angles):.2f}°, "
            f"largest {np.max(angles):.2f}°; ends {edge.stops[1].name}."
        )
        if progress and not progress.update((number + 1) / len(Tangent), way.value):
            break
    if not curves:
        return ()
    title = "Figures 4.9 and 4.11: tangent as found against the true one"
    return (Curves(title, "edge point", "angle, degrees", tuple(curves), tuple(notes)),)


def tangent_errors(points: NDArray, tangents: NDArray) -> NDArray[np.float64]:
    """Angle of tangents (m, 3) to the circle round the z axis at points (m, 3), degrees."""
    x, y, _ = points.T
    true = np.column_stack([-y, x, np.zeros(len(points))]) / np.hypot(x, y)[:, None]
    return np.degrees(np.arccos(np.clip(np.einsum("mi,mi->m", true, tangents), -1.0, 1.0)))


def _errors(title: str, statistic: str, found: dict[str, DoeResult]) -> Curves:
    curves = [
        Curve.of(name, TESTS, result.column(statistic), measured=True)
        for name, result in found.items()
    ]
    published = published_result().of_group(_GROUP)
    printed = [getattr(published[_EXPERIMENT, test], statistic) for test in TESTS]
    curves.append(Curve.of("published", TESTS, printed, measured=True))
    notes = [
        f"{curve.name}: geometric mean {np.exp(np.mean(np.log(curve.y))):.4f} mm"
        + (f", {found[curve.name].completed} of 16 completed" if curve.name in found else "")
        for curve in curves
    ]
    full = f"{title} error by compensation, experiment 1, square, quadratic"
    return Curves(full, "test", "error, mm", tuple(curves), tuple(notes))


class _Part:
    """Progress of one of several equal parts."""

    def __init__(self, whole: Progress | None, number: int, of: int) -> None:
        self.whole, self.number, self.of = whole, number, of

    def update(self, fraction: float, so_far: object) -> bool:
        """Tell the whole how far it is."""
        if self.whole is None:
            return True
        return self.whole.update((self.number + fraction) / self.of, f"part {self.number + 1}")
