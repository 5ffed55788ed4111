# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scanning tolerance of a machine that nobody has told it, learned from the first line.

Far from the edge, where no rounding is, the contacts scatter about their curves by the machine's
noise and by what the curves are off the surfaces. A tolerance far above that would let the outer
part of a rounding pass; one below would give good points away.
"""

from __future__ import annotations

import numpy as np

from ..geometry.polynomial_curve import fit_polynomial
from .probe_settings import ProbeSettings
from .probed_line import ProbedLine

__all__ = ["TOLERANCE_REASON", "learned_tolerance"]

TOLERANCE_REASON = "four times what the first line scatters far from the edge"
_TIMES = 4.0
_OUTER = 0.6  # of a side's points
_SPARE = 2  # points beyond those a curve needs
_LEAST = 1e-4  # of the amplitude; without noise the scatter is that of rounding errors


def learned_tolerance(line: ProbedLine, settings: ProbeSettings) -> float:
    """Tolerance from the outer points of a line, mm.

    Parameters
    ----------
    line : a scanned line
    settings : it was scanned with; their tolerance is the largest one to answer
    """
    squares, freedom = 0.0, 0
    for section in line.sections:
        count = max(round(_OUTER * len(section.points)), settings.degree + 1 + _SPARE)
        points = section.points[:count]
        if len(points) < settings.degree + 1 + _SPARE:
            continue
        curve, u = fit_polynomial(points, settings.degree)
        off = curve.at(curve.closest(points, u)) - points
        squares += float(np.einsum("ni,ni->", off, off))
        freedom += len(points) - settings.degree - 1
    if not freedom:
        return settings.tolerance
    learned = max(_TIMES * float(np.sqrt(squares / freedom)), _LEAST * settings.amplitude)
    return min(learned, settings.tolerance)
