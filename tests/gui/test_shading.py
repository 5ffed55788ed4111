# SPDX-License-Identifier: LGPL-2.1-or-later
"""An imported cloud shows its shape."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")


def test_two_sides_that_face_the_light_differently_are_told_apart(
    window: Any, tmp_path: Path
) -> None:
    from freecad_edgescan import document
    from freecad_edgescan.cloud import read_cloud
    from freecad_edgescan.gui.import_cloud_command import import_clouds

    (first,) = window.doc.findObjects("Points::Feature")
    points = document.points_of(first)
    np.savetxt(tmp_path / "again.xyz", points)
    path = tmp_path / "again.xyz"
    (cloud,) = import_clouds({path: read_cloud(path)})
    assert cloud.ViewObject.DisplayMode == "Color"
    grey = np.array([colour[0] for colour in cloud.Color])
    assert grey.min() >= 0.34
    left, right = (np.median(grey[sign * points[:, 0] > 1.0]) for sign in (-1, 1))
    assert abs(left - right) > 0.2
    first.ViewObject.Visibility = False
    window.picture("shaded_cloud")
    window.doc.undo()
    assert window.doc.findObjects("Points::Feature") == [first]
