# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a place is written in a sentence."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["place_text"]

_NOTHING = 9  # decimals of a mm beyond which a coordinate is zero


def place_text(point: ArrayLike) -> str:
    """Coordinates of a point (3,), mm, to four digits: "12.5, 0, -3.02"."""
    place: NDArray[np.float64] = np.round(np.asarray(point, dtype=float), _NOTHING) + 0.0
    return ", ".join(f"{value:.4g}" for value in place)
