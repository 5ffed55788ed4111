# SPDX-License-Identifier: LGPL-2.1-or-later
"""The .ply format: ascii and binary of both byte orders, any properties in any order.

Only x, y and z of the element ``vertex`` are taken, so that a mesh comes in by its vertices.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import accumulate
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from .text_rows import Listener, Row, read_rows

__all__ = ["PLY_MAGIC", "read_ply", "write_ply"]

Array = NDArray[np.float64]

PLY_MAGIC = b"ply"
LONGEST_HEADER = 1 << 20  # bytes

_TYPES = {
    "char": "i1",
    "int8": "i1",
    "uchar": "u1",
    "uint8": "u1",
    "short": "i2",
    "int16": "i2",
    "ushort": "u2",
    "uint16": "u2",
    "int": "i4",
    "int32": "i4",
    "uint": "u4",
    "uint32": "u4",
    "float": "f4",
    "float32": "f4",
    "double": "f8",
    "float64": "f8",
}
_BYTE_ORDERS = {"binary_little_endian": "<", "binary_big_endian": ">"}


@dataclass(frozen=True)
class _Property:
    name: str
    kind: str  # numpy's name of the type, without byte order
    counted_by: str | None = None  # of a list: the type of its length


@dataclass(frozen=True)
class _Element:
    name: str
    count: int
    properties: list[_Property] = field(default_factory=list)

    @property
    def has_lists(self) -> bool:
        return any(p.counted_by for p in self.properties)


@dataclass(frozen=True)
class _Header:
    format: str
    elements: list[_Element]
    lines: int
    size: int  # bytes


def read_ply(path: Path, progress: Listener | None = None) -> Array:
    """Vertices of a .ply file, (n, 3), mm.

    Raises
    ------
    ValueError: a header that cannot be understood, no vertices, or fewer than it promises.
    """
    header = _read_header(path)
    before, vertex = _split(header, path.name)
    if header.format == "ascii":
        return _read_ascii(path, header, before, vertex, progress)
    order = _BYTE_ORDERS[header.format]
    with path.open("rb") as stream:
        stream.seek(header.size)
        for element in before:
            _read_element(stream, element, order, path.name)
        return _read_element(stream, vertex, order, path.name)


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


def _read_header(path: Path) -> _Header:
    with path.open("rb") as stream:
        head = stream.read(LONGEST_HEADER)
    end = head.find(b"end_header")
    if not head.startswith(PLY_MAGIC) or end < 0:
        raise ValueError(
            f"{path.name} is no .ply file: it does not begin with 'ply' and a header that ends in "
            "'end_header'. It may be cut off, or another format with the wrong ending."
        )
    size = end + len(b"end_header")
    size += 2 if head[size : size + 2] == b"\r\n" else 1
    lines = head[:size].decode("ascii", errors="replace").splitlines()
    format_name = ""
    elements: list[_Element] = []
    for number, line in enumerate(lines, 1):
        try:
            match line.split():
                case ["format", name, *_]:
                    format_name = name
                case ["element", name, count]:
                    elements.append(_Element(name, int(count)))
                case ["property", "list", counted_by, kind, name]:
                    listed = _Property(name, _TYPES[kind], _TYPES[counted_by])
                    elements[-1].properties.append(listed)
                case ["property", kind, name]:
                    elements[-1].properties.append(_Property(name, _TYPES[kind]))
        except (ValueError, KeyError, IndexError):
            raise ValueError(
                f"Line {number} of the header of {path.name} cannot be understood: '{line[:60]}'. "
                "Export the file again."
            ) from None
    if format_name not in ("ascii", *_BYTE_ORDERS):
        raise ValueError(
            f"{path.name} has the format '{format_name}'; a .ply file is ascii, "
            "binary_little_endian or binary_big_endian. Export the file again."
        )
    return _Header(format_name, elements, len(lines), size)


def _split(header: _Header, name: str) -> tuple[list[_Element], _Element]:
    """The elements before the vertices, and the vertices."""
    names = [element.name for element in header.elements]
    if "vertex" not in names:
        raise ValueError(
            f"{name} has no element 'vertex' (but {', '.join(names) or 'nothing'}), "
            "so it holds no points."
        )
    place = names.index("vertex")
    vertex = header.elements[place]
    if vertex.count <= 0:
        raise ValueError(f"{name} holds no points: it promises {vertex.count} vertices.")
    scalars = {p.name for p in vertex.properties if not p.counted_by}
    missing = [axis for axis in "xyz" if axis not in scalars]
    if missing:
        raise ValueError(
            f"The vertices of {name} have no {' and no '.join(missing)} (only "
            f"{', '.join(sorted(scalars)) or 'lists'}). Export the file again with coordinates."
        )
    return header.elements[:place], vertex


def _read_ascii(
    path: Path,
    header: _Header,
    before: list[_Element],
    vertex: _Element,
    progress: Listener | None,
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
        for _ in range(first):
            next(stream, None)
        return read_rows(
            stream,
            Row(columns),
            name=path.name,
            first_line=first + 1,
            rows=vertex.count,
            progress=progress,
        )


def _read_element(stream: BinaryIO, element: _Element, order: str, name: str) -> Array:
    """Read past an element; its x, y, z as (count, 3) where it has them."""
    start = stream.tell()
    if element.has_lists:
        lengths = _list_lengths(stream, element, order)
        stream.seek(start)
        table = _fixed_table(stream, element, order, lengths)
        if table is None:
            stream.seek(start)
            return _read_ragged(stream, element, order, name)
    else:
        table = _fixed_table(stream, element, order, {})
    if table is None or len(table) < element.count:
        _complain_of_end(element, 0 if table is None else len(table), name)
    assert table is not None
    return _coordinates(table)


def _row_type(element: _Element, order: str, lengths: dict[str, int]) -> np.dtype:
    """One row as packed fields; each list as its length and so many items."""
    names: list[str] = []
    kinds: list[str] = []
    for p in element.properties:
        if p.counted_by:
            names.append(f"{p.name} length")
            kinds.append(order + p.counted_by)
        names.append(p.name)
        kinds.append((f"({lengths[p.name]},)" if p.counted_by else "") + order + p.kind)
    sizes = [np.dtype(kind).itemsize for kind in kinds]
    offsets = list(accumulate(sizes, initial=0))
    unique = [f"{place} {name}" for place, name in enumerate(names)]
    for place, name in enumerate(names):
        if name in "xyz":
            unique[place] = name
    return np.dtype(
        {"names": unique, "formats": kinds, "offsets": offsets[:-1], "itemsize": offsets[-1]}
    )


def _list_lengths(stream: BinaryIO, element: _Element, order: str) -> dict[str, int]:
    """Lengths of the lists in the row the stream stands at."""
    lengths: dict[str, int] = {}
    for p in element.properties:
        if p.counted_by:
            lengths[p.name] = _read_length(stream, order + p.counted_by)
        stream.seek(np.dtype(p.kind).itemsize * lengths.get(p.name, 1), 1)
    return lengths


def _read_length(stream: BinaryIO, kind: str) -> int:
    value = np.frombuffer(stream.read(np.dtype(kind).itemsize).ljust(8, b"\0"), kind, 1)
    return max(int(value[0]), 0)


def _fixed_table(
    stream: BinaryIO, element: _Element, order: str, lengths: dict[str, int]
) -> np.ndarray | None:
    """All rows at once, or None where the lists are not of these lengths throughout."""
    row = _row_type(element, order, lengths)
    data = stream.read(row.itemsize * element.count)
    table = np.frombuffer(data, row, len(data) // row.itemsize if row.itemsize else 0)
    places = accumulate((2 if p.counted_by else 1 for p in element.properties), initial=0)
    for p, place in zip(element.properties, places, strict=False):
        if p.counted_by:
            found = table[f"{place} {p.name} length"]
            if len(table) < element.count or np.any(found != lengths[p.name]):
                return None
    return table


def _read_ragged(stream: BinaryIO, element: _Element, order: str, name: str) -> Array:
    """Row by row, for lists of changing length."""
    points = np.zeros((element.count, 3))
    axes = {p.name: "xyz".index(p.name) for p in element.properties if p.name in "xyz"}
    for i in range(element.count):
        for p in element.properties:
            count = _read_length(stream, order + p.counted_by) if p.counted_by else 1
            data = stream.read(np.dtype(p.kind).itemsize * count)
            if len(data) < np.dtype(p.kind).itemsize * count:
                _complain_of_end(element, i, name)
            if p.name in axes and not p.counted_by:
                points[i, axes[p.name]] = np.frombuffer(data, order + p.kind)[0]
    return points


def _coordinates(table: np.ndarray) -> Array:
    names = table.dtype.names or ()
    if not {"x", "y", "z"} <= set(names):
        return np.empty((0, 3))
    return np.stack([table[axis].astype(np.float64) for axis in "xyz"], axis=1)


def _complain_of_end(element: _Element, found: int, name: str) -> None:
    raise ValueError(
        f"{name} promises {element.count} rows of '{element.name}' but ends after {found}. "
        "It was cut off while it was written or copied; get it again."
    )
