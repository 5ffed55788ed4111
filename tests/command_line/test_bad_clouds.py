# SPDX-License-Identifier: LGPL-2.1-or-later
"""A file or cloud that cannot be scanned is one sentence that names what is wrong with it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from .roof import complaint, roof


def test_a_missing_file_is_named(capsys, tmp_path: Path) -> None:
    assert "nowhere.ply" in complaint(capsys, "info", tmp_path / "nowhere.ply")


def test_an_empty_file_is_called_empty(capsys, tmp_path: Path) -> None:
    (tmp_path / "nothing.xyz").touch()
    said = complaint(capsys, "info", tmp_path / "nothing.xyz")
    assert "nothing.xyz" in said


def test_a_folder_is_no_cloud(capsys, tmp_path: Path) -> None:
    (tmp_path / "folder.xyz").mkdir()
    assert "folder.xyz" in complaint(capsys, "info", tmp_path / "folder.xyz")


def test_a_file_that_is_no_cloud_lists_what_is_readable(capsys, tmp_path: Path) -> None:
    (tmp_path / "part.doc").write_bytes(bytes(range(256)) * 20)
    said = complaint(capsys, "info", tmp_path / "part.doc")
    assert ".doc" in said
    assert ".ply" in said


@pytest.mark.parametrize("ending", ["xyz", "ply", "pcd"])
def test_a_wrongly_named_file_is_told(capsys, tmp_path: Path, ending: str) -> None:
    (tmp_path / f"part.{ending}").write_bytes(bytes(range(256)) * 20)
    assert f"part.{ending}" in complaint(capsys, "info", tmp_path / f"part.{ending}")


def test_text_among_the_numbers_is_told_with_its_line(capsys, tmp_path: Path) -> None:
    rows = ["1 2 3"] * 6 + ["1 two 3"] + ["4 5 6"] * 30
    (tmp_path / "typo.xyz").write_text("\n".join(rows))
    said = complaint(capsys, "info", tmp_path / "typo.xyz")
    assert "typo.xyz" in said
    assert "7" in said.replace(str(tmp_path), "")


def test_a_handful_of_points_is_no_surface(capsys, tmp_path: Path) -> None:
    np.savetxt(tmp_path / "few.xyz", roof()[:7])
    assert "7" in complaint(capsys, "info", tmp_path / "few.xyz").replace(str(tmp_path), "")
    assert "7" in complaint(capsys, "scan", tmp_path / "few.xyz", "--at", "0,0,0").replace(
        str(tmp_path), ""
    )


@pytest.mark.parametrize(
    "points",
    [
        np.ones((100, 3)),
        np.outer(np.arange(100.0), (1, 2, 3)),
        np.array([(x, y, 0.0) for x in range(20) for y in range(20)]),
    ],
    ids=["one place", "one line", "one plane"],
)
def test_a_cloud_without_an_edge_says_so(capsys, tmp_path: Path, points: np.ndarray) -> None:
    np.savetxt(tmp_path / "dull.xyz", points)
    complaint(capsys, "scan", tmp_path / "dull.xyz", "--at", "5,5,0")


@pytest.mark.parametrize("times", [4, 50])
@pytest.mark.parametrize("command", ["info", "find", "scan --at 5,5,5", "recommend --at 5,5,5"])
def test_points_that_are_there_many_times_are_said_to_be(
    capsys, tmp_path: Path, command: str, times: int
) -> None:
    places = np.random.default_rng(0).uniform(0.0, 10.0, (100, 3))
    np.savetxt(tmp_path / "again.xyz", np.repeat(places, times, axis=0))
    said = complaint(capsys, *command.split(), tmp_path / "again.xyz")
    assert f"there {times} times or more among its {100 * times} points" in said
    assert "once" in said
