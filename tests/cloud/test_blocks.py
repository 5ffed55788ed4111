# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files read in blocks: the same cloud whatever the size of a block, and no more in memory."""

from __future__ import annotations

import tracemalloc
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from freecad_edgescan import PointCloud, write_cloud
from freecad_edgescan.cloud import read_cloud
from freecad_edgescan.cloud.growing_points import GrowingPoints
from freecad_edgescan.cloud.reading import cloud_blocks

# float32 holds them exactly, and no two are equal
POINTS = np.random.default_rng(0).integers(-4000, 4000, (53, 3)) / 8.0
REGION = ((-300.0, -200.0, -400.0), (250.0, 400.0, 350.0))
INSIDE = ((np.array(REGION[0]) <= POINTS) & (np.array(REGION[1]) >= POINTS)).all(axis=1)

Writer = Callable[[Path], None]


def table(*before: str, floats: str = "<f4", after: tuple[str, ...] = ()) -> np.ndarray:
    """Points as rows with other fields of a byte before and after their coordinates."""
    names = [*before, "x", "y", "z", *after]
    kinds = [floats if name in "xyz" else "u1" for name in names]
    rows = np.zeros(len(POINTS), np.dtype(list(zip(names, kinds, strict=True))))
    for axis, values in zip("xyz", POINTS.T, strict=True):
        rows[axis] = values
    return rows


def lines(row: Callable[[np.ndarray], str]) -> str:
    return "".join(row(point) + "\n" for point in POINTS)


def text(path: Path) -> None:
    path.write_text("# scanned\n" + lines(lambda p: f"{p[0]} {p[1]} {p[2]} 7") + "\n# end\n")


def decimal_commas(path: Path) -> None:
    path.write_text(lines(lambda p: ";".join(str(x).replace(".", ",") for x in p)))


def named_columns(path: Path) -> None:
    path.write_text("z,id,x,y\n" + lines(lambda p: f"{p[2]},1,{p[0]},{p[1]}"))


def ply_header(form: str, properties: str, before: str = "", after: str = "") -> bytes:
    vertex = f"element vertex {len(POINTS)}\n{properties}"
    return f"ply\nformat {form} 1.0\n{before}{vertex}{after}end_header\n".encode()


XYZ = "property float x\nproperty float y\nproperty float z\n"


def ascii_ply(path: Path) -> None:
    after = "element face 1\nproperty list uchar int vertex_indices\n"
    body = lines(lambda p: f"{p[0]} {p[1]} {p[2]}") + "3 0 1 2\n"
    path.write_bytes(ply_header("ascii", XYZ, after=after) + body.encode())


def big_endian_ply(path: Path) -> None:
    properties = "property uchar red\n" + XYZ.replace("float", "double") + "property uchar blue\n"
    rows = table("red", floats=">f8", after=("blue",))
    path.write_bytes(ply_header("binary_big_endian", properties) + rows.tobytes())


def ply_behind_faces(path: Path) -> None:
    before = "element face 2\nproperty list uchar int vertex_indices\n"
    faces = b"".join(bytes([n]) + np.arange(n, dtype="<i4").tobytes() for n in (3, 5))
    head = ply_header("binary_little_endian", XYZ, before=before)
    path.write_bytes(head + faces + table().tobytes())


def ply_with_lists(path: Path) -> None:
    properties = XYZ + "property list uchar uchar seen_by\n"
    rows = (row.tobytes() + bytes([k % 3, *range(k % 3)]) for k, row in enumerate(table()))
    path.write_bytes(ply_header("binary_little_endian", properties) + b"".join(rows))


def pcd_header(form: str) -> bytes:
    return (
        "VERSION .7\nFIELDS ring x y z\nSIZE 1 4 4 4\nTYPE U F F F\nCOUNT 1 1 1 1\n"
        f"WIDTH {len(POINTS)}\nHEIGHT 1\nPOINTS {len(POINTS)}\nDATA {form}\n"
    ).encode()


def ascii_pcd(path: Path) -> None:
    body = lines(lambda p: f"4 {p[0]} {p[1]} {p[2]}")
    path.write_bytes(pcd_header("ascii") + body.encode())


def binary_pcd(path: Path) -> None:
    path.write_bytes(pcd_header("binary") + table("ring").tobytes())


def compressed_pcd(path: Path) -> None:
    rows = table("ring")
    columns = b"".join(rows[name].tobytes() for name in ("ring", "x", "y", "z"))
    pieces = (columns[k : k + 32] for k in range(0, len(columns), 32))
    packed = b"".join(bytes([len(piece) - 1]) + piece for piece in pieces)  # literals only
    sizes = np.array([len(packed), len(columns)], "<u4").tobytes()
    path.write_bytes(pcd_header("binary_compressed") + sizes + packed)


