# SPDX-License-Identifier: LGPL-2.1-or-later
from __future__ import annotations

import struct

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from freecad_edgescan.cloud import read_cloud
from freecad_edgescan.cloud.lzf import decompress_lzf

POINTS = [[1.5, -2.25, 3.0], [4.0, 5.125, -6.5], [700.0, 8.0, 9.0]]
FORMS = ["ascii", "binary", "binary_compressed"]


def compress(data: bytes) -> bytes:
    """A plain LZF packer: repeats of at least three bytes, found by their first three."""
    out, literal, seen, i = b"", b"", {}, 0

    def flush() -> bytes:
        pieces = (literal[k : k + 32] for k in range(0, len(literal), 32))
        return b"".join(bytes([len(piece) - 1]) + piece for piece in pieces)

    while i < len(data):
        start = seen.get(data[i : i + 3], -1)
        seen[data[i : i + 3]] = i
        if start < 0 or i - start > 8191 or i + 3 > len(data):
            literal += data[i : i + 1]
            i += 1
            continue
        length = 3
        while length < 264 and i + length < len(data) and data[start + length] == data[i + length]:
            length += 1
        out, literal = out + flush(), b""
        high, low = divmod(i - start - 1, 256)
        short = length - 2 < 7
        out += bytes([(length - 2) << 5 | high]) if short else bytes([7 << 5 | high, length - 9])
        out += bytes([low])
        i += length
    return out + flush()


def pcd(form: str, fields: list[tuple[str, str, int, int]], rows: list[list[tuple]]) -> bytes:
    """A .pcd file of fields (name, type letter, bytes, count), each row a tuple a field."""
    names, types, sizes, counts = (" ".join(str(f[k]) for f in fields) for k in range(4))
    head = (
        f"# .PCD v0.7\nVERSION 0.7\nFIELDS {names}\nSIZE {sizes}\nTYPE {types}\nCOUNT {counts}\n"
        f"WIDTH {len(rows)}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {len(rows)}\nDATA {form}\n"
    ).encode()
    if form == "ascii":
        return head + "".join(" ".join(repr(v) for t in r for v in t) + "\n" for r in rows).encode()
    letters = {"F4": "f", "F8": "d", "U1": "B", "U2": "H", "U4": "I", "I4": "i"}
    codes = [f"<{count}{letters[f'{letter}{size}']}" for _, letter, size, count in fields]
    cells = [[struct.pack(c, *t) for c, t in zip(codes, row, strict=True)] for row in rows]
    if form == "binary":
        return head + b"".join(b"".join(row) for row in cells)
    columns = b"".join(b"".join(column) for column in zip(*cells, strict=True))
    packed = compress(columns)
    return head + struct.pack("<II", len(packed), len(columns)) + packed


PLAIN = [("x", "F", 4, 1), ("y", "F", 4, 1), ("z", "F", 4, 1)]


def plain(form: str, points=POINTS) -> bytes:
    return pcd(form, PLAIN, [[(v,) for v in point] for point in points])


def read(folder, data: bytes, name: str = "cloud.pcd"):
    path = folder / name
    path.write_bytes(data)
    return read_cloud(path)


@pytest.mark.parametrize("form", FORMS)
def test_the_three_forms_of_pcd_give_the_same_points(tmp_path, form):
    assert read(tmp_path, plain(form)).points.tolist() == POINTS


@pytest.mark.parametrize("form", FORMS)
def test_fields_may_be_of_any_order_type_and_count(tmp_path, form):
    fields = [("_", "U", 1, 3), ("z", "F", 8, 1), ("rgb", "U", 4, 1), ("x", "F", 4, 1)]
    fields += [("_", "U", 1, 2), ("y", "F", 8, 1), ("normal", "F", 4, 3)]
    rows = [[(0, 0, 0), (z,), (7,), (x,), (0, 0), (y,), (0.0, 0.0, 1.0)] for x, y, z in POINTS]
    assert read(tmp_path, pcd(form, fields, rows)).points.tolist() == POINTS


@pytest.mark.parametrize("form", FORMS)
def test_points_the_sensor_missed_are_left_out_and_counted(tmp_path, form):
    with pytest.warns(UserWarning, match="1 of 4 points"):
        cloud = read(tmp_path, plain(form, [*POINTS, [float("nan")] * 3]))
    assert cloud.points.tolist() == POINTS


def test_a_file_is_known_by_its_content_and_an_old_header_is_understood(tmp_path):
    data = plain("binary").replace(b"FIELDS", b"COLUMNS").replace(b"POINTS 3\n", b"")
    data = data.replace(b"COUNT 1 1 1\n", b"")
    assert read(tmp_path, data, "cloud.dat").points.tolist() == POINTS


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (b"something else\n", "FIELDS and DATA"),
        (plain("ascii", []), "promises 0"),
        (plain("ascii").replace(b"FIELDS x y z", b"FIELDS x y w"), "no z"),
        (plain("ascii").replace(b"SIZE 4 4 4", b"SIZE 4 4"), "header .* cannot be understood"),
        (plain("ascii").replace(b"SIZE 4 4 4", b"SIZE 4 3 4"), "header .* cannot be understood"),
        (plain("ascii").replace(b"POINTS 3", b"POINTS x"), "header .* cannot be understood"),
        (plain("ascii").replace(b"DATA ascii", b"DATA morse"), "'morse'"),
        (plain("ascii").replace(b"5.125", b"five"), "Line 13 .*'five'"),
        (plain("ascii")[:-14], "promises 3 points but ends after 2"),
        (plain("binary")[:-1], "promises 3 points but ends after 2"),
        (plain("binary_compressed")[:-5], "cut off"),
        (plain("binary_compressed").replace(b"POINTS 3", b"POINTS 4"), "promises 48"),
    ],
)
def test_a_damaged_file_is_refused_with_the_reason(tmp_path, data, said):
    with pytest.raises(ValueError, match=said):
        read(tmp_path, data)


@given(
    form=st.sampled_from(FORMS),
    points=st.lists(st.tuples(*[st.floats(-1e6, 1e6, width=32)] * 3), min_size=1, max_size=20),
)
def test_every_valid_file_gives_the_points_written(tmp_path_factory, form, points):
    path = tmp_path_factory.mktemp("pcd") / "cloud.pcd"
    path.write_bytes(plain(form, points))
    assert np.array_equal(read_cloud(path).points, np.array(points))


@given(st.binary(max_size=400) | st.text("ab", max_size=900).map(str.encode))
def test_what_was_compressed_comes_back(data):
    assert decompress_lzf(compress(data), len(data)) == data


@given(st.binary(max_size=60))
def test_damaged_compression_is_an_error_and_never_anything_else(data):
    with pytest.raises(ValueError, match="damaged"):
        decompress_lzf(data, 100_000)
