# SPDX-License-Identifier: LGPL-2.1-or-later
"""Derivatives of a rational surface from those of its homogeneous form.

Piegl and Tiller, The NURBS Book (1997), eq. 4.20: the quotient rule, order by order.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import comb

import numpy as np
from numpy.typing import NDArray

__all__ = ["divided", "orders_below"]

Array = NDArray[np.float64]


def orders_below(du: int, dv: int) -> tuple[tuple[int, int], ...]:
    """Every order up to (du, dv), each after those it needs."""
    return tuple((i, j) for i in range(du + 1) for j in range(dv + 1))


def divided(homogeneous: Array, orders: Sequence[tuple[int, int]]) -> Array:
    """Derivatives of the surface from homogeneous ones of the same orders.

    Parameters
    ----------
    homogeneous : (k, 4, m) array, or (k, 3, m) of a polynomial surface, whose own these are
    orders : k orders in u and v, every one after all that are lower

    Returns
    -------
    (k, 3, m) array.
    """
    if homogeneous.shape[1] == 3:
        return homogeneous
    place = {order: number for number, order in enumerate(orders)}
    result = homogeneous[:, :3].copy()
    for i, j in orders:
        value = result[place[i, j]]
        for k, m in orders_below(i, j)[1:]:
            weight = comb(i, k) * comb(j, m) * homogeneous[place[k, m], 3]
            value -= weight * result[place[i - k, j - m]]
        value /= homogeneous[0, 3]
    return result
