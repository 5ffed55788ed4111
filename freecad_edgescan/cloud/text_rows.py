# SPDX-License-Identifier: LGPL-2.1-or-later
"""Three columns of numbers out of lines of text, fast, with the line named when it cannot be done.

All textual formats (xyz, ascii ply, ascii pcd) read their points here: numpy's C reader takes
the lines in blocks; only a block it refuses is looked at line by line.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from itertools import islice
from typing import TextIO

import numpy as np
from numpy.typing import NDArray

from .blocks import ROWS, Block, Blocks

__all__ = ["Row", "holds_data", "row_blocks"]

Array = NDArray[np.float64]

COMMENT_MARKS = ("#", "//", "%")


@dataclass(frozen=True)
class Row:
    """How a line holds its numbers: which columns, what separates them, the decimal sign."""

    columns: tuple[int, int, int] = (0, 1, 2)
    separator: str | None = None  # None: blanks and tabs
    decimal_comma: bool = False

    def fields(self, line: str) -> list[str]:
        """Texts of all columns of a line."""
        text = line.strip().replace(",", ".") if self.decimal_comma else line.strip()
        return [field.strip() for field in text.split(self.separator)]


def row_blocks(
    stream: TextIO,
    row: Row,
    *,
    name: str,
    first_line: int = 1,
    promised: int | None = None,
    rows: int = ROWS,
) -> Blocks:
    """Points from the lines of a stream.

    Parameters
    ----------
    stream : text stream, standing at line number ``first_line``
    row : how each line holds its numbers
    name : of the file, for messages
    first_line : number of the line the stream stands at
    promised : how many points to read; None reads to the end
    rows : lines of a block

    Raises
    ------
    ValueError: a line without three numbers, named by its line number; fewer rows than promised.
    """
    line, found = first_line, 0
    size = _size(stream)
    while promised is None or found < promised:
        lines = list(islice(stream, rows if promised is None else min(promised - found, rows)))
        if not lines:
            break
        points = _points(lines, row, name, line)
        line += len(lines)
        found += len(points)
        yield Block(points, stream.buffer.tell() / size)
    if promised is not None and found < promised:
        raise ValueError(
            f"{name} promises {promised} points but ends after {found}. "
            "It was cut off while it was written or copied; get it again."
        )


def _size(stream: TextIO) -> int:
    buffer = stream.buffer
    here = buffer.tell()
    size = buffer.seek(0, 2)
    buffer.seek(here)
    return max(size, 1)


def _points(lines: list[str], row: Row, name: str, first_line: int) -> Array:
    if row.decimal_comma:
        lines = [line.replace(",", ".") for line in lines]
    if not any(holds_data(line) for line in lines):
        return np.empty((0, 3))
    try:
        return _load(lines, row)
    except ValueError as error:
        for number, line in enumerate(lines, first_line):
            if holds_data(line):
                _require_numbers(line, row, name, number)
        try:
            return _load([line for line in lines if holds_data(line)], row)
        except ValueError:
            last_line = first_line + len(lines) - 1
            raise ValueError(
                f"{name} has no readable numbers between line {first_line} and line {last_line}: "
                f"{error}"
            ) from None


def _load(lines: list[str], row: Row) -> Array:
    return np.loadtxt(lines, delimiter=row.separator, comments="#", usecols=row.columns, ndmin=2)


def holds_data(line: str) -> bool:
    """Whether the line is neither blank nor a comment."""
    text = line.lstrip()
    return bool(text) and not text.startswith(COMMENT_MARKS)


def _require_numbers(line: str, row: Row, name: str, number: int) -> None:
    fields = row.fields(line.partition("#")[0])
    shown = line.strip()[:60]
    if len(fields) <= max(row.columns):
        raise ValueError(
            f"Line {number} of {name} has {len(fields)} column{'s' * (len(fields) != 1)}, "
            f"x, y and z need {max(row.columns) + 1}: '{shown}'. "
            "Complete the line or delete it."
        )
    for column in row.columns:
        try:
            float(fields[column])
        except ValueError:
            comma = re.fullmatch(r"[-+]?\d+,\d+", fields[column]) is not None
            way = "Write it with a decimal point, as the lines before" if comma else "Correct it"
            what = " (a decimal comma)" if comma else ""
            raise ValueError(
                f"Line {number} of {name} holds '{fields[column][:30]}'{what} where a number "
                f"should be: '{shown}'. {way}, or delete the line."
            ) from None