FILES = {
    "cloud.xyz": text,
    "commas.csv": decimal_commas,
    "named.txt": named_columns,
    "ascii.ply": ascii_ply,
    "big.ply": big_endian_ply,
    "faces.ply": ply_behind_faces,
    "lists.ply": ply_with_lists,
    "ascii.pcd": ascii_pcd,
    "binary.pcd": binary_pcd,
    "compressed.pcd": compressed_pcd,
}


@pytest.fixture(params=FILES.items(), ids=lambda item: item[0])
def file(request, tmp_path) -> Path:
    name, write = request.param
    path = tmp_path / name
    write(path)
    return path


@pytest.mark.parametrize("rows", [1, 7, 53, 54])
def test_blocks_of_any_size_are_the_cloud(file, rows):
    blocks = list(cloud_blocks(file, rows))
    assert np.array_equal(np.concatenate([block.points for block in blocks]), POINTS)
    assert max(len(block.points) for block in blocks) <= rows
    shares = [block.share for block in blocks]
    assert shares == sorted(shares)
    assert shares[0] > 0.0
    assert shares[-1] <= 1.0


def test_a_region_keeps_exactly_the_points_in_it(file):
    assert 0 < np.count_nonzero(INSIDE) < len(POINTS)
    assert np.array_equal(read_cloud(file, region=REGION).points, POINTS[INSIDE])


def test_points_on_the_faces_of_a_region_are_in_it(file):
    corner = tuple(POINTS[11].tolist())
    assert np.array_equal(read_cloud(file, region=(corner, corner)).points, POINTS[11:12])


def test_a_region_is_mm_whatever_the_unit_of_the_file(tmp_path):
    path = tmp_path / "metres.xyz"
    path.write_text("0.001 0 0\n0.002 0 0\n0.003 0 0\n")
    cloud = read_cloud(path, region=((1.5, -1, -1), (9, 1, 1)), unit="m")
    assert cloud.points[:, 0].tolist() == [2.0, 3.0]


def test_an_empty_region_is_said_with_the_cloud_s_own_box(file):
    low, high = (
        ", ".join(f"{x:.6g}" for x in corner) for corner in (POINTS.min(axis=0), POINTS.max(axis=0))
    )
    with pytest.raises(ValueError, match="Take a region that overlaps the cloud") as refused:
        read_cloud(file, region=((600, 600, 600), (700, 700, 700)))
    assert str(refused.value) == (
        f"No point of {file.name}, which reaches from ({low}) to ({high}), lies in the region "
        "(600, 600, 600) to (700, 700, 700). Take a region that overlaps the cloud."
    )


def test_rows_without_numbers_do_not_hide_that_a_region_is_empty(tmp_path):
    path = tmp_path / "cloud.xyz"
    path.write_text("nan nan nan\n1 2 3\n4 5 6\n")
    with pytest.raises(ValueError, match=r"from \(1, 2, 3\) to \(4, 5, 6\), lies"):
        read_cloud(path, region=((7, 7, 7), (8, 8, 8)))


@pytest.mark.parametrize("size", [1, 5, 1000])
def test_what_grows_holds_what_was_appended(size):
    points = np.arange(3000.0).reshape(-1, 3)
    growing = GrowingPoints()
    for first in range(0, len(points), size):
        growing.append(points[first : first + size])
    assert len(growing) == len(points)
    taken = growing.taken()
    assert np.array_equal(taken, points)
    assert not taken.flags.writeable
    assert len(growing) == 0


def peak_of(task: Callable[[], object]) -> int:
    """Most bytes that Python and numpy held at a time meanwhile; a mapped file is none of them."""
    tracemalloc.start()
    try:
        task()
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


LARGE = 1_200_000  # points
BLOCK = 100_000 * 125  # bytes that five arrays of a block take, 24 bytes a point each


@pytest.fixture(scope="module")
def large(tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("large") / "cloud.ply"
    points = np.random.default_rng(0).uniform(0.0, 100.0, (LARGE, 3))
    write_cloud(PointCloud(points), path)
    return path


def test_a_cloud_is_in_memory_once_when_it_is_read(large):
    # three doubles of 8 bytes; the array grows by a quarter at a time
    assert peak_of(lambda: read_cloud(large)) < 1.25 * 24 * LARGE + BLOCK


def test_of_a_cloud_of_which_a_region_is_kept_no_more_than_a_block_is_in_memory(large):
    assert BLOCK < 24 * LARGE / 2
    assert peak_of(lambda: read_cloud(large, region=((0, 0, 0), (10, 10, 10)))) < BLOCK


def test_an_array_that_nobody_can_change_is_not_copied():
    own = np.random.default_rng(0).uniform(0.0, 1.0, (100, 3))
    copied = PointCloud(own)
    own[0] = 5.0
    assert copied.points[0].max() < 5.0
    own.setflags(write=False)
    assert PointCloud(own).points is own
    view = own[:50]
    assert PointCloud(view).points is not view
