# SPDX-License-Identifier: LGPL-2.1-or-later
"""The launcher: helps, refuses politely, and works from anywhere with the system's Python."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

LAUNCHER = Path(__file__).resolve().parents[1] / "edgescan"


def run(*words: str | Path, launcher: Path = LAUNCHER, **environment: str):
    return subprocess.run(
        [str(word) for word in (launcher, *words)],
        capture_output=True,
        text=True,
        timeout=120,
        cwd="/",
        env={**os.environ, **environment},
    )


def home_at(folder: Path) -> dict[str, str]:
    """Environment in which FreeCAD keeps its settings and add-ons in a folder."""
    return dict.fromkeys(("HOME", "FREECAD_USER_HOME", "XDG_DATA_HOME"), str(folder))


@pytest.fixture
def small_cloud(tmp_path: Path) -> Path:
    """A flat grid of 30 x 30 points, 1 mm apart."""
    path = tmp_path / "flat cloud.xyz"
    rows = (f"{x} {y} {0.001 * ((x * 7 + y * 3) % 5)}" for x in range(30) for y in range(30))
    path.write_text("\n".join(rows) + "\n")
    return path


@pytest.mark.parametrize("words", [[], ["--help"], ["-h"], ["help"]])
def test_help_lists_every_command(words: list[str]) -> None:
    answer = run(*words)
    assert answer.returncode == 0
    for command in ("demo", "scan", "info", "bench", "install", "gui", "test"):
        assert f"\n    {command} " in answer.stdout


@pytest.mark.parametrize("command", ["demo", "scan", "info", "bench", "install", "gui", "test"])
def test_each_command_has_help_of_its_own(command: str) -> None:
    answer = run(command, "--help")
    assert answer.returncode == 0
    assert f"edgescan {command}" in answer.stdout


def test_an_unknown_command_is_named_and_refused() -> None:
    answer = run("skan")
    assert answer.returncode == 2
    assert "'skan'" in answer.stderr
    assert "--help" in answer.stderr


def test_it_works_through_a_symlink_from_another_folder(tmp_path: Path, small_cloud: Path) -> None:
    link = tmp_path / "a link with blanks"
    link.symlink_to(LAUNCHER)
    answer = run("info", small_cloud, launcher=link)
    assert answer.returncode == 0, answer.stderr
    assert "900" in answer.stdout


def test_it_works_in_a_folder_with_blanks(tmp_path: Path, small_cloud: Path) -> None:
    copy = tmp_path / "a copy with blanks"
    copy.mkdir()
    shutil.copy(LAUNCHER, copy)
    shutil.copytree(LAUNCHER.parent / "freecad_edgescan", copy / "freecad_edgescan")
    answer = run("info", small_cloud, launcher=copy / "edgescan")
    assert answer.returncode == 0, answer.stderr


def test_another_python_on_the_path_is_not_used(tmp_path: Path, small_cloud: Path) -> None:
    impostor = tmp_path / "python3"
    impostor.write_text("#!/bin/sh\nexit 99\n")
    impostor.chmod(0o755)
    answer = run("info", small_cloud, PATH=f"{tmp_path}:{os.environ['PATH']}")
    assert answer.returncode == 0, answer.stderr


def test_what_cannot_be_installed_is_listed_and_nothing_runs(tmp_path: Path) -> None:
    for tool in ("bash", "readlink", "dirname", "id", "env"):
        (tmp_path / tool).symlink_to(str(shutil.which(tool)))
    answer = run("demo", PATH=str(tmp_path), EDGESCAN_FREECAD_LIB="/nowhere")
    assert answer.returncode == 3
    assert "freecad" in answer.stderr
    assert "apt-get install" in answer.stderr


def test_install_links_the_checkout_where_freecad_looks_for_it(tmp_path: Path) -> None:
    answer = run("install", **home_at(tmp_path))
    assert answer.returncode == 0, answer.stderr
    (link,) = tmp_path.rglob("Mod/EdgeScan")
    assert link.is_symlink()
    assert link.resolve() == LAUNCHER.parent
    again = run("install", **home_at(tmp_path))
    assert again.returncode == 0, again.stderr


def test_install_never_replaces_a_real_folder(tmp_path: Path) -> None:
    assert run("install", **home_at(tmp_path)).returncode == 0
    (link,) = tmp_path.rglob("Mod/EdgeScan")
    link.unlink()
    (link / "somebody's").mkdir(parents=True)
    answer = run("install", **home_at(tmp_path))
    assert answer.returncode == 1
    assert "not replaced" in answer.stderr
    assert (link / "somebody's").is_dir()


def test_testing_a_file_that_is_not_there_is_refused() -> None:
    answer = run("test", "tests/cloud/test_nothing.py")
    assert answer.returncode == 2
    assert "tests/cloud/test_nothing.py" in answer.stderr
