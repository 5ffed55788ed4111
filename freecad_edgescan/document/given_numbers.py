# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers that a user gives, as an argument or in a property of an object.

What cannot work is refused in one sentence, the same in both places: by ``make_…`` before anything
is made, and by the object's task, which leaves the result made before.
"""

from __future__ import annotations

import math
from typing import Any

from ..scanning.least_angle import check_least_angle

__all__ = [
    "finite_number",
    "least_angle",
    "length_or_zero",
    "positive_length",
    "positive_number",
    "share_of_rail",
    "whole_number",
]


def positive_length(what: str, value: Any) -> float:
    """A length above 0, mm; `what` it is, such as "pitch".

    Raises
    ------
    ValueError: anything else, also nan, inf, and what is no number.
    """
    length = _finite(value)
    if not length > 0.0:
        raise ValueError(f"The {what} is {_shown(value)}; give a positive length in mm.")
    return length


def length_or_zero(what: str, value: Any) -> float:
    """A length, mm, where 0 says something, too; `what` it is, such as "reach".

    Raises
    ------
    ValueError: anything else, also nan, inf, and what is no number.
    """
    length = _finite(value)
    if not length >= 0.0:
        raise ValueError(f"The {what} is {_shown(value)}; give 0 or a positive length in mm.")
    return length


def finite_number(what: str, value: Any) -> float:
    """Any number without a unit; `what` it is, such as "τ of the extension".

    Raises
    ------
    ValueError: nan, inf, and what is no number.
    """
    number = _finite(value)
    if math.isnan(number):
        raise ValueError(f"The {what} is {_shown(value)}; give a number.")
    return number


def positive_number(what: str, value: Any) -> float:
    """A number above 0 without a unit; `what` it is, such as "ratio".

    Raises
    ------
    ValueError: anything else, also nan, inf, and what is no number.
    """
    number = _finite(value)
    if not number > 0.0:
        raise ValueError(f"The {what} is {_shown(value)}; give a positive number.")
    return number


def share_of_rail(value: Any) -> float:
    """A place on a rail, as a share of its length from 0 to 1.

    Raises
    ------
    ValueError: anything else.
    """
    share = _finite(value)
    if not 0.0 <= share <= 1.0:
        raise ValueError(f"The share of the rail is {_shown(value)}; give a number from 0 to 1.")
    return share


def least_angle(value: Any) -> float:
    """The least turn between the two sides of an edge, rad.

    Raises
    ------
    ValueError: it is not above 0 and below pi.
    """
    angle = _finite(value)
    check_least_angle(value if math.isnan(angle) else angle)
    return angle


def whole_number(what: str, value: Any, least: int) -> int:
    """A whole number, not below the least one; `what` it is, such as "seed".

    Raises
    ------
    ValueError: anything else.
    """
    number = _finite(value)
    if not (number >= least and number == int(number)):
        raise ValueError(f"The {what} is {_shown(value)}; give a whole number of {least} or more.")
    return int(number)


def _finite(value: Any) -> float:
    """The number, or nan."""
    try:
        number = float(value)
    except (TypeError, ValueError, OverflowError):
        return math.nan
    return number if math.isfinite(number) else math.nan


def _shown(value: Any) -> str:
    try:
        return repr(value) if isinstance(value, str) else f"{float(value):g}"
    except (TypeError, ValueError, OverflowError):
        return repr(value)
