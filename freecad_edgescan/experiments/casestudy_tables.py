# SPDX-License-Identifier: LGPL-2.1-or-later
"""The case study's tables: its errors and times beside the published ones."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..surfacing import SweepModel
from .casestudy import CaseStudy
from .casestudy_published import PUBLISHED_ERRORS, PUBLISHED_MINUTES

__all__ = ["casestudy_tables"]


def casestudy_tables(study: CaseStudy, seconds: Mapping[str, float] | None = None) -> str:
    """Table 1 and the times of appendix F as text, ours beside the published.

    Parameters
    ----------
    study : CaseStudy
    seconds : of each step; None: those of the study alone
    """
    return "\n".join([*_errors(study), "", *_times(seconds or study.seconds)])


def _errors(study: CaseStudy) -> list[str]:
    lines = [
        "Deviation of the points from the fitted sweep, and of the sweep from the true wall, mm",
        "pipe  grid     cloud      model      points   average  maximum   true average  maximum",
    ]
    for pipe in study.pipes:
        lines.append(
            f"{pipe.number:<4}  its points as they are    {len(pipe.points):15d}"
            f"{np.mean(pipe.noise):34.3f} {np.max(pipe.noise):8.3f}"
        )
        for grid in sorted({own.grid for own in pipe.fits}):
            label = f"{pipe.number:<4}  {grid[0]:2d} × {grid[1]:<2d} "
            for thinned in (True, False):
                for model in SweepModel:
                    found = pipe.fit(model, grid, thinned)
                    if found is None:
                        continue
                    count = int((~found.fit.outside).sum())
                    lines.append(
                        f"{label}  {'5 mm grid' if thinned else 'whole':<9}  {model:<7} "
                        f"{count:9d}  {found.fit.average:8.3f} {found.fit.maximum:8.3f}   "
                        f"{np.mean(found.error):12.3f} {np.max(found.error):8.3f}"
                    )
            if (pipe.number, grid) in PUBLISHED_ERRORS:
                average, maximum = PUBLISHED_ERRORS[pipe.number, grid]
                lines.append(f"{label}  5 mm grid  published         {average:8.3f} {maximum:8.3f}")
    return lines


def _times(seconds: Mapping[str, float]) -> list[str]:
    lines = ["step                         seconds   published, min"]
    for name in dict.fromkeys([*PUBLISHED_MINUTES, *seconds]):
        if name in seconds:
            minutes = PUBLISHED_MINUTES.get(name)
            published = "" if minutes is None else f"{minutes:14.0f}"
            lines.append(f"{name:<26} {seconds[name]:9.2f}   {published}".rstrip())
    minutes = sum(PUBLISHED_MINUTES.values())
    return [*lines, f"{'all':<26} {sum(seconds.values()):9.2f}   {minutes:14.0f}"]
