# SPDX-License-Identifier: LGPL-2.1-or-later
from __future__ import annotations

import struct

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from freecad_edgescan.cloud import read_cloud

POINTS = [[1.5, -2.25, 3.0], [4.0, 5.125, -6.5], [700.0, 8.0, 9.0]]

LETTERS = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I"}
LETTERS |= {"float": "f", "double": "d", "float32": "f", "float64": "d", "uint8": "B"}


class Part:
    """An element of a .ply file: its name, typed properties and rows (lists as tuples)."""

    def __init__(self, name, properties, rows):
        self.name, self.properties, self.rows = name, properties, rows

    def header(self) -> str:
        kinds = (f"property {kind} {name}\n" for kind, name in self.properties)
        return f"element {self.name} {len(self.rows)}\n" + "".join(kinds)

    def ascii(self) -> bytes:
        return "".join(" ".join(self._words(row)) + "\n" for row in self.rows).encode()

    @staticmethod
    def _words(row):
        for value in row:
            if isinstance(value, tuple):
                yield str(len(value))
            yield from map(repr, value if isinstance(value, tuple) else (value,))

    def binary(self, order: str) -> bytes:
        packed = b""
        for row in self.rows:
            for (kind, _), value in zip(self.properties, row, strict=True):
                if kind.startswith("list"):
                    _, length, item = kind.split()
                    packed += struct.pack(order + LETTERS[length], len(value))
                    packed += struct.pack(f"{order}{len(value)}{LETTERS[item]}", *value)
                else:
                    packed += struct.pack(order + LETTERS[kind], value)
        return packed


def ply(form: str, *parts: Part) -> bytes:
    head = f"ply\nformat {form} 1.0\ncomment made up\n" + "".join(p.header() for p in parts)
    head += "end_header\n"
    if form == "ascii":
        return head.encode() + b"".join(part.ascii() for part in parts)
    order = "<" if form == "binary_little_endian" else ">"
    return head.encode() + b"".join(part.binary(order) for part in parts)


FORMS = ["ascii", "binary_little_endian", "binary_big_endian"]
VERTICES = Part("vertex", [("float", "x"), ("float", "y"), ("float", "z")], POINTS)
TRIANGLES = Part("face", [("list uchar int", "vertex_indices")], [((0, 1, 2),), ((2, 1, 0),)])
RAGGED = Part("face", [("list uchar int", "vertex_indices")], [((0, 1),), ((2, 1, 0),), ((),)])
CAMERA = Part("camera", [("float", "view"), ("uint", "width")], [(0.5, 640)])


def read(folder, data: bytes, name: str = "cloud.ply"):
    path = folder / name
    path.write_bytes(data)
    return read_cloud(path)


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize(
    "parts",
    [
        (VERTICES,),
        (VERTICES, TRIANGLES),
        (TRIANGLES, VERTICES),
        (RAGGED, CAMERA, VERTICES, TRIANGLES),
        (CAMERA, VERTICES),
    ],
)
def test_vertices_are_read_whatever_stands_before_and_after_them(tmp_path, form, parts):
    assert read(tmp_path, ply(form, *parts)).points.tolist() == POINTS


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("kind", ["float", "double", "float32", "float64", "int", "short"])
def test_coordinates_may_be_of_any_type_in_any_order_among_others(tmp_path, form, kind):
    whole = [[int(v) if LETTERS[kind] in "ih" else v for v in p] for p in POINTS]
    properties = [("uchar", "red"), (kind, "z"), (kind, "x"), ("ushort", "id"), (kind, "y")]
    rows = [(255, z, x, i, y) for i, (x, y, z) in enumerate(whole)]
    assert read(tmp_path, ply(form, Part("vertex", properties, rows))).points.tolist() == whole


@pytest.mark.parametrize("form", ["binary_little_endian", "binary_big_endian"])
@pytest.mark.parametrize("lists", [[(7,), (8,), (9,)], [(7, 7), (), (9,)]])
def test_vertices_that_carry_lists_are_read(tmp_path, form, lists):
    properties = [("float", "x"), ("list uint8 short", "seen"), ("float", "y"), ("float", "z")]
    rows = [(x, seen, y, z) for (x, y, z), seen in zip(POINTS, lists, strict=True)]
    part = Part("vertex", properties, rows)
    assert read(tmp_path, ply(form, part, TRIANGLES)).points.tolist() == POINTS


