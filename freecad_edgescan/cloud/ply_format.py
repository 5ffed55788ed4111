# SPDX-License-Identifier: LGPL-2.1-or-later
"""The .ply format: ascii and binary of both byte orders, any properties in any order.

Only x, y and z of the element ``vertex`` are taken, so that a mesh comes in by its vertices.
"""

from __future__ import annotations

from collections import deque
from itertools import islice
from pathlib import Path
from typing import Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from .ply_header import BYTE_ORDERS, PlyElement, PlyHeader, read_ply_header, split_at_vertices
from .progress import Progress
from .text_rows import Row, read_rows

__all__ = ["read_ply", "write_ply"]

Array = NDArray[np.float64]


def read_ply(path: Path, progress: Progress | None = None) -> Array:
    """Vertices of a .ply file, (n, 3), mm.

    Raises
    ------
    ValueError: a header that cannot be understood, no vertices, or fewer than it promises.
    """
    header = read_ply_header(path)
    before, vertex = split_at_vertices(header, path.name)
    if header.format == "ascii":
        return _read_ascii(path, header, before, vertex, progress)
    order = BYTE_ORDERS[header.format]
    body = path.read_bytes()
    start = header.size
    for element in before:
        _, start = _read_element(body, start, element, order, path.name)
    return _read_element(body, start, vertex, order, path.name)[0]


def write_ply(points: Array, path: Path) -> None:
    """Write (n, 3) points as a binary .ply of doubles, which loses nothing."""
    header = (
        "ply\nformat binary_little_endian 1.0\ncomment millimetres\n"
        f"element vertex {len(points)}\n"
        "property double x\nproperty double y\nproperty double z\nend_header\n"
    )
    with path.open("wb") as stream:
        stream.write(header.encode("ascii"))
        stream.write(np.ascontiguousarray(points, dtype="<f8").tobytes())


def _read_ascii(
    path: Path,
    header: PlyHeader,
    before: list[PlyElement],
    vertex: PlyElement,
    progress: Progress | None,
) -> Array:
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
        return read_rows(
            stream,
            Row(columns),
            name=path.name,
            first_line=first + 1,
            rows=vertex.count,
            progress=progress,
        )


def _read_element(
    body: bytes, start: int, element: PlyElement, order: str, name: str
) -> tuple[Array, int]:
    """The x, y, z of an element that begins at a byte, (count, 3), and where the next begins."""
    lengths = _list_lengths(body, start, element, order)
    row = _row_type(element, order, lengths) if sum(lengths.values()) < len(body) else None
    fitting = (len(body) - start) // row.itemsize if row is not None and row.itemsize else 0
    if row is not None and fitting >= element.count:
        table = np.frombuffer(body, row, element.count, start)
        if all(np.all(table[f"{p} length"] == length) for p, length in lengths.items()):
            return _coordinates(table), start + row.itemsize * element.count
    if not element.has_lists:
        _complain_of_end(element, fitting, name)
    return _read_ragged(body, start, element, order, name)


def _list_lengths(body: bytes, start: int, element: PlyElement, order: str) -> dict[str, int]:
    """Lengths of the lists in the row that begins at a byte."""
    lengths: dict[str, int] = {}
    for p in element.properties:
        if p.counted_by:
            lengths[p.name], start = _read_length(body, start, order + p.counted_by)
        start += np.dtype(p.kind).itemsize * lengths.get(p.name, 1)
    return lengths


def _read_length(body: bytes, start: int, kind: str) -> tuple[int, int]:
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


def _read_ragged(
    body: bytes, start: int, element: PlyElement, order: str, name: str
) -> tuple[Array, int]:
    """Row by row, for lists of changing length."""
    rows: list[list[float]] = []
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
        rows.append(list(found.values()))
    return np.array(rows), start


def _coordinates(table: np.ndarray) -> Array:
    names = table.dtype.names or ()
    if not {"x", "y", "z"} <= set(names):
        return np.empty((0, 3))
    return np.stack([table[axis].astype(np.float64) for axis in "xyz"], axis=1)


def _complain_of_end(element: PlyElement, found: int, name: str) -> NoReturn:
    raise ValueError(
        f"{name} promises {element.count} rows of '{element.name}' but ends after {found}. "
        "It was cut off while it was written or copied; get it again."
    )
