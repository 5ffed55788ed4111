# SPDX-License-Identifier: LGPL-2.1-or-later
"""The comparisons that justify the defaults of a probed scan (Schreve 4.4.1, 4.5.5), and 5.2."""

from __future__ import annotations

from ..scanning import Progress
from .compensation_figures import compare_compensation
from .doe_curves import Curves
from .model_scans import compare_with_model
from .tangent_figures import compare_tangents

__all__ = ["compare_choices"]

_CHOICES = {
    "compensation": compare_compensation,
    "tangent": compare_tangents,
    "model": compare_with_model,
}


def compare_choices(
    choice: str, seed: int = 0, jobs: int = 2, progress: Progress | None = None
) -> tuple[Curves, ...]:
    """Compare the ways of a probed scan; what there is so far when `progress` cancels.

    Parameters
    ----------
    choice : compensation, tangent, or model: the analytical error of a scan without noise
    seed : of the noise
    jobs : number of processes

    Raises
    ------
    ValueError: a choice there is not.
    """
    if choice not in _CHOICES:
        known = ", ".join(_CHOICES)
        raise ValueError(f"There is no comparison of {choice!r}; choose from {known}.")
    return _CHOICES[choice](seed, jobs, progress)
