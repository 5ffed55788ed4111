# SPDX-License-Identifier: LGPL-2.1-or-later
"""What moves an edge by more than chance: two estimates, one of them of fewer points."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import uniform_filter1d

__all__ = ["beyond_chance"]

_BY_CHANCE = 2.0  # times that what noise moves may be met by chance, on their average


def beyond_chance(
    gap: np.ndarray, by_chance: np.ndarray, sections: int, closed: bool
) -> np.ndarray:
    """Variance (m, …) of what is more than chance, never negative.

    What is left of a rounding, or of another shape, is alike along the edge; chance is not. The
    variance of the difference of two such estimates is that of their variances (Hausman,
    Econometrica 46, 1978).

    Parameters
    ----------
    gap : (m, …) squared differences of the estimates, one for each of m sections
    by_chance : their variances
    sections : over which the average is taken
    closed : whether the last section leads back to the first
    """
    more = uniform_filter1d(
        gap - _BY_CHANCE * by_chance,
        min(sections, len(gap)),
        axis=0,
        mode="wrap" if closed else "nearest",
    )
    return np.asarray(np.maximum(more, 0.0))
