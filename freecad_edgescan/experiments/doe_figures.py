# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of the publication by their numbers (Schreve chapter 5, appendix D)."""

from __future__ import annotations

from ..scanning import Progress
from .cost_figures import amplitude_cost, cloud_cost
from .doe_curves import Curves
from .model_figures import angle_figure, deviation_figure, fillet_figure, probe_figure
from .scan_figures import noise_figure, pattern_figure

__all__ = ["make_figure"]

_OF_THE_MODEL = {
    "5.2": (deviation_figure, 2),
    "D.9": (deviation_figure, 1),
    "5.3": (angle_figure, 2),
    "D.10": (angle_figure, 1),
    "5.4": (probe_figure, 2),
    "D.11": (probe_figure, 1),
    "5.5": (fillet_figure, 2),
    "D.12": (fillet_figure, 1),
}
_OF_SCANS = {
    "5.6": (noise_figure, 2),
    "5.7": (noise_figure, 1),
    "5.8": (pattern_figure, 2),
    "5.9": (pattern_figure, 1),
}
_OF_COST = {"5.37": amplitude_cost, "5.38": cloud_cost}


def make_figure(
    number: str,
    seed: int = 0,
    jobs: int = 2,
    method: str = "probe",
    literal: bool = False,
    progress: Progress | None = None,
) -> tuple[Curves, ...]:
    """Compute a figure; what was computed so far when `progress` cancels.

    Parameters
    ----------
    number : such as 5.6 or D.9
    seed : of the noise of scanned clouds
    jobs : number of processes that scan; times are measured in this one alone
    method : probe or patch, for the figures of cost
    literal : whether figures 5.6 to 5.9 scan as printed

    Raises
    ------
    ValueError: a figure there is not.
    """
    if number in _OF_THE_MODEL:
        model, degree = _OF_THE_MODEL[number]
        return (model(degree, number),)
    if number in _OF_SCANS:
        scans, degree = _OF_SCANS[number]
        return scans(degree, number, seed, jobs, literal, progress)
    if number in _OF_COST:
        return _OF_COST[number](method, number, progress)
    known = ", ".join([*_OF_THE_MODEL, *_OF_SCANS, *_OF_COST])
    raise ValueError(f"There is no figure {number!r} here; choose from {known}.")
