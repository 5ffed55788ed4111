# SPDX-License-Identifier: LGPL-2.1-or-later
"""The .pcd format of the Point Cloud Library: ascii, binary and binary_compressed.

Fields may stand in any order, of any type and count; only x, y and z are taken. The compressed
form holds all values of one field after the other, and those packed by LZF.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import accumulate
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .blocks import ROWS, Block, Blocks, Bytes, mapped, table_blocks
from .lzf import decompress_lzf
from .text_rows import Row, row_blocks

__all__ = ["looks_like_pcd", "pcd_blocks"]

Array = NDArray[np.float64]

LONGEST_HEADER = 1 << 16  # bytes
_LETTERS = {"F": "f", "U": "u", "I": "i"}


@dataclass(frozen=True)
class _Header:
    names: list[str]
    kinds: list[str]  # numpy's names of the types
    counts: list[int]
    points: int
    data: str
    lines: int
    size: int  # bytes

    @property
    def widths(self) -> list[int]:
        """Bytes of each field in one row."""
        pairs = zip(self.kinds, self.counts, strict=True)
        return [np.dtype(kind).itemsize * count for kind, count in pairs]


def looks_like_pcd(head: bytes) -> bool:
    """Whether a file that begins with these bytes is a .pcd file."""
    return b"\nDATA " in head and (b"FIELDS " in head or b"COLUMNS " in head)


def pcd_blocks(path: Path, rows: int = ROWS) -> Blocks:
    """Points of a .pcd file in blocks of so many, mm.

    Raises
    ------
    ValueError: a header that cannot be understood, no points, fewer than it promises, or damaged
        compressed data.
    """
    header = _read_header(path)
    if header.data == "ascii":
        yield from _ascii_blocks(path, header, rows)
    elif header.data == "binary":
        yield from _blocks_of_rows(path, header, rows)
    else:
        yield from _blocks_of_columns(mapped(path), header, path.name, rows)


def _read_header(path: Path) -> _Header:
    with path.open("rb") as stream:
        head = stream.read(LONGEST_HEADER)
    if not looks_like_pcd(head):
        raise ValueError(
            f"{path.name} is no .pcd file: it has no header with FIELDS and DATA. It may be cut "
            "off, or another format with the wrong ending."
        )
    size = head.index(b"\n", head.index(b"\nDATA ") + 1) + 1 if _ends(head) else len(head)
    lines = head[:size].decode("ascii", errors="replace").splitlines()
    words = {line.split()[0]: line.split()[1:] for line in lines if line.strip()}
    try:
        names = words["FIELDS"] if "FIELDS" in words else words["COLUMNS"]
        sizes = words["SIZE"]
        kinds = [
            np.dtype(_LETTERS[letter] + width).str[1:]
            for letter, width in zip(words["TYPE"], sizes, strict=True)
        ]
        counts = [int(count) for count in words.get("COUNT", ["1"] * len(names))]
        if "POINTS" in words:
            points = int(words["POINTS"][0])
        else:
            points = int(words["WIDTH"][0]) * int(words["HEIGHT"][0])
        data = words["DATA"][0].lower()
        if not len(names) == len(kinds) == len(counts) or min(counts) < 0:
            raise ValueError("FIELDS, SIZE, TYPE and COUNT are not equally long")
    except (KeyError, ValueError, TypeError, IndexError) as error:
        raise ValueError(
            f"The header of {path.name} cannot be understood ({error}). Export the file again."
        ) from None
    _check_header(names, points, data, path.name)
    return _Header(names, kinds, counts, points, data, len(lines), size)


def _ends(head: bytes) -> bool:
    return b"\n" in head[head.index(b"\nDATA ") + 1 :]


def _check_header(names: list[str], points: int, data: str, name: str) -> None:
    missing = [axis for axis in "xyz" if axis not in names]
    if missing:
        raise ValueError(
            f"The points of {name} have no {' and no '.join(missing)} (only {', '.join(names)}). "
            "Export the file again with coordinates."
        )
    if points <= 0:
        raise ValueError(f"{name} holds no points: it promises {points}.")
    if data not in ("ascii", "binary", "binary_compressed"):
        raise ValueError(
            f"{name} holds its points as '{data}'; a .pcd file is ascii, binary or "
            "binary_compressed. Export the file again."
        )


def _ascii_blocks(path: Path, header: _Header, rows: int) -> Blocks:
    columns = list(accumulate(header.counts, initial=0))
    x, y, z = (columns[header.names.index(axis)] for axis in "xyz")
    with path.open(encoding="utf-8", errors="replace") as stream:
        for _ in range(header.lines):
            next(stream)
        yield from row_blocks(
            stream,
            Row((x, y, z)),
            name=path.name,
            first_line=header.lines + 1,
            promised=header.points,
            rows=rows,
        )


def _blocks_of_rows(path: Path, header: _Header, rows: int) -> Blocks:
    offsets = list(accumulate(header.widths, initial=0))
    places = [header.names.index(axis) for axis in "xyz"]
    row = np.dtype(
        {
            "names": ["x", "y", "z"],
            "formats": ["<" + header.kinds[place] for place in places],
            "offsets": [offsets[place] for place in places],
            "itemsize": offsets[-1],
        }
    )
    found = (path.stat().st_size - header.size) // row.itemsize
    if found < header.points:
        _complain_of_end(header.points, found, path.name)
    yield from table_blocks(path, row, header.size, header.points, rows)


def _blocks_of_columns(body: Bytes, header: _Header, name: str, rows: int) -> Blocks:
    columns = _unpacked(body, header, name)
    starts = [width * header.points for width in accumulate(header.widths, initial=0)]
    xyz = []
    for axis in "xyz":
        place = header.names.index(axis)
        count = header.counts[place]
        kind = "<" + header.kinds[place]
        xyz.append(np.frombuffer(columns, kind, header.points * count, starts[place])[::count])
    for first in range(0, header.points, rows):
        points = np.stack([own[first : first + rows].astype(np.float64) for own in xyz], axis=1)
        yield Block(points, (first + len(points)) / header.points)


def _unpacked(body: Bytes, header: _Header, name: str) -> Bytes:
    """The values of all fields, one field after the other."""
    size = len(body) - header.size
    if size < 8:
        _complain_of_end(header.points, 0, name)
    packed, unpacked = (int(own) for own in np.frombuffer(body, "<u4", 2, header.size))
    expected = sum(header.widths) * header.points
    if unpacked != expected:
        raise ValueError(
            f"{name} holds {unpacked} bytes of points, its header promises {expected}. "
            "Export the file again."
        )
    if size < 8 + packed:
        raise ValueError(
            f"{name} promises {packed} bytes of compressed points but ends after {size - 8}. "
            "It was cut off while it was written or copied; get it again."
        )
    begin = header.size + 8
    try:
        return decompress_lzf(body[begin : begin + packed], unpacked)
    except ValueError as error:
        raise ValueError(f"{name} cannot be read. {error} Get the file again.") from None


def _complain_of_end(promised: int, found: int, name: str) -> None:
    raise ValueError(
        f"{name} promises {promised} points but ends after {found}. "
        "It was cut off while it was written or copied; get it again."
    )
