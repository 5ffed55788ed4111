# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of the screen, told apart by colour-blind people too.

Single colours are Okabe and Ito's; what grows is shown in viridis (Smith and van der Walt 2015),
which also grows in brightness.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["CLICK", "EDGE", "GATE", "LEFT_OUT", "SIDES", "sigma_colours", "sigma_range"]

Array = NDArray[np.float64]
Colour = tuple[float, float, float]

EDGE: Colour = (0.84, 0.37, 0.0)
CLICK: Colour = (0.0, 0.45, 0.70)
GATE: Colour = (0.80, 0.47, 0.65)
LEFT_OUT: Colour = (0.60, 0.60, 0.60)
# Of the two surfaces of an edge, on light and on dark ground.
SIDES: dict[bool, tuple[Colour, Colour]] = {
    False: ((0.0, 0.45, 0.70), (0.84, 0.37, 0.0)),
    True: ((0.34, 0.71, 0.91), (0.90, 0.62, 0.0)),
}
# Viridis without its darkest part, which is lost on FreeCAD's dark backgrounds.
_GROWING = np.array(
    [
        (0.231, 0.322, 0.545),
        (0.173, 0.443, 0.557),
        (0.129, 0.565, 0.553),
        (0.153, 0.678, 0.506),
        (0.361, 0.784, 0.388),
        (0.667, 0.863, 0.196),
        (0.992, 0.906, 0.145),
    ]
)
_LEAST_SPAN = 2.0  # largest over smallest value: below it colours would make much of nothing


def sigma_range(sigma: ArrayLike) -> tuple[float, float]:
    """Smallest and largest sigma the colours stand for, mm; the latter at least twice the former.

    Parameters
    ----------
    sigma : (m,) mm; what is not finite does not count
    """
    values = np.asarray(sigma, dtype=np.float64)
    values = values[np.isfinite(values)]
    if not len(values):
        return 0.0, 1.0
    low = float(values.min())
    return low, max(float(values.max()), _LEAST_SPAN * low, low + 1e-9)


def sigma_colours(sigma: ArrayLike, within: tuple[float, float] | None = None) -> Array:
    """Colour of each sigma, (m, 3) red, green, blue from 0 to 1.

    Parameters
    ----------
    within : smallest and largest value of the colours; None: those of the values
    """
    values = np.nan_to_num(np.asarray(sigma, dtype=np.float64), nan=np.inf)
    low, high = sigma_range(sigma) if within is None else within
    place = np.clip((values - low) / (high - low), 0.0, 1.0) * (len(_GROWING) - 1)
    stops = np.arange(len(_GROWING))
    return np.column_stack([np.interp(place, stops, channel) for channel in _GROWING.T])
