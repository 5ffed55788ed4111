# SPDX-License-Identifier: LGPL-2.1-or-later
"""The public API: complete by name, and free of charge until it is used."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import freecad_edgescan as es

REPOSITORY = Path(__file__).resolve().parents[1]


def modules_loaded_after(statement: str) -> set[str]:
    """Top-level modules a fresh interpreter holds after running a statement."""
    code = f"import sys; sys.path.insert(0, {str(REPOSITORY)!r}); {statement}; print(*sys.modules)"
    run = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60
    )
    return {name.split(".")[0] for name in run.stdout.split()}


@pytest.mark.parametrize(
    "statement",
    ["import freecad_edgescan", "import freecad_edgescan; dir(freecad_edgescan)"],
)
def test_importing_loads_neither_numpy_nor_scipy_nor_freecad_nor_qt(statement: str) -> None:
    heavy = {"numpy", "scipy", "matplotlib", "FreeCAD", "Part", "Points"}
    heavy |= {"PySide", "PySide2", "PySide6"}
    assert not heavy & modules_loaded_after(statement)


def test_the_command_line_shows_its_help_without_loading_numpy() -> None:
    statement = "import freecad_edgescan.__main__"
    assert not {"numpy", "scipy", "FreeCAD"} & modules_loaded_after(statement)


def test_numbers_are_scanned_without_freecad_or_qt() -> None:
    statement = "import freecad_edgescan as es; es.scan_edge, es.read_cloud, es.BSplineCurve"
    loaded = modules_loaded_after(statement)
    assert not {"FreeCAD", "Part", "Points", "PySide", "PySide2", "PySide6"} & loaded


# document needs FreeCAD and is tested there
@pytest.mark.parametrize("name", [name for name in es.__all__ if name != "document"])
def test_every_public_name_exists_and_is_documented(name: str) -> None:
    assert getattr(es, name).__doc__


def test_public_names_are_offered_to_completion() -> None:
    assert set(es.__all__) <= set(dir(es))
    assert "__version__" in dir(es)


def test_an_unknown_name_is_an_attribute_error_that_names_it() -> None:
    with pytest.raises(AttributeError, match="scan_hedge"):
        es.scan_hedge  # noqa: B018


def test_the_manifest_and_the_package_state_the_same_version() -> None:
    assert f"<version>{es.__version__}</version>" in (REPOSITORY / "package.xml").read_text()
    assert f"## {es.__version__}" in (REPOSITORY / "CHANGELOG.md").read_text()
