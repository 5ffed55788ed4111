# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a length or a coordinate is written in a sentence: as a plain decimal, never with a power."""

from __future__ import annotations

import math

__all__ = ["plain"]

_MOST = 9  # decimals


def plain(value: float, digits: int, decimals: int = 0) -> str:
    """A number to some digits, all of those before the point among them: "0.0312", "39567".

    Parameters
    ----------
    value : the number
    digits : from its first one that is not 0
    decimals : that are written however many digits there are before the point
    """
    if not math.isfinite(value):
        return f"{value:g}"
    first = math.floor(math.log10(abs(value))) if value else 0
    count = min(max(digits - 1 - first, decimals, 0), _MOST)
    text = f"{value:.{count}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return "0" if text == "-0" else text
