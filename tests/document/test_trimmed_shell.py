# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces that cross are trimmed and sewn; what sticks out is dropped."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402

V = FreeCAD.Vector
SIZE = np.array([40.0, 30.0, 20.0])
AXES = np.eye(3)


def feature(doc: Any, shape: Any, name: str = "Shape") -> Any:
    made = doc.addObject("Part::Feature", name)
    made.Shape = shape
    return made


def side(axis: int, end: int, room: float = 5.0, bump: float = 0.0) -> Any:
    """A side of a box round the origin that reaches beyond it, bent outwards by a bump."""
    u, v = AXES[(axis + 1) % 3], AXES[(axis + 2) % 3]
    reach = SIZE[(axis + 1) % 3] / 2 + room, SIZE[(axis + 2) % 3] / 2 + room
    at = end * SIZE[axis] / 2 * AXES[axis]
    share = np.linspace(-1, 1, 7)
    rows = [
        [
            V(*(at + s * reach[0] * u + t * reach[1] * v
                + end * bump * np.cos(s) * np.cos(t) * AXES[axis]))
            for t in share
        ]
        for s in share
    ]  # fmt: skip
    surface = Part.BSplineSurface()
    surface.interpolate(rows)
    return surface.toShape()


def sides(doc: Any, bump: float = 0.0, leave_out: tuple[int, int] | None = None) -> list[Any]:
    return [
        feature(doc, side(axis, end, bump=bump), "Side")
        for axis in range(3)
        for end in (-1, 1)
        if (axis, end) != leave_out
    ]


def test_six_flat_sides_make_the_box(doc: Any) -> None:
    shell = document.make_trimmed_shell(doc, sides(doc), solid=True)
    doc.recompute()
    assert shell.Shape.ShapeType == "Solid" and shell.Shape.isValid()
    assert shell.Closed and shell.FaceCount == 6 and shell.Message == ""
    assert abs(shell.Shape.Volume) == pytest.approx(40 * 30 * 20, rel=1e-6)
    assert shell.Area.Value == pytest.approx(2 * (40 * 30 + 40 * 20 + 30 * 20), rel=1e-6)


def test_a_step_file_of_bent_sides_reopens_with_the_same_area(doc: Any, tmp_path: Path) -> None:
    shell = document.make_trimmed_shell(doc, sides(doc, bump=2.0))
    doc.recompute()
    assert shell.Shape.ShapeType == "Shell" and shell.Closed and shell.Shape.isValid()
    assert Part.Solid(shell.Shape).Volume > 40 * 30 * 20  # normals point outwards
    document.export_step([shell], tmp_path / "shell.step")
    read = Part.Shape()
    read.read(str(tmp_path / "shell.step"))
    assert len(read.Faces) == 6
    assert read.Area == pytest.approx(shell.Area.Value, rel=1e-6)
    assert all(len(read.ancestorsOfType(edge, Part.Face)) == 2 for edge in read.Edges)


def test_edges_end_a_shell_where_no_other_surface_is(doc: Any) -> None:
    x, y, z = SIZE / 2
    rim = Part.makePolygon([V(-x, -y, z), V(x, -y, z), V(x, y, z), V(-x, y, z), V(-x, -y, z)])
    tray = sides(doc, leave_out=(2, 1))
    rims = [feature(doc, edge, "Rim") for edge in rim.Edges]
    open_box = document.make_trimmed_shell(doc, tray, rims)
    doc.recompute()
    assert not open_box.Closed and open_box.FaceCount == 5
    assert open_box.Area.Value == pytest.approx(40 * 30 + 2 * (40 * 20 + 30 * 20), rel=1e-6)
    open_box.Solid = True
    doc.recompute()
    assert "open, so that it makes no solid" in open_box.Message


