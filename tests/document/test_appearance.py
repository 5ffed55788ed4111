# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files written without a screen tell FreeCAD how their objects look."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree
from zipfile import ZipFile

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")

from freecad_edgescan.document.appearance import Look, write_appearance  # noqa: E402

BOX = ((0.0, 0.0, 0.0), (10.0, 20.0, 30.0))
LOOKS = {"Ball": Look(colour=(1.0, 0.0, 0.5), line_colour=(0.0, 0.0, 0.0), visible=False)}


@pytest.fixture
def file(doc, tmp_path: Path) -> Path:
    doc.addObject("Part::Sphere", "Ball")
    doc.recompute()
    path = tmp_path / "ball.FCStd"
    doc.saveAs(str(path))
    return path


def test_looks_are_written_by_name(file: Path) -> None:
    write_appearance(file, LOOKS, BOX, view=(1.0, -1.0, 1.0))
    root = ElementTree.fromstring(ZipFile(file).read("GuiDocument.xml"))
    (ball,) = root.iter("ViewProvider")
    assert ball.get("name") == "Ball"
    values = {item.get("name"): item[0].get("value") for item in ball.iter("Property")}
    assert values["Visibility"] == "false"
    assert int(values["ShapeColor"]) == 0xFF008000


def test_the_camera_looks_at_the_middle_of_the_box_with_z_upwards(file: Path) -> None:
    view = np.array([1.0, -1.0, 1.0]) / np.sqrt(3.0)
    write_appearance(file, LOOKS, BOX, view)
    settings = ElementTree.fromstring(ZipFile(file).read("GuiDocument.xml")).find("Camera")
    words = settings.get("settings").split()
    position, turn, distance = (
        np.array(words[words.index(name) + 1 :][:count], dtype=float)
        for name, count in (("position", 3), ("orientation", 4), ("focalDistance", 1))
    )
    rotation = FreeCAD.Rotation(FreeCAD.Vector(*turn[:3]), float(np.degrees(turn[3])))
    ahead = np.array(rotation.multVec(FreeCAD.Vector(0, 0, -1)))
    upwards = np.array(rotation.multVec(FreeCAD.Vector(0, 1, 0)))
    np.testing.assert_allclose(ahead, -view, atol=1e-6)
    np.testing.assert_allclose(position + distance * ahead, (5.0, 10.0, 15.0), atol=1e-3)
    assert upwards[2] > 0.0


def test_a_file_with_an_appearance_keeps_it(file: Path) -> None:
    write_appearance(file, LOOKS, BOX, view=(0.0, 0.0, 1.0))
    with pytest.raises(ValueError, match="already"):
        write_appearance(file, LOOKS, BOX, view=(0.0, 0.0, 1.0))
    assert ZipFile(file).namelist().count("GuiDocument.xml") == 1


def test_the_file_still_opens(file: Path) -> None:
    write_appearance(file, LOOKS, BOX, view=(0.0, 0.0, 1.0))
    again = FreeCAD.openDocument(str(file))
    assert again.getObject("Ball").Shape.isValid()
    FreeCAD.closeDocument(again.Name)
