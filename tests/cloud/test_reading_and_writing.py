# SPDX-License-Identifier: LGPL-2.1-or-later
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from freecad_edgescan.cloud import PointCloud, read_cloud, write_cloud

COORDINATE = st.floats(-1e9, 1e9, allow_subnormal=True)


@pytest.mark.parametrize("ending", [".xyz", ".ply", ".XYZ"])
@given(points=st.lists(st.tuples(COORDINATE, COORDINATE, COORDINATE), min_size=1, max_size=10))
def test_what_is_written_reads_back_bit_for_bit(tmp_path_factory, ending, points):
    path = tmp_path_factory.mktemp("cloud") / f"cloud{ending}"
    write_cloud(PointCloud(points), path)
    assert np.array_equal(read_cloud(path).points, np.array(points))


def test_a_long_cloud_is_written_in_full(tmp_path):
    points = np.random.default_rng(0).normal(size=(150_000, 3)) * 1e4
    write_cloud(PointCloud(points), tmp_path / "cloud.xyz")
    assert np.array_equal(read_cloud(tmp_path / "cloud.xyz").points, points)


def test_probe_radius_and_approach_go_with_the_cloud(tmp_path):
    path = tmp_path / "cloud.xyz"
    path.write_text("1 2 3\n")
    cloud = read_cloud(str(path), probe_radius=1.0, approach=(0, 0, -2))
    assert cloud.probe_radius == 1.0
    assert cloud.approach.tolist() == [0, 0, -1]


def test_only_points_in_the_region_are_kept(tmp_path):
    path = tmp_path / "cloud.xyz"
    path.write_text("".join(f"{i} {i} 0\n" for i in range(10)))
    cloud = read_cloud(path, region=((2, 0, -1), (5, 9, 1)))
    assert cloud.points[:, 0].tolist() == [2, 3, 4, 5]


@pytest.mark.parametrize(
    ("region", "said"),
    [
        (((5, 5, 5), (6, 6, 6)), r"\(0, 0, 0\) to \(9, 9, 0\)"),
        (((1, 1, 1), (0, 0, 0)), "no box"),
        ((1, 2, 3), "no box"),
        ("here", "no box"),
    ],
)
def test_a_region_without_points_or_that_is_no_box_is_refused(tmp_path, region, said):
    path = tmp_path / "cloud.xyz"
    path.write_text("".join(f"{i} {i} 0\n" for i in range(10)))
    with pytest.raises(ValueError, match=said):
        read_cloud(path, region=region)


@pytest.mark.parametrize("name", ["cloud.xyz", "cloud.ply", "cloud.pcd", "cloud.stl", "cloud"])
def test_an_empty_a_missing_file_and_a_folder_are_refused_by_name(tmp_path, name):
    path = tmp_path / name
    with pytest.raises(ValueError, match=rf"no file .*{name}"):
        read_cloud(path)
    path.write_bytes(b"")
    with pytest.raises(ValueError, match=rf"{name} is empty"):
        read_cloud(path)
    path.unlink()
    path.mkdir()
    with pytest.raises(ValueError, match=rf"{name} is a folder"):
        read_cloud(path)


@pytest.mark.parametrize("name", ["cloud.pts", "cloud.dat", "cloud", "cloud.ply", "cloud.PCD"])
def test_a_table_of_points_is_read_whatever_it_is_called(tmp_path, name):
    path = tmp_path / name
    path.write_text("2\n1 2 3 0.5\n4 5 6 0.5\n")
    assert read_cloud(path).points.tolist() == [[1, 2, 3], [4, 5, 6]]


@pytest.mark.parametrize(
    ("name", "data"),
    [
        ("part.stl", b"solid part\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"),
        ("part.obj", b"v 0 0 0\nv 1 0 0\nf 1 2 3\n"),
        ("part.off", b"OFF\n8 6 12\n0 0 0\n"),
        ("part.step", b"ISO-10303-21;\nHEADER;\n"),
        ("part.e57", b"ASTM-E57\x01\x00\x00\x00"),
        ("part", b"\x7fELF\x00\x01\x02"),
    ],
)
def test_other_formats_are_refused_with_the_endings_that_can_be_read(tmp_path, name, data):
    (tmp_path / name).write_bytes(data)
    with pytest.raises(ValueError, match=r"\.xyz, \.txt, \.asc, \.csv, \.ply, \.pcd.*FreeCAD"):
        read_cloud(tmp_path / name)


@pytest.mark.parametrize("name", ["cloud.pcd", "cloud.stl", "cloud"])
def test_writing_under_another_ending_is_refused(tmp_path, name):
    with pytest.raises(ValueError, match=rf"'{name}'.*\.xyz or \.ply"):
        write_cloud(PointCloud([[1, 2, 3]]), tmp_path / name)


@pytest.mark.parametrize("name", ["nowhere/cloud.xyz", "nowhere/cloud.ply"])
def test_writing_into_a_folder_that_is_not_there_is_refused(tmp_path, name):
    with pytest.raises(ValueError, match="cannot be written"):
        write_cloud(PointCloud([[1, 2, 3]]), tmp_path / name)


@pytest.mark.parametrize(("unit", "length"), [("mm", 1.0), ("m", 1000.0), ("inch", 25.4)])
def test_numbers_of_another_unit_become_mm(tmp_path: Path, unit: str, length: float) -> None:
    (tmp_path / "three.xyz").write_text("1 2 3\n4 5 6\nnan 8 9\n")
    with pytest.warns(UserWarning, match="1 of 3"):
        cloud = read_cloud(tmp_path / "three.xyz", unit=unit)
    assert cloud.points.tolist() == pytest.approx(length * np.array([[1, 2, 3], [4, 5, 6]]))


def test_an_unknown_unit_is_refused_with_those_that_are_known(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"'ell'.*inch"):
        read_cloud(tmp_path / "three.xyz", unit="ell")
