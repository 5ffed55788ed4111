# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cloud's file in blocks of points, so that memory holds what is kept of it and not the file.

Where a binary file does not say where things are, it is mapped: the system reads a page of it when
that is looked at, and may drop it afterwards.
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


def table_blocks(path: Path, row: np.dtype, start: int, count: int, rows: int = ROWS) -> Blocks:
    """Points of a table of so many rows that begins at a byte of a file, with fields x, y and z."""
    size = path.stat().st_size
    with path.open("rb") as stream:
        stream.seek(start)
        for first in range(0, count, rows):
            table = np.fromfile(stream, row, min(rows, count - first))
            points = np.empty((len(table), 3))
            for column, axis in enumerate("xyz"):
                points[:, column] = table[axis]
            del table  # before the points go on
            yield Block(points, stream.tell() / size)
