# SPDX-License-Identifier: LGPL-2.1-or-later
"""The manifest that FreeCAD's Addon Manager reads agrees with what is in this folder."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from urllib.parse import urlsplit
from xml.etree import ElementTree

import pytest

import freecad_edgescan
from freecad_edgescan.__main__ import main

FOLDER = Path(__file__).resolve().parents[1]


@pytest.fixture(scope="module")
def manifest() -> ElementTree.Element:
    """The manifest without its name space."""
    text = (FOLDER / "package.xml").read_text(encoding="utf-8")
    return ElementTree.fromstring(re.sub(r' xmlns="[^"]*"', "", text).partition("?>")[2])


@pytest.fixture(scope="module")
def project() -> dict:
    return tomllib.loads((FOLDER / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def test_the_version_is_that_of_the_package(manifest) -> None:
    assert manifest.findtext("version") == freecad_edgescan.__version__


def test_the_command_line_tells_the_version(manifest, capsys) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["--version"])
    assert ended.value.code == 0
    assert capsys.readouterr().out == f"EdgeScan {manifest.findtext('version')}\n"


def test_every_required_field_is_there(manifest) -> None:
    for field in ("name", "description", "date", "maintainer", "license", "icon", "content"):
        assert manifest.find(field) is not None, field
    assert re.fullmatch(r"[^@\s]+@[^@\s]+\.[a-z]+", manifest.find("maintainer").get("email"))


def test_every_file_it_names_exists_and_icons_are_small(manifest) -> None:
    assert (FOLDER / manifest.find("license").get("file")).is_file()
    for icon in manifest.iter("icon"):
        file = FOLDER / icon.text
        assert file.suffix == ".svg"
        assert file.stat().st_size <= 10_000


def test_the_workbench_is_the_class_that_is_registered(manifest) -> None:
    name = manifest.findtext("content/workbench/classname")
    assert f"addWorkbench({name}())" in (FOLDER / "InitGui.py").read_text(encoding="utf-8")


def test_what_it_depends_on_is_what_the_package_depends_on(manifest, project) -> None:
    named = {entry.text for entry in manifest.findall("depend[@type='python']")}
    assert named == {re.match(r"\w+", line)[0] for line in project["dependencies"]}
    assert project["requires-python"] == f">={manifest.findtext('pythonmin')}"


def test_all_addresses_are_of_one_repository(manifest, project) -> None:
    addresses = {entry.get("type"): entry.text for entry in manifest.findall("url")}
    assert {"repository", "readme", "bugtracker", "documentation"} <= addresses.keys()
    base = addresses["repository"]
    assert urlsplit(base).scheme == "https"
    assert all(other.startswith(base) for other in addresses.values())
    assert all(other.startswith(base) for other in project["urls"].values())
    assert "/raw/" in addresses["readme"]
