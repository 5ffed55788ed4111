# SPDX-License-Identifier: LGPL-2.1-or-later
"""Knots of clamped splines: equal, averaged over data, refined and merged.

Knots count as equal within `SAME` times the range: knots of two curves that were brought to one
range differ by rounding, and a piece shorter than that is none.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["averaged_knots", "clamped_knots", "cut_knots", "greville", "merged_knots"]

Array = NDArray[np.float64]

SAME = 1e-9


def clamped_knots(breaks: ArrayLike, degree: int) -> Array:
    """Knots with simple inner breaks and degree + 1 equal ones at both ends."""
    breaks = np.asarray(breaks, dtype=float)
    return np.r_[[breaks[0]] * degree, breaks, [breaks[-1]] * degree]


def averaged_knots(
    parameters: ArrayLike, count: int, degree: int, limits: tuple[float, float]
) -> Array:
    """Clamped knots for a least-squares spline: each inner span holds some of the parameters.

    Piegl and Tiller, The NURBS Book, 2nd ed. (1997), eqs. 9.68 and 9.69.

    Parameters
    ----------
    parameters : (m,) array, of the data, in any order
    count : int, number of poles
    degree : int
    limits : first and last knot

    Returns
    -------
    (count + degree + 1,) array.
    """
    sorted_ = np.sort(np.asarray(parameters, dtype=float))
    spans = count - degree
    place = np.arange(1, spans) * (len(sorted_) / spans)
    whole = np.floor(place).astype(np.intp)
    share = place - whole
    whole = np.clip(whole, 1, len(sorted_) - 1)
    inner = (1.0 - share) * sorted_[whole - 1] + share * sorted_[whole]
    return clamped_knots(np.r_[limits[0], inner, limits[1]], degree)


def greville(knots: ArrayLike, degree: int) -> Array:
    """Greville's abscissae: the mean of the knots that belong to each pole."""
    knots = np.asarray(knots, dtype=float)
    means = np.convolve(knots[1:-1], np.full(degree, 1.0 / degree), mode="valid")
    return np.clip(means, knots[degree], knots[-degree - 1])


def cut_knots(knots: Array, degree: int, first: float, last: float) -> Array:
    """Clamped knots of the part between two parameters."""
    near = SAME * (knots[-1] - knots[0])
    inner = knots[(knots > first + near) & (knots < last - near)]
    return np.r_[[first] * (degree + 1), inner, [last] * (degree + 1)]


def merged_knots(several: Sequence[Array], degree: int) -> Array:
    """Fewest clamped knots that hold each of several clamped knot vectors over one range."""
    first, last = several[0][0], several[0][-1]
    near = SAME * (last - first)
    everything = np.sort(np.concatenate([knots[degree + 1 : -degree - 1] for knots in several]))
    breaks = everything[np.diff(everything, prepend=-np.inf) > near]
    counts = np.zeros(len(breaks), dtype=np.intp)
    for knots in several:
        inside = knots[degree + 1 : -degree - 1]
        counts = np.maximum(counts, np.sum(np.abs(breaks[:, None] - inside) <= 2 * near, axis=1))
    return np.r_[[first] * (degree + 1), np.repeat(breaks, counts), [last] * (degree + 1)]
