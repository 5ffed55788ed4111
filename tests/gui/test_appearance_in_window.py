# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a file written without a screen says about looks is what a window shows."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from zipfile import ZipFile

import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")

from freecad_edgescan.document.appearance import Look, write_appearance  # noqa: E402


def test_objects_open_as_visible_and_coloured_as_written(window: Any, tmp_path: Path) -> None:
    ball = window.doc.addObject("Part::Sphere", "Ball")
    box = window.doc.addObject("Part::Box", "Box")
    window.doc.recompute()
    names = ball.Name, box.Name
    full, bare = tmp_path / "full.FCStd", tmp_path / "bare.FCStd"
    window.doc.saveAs(str(full))
    FreeCAD.closeDocument(window.doc.Name)
    with ZipFile(full) as source, ZipFile(bare, "w") as target:
        for member in source.namelist():
            if member != "GuiDocument.xml" and "Color" not in member:
                target.writestr(member, source.read(member))
    blue = Look(colour=(0.0, 0.0, 1.0), line_colour=(1.0, 0.0, 0.0), line_width=5.0)
    looks = {names[0]: blue, names[1]: Look(colour=(0.0, 1.0, 0.0), visible=False)}
    write_appearance(bare, looks, ((0, 0, 0), (10, 10, 10)), view=(0.0, -1.0, 1.0))
    doc = FreeCAD.openDocument(str(bare))
    shown, hidden = (doc.getObject(name).ViewObject for name in names)
    assert shown.Visibility and not hidden.Visibility
    assert shown.ShapeColor[:3] == (0.0, 0.0, 1.0)
    assert shown.LineColor[:3] == (1.0, 0.0, 0.0)
    assert shown.LineWidth == 5.0
    FreeCAD.closeDocument(doc.Name)
