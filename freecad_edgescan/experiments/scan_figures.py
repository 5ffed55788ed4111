# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scans of noisy clouds beside the analytical error: figures 5.6 to 5.9.

Printed with the figures: ρ_L = ρ_e = 2, R_p = 0.5, R_f = 0, ρ_c = 1 mm, κ_e = 0.004 / mm,
θ = 90°, r = 50 mm, and a tolerance for each noise.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..scanning import Progress
from .doe_curves import Curve, Curves
from .doe_design import Trial
from .doe_scan import RowTask, scan_rows
from .model_figures import Shape, model_errors

__all__ = ["noise_figure", "pattern_figure", "printed_trial"]

TOLERANCES = {0.005: 0.2, 0.05: 0.25, 0.1: 0.3}  # mm, by noise level
# From the fewest points that inequality 4.7.1.1 allows.
_SHARES = {
    1: (0.08, 0.1, 0.12, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 0.6),
    2: (0.12, 0.16, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0),
}
_KINDS = {1: "linear", 2: "quadratic"}


def noise_figure(
    degree: int, number: str, seed: int, jobs: int, literal: bool, progress: Progress | None
) -> tuple[Curves, ...]:
    """Square scans with three noises beside the analytical error."""
    title = f"Figure {number}: average error of square {_KINDS[degree]} scans"
    return _figure(title, degree, ("square",), seed, jobs, literal, progress)


def pattern_figure(
    degree: int, number: str, seed: int, jobs: int, literal: bool, progress: Progress | None
) -> tuple[Curves, ...]:
    """Zigzag beside square scans with three noises."""
    title = f"Figure {number}: average error of zigzag and square {_KINDS[degree]} scans"
    return _figure(title, degree, ("zigzag", "square"), seed, jobs, literal, progress)


def printed_trial(share: float, noise: float, section_radius: float = 50.5, test: int = 0) -> Trial:
    """The object printed with the figures, scanned with line sections of s = share·r."""
    trial = Trial(
        experiment=0,
        test=test,
        section_radius=section_radius,
        amplitude=np.nan,
        noise=noise,
        line_pitch=2.0,
        edge_pitch=2.0,
        edge_radius=250.0,
        angle=np.pi / 2,
        tolerance=TOLERANCES[noise],
        fillet_radius=0.0,
        probe_radius=0.5,
        cloud_pitch=1.0,
    )
    side = share * (section_radius - trial.probe_radius)
    return replace(trial, amplitude=2 * side + trial.object.rounding_length)


def _figure(
    title: str,
    degree: int,
    patterns: Sequence[str],
    seed: int,
    jobs: int,
    literal: bool,
    progress: Progress | None,
) -> tuple[Curves, ...]:
    shares, groups = _SHARES[degree], tuple((pattern, degree) for pattern in patterns)
    places = [(noise, share) for noise in TOLERANCES for share in shares]
    tasks = [
        RowTask(printed_trial(share, noise, test=test), groups, seed=seed, literal=literal)
        for test, (noise, share) in enumerate(places)
    ]
    rows = scan_rows(tasks, jobs, progress)
    errors = {
        (*places[number], run.pattern): run.avg_error
        for number, row in rows.items()
        for run in row
        if run.completed
    }
    if not errors:
        return ()
    curves = [_model(degree)]
    for pattern, noise in itertools.product(patterns, TOLERANCES):
        name = f"{pattern}, η = {noise:g} mm"
        found = [errors.get((noise, share, pattern), np.nan) for share in shares]
        curves.append(Curve.of(name, shares, found, measured=True))
    missing = len(places) * len(patterns) - len(errors)
    unmade = len(places) - len(rows)
    words = f", {unmade * len(patterns)} of them not made" if unmade else ""
    notes = (f"{missing} scans did not complete and are missing{words}.",) if missing else ()
    label = "length of a line section over its radius, s/r"
    return (Curves(title, label, "average error, mm", tuple(curves), notes, logarithmic=True),)


def _model(degree: int) -> Curve:
    trial, shares = printed_trial(0.1, min(TOLERANCES)), np.array(_SHARES[degree])
    shape = Shape(trial.section_radius, trial.angle, trial.fillet_radius, trial.probe_radius)
    arcs = shares * (trial.section_radius - trial.probe_radius)
    return Curve.of("analytical", shares, model_errors(degree, arcs, shape))
