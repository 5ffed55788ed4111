# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work on many rows of an array in pieces that fit the processor's cache, in threads.

It pays where nearly all time is spent in NumPy and SciPy, which let go of the interpreter.
"""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

import numpy as np

from .cloud_workers import cores

__all__ = ["in_pieces"]

Result = TypeVar("Result")

_AT_ONCE = 4000  # rows of a piece


def in_pieces(function: Callable[[np.ndarray], Result], rows: np.ndarray) -> list[Result]:
    """What a function answers to pieces of some rows (n,), in order; of none to one empty piece."""
    pieces = np.array_split(rows, max(1, -(-len(rows) // _AT_ONCE)))
    if len(pieces) == 1:
        return [function(pieces[0])]
    with ThreadPoolExecutor(cores()) as threads:
        return list(threads.map(function, pieces))