@pytest.mark.parametrize("form", FORMS)
def test_a_header_with_windows_line_ends_is_read(tmp_path, form):
    data = ply(form, VERTICES)
    head, tail = data.split(b"end_header\n")
    data = head.replace(b"\n", b"\r\n") + b"end_header\r\n" + tail
    assert read(tmp_path, data).points.tolist() == POINTS


def test_the_content_decides_over_the_ending(tmp_path):
    assert read(tmp_path, ply("ascii", VERTICES), "cloud.xyz").points.tolist() == POINTS
    assert read(tmp_path, b"1 2 3\n4 5 6\n", "cloud.ply").points.tolist() == [[1, 2, 3], [4, 5, 6]]


HEAD = "ply\nformat ascii 1.0\n"


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (b"solid of another kind\n", "does not begin with 'ply'"),
        (b"ply\nformat ascii 1.0\nelement vertex 3\n", "end_header"),
        (ply("ascii", Part("vertex", VERTICES.properties, [])), "promises 0 vertices"),
        (ply("ascii", TRIANGLES), "no element 'vertex'.*face"),
        (ply("ascii", Part("vertex", [("float", "x"), ("float", "u")], [(1, 2)])), "no y and no z"),
        (f"{HEAD}element vertex many\nend_header\n".encode(), "Line 3 .*element vertex many"),
        (f"{HEAD}element vertex 1\nproperty half x\nend_header\n".encode(), "Line 4 .*half"),
        (f"{HEAD}element vertex -1\nend_header\n".encode(), "Line 3 .*element vertex -1"),
        (
            ply("ascii", TRIANGLES, VERTICES).replace(b"face 2", b"face 99999999999"),
            "promises 3 points but ends after 0",
        ),
        (
            ply("binary_big_endian", RAGGED, VERTICES).replace(b"face 3", b"face 99999999999"),
            "promises 99999999999 rows of 'face' but ends after",
        ),
        (b"ply\nformat morse 1.0\nend_header\n", "'morse'"),
        (ply("ascii", VERTICES).replace(b"5.125", b"five"), r"Line 10 .*'five'"),
        (ply("ascii", VERTICES)[:-14], "promises 3 points but ends after 2"),
        (ply("binary_big_endian", VERTICES)[:-1], "promises 3 rows of 'vertex' but ends after 2"),
        (ply("binary_little_endian", RAGGED, VERTICES)[:-40], "'face' but ends after"),
        (ply("binary_little_endian", TRIANGLES)[:-9], "no element 'vertex'"),
    ],
)
def test_a_damaged_file_is_refused_with_the_reason(tmp_path, data, said):
    with pytest.raises(ValueError, match=said):
        read(tmp_path, data)


@given(
    data=st.data(),
    form=st.sampled_from(FORMS),
    points=st.lists(st.tuples(*[st.floats(-1e6, 1e6)] * 3), min_size=1, max_size=8),
)
def test_every_valid_file_gives_the_points_written(tmp_path_factory, data, form, points):
    others = data.draw(st.lists(st.sampled_from(["uchar", "short", "float", "double"]), max_size=4))
    names = data.draw(st.permutations([*"xyz", *(f"other{i}" for i in range(len(others)))]))
    kinds = {f"other{i}": kind for i, kind in enumerate(others)}
    properties = [(kinds.get(name, "double"), name) for name in names]
    rows = [[dict(zip("xyz", point, strict=True)).get(n, 1) for n in names] for point in points]
    around = data.draw(st.permutations([TRIANGLES, CAMERA, Part("vertex", properties, rows)]))
    path = tmp_path_factory.mktemp("ply") / "cloud.ply"
    path.write_bytes(ply(form, *around))
    assert np.array_equal(read_cloud(path).points, np.array(points))
