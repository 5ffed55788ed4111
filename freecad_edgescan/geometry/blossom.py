# SPDX-License-Identifier: LGPL-2.1-or-later
"""The blossom of a spline, from which every exact change of its form follows.

The blossom of a polynomial of degree p is the one symmetric function of p arguments, affine in
each, that is the polynomial where all arguments are equal. A pole of a spline is the blossom of
any piece in the pole's support at the p knots between that support's ends (L. Ramshaw, Blossoming:
a connect-the-dots approach to splines, 1987). Inserting knots, raising the degree and cutting are
therefore all the same: the poles of the old curve's blossom at the new curve's knots.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["blossom", "poles_of_higher_degree", "poles_over_knots"]

Array = NDArray[np.float64]


def blossom(knots: Array, degree: int, poles: Array, arguments: Array, inside: Array) -> Array:
    """Values of the blossoms of a spline's pieces, by de Boor's recursion.

    Parameters
    ----------
    knots : (n + degree + 1,) array
    degree : int
    poles : (n, d) array
    arguments : (m, degree) array
    inside : (m,) array, parameters strictly inside the pieces whose blossoms are asked for

    Returns
    -------
    (m, d) array.
    """
    piece = np.clip(np.searchsorted(knots, inside, side="right") - 1, degree, len(poles) - 1)
    value = poles[piece[:, None] - degree + np.arange(degree + 1)]
    for step in range(1, degree + 1):
        first = piece[:, None] - degree + np.arange(step, degree + 1)
        low, high = knots[first], knots[first + degree - step + 1]
        share = ((arguments[:, step - 1, None] - low) / (high - low))[..., None]
        value = (1.0 - share) * value[:, :-1] + share * value[:, 1:]
    return np.asarray(value[:, 0])


def _inside_support(knots: Array, degree: int, count: int) -> Array:
    """Middle of the longest piece in the support of each of the first `count` poles."""
    first = np.arange(count)[:, None] + np.arange(degree + 1)
    longest = np.argmax(knots[first + 1] - knots[first], axis=1) + np.arange(count)
    return np.asarray((knots[longest] + knots[longest + 1]) / 2)


def poles_over_knots(knots: Array, degree: int, poles: Array, wanted: Array) -> Array:
    """Poles (k, d) of the same spline over other knots (k + degree + 1,).

    Between its ends `wanted` must hold the old knots, each as often as before or more often.
    """
    count = len(wanted) - degree - 1
    arguments = wanted[np.arange(count)[:, None] + np.arange(1, degree + 1)]
    return blossom(knots, degree, poles, arguments, _inside_support(wanted, degree, count))


def poles_of_higher_degree(knots: Array, degree: int, poles: Array) -> tuple[Array, Array]:
    """Knots and poles of the same spline written with a degree higher by one.

    The higher blossom is the mean of the lower ones that leave out one argument each.
    """
    distinct, counts = np.unique(knots, return_counts=True)
    raised = np.repeat(distinct, counts + 1)
    count = len(raised) - degree - 2
    arguments = raised[np.arange(count)[:, None] + np.arange(1, degree + 2)]
    inside = _inside_support(raised, degree + 1, count)
    values = [
        blossom(knots, degree, poles, np.delete(arguments, left_out, axis=1), inside)
        for left_out in range(degree + 1)
    ]
    return raised, np.mean(values, axis=0)
