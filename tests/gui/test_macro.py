# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is clicked is recorded, and replays without a window to the same result, bit for bit."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")

WRITE = """
with open({result!r}, "w") as file:
    for item in FreeCAD.ActiveDocument.Objects:
        shape = item.Shape.exportBrepToString() if hasattr(item, "Shape") else ""
        points = item.Points.Points if item.isDerivedFrom("Points::Feature") else ""
        file.write(f"{{item.Name}} {{shape}} {{points}}\\n")
"""
END = "import os\nos._exit(0)\n"


@pytest.mark.slow
def test_an_import_a_scan_and_a_thinned_cloud_replay_in_freecadcmd(
    workbench: Any, panels: list[Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from freecad_edgescan.gui.form_dialog import FormDialog
    from freecad_edgescan.gui.qt import QtWidgets

    from .conftest import Window, roof

    lines: list[str] = []
    run = Gui.doCommand
    monkeypatch.setattr(Gui, "doCommand", lambda line: (lines.append(line), run(line)))
    monkeypatch.setattr(FormDialog, "asked", lambda _: True)
    np.savetxt(tmp_path / "roof.xyz", roof())
    answer = ([str(tmp_path / "roof.xyz")], "")
    monkeypatch.setattr(QtWidgets.QFileDialog, "getOpenFileNames", lambda *_: answer)
    Gui.runCommand("EdgeScan_ImportCloud")
    window = Window(FreeCAD.ActiveDocument, panels)
    window.view.setAnimationEnabled(False)
    window.view.viewIsometric()
    window.view.fitAll()
    window.settle()
    Gui.runCommand("EdgeScan_ScanEdge")
    window.settle()
    window.click((0.0, 2.0, 5.0))
    window.wait_until(lambda: window.button("Ok").isEnabled())
    window.button("Ok").click()
    window.settle()
    Gui.Selection.clearSelection()
    Gui.runCommand("EdgeScan_ThinCloud")
    assert len(window.doc.Objects) == 3
    clicked, replayed, macro = (tmp_path / name for name in ("clicked", "replayed", "macro.py"))
    exec(WRITE.format(result=str(clicked)), {"FreeCAD": FreeCAD})
    FreeCAD.closeDocument(window.doc.Name)
    window.settle()

    text = "import FreeCAD\n" + "\n".join(lines) + WRITE.format(result=str(replayed)) + END
    assert "Gui" not in text
    macro.write_text(text)
    program = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    subprocess.run([str(program), str(macro)], timeout=120, capture_output=True, check=False)
    assert replayed.read_text() == clicked.read_text()
