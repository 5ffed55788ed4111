# SPDX-License-Identifier: LGPL-2.1-or-later
"""The case study's tables: its errors and times beside the published ones."""

from __future__ import annotations

import numpy as np

from ..surfacing import SweepModel
from .casestudy import CaseStudy
from .casestudy_published import PUBLISHED_ERRORS, PUBLISHED_MINUTES

__all__ = ["casestudy_tables"]


def casestudy_tables(study: CaseStudy) -> str:
    """Table 1 and the times of appendix F as text, ours beside the published."""
    return "\n".join([*_errors(study), "", *_times(study)])


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


def _times(study: CaseStudy) -> list[str]:
    lines = ["step                         seconds   published, min"]
    total = 0.0
    for name in dict.fromkeys([*PUBLISHED_MINUTES, *study.seconds]):
        if name not in study.seconds:
            continue
        seconds, minutes = study.seconds[name], PUBLISHED_MINUTES.get(name)
        total += seconds
        published = "" if minutes is None else f"{minutes:14.0f}"
        lines.append(f"{name:<26} {seconds:9.2f}   {published}".rstrip())
    lines.append(f"{'all':<26} {total:9.2f}   {sum(PUBLISHED_MINUTES.values()):14.0f}")
    return lines
