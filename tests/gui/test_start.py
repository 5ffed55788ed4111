# SPDX-License-Identifier: LGPL-2.1-or-later
"""Starting costs nothing, and a missing SciPy is said: tried in a FreeCAD of its own."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("FreeCADGui")

import freecad_edgescan

pytestmark = pytest.mark.slow

SCRIPT = '''
import json
import os
import sys

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

HEAVY = ("numpy", "scipy", "matplotlib", "Part", "Points", "pivy", "freecad_edgescan.document")


class NoScipy:
    """As if SciPy were not installed."""

    def find_spec(self, name, path=None, target=None):
        if name == "scipy":
            raise ModuleNotFoundError("No module named 'scipy'", name="scipy")


def loaded():
    return [name for name in HEAVY if name in sys.modules]


seen = {"at start": loaded(), "said": {}}


def try_everything():
    try:
        Gui.activateWorkbench("EdgeScanWorkbench")
        seen["in the workbench"] = loaded()
        sys.meta_path.insert(0, NoScipy())
        said = []
        QtGui.QMessageBox.warning = lambda _parent, _title, text, *_: said.append(text)
        QtGui.QFileDialog.getOpenFileNames = lambda *_: ([sys.argv[0]], "")
        for name in ("EdgeScan_ImportCloud", "EdgeScan_TryIt"):
            Gui.runCommand(name)
            seen["said"][name] = list(said)
            said.clear()
        doc = FreeCAD.newDocument("Doc")
        doc.addObject("Points::Feature", "Cloud")
        Gui.runCommand("EdgeScan_ScanEdge")
        seen["said"]["EdgeScan_ScanEdge"] = list(said)
        seen["documents"] = len(FreeCAD.listDocuments())
        FreeCAD.closeDocument(doc.Name)
    except BaseException as error:
        seen["error"] = repr(error)
    with open(os.environ["EDGESCAN_SEEN"], "w") as file:
        json.dump(seen, file)
    os._exit(0)


QtCore.QTimer.singleShot(1000, try_everything)
'''


@pytest.fixture(scope="module")
def seen(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """What a FreeCAD without SciPy has loaded and said."""
    home = tmp_path_factory.mktemp("home")
    (home / "Mod").mkdir()
    (home / "Mod" / "EdgeScan").symlink_to(Path(freecad_edgescan.__file__).resolve().parents[1])
    config = (Path(os.environ["FREECAD_USER_HOME"]) / "user.cfg").read_text()
    (home / "user.cfg").write_text(config.replace("EdgeScanWorkbench", "PartWorkbench"))
    (home / "try_everything.py").write_text(SCRIPT)
    environment = {
        **os.environ,
        "FREECAD_USER_HOME": str(home),
        "EDGESCAN_SEEN": str(home / "seen.json"),
    }
    subprocess.run(
        [sys.executable, "-u", str(home / "user.cfg"), str(home / "try_everything.py")],
        env=environment,
        timeout=120,
        capture_output=True,
        check=False,
    )
    return dict(json.loads((home / "seen.json").read_text()))


def test_start_and_workbench_load_nothing_heavy(seen: dict[str, Any]) -> None:
    ours = {"numpy", "scipy", "matplotlib", "freecad_edgescan.document"}
    assert "error" not in seen
    assert not ours & set(seen["at start"])
    assert not ours & set(seen["in the workbench"])


@pytest.mark.parametrize("name", ["EdgeScan_ImportCloud", "EdgeScan_TryIt", "EdgeScan_ScanEdge"])
def test_without_scipy_one_sentence_says_the_way_out(seen: dict[str, Any], name: str) -> None:
    (sentence,) = seen["said"][name]
    assert "scipy" in sentence
    assert "apt install python3-scipy" in sentence


def test_without_scipy_nothing_is_left_behind(seen: dict[str, Any]) -> None:
    assert seen["documents"] == 1
