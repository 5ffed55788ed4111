# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces, sections, segments and maps as a person makes them: select, run, undo."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")
Part = pytest.importorskip("Part")

V = FreeCAD.Vector


def select(*items: Any) -> None:
    Gui.Selection.clearSelection()
    for item in items:
        Gui.Selection.addSelection(item)


def feature(doc: Any, shape: Any, name: str) -> Any:
    made = doc.addObject("Part::Feature", name)
    made.Shape = shape
    return made


def run(doc: Any, name: str, *selected: Any) -> Any:
    """Run a command on what is selected, and answer what it made in one undo step."""
    before, steps = {item.Name for item in doc.Objects}, doc.UndoCount
    select(*selected)
    Gui.runCommand(name)
    (made,) = (item for item in doc.Objects if item.Name not in before)
    assert doc.UndoCount == steps + 1
    assert Path(made.ViewObject.Proxy.getIcon()).is_file()
    assert "Invalid" not in made.State
    return made


@pytest.fixture
def pipe(window: Any) -> dict[str, Any]:
    """A cloud of half a cylinder, its two rims, and two arcs."""
    from freecad_edgescan import document

    angle, x = np.random.default_rng(0).uniform((0.01, 0), (np.pi - 0.01, 60), (6000, 2)).T
    points = np.column_stack([x, 17 * np.cos(angle), -17 * np.sin(angle)])
    doc = window.doc
    return {
        "doc": doc,
        "cloud": document.make_cloud(doc, points),
        "rails": [feature(doc, Part.makeLine(V(0, y, 0), V(60, y, 0)), "Rail") for y in (17, -17)],
        "arcs": [
            feature(doc, Part.Arc(V(x, 17, 0), V(x, 0, -17), V(x, -17, 0)).toShape(), "Arc")
            for x in (0, 60)
        ],
    }


def test_from_rails_to_a_deviation_map(pipe: dict[str, Any]) -> None:
    doc, cloud = pipe["doc"], pipe["cloud"]
    section = run(doc, "EdgeScan_CloudSection", cloud, *pipe["rails"])
    assert section.Radius.Value == pytest.approx(17, abs=0.01)
    swept = run(doc, "EdgeScan_SweptSurface", *pipe["rails"], *pipe["arcs"])
    assert swept.Shape.Area == pytest.approx(np.pi * 17 * 60, rel=5e-3)
    segment = run(doc, "EdgeScan_CloudSegment", cloud, swept)
    assert segment.PointCount > 5000
    fitted = run(doc, "EdgeScan_FittedSurface", swept, segment)
    assert fitted.Maximum.Value < 0.3  # of six control points round half a circle
    longer = run(doc, "EdgeScan_ExtendSurface", fitted)
    assert longer.Shape.Area > 1.2 * fitted.Shape.Area
    plane = feature(doc, Part.makePlane(80, 60, V(-10, -30, -8)), "Plane")
    curve = run(doc, "EdgeScan_IntersectSurfaces", longer, plane)
    assert curve.CurveCount == 2
    caps = [
        feature(doc, Part.makePlane(40, 40, V(x, -20, -20), V(1, 0, 0)), "Cap") for x in (5, 55)
    ]
    for cap in caps:
        cap.Placement.Base = V(0, -20 - cap.Shape.BoundBox.YMin, -20 - cap.Shape.BoundBox.ZMin)
    shell = run(doc, "EdgeScan_TrimmedShell", swept, plane, *caps)
    assert shell.Closed and shell.FaceCount == 4
    shown = run(doc, "EdgeScan_DeviationMap", cloud, fitted)
    assert shown.ViewObject.DisplayMode == "Color"
    assert Gui.Selection.getSelection() == [shown]
    assert not cloud.ViewObject.Visibility  # it would cover the map
    assert not fitted.ViewObject.Visibility
    doc.undo()
    assert cloud.ViewObject.Visibility and fitted.ViewObject.Visibility
    assert doc.getObject(curve.Name) is not None


@pytest.mark.parametrize(
    "name",
    [
        *("EdgeScan_CloudSection", "EdgeScan_SweptSurface", "EdgeScan_CloudSegment"),
        *("EdgeScan_FittedSurface", "EdgeScan_ExtendSurface", "EdgeScan_IntersectSurfaces"),
        *("EdgeScan_TrimmedShell", "EdgeScan_DeviationMap"),
    ],
)
def test_with_the_wrong_selection_one_sentence_says_what_to_select(
    window: Any, name: str, problems: list[str]
) -> None:
    feature(window.doc, Part.makeLine(V(0, 0, 0), V(9, 0, 0)), "Line")
    before = window.trace()
    select()
    clouds = window.doc.findObjects("Points::Feature")
    if name != "EdgeScan_FittedSurface":  # which can do with a cloud alone
        select(clouds[0])
    Gui.runCommand(name)
    assert len(problems) == 1
    assert "Select" in problems[0]
    assert window.trace() == before
