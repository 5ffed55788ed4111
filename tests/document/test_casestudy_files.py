# SPDX-License-Identifier: LGPL-2.1-or-later
"""The case study writes files that reopen with nothing left to compute."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402
from freecad_edgescan.cloud import CoreBox  # noqa: E402


class Listener:
    """Cancels at a share of the whole."""

    def __init__(self, cancel_at: float) -> None:
        self.cancel_at = cancel_at

    def update(self, fraction: float, so_far: object) -> bool:
        return fraction < self.cancel_at


def run(folder: Path, cancel_at: float = 2.0) -> str:
    return document.make_casestudy(
        folder, Listener(cancel_at), CoreBox.small(), grids=((12, 6),), thinned_pitch=1.5
    )


@dataclass(frozen=True)
class Study:
    """The folder of a study's files, what it has said, and the documents that it has left open."""

    folder: Path
    text: str
    left_open: set[str]


@pytest.fixture(scope="module")
def small(tmp_path_factory: pytest.TempPathFactory) -> Study:
    folder = tmp_path_factory.mktemp("small") / "study"
    before = set(FreeCAD.listDocuments())
    text = run(folder)
    return Study(folder, text, set(FreeCAD.listDocuments()) - before)


def test_a_small_box_gives_all_files_and_surfaces_near_the_truth(small: Study) -> None:
    assert small.left_open == set()
    assert "read the cloud" in small.text and "published" in small.text
    with (small.folder / "casestudy.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 4
    (best,) = [row for row in rows if (row["model"], row["cloud"]) == ("rotate", "whole")]
    assert float(best["true_average_mm"]) < 0.03 and float(best["true_maximum_mm"]) < 0.2
    read = Part.Shape()
    read.read(str(small.folder / "casestudy.step"))
    assert len(read.Faces) == 1
    doc = FreeCAD.openDocument(str(small.folder / "casestudy.FCStd"))
    try:
        surface = doc.getObject("Pipe1Rotate")
        assert read.Faces[0].Area == pytest.approx(surface.Shape.Area, rel=1e-6)
        assert surface.Average.Value == pytest.approx(float(best["average_mm"]), abs=1e-6)
        made = [item for item in doc.Objects if hasattr(item, "InputHash")]
        assert len(made) == 2 + 2 + 1 + 1 + 2 + 1  # rims, profiles, base, points, models, map
        before_touch = [item.InputHash for item in made]
        assert all(before_touch)
        for item in made:
            item.touch()
        doc.recompute()
        assert [item.InputHash for item in made] == before_touch
        assert not [item.Label for item in made if "Invalid" in item.State]
    finally:
        FreeCAD.closeDocument(doc.Name)


def test_when_a_start_moves_the_surfaces_follow(small: Study) -> None:
    doc = FreeCAD.openDocument(str(small.folder / "casestudy.FCStd"))
    try:
        rim, base = doc.getObject("Rim1"), doc.getObject("Pipe1Base")
        for name in ("Pipe1Blend", "Pipe1Rotate"):  # their fits take a while
            doc.removeObject(name)
        profile = doc.getObject("Pipe1Profile1")
        area, length = base.Shape.Area, rim.Shape.Length
        count = doc.getObject("Pipe1Points").PointCount
        rim.At = rim.At + 5.0 * rim.Along
        doc.recompute()
        assert rim.Shape.Length < length - 3.0
        assert base.Shape.Area < area
        assert doc.getObject("Pipe1Points").PointCount < count
        start = rim.Shape.Vertexes[0].Point
        assert min(start.distanceToPoint(v.Point) for v in profile.Shape.Vertexes) < 0.1
    finally:
        FreeCAD.closeDocument(doc.Name)


@pytest.mark.parametrize("cancel_at", [0.0, 0.3, 0.67])
def test_a_cancelled_study_writes_what_it_has(tmp_path: Path, cancel_at: float) -> None:
    text = run(tmp_path, cancel_at)
    assert (tmp_path / "casestudy.FCStd").is_file()
    assert "Wrote casestudy-raster.ply, casestudy.FCStd" in text
    assert np.isfinite((tmp_path / "casestudy.FCStd").stat().st_size)
