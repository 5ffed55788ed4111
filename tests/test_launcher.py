# SPDX-License-Identifier: LGPL-2.1-or-later
"""The launcher: helps, refuses politely, and works from anywhere with the system's Python."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

LAUNCHER = Path(__file__).resolve().parents[1] / "edgescan"
COMMANDS = (
    *("demo", "gui", "install"),
    *("info", "scan", "recommend", "accuracy", "doe", "bench"),
    "test",
)


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
    for command in COMMANDS:
        assert f"\n    {command} " in answer.stdout


@pytest.mark.parametrize("command", COMMANDS)
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


def tools_without_freecad(folder: Path, **scripts: str) -> str:
    """A PATH on which there is no FreeCAD, of a user with a number other than root's."""
    for tool in ("bash", "cat", "dirname", "env", "mktemp", "readlink", "rm", "tail", "touch"):
        (folder / tool).symlink_to(str(shutil.which(tool)))
    for name, script in {"id": "echo 1000", **scripts}.items():
        (folder / name).write_text(f"#!{shutil.which('bash')}\n{script}\n")
        (folder / name).chmod(0o755)
    return str(folder)


def scan_to_step(cloud: Path, path: str) -> subprocess.CompletedProcess[str]:
    words = ("scan", cloud, "--at", "15,15,0", "-o", cloud.with_suffix(".step"))
    return run(*words, PATH=path, EDGESCAN_FREECAD_LIB="/nowhere")


def test_a_user_with_sudo_gets_what_is_missing_and_the_command_goes_on(
    tmp_path: Path, small_cloud: Path
) -> None:
    log = tmp_path / "log"
    sudo = f'echo "sudo $@" >>"{log}"; [ "$1" = -n ] || "$@"'
    (tools := tmp_path / "tools").mkdir()
    answer = scan_to_step(
        small_cloud, tools_without_freecad(tools, **{"sudo": sudo, "apt-get": "true"})
    )
    asked, updated, installed = log.read_text().splitlines()
    assert asked == "sudo -n true"
    assert updated.startswith("sudo apt-get update")
    assert "apt-get install" in installed
    assert installed.endswith(" freecad")
    said = answer.stderr.splitlines()
    assert said[0] == "edgescan: installing freecad (needed for writing STEP files)"
    assert "edge 1" in said[1]  # of a flat cloud: the command itself has the word
    assert answer.returncode == 2


@pytest.mark.parametrize("sudo", [{}, {"sudo": "exit 1"}], ids=["without sudo", "not allowed"])
def test_a_user_who_cannot_become_root_is_told_what_is_missing(
    tmp_path: Path, small_cloud: Path, sudo: dict[str, str]
) -> None:
    (tools := tmp_path / "tools").mkdir()
    path = tools_without_freecad(tools, **{"apt-get": f'touch "{tmp_path}/called"', **sudo})
    answer = scan_to_step(small_cloud, path)
    assert answer.returncode == 3
    assert "apt-get install freecad" in answer.stderr
    assert not (tmp_path / "called").exists()


def test_without_a_network_the_words_of_apt_and_a_way_out_are_shown(
    tmp_path: Path, small_cloud: Path
) -> None:
    (tools := tmp_path / "tools").mkdir()
    failing = "echo 'E: Failed to fetch http://deb.example/freecad.deb' >&2; exit 100"
    path = tools_without_freecad(tools, **{"sudo": '[ "$1" = -n ] || "$@"', "apt-get": failing})
    answer = scan_to_step(small_cloud, path)
    assert answer.returncode == 3
    assert "E: Failed to fetch" in answer.stderr
    assert "Check the network" in answer.stderr


def freecad_that_answers(folder: Path, data: Path | None) -> dict[str, str]:
    """Environment in which FreeCAD's Python module names a folder of data, or does not load."""
    (folder / "FreeCAD").mkdir(parents=True)
    (folder / "FreeCAD.so").touch()
    body = "raise ImportError" if data is None else f"return {str(data) + os.sep!r}"
    module = f"print('FreeCAD greets')\n\n\ndef getUserAppDataDir():\n    {body}\n"
    (folder / "FreeCAD" / "__init__.py").write_text(module)
    return {"EDGESCAN_FREECAD_LIB": str(folder)}


@pytest.mark.parametrize("version", ["", "v1-1", "v26-3"], ids=["up to 1.0", "1.1", "26.3"])
def test_install_asks_freecad_for_its_folder(tmp_path: Path, version: str) -> None:
    data = tmp_path / "home" / "FreeCAD" / version
    freecad = freecad_that_answers(tmp_path / "lib", data)
    for _ in range(2):
        answer = run("install", **home_at(tmp_path / "home"), **freecad)
        assert answer.returncode == 0, answer.stderr
    assert [link.parent.parent for link in tmp_path.rglob("Mod/EdgeScan")] == [data]
    assert (data / "Mod" / "EdgeScan").resolve() == LAUNCHER.parent


@pytest.mark.parametrize("answers", [True, False])
def test_install_serves_every_version_that_was_started_before(
    tmp_path: Path, answers: bool
) -> None:
    data = tmp_path / "FreeCAD"
    (data / "v1-1").mkdir(parents=True)
    freecad = freecad_that_answers(tmp_path / "lib", data if answers else None)
    answer = run("install", **home_at(tmp_path), **freecad)
    assert answer.returncode == 0, answer.stderr
    for folder in (data, data / "v1-1"):
        assert (folder / "Mod" / "EdgeScan").resolve() == LAUNCHER.parent


def test_install_mends_a_link_that_leads_nowhere(tmp_path: Path) -> None:
    assert run("install", **home_at(tmp_path)).returncode == 0
    (link,) = tmp_path.rglob("Mod/EdgeScan")
    link.unlink()
    link.symlink_to(tmp_path / "deleted checkout")
    assert run("install", **home_at(tmp_path)).returncode == 0
    assert link.resolve() == LAUNCHER.parent


def test_install_is_content_with_a_checkout_among_the_add_ons(tmp_path: Path) -> None:
    checkout = tmp_path / "FreeCAD" / "Mod" / "EdgeScan"
    checkout.mkdir(parents=True)
    shutil.copy(LAUNCHER, checkout)
    freecad = freecad_that_answers(tmp_path / "lib", tmp_path / "FreeCAD")
    answer = run("install", launcher=checkout / "edgescan", **home_at(tmp_path), **freecad)
    assert answer.returncode == 0, answer.stderr
    assert "already" in answer.stdout
    assert not checkout.is_symlink()


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


def test_an_option_that_pytest_does_not_know_is_named_before_anything_runs() -> None:
    if not list(LAUNCHER.parent.glob(".venv-*/installed")):
        pytest.skip("the development tools are not installed")
    answer = run("test", "tests/test_manifest.py", "--frob")
    assert answer.returncode == 2
    assert "--frob" in answer.stderr.splitlines()[-1]


def test_a_window_without_a_screen_is_refused_in_one_sentence() -> None:
    answer = run("gui", DISPLAY="", WAYLAND_DISPLAY="", QT_QPA_PLATFORM="")
    assert answer.returncode == 2
    assert len(answer.stderr.splitlines()) == 1
    assert "screen" in answer.stderr
