# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a place is written in a sentence."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from .plain_number import plain

__all__ = ["place_text"]

_NOTHING = 6  # decimals of a mm beyond which a coordinate is zero
_DECIMALS = 2  # of a mm, by which places far from the origin can still be told apart


def place_text(point: ArrayLike) -> str:
    """Coordinates of a point (3,), mm, to four digits and 0.01 mm: "12.5, 0, -400003.02"."""
    place = np.round(np.asarray(point, dtype=float), _NOTHING)
    return ", ".join(plain(float(value), 4, _DECIMALS) for value in place)