def test_one_surface_is_trimmed_by_the_edges_round_a_face(doc: Any) -> None:
    height = 0.01  # scanned edges lie beside the surface
    corners = [V(-10, -8, height), V(12, -8, -height), V(12, 9, height), V(-10, 9, 0)]
    edges = [feature(doc, Part.makeLine(corners[k - 1], corners[k]), "Edge") for k in range(4)]
    plate = feature(doc, Part.makePlane(60, 40, V(-30, -20, 0)), "Plate")
    face = document.make_trimmed_shell(doc, [plate], edges)
    doc.recompute()
    assert face.Shape.ShapeType == "Face"
    assert face.Area.Value == pytest.approx(22 * 17, rel=1e-3)


def test_rims_that_all_but_meet_are_sewn(doc: Any) -> None:
    """Two half pipes, each fitted for itself, and two caps."""
    gap = 0.01
    upper, lower = (
        Part.makeCylinder(10, 30, V(0, 0, 0), V(1, 0, 0), 180).Faces[0] for _ in range(2)
    )
    lower.rotate(V(0, 0, 0), V(1, 0, 0), 180)
    lower.translate(V(0, 0, -gap))
    caps = [side(0, end) for end in (-1, 1)]
    for cap, x in zip(caps, (1, 29), strict=True):
        cap.translate(V(x - cap.BoundBox.XMin, 0, 0))
    made = [feature(doc, shape, "Part") for shape in (upper, lower, *caps)]
    shell = document.make_trimmed_shell(doc, made, solid=True)
    doc.recompute()
    assert shell.Closed, shell.Message
    assert abs(shell.Shape.Volume) == pytest.approx(np.pi * 100 * 28, rel=2e-3)


def test_it_follows_its_surfaces_and_survives_its_file(doc: Any, tmp_path: Path) -> None:
    made = sides(doc)
    shell = document.make_trimmed_shell(doc, made)
    doc.recompute()
    made[1].Placement.Base = V(3, 0, 0)  # the side at +x
    doc.recompute()
    assert shell.Area.Value == pytest.approx(2 * (43 * 30 + 43 * 20 + 30 * 20), rel=1e-6)
    before, name = shell.InputHash, shell.Name
    doc.saveAs(str(tmp_path / "shell.FCStd"))
    FreeCAD.closeDocument(doc.Name)
    again = FreeCAD.openDocument(str(tmp_path / "shell.FCStd"))
    try:
        for item in again.Objects:
            item.touch()
        again.recompute()
        assert again.getObject(name).InputHash == before
    finally:
        FreeCAD.closeDocument(again.Name)


def test_what_closes_nowhere_is_said_and_the_last_shape_stays(doc: Any) -> None:
    made = sides(doc)
    shell = document.make_trimmed_shell(doc, made)
    doc.recompute()
    area = shell.Area.Value
    shell.Surfaces = made[:5]
    doc.recompute()
    assert "close nowhere" in shell.Message and "Invalid" in shell.State
    assert shell.Shape.Area == pytest.approx(area)
    middle = feature(doc, Part.makePlane(60, 60, V(-30, -30, 2)), "Middle")
    shell.Surfaces = [*made, middle]
    doc.recompute()
    assert "More than two faces meet" in shell.Message
    far = feature(doc, Part.makePlane(5, 5, V(0, 0, 90)), "Far")
    shell.Surfaces = [*made, far]
    doc.recompute()
    assert shell.Message == "'Far' bounds no part of the shell and was left out."


def test_wrong_arguments_make_nothing(doc: Any) -> None:
    plate = feature(doc, Part.makePlane(5, 5))
    count = len(doc.Objects)
    for make, words in (
        (lambda: document.make_trimmed_shell(doc, []), "no surface to trim"),
        (lambda: document.make_trimmed_shell(doc, ["x"]), "has no shape"),
        (lambda: document.make_trimmed_shell(doc, [plate], tolerance=0.0), "positive length"),
    ):
        with pytest.raises(ValueError, match=words):
            make()
    assert len(doc.Objects) == count
