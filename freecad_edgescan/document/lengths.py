# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths that a user gives: what is none is refused in a sentence, before anything is made."""

from __future__ import annotations

import math
from typing import Any

__all__ = ["length_or_zero", "positive_length"]


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


def _finite(value: Any) -> float:
    """The number, or nan."""
    try:
        number = float(value)
    except (TypeError, ValueError):
        return math.nan
    return number if math.isfinite(number) else math.nan


def _shown(value: Any) -> str:
    try:
        return f"{float(value):g}"
    except (TypeError, ValueError):
        return repr(value)
