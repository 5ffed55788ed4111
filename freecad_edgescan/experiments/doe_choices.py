# SPDX-License-Identifier: LGPL-2.1-or-later
"""The comparisons that justify the defaults of a probed scan (Schreve 4.4.1, 4.5.5)."""

from __future__ import annotations

from ..scanning import Progress
from .compensation_figures import compare_compensation
from .doe_curves import Curves
from .tangent_figures import compare_tangents

__all__ = ["compare_choices"]

_CHOICES = {"compensation": compare_compensation, "tangent": compare_tangents}


def compare_choices(
    choice: str, seed: int = 0, jobs: int = 2, progress: Progress | None = None
) -> tuple[Curves, ...]:
    """Compare the ways of a probed scan; what there is so far when `progress` cancels.

    Parameters
    ----------
    choice : compensation, or tangent
    seed : of the noise
    jobs : number of processes

    Raises
    ------
    ValueError: a choice there is not.
    """
    if choice not in _CHOICES:
        raise ValueError(f"There is no comparison of {choice!r}; choose compensation or tangent.")
    return _CHOICES[choice](seed, jobs, progress)
