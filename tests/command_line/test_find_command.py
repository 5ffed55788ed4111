# SPDX-License-Identifier: LGPL-2.1-or-later
"""``edgescan find``: what it says, its exit code, and numbers that agree in all its files."""

from __future__ import annotations

import csv
import re
from pathlib import Path

import numpy as np
import pytest

from freecad_edgescan.__main__ import main
from freecad_edgescan.scanning import EdgeNetwork, find_edges
from freecad_edgescan.scanning.errors import ScanError

SIZE, PITCH, NOISE = np.array([20.0, 14.0, 9.0]), 0.5, 0.02


def box_points() -> np.ndarray:
    """The six faces of a box with a corner in the origin, strewn with points."""
    rng = np.random.default_rng(2)
    faces = []
    for axis in range(3):
        for place in (0.0, SIZE[axis]):
            others = np.delete(SIZE, axis)
            count = round(float(np.prod(others)) / PITCH**2)
            face = np.insert(rng.uniform(0.0, others, (count, 2)), axis, place, axis=1)
            face[:, axis] += rng.normal(0.0, NOISE, count)
            faces.append(face)
    return np.vstack(faces)


def sphere_points() -> np.ndarray:
    normals = np.random.default_rng(0).normal(size=(8000, 3))
    return 10.0 * normals / np.linalg.norm(normals, axis=1)[:, None]


@pytest.fixture(scope="module")
def box_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("box") / "box.xyz"
    np.savetxt(path, box_points())
    return path


@pytest.fixture(scope="module")
def sphere_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("sphere") / "sphere.xyz"
    np.savetxt(path, sphere_points())
    return path


def rows_of(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def place(row: dict[str, str]) -> np.ndarray:
    return np.array([float(row[f"{axis}_mm"]) for axis in "xyz"])


def test_numbers_of_edges_and_corners_are_the_same_everywhere(capsys, box_file: Path) -> None:
    folder = box_file.parent
    words = ["--csv", folder / "edges.csv", "--corners", folder / "corners.csv"]
    assert main(["find", str(box_file), *map(str, words)]) == 0
    table = [line for line in capsys.readouterr().out.splitlines() if " corner " in line]
    edges, corners = rows_of(folder / "edges.csv"), rows_of(folder / "corners.csv")
    assert len(table) == 12 and len(corners) == 8
    for corner in corners:
        truth = SIZE * (place(corner) > 0.5 * SIZE)
        assert np.linalg.norm(place(corner) - truth) < PITCH
        numbers = corner["edges"].split()
        assert len(numbers) == 3
        for number in numbers:
            assert f"corner {corner['corner']} " in table[int(number) - 1] + " "
            points = np.array([place(row) for row in edges if row["edge"] == number])
            # Another corner is farther off than half of the shortest side.
            assert np.linalg.norm(points - truth, axis=1).min() < 0.5 * SIZE.min()


def test_edges_of_a_step_file_stand_in_the_order_of_the_table(capsys, box_file: Path) -> None:
    pytest.importorskip("FreeCAD")
    import Part

    step, table = box_file.parent / "edges.step", box_file.parent / "ordered.csv"
    assert main(["find", str(box_file), "-o", str(step), "--csv", str(table)]) == 0
    shape = Part.Shape()
    shape.read(str(step))
    assert len(shape.Edges) == 12
    for number, edge in enumerate(shape.Edges, 1):
        points = [place(row) for row in rows_of(table) if row["edge"] == str(number)]
        away = [edge.distToShape(Part.Vertex(*point))[0] for point in points]
        assert max(away) < PITCH


def test_where_no_edge_is_found_the_exit_code_and_a_sentence_say_that_nothing_was_written(
    capsys, sphere_file: Path
) -> None:
    table = sphere_file.parent / "s.csv"
    assert main(["find", str(sphere_file), "--csv", str(table)]) == 2
    said = capsys.readouterr()
    assert said.out == "" and not table.exists()
    assert "No edge was found" in said.err
    assert said.err.endswith(f"Nothing was written into {table}.\n")


def test_edges_that_are_all_shorter_than_wanted_are_not_called_smooth(
    capsys, box_file: Path
) -> None:
    assert main(["find", str(box_file), "--min-length", "1000"]) == 2
    said = capsys.readouterr().err
    longest = re.search(r"12 edges were found, the longest of (\S+) mm", said)
    assert longest is not None
    assert float(longest[1]) == pytest.approx(SIZE.max(), abs=2.0 * PITCH)
    assert "the least length is 1000 mm" in said and "smooth" not in said


@pytest.mark.parametrize("angle", ["200", "0", "-5", "nan"])
def test_a_least_angle_that_is_none_is_said_in_degrees(capsys, box_file: Path, angle: str) -> None:
    assert main(["find", str(box_file), "--min-angle", angle]) == 2
    said = capsys.readouterr().err
    assert f"--min-angle is {angle}°" in said and "rad" not in said


def test_python_says_the_least_angle_in_rad_and_in_degrees() -> None:
    from freecad_edgescan.cloud import PointCloud

    with pytest.raises(ScanError, match=r"4 rad \(229\.183°\); give one between 0 and pi in rad"):
        find_edges(PointCloud(box_points()), min_angle=4.0)
    with pytest.raises(ScanError, match=r"find_edges needs a PointCloud .* ndarray"):
        find_edges(box_points())


def test_one_edge_is_not_several(capsys, tmp_path: Path) -> None:
    points = box_points()
    np.savetxt(tmp_path / "roof.xyz", points[(points[:, 0] < 10) & (points[:, 1] < 7)])
    region = ["--region", "-1,2,-1", "21,12,4"]  # round the edge x = 0, z = 0
    assert main(["find", str(tmp_path / "roof.xyz"), *region]) == 0
    assert "1 edge of" in capsys.readouterr().out


def test_the_numbers_are_drawn_beside_the_edges(box_file: Path, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    from freecad_edgescan.cloud import read_cloud
    from freecad_edgescan.experiments import draw_edges

    network: EdgeNetwork = find_edges(read_cloud(box_file))
    picture = tmp_path / "net.svg"
    import matplotlib as mpl

    with mpl.rc_context({"svg.fonttype": "none"}):
        draw_edges(network.cloud, network.edges, picture, numbered=True)
    drawn = picture.read_text(encoding="utf-8")
    assert all(f">{number}</text>" in drawn for number in range(1, 13))
