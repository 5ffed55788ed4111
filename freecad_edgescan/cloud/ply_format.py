# SPDX-License-Identifier: LGPL-2.1-or-later
"""The .ply format: ascii and binary of both byte orders, any properties in any order.

Only x, y and z of the element ``vertex`` are taken, so that a mesh comes in by its vertices.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from .blocks import ROWS, Block, Blocks, Bytes, mapped, table_blocks
from .ply_header import BYTE_ORDERS, PlyElement, PlyHeader, read_ply_header, split_at_vertices
from .text_rows import Row, row_blocks

__all__ = ["ply_blocks", "write_ply"]

Array = NDArray[np.float64]


def ply_blocks(path: Path, rows: int = ROWS) -> Blocks:
    """Vertices of a .ply file in blocks of so many, mm.

    Raises
    ------
    ValueError: a header that cannot be understood, no vertices, or fewer than it promises.
    """
    header = read_ply_header(path)
    before, vertex = split_at_vertices(header, path.name)
    if header.format == "ascii":
        yield from _ascii_blocks(path, header, before, vertex, rows)
        return
    order = BYTE_ORDERS[header.format]
    body, start = mapped(path), header.size
    for element in before:
        start = _end_of(body, start, element, order, path.name)
    row = _fixed_row(body, start, vertex, order, path.name)
    if row is not None:
        yield from table_blocks(path, row, start, vertex.count, rows)
    else:
        yield from _ragged_blocks(body, start, vertex, order, path.name, rows)


def write_ply(points: Array, path: Path) -> None:
    """Write (n, 3) points as a binary .ply of doubles, which loses nothing."""
    header = (
        "ply\nformat binary_little_endian 1.0\ncomment millimetres\n"
        f"element vertex {len(points)}\n"
        "property double x\nproperty double y\nproperty double z\nend_header\n"
    )
    with path.open("wb") as stream:
        stream.write(header.encode("ascii"))
        stream.write(np.ascontiguousarray(points, dtype="<f8").data)


def _ascii_blocks(
    path: Path, header: PlyHeader, before: list[PlyElement], vertex: PlyElement, rows: int
) -> Blocks:
    names = [p.name for p in vertex.properties]
    columns = (names.index("x"), names.index("y"), names.index("z"))
    if any(p.counted_by for p in vertex.properties[: max(columns)]):
        raise ValueError(
            f"The vertices of {path.name} have a list before their coordinates, which cannot be "
            "read from ascii. Export it as a binary .ply."
        )
    first = header.lines + sum(element.count for element in before)
    with path.open(encoding="utf-8", errors="replace") as stream:
        deque(islice(stream, first), maxlen=0)
        yield from row_blocks(
            stream,
            Row(columns),
            name=path.name,
            first_line=first + 1,
            promised=vertex.count,
            rows=rows,
        )


def _end_of(body: Bytes, start: int, element: PlyElement, order: str, name: str) -> int:
    """Where the element ends that begins at a byte."""
    row = _fixed_row(body, start, element, order, name)
    if row is not None:
        return start + row.itemsize * element.count
    for _, end in _ragged_rows(body, start, element, order, name):
        start = end
    return start


def _fixed_row(
    body: Bytes, start: int, element: PlyElement, order: str, name: str
) -> np.dtype | None:
    """What all rows of the element that begins at a byte look like; None where they differ."""
    lengths = _list_lengths(body, start, element, order)
    row = _row_type(element, order, lengths) if sum(lengths.values()) < len(body) else None
    fitting = (len(body) - start) // row.itemsize if row is not None and row.itemsize else 0
    if row is not None and fitting >= element.count:
        table = np.frombuffer(body, row, element.count, start)
        if all(np.all(table[f"{p} length"] == length) for p, length in lengths.items()):
            return row
    if not element.has_lists:
        _complain_of_end(element, fitting, name)
    return None


def _list_lengths(body: Bytes, start: int, element: PlyElement, order: str) -> dict[str, int]:
    """Lengths of the lists in the row that begins at a byte."""
    lengths: dict[str, int] = {}
    for p in element.properties:
        if p.counted_by:
            lengths[p.name], start = _read_length(body, start, order + p.counted_by)
        start += np.dtype(p.kind).itemsize * lengths.get(p.name, 1)
    return lengths


def _read_length(body: Bytes, start: int, kind: str) -> tuple[int, int]:
    """A list's length, 0 past the end of the file, and where its items begin."""
    end = start + np.dtype(kind).itemsize
    length = int(np.frombuffer(body, kind, 1, start)[0]) if end <= len(body) else 0
    return max(length, 0), end


def _row_type(element: PlyElement, order: str, lengths: dict[str, int]) -> np.dtype:
    """One row as packed fields; each list as its length and so many items."""
    fields: list[tuple[Any, ...]] = []
    for p in element.properties:
        if p.counted_by:
            fields.append((f"{p.name} length", order + p.counted_by))
            fields.append((p.name, order + p.kind, (lengths[p.name],)))
        else:
            fields.append((p.name, order + p.kind))
    return np.dtype(fields)


def _ragged_rows(
    body: Bytes, start: int, element: PlyElement, order: str, name: str
) -> Iterator[tuple[list[float], int]]:
    """Row by row, for lists of changing length: x, y, z and where the next row begins."""
    for i in range(element.count):
        found = dict.fromkeys("xyz", 0.0)
        for p in element.properties:
            count = 1
            if p.counted_by:
                count, start = _read_length(body, start, order + p.counted_by)
            end = start + np.dtype(p.kind).itemsize * count
            if end > len(body):
                _complain_of_end(element, i, name)
            if p.name in found and not p.counted_by:
                found[p.name] = float(np.frombuffer(body, order + p.kind, 1, start)[0])
            start = end
        yield list(found.values()), start


def _ragged_blocks(
    body: Bytes, start: int, vertex: PlyElement, order: str, name: str, rows: int
) -> Blocks:
    remaining = _ragged_rows(body, start, vertex, order, name)
    while some := list(islice(remaining, rows)):
        points, ends = zip(*some, strict=True)
        yield Block(np.array(points), ends[-1] / len(body))


def _complain_of_end(element: PlyElement, found: int, name: str) -> NoReturn:
    raise ValueError(
        f"{name} promises {element.count} rows of '{element.name}' but ends after {found}. "
        "It was cut off while it was written or copied; get it again."
    )
