# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cloud's file in blocks of points, so that memory holds what is kept of it and not the file.

A binary file is mapped: the system reads a page of it when a block needs it, and may drop it after.
"""

from __future__ import annotations

import mmap
from collections.abc import Generator
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["ROWS", "Block", "Blocks", "Bytes", "mapped", "table_blocks"]

Array = NDArray[np.float64]
Bytes = bytes | bytearray | mmap.mmap

ROWS = 100_000  # points of a block


class Block(NamedTuple):
    """Points (k, 3) that follow those of the block before, and the share of the file read then."""

    points: Array
    share: float


Blocks = Generator[Block, None, None]


def mapped(path: Path) -> Bytes:
    """The bytes of a file, which are read when they are looked at."""
    with path.open("rb") as stream:
        return mmap.mmap(stream.fileno(), 0, access=mmap.ACCESS_READ)


def table_blocks(body: Bytes, row: np.dtype, start: int, count: int, rows: int = ROWS) -> Blocks:
    """Points of a table of so many rows, with fields x, y and z, that begins at a byte."""
    for first in range(0, count, rows):
        begin, size = start + first * row.itemsize, min(rows, count - first)
        table = np.frombuffer(body, row, size, begin)
        points = np.stack([table[axis].astype(np.float64) for axis in "xyz"], axis=1)
        yield Block(points, (begin + size * row.itemsize) / len(body))
