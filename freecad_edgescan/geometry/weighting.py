# SPDX-License-Identifier: LGPL-2.1-or-later
"""Standard deviations that a weighted fit can divide by."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["sigmas_of"]


def sigmas_of(points: NDArray[np.float64], sigma: ArrayLike | None) -> NDArray[np.float64]:
    """One positive standard deviation for each point.

    Parameters
    ----------
    points : (m, 3) array
        Points in mm.
    sigma : (m,) array or number, optional
        mm; infinite for a point that says nothing. Values below a thousandth of the median, and
        below 1e-7 of the points' extent, are raised to it: no point is exact. None means 1.

    Returns
    -------
    sigma (m,), mm

    Raises
    ------
    ValueError: negative or missing values, or a wrong number of them.
    """
    if sigma is None:
        return np.ones(len(points))
    given = np.asarray(sigma, dtype=float)
    if given.shape not in ((), (1,), (len(points),)):
        raise ValueError(
            f"There are {len(points)} points and sigmas of shape {given.shape}; "
            "give one for each point, or one for all."
        )
    values = np.array(np.broadcast_to(given, len(points)))
    wrong = ~(values >= 0.0)
    if wrong.any():
        where = int(np.argmax(wrong))
        raise ValueError(
            f"The sigma of point {where} is {values[where]}; "
            "give zero, a positive number, or infinity for a point that says nothing."
        )
    known = values[np.isfinite(values) & (values > 0.0)]
    extent = float(np.ptp(points, axis=0).max()) if len(points) else 0.0
    floor = max(1e-7 * extent, 1e-77)
    if len(known):
        floor = max(floor, 1e-3 * float(np.median(known)))
    return np.maximum(values, floor)
