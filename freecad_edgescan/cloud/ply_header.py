# SPDX-License-Identifier: LGPL-2.1-or-later
"""The header of a .ply file: which elements follow, how many of each, and how they are written."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

__all__ = [
    "BYTE_ORDERS",
    "PLY_MAGIC",
    "PlyElement",
    "PlyHeader",
    "PlyProperty",
    "read_ply_header",
    "split_at_vertices",
]

PLY_MAGIC = b"ply"
LONGEST_HEADER = 1 << 20  # bytes
MOST_ROWS = 1 << 40

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
BYTE_ORDERS = {"binary_little_endian": "<", "binary_big_endian": ">"}


@dataclass(frozen=True)
class PlyProperty:
    """One value of each row of an element, or one list of values."""

    name: str
    kind: str  # numpy's name of the type, without byte order
    counted_by: str | None = None  # of a list: the type of its length


@dataclass(frozen=True)
class PlyElement:
    """One kind of rows: vertices, faces, …"""

    name: str
    count: int
    properties: list[PlyProperty] = field(default_factory=list)

    @property
    def has_lists(self) -> bool:
        """Whether rows may differ in length."""
        return any(p.counted_by for p in self.properties)


@dataclass(frozen=True)
class PlyHeader:
    """All elements in the order of the file, and where the header ends."""

    format: str
    elements: list[PlyElement]
    lines: int
    size: int  # bytes


def read_ply_header(path: Path) -> PlyHeader:
    """Read the header of a .ply file.

    Raises
    ------
    ValueError: no .ply file, or a line that cannot be understood, named by its number.
    """
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
    elements: list[PlyElement] = []
    for number, line in enumerate(lines, 1):
        try:
            match line.split():
                case ["format", name, *_]:
                    format_name = name
                case ["element", name, count]:
                    if not 0 <= int(count) <= MOST_ROWS:
                        raise ValueError
                    elements.append(PlyElement(name, int(count)))
                case ["property", "list", counted_by, kind, name]:
                    listed = PlyProperty(name, _TYPES[kind], _TYPES[counted_by])
                    elements[-1].properties.append(listed)
                case ["property", kind, name]:
                    elements[-1].properties.append(PlyProperty(name, _TYPES[kind]))
        except (ValueError, KeyError, IndexError):
            raise ValueError(
                f"Line {number} of the header of {path.name} cannot be understood: '{line[:60]}'. "
                "Export the file again."
            ) from None
    if format_name not in ("ascii", *BYTE_ORDERS):
        raise ValueError(
            f"{path.name} has the format '{format_name}'; a .ply file is ascii, "
            "binary_little_endian or binary_big_endian. Export the file again."
        )
    return PlyHeader(format_name, elements, len(lines), size)


def split_at_vertices(header: PlyHeader, name: str) -> tuple[list[PlyElement], PlyElement]:
    """The elements before the vertices, and the vertices.

    Raises
    ------
    ValueError: no vertices, or vertices without x, y and z.
    """
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
