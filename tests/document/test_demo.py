# SPDX-License-Identifier: LGPL-2.1-or-later
"""The demonstration makes its files and its edges are near the truth."""

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
from freecad_edgescan.document import demo  # noqa: E402


class Listener:
    """Notes the shares it is told, and cancels when it is to."""

    def __init__(self, cancel_at: float = 2.0) -> None:
        self.shares: list[float] = []
        self.cancel_at = cancel_at

    def update(self, fraction: float, so_far: object) -> bool:
        self.shares.append(fraction)
        return fraction < self.cancel_at


def run(folder: Path, listener: Listener) -> str:
    return document.make_demo(folder, listener, box=CoreBox.small(), amplitude=10.0, profiles=9)


@dataclass(frozen=True)
class Demo:
    """A demonstration of the small box.

    Attributes
    ----------
    folder : of its files
    table : that it prints
    shares : of progress
    left_open : documents that it has opened and not closed
    """

    folder: Path
    table: str
    shares: list[float]
    left_open: set[str]


@pytest.fixture(scope="module")
def small(tmp_path_factory: pytest.TempPathFactory) -> Demo:
    folder, listener, before = tmp_path_factory.mktemp("small"), Listener(), set(documents())
    table = run(folder / "demo", listener)
    return Demo(folder / "demo", table, listener.shares, set(documents()) - before)


def documents() -> list[str]:
    return list(FreeCAD.listDocuments())


def test_a_small_box_gives_edges_near_the_truth_and_all_files(small: Demo) -> None:
    assert small.table.count("GATE") == 2
    with (small.folder / "corebox.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    errors = np.array([float(row["error_mm"]) for row in rows])
    assert {row["edge"] for row in rows} == {"rim 1", "rim 2"}
    assert errors.mean() < 0.03
    assert errors.max() < 0.15
    assert small.shares == sorted(small.shares)
    assert small.shares[-1] <= 1.0
    read = Part.Shape()
    read.read(str(small.folder / "corebox.step"))
    assert len(read.Faces) == 2 + 2  # sweep and loft; base and fitted sweep
    doc = FreeCAD.openDocument(str(small.folder / "corebox.FCStd"))
    try:
        assert len(doc.findObjects("Part::Loft")) == 1
        sweep = doc.getObject("Pipe1Sweep")
        assert sweep.Frames == "at a fixed angle to the plane of the rail"
        heights = np.array([vertex.z for vertex in sweep.Shape.tessellate(0.05)[0]])
        assert heights.min() == pytest.approx(-8.0, abs=0.1)
        assert heights.max() == pytest.approx(0.0, abs=0.1)
        assert all(obj.Shape.isValid() for obj in doc.Objects if hasattr(obj, "Shape"))
        profiles = doc.getObject("Pipe1Profiles").Group
        radii = [profile.Shape.Curve.Radius for profile in profiles]
        np.testing.assert_allclose([radii[0], radii[-1]], [8.0, 7.0], atol=0.1)
    finally:
        FreeCAD.closeDocument(doc.Name)


def test_pictures_are_drawn_or_their_absence_is_said(small: Demo) -> None:
    pictures = sorted(path.name for path in small.folder.glob("*.png"))
    try:
        import matplotlib  # noqa: F401
    except ImportError:
        assert "needs matplotlib" in small.table
    else:
        assert pictures == ["corebox-section.png", "corebox.png"]


def test_no_document_stays_open(small: Demo) -> None:
    assert small.left_open == set()


def test_cancelling_keeps_what_was_found(tmp_path: Path) -> None:
    table = run(tmp_path, Listener(cancel_at=0.4))
    assert "CANCELLED" in table
    assert (tmp_path / "corebox.csv").stat().st_size > 100


def test_loft_and_fitted_sweep_follow_the_pipe_and_the_sweep_of_one_profile_cannot(
    small: Demo,
) -> None:
    rows = {line[:12]: line.split() for line in small.table.splitlines() if " yes " in line}
    sweep, loft, fitted = (rows[f"pipe 1 {kind}"] for kind in ("sweep", "loft ", "fitte"))
    assert sweep[4] == loft[4] == fitted[4] == "yes"
    assert float(fitted[5]) < 0.03 and float(fitted[6]) < 0.2
    assert "pipe 1 fitted: the cloud's points are 0.0" in small.table
    assert float(loft[5]) < 0.1
    assert float(sweep[5]) > 3 * float(loft[5])


@pytest.mark.slow
def test_the_full_core_box_meets_the_promised_errors(tmp_path: Path) -> None:
    table = document.make_demo(tmp_path)
    assert table.count("GATE") == 4
    with (tmp_path / "corebox.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    for name in {row["edge"] for row in rows}:
        errors = np.array([float(row["error_mm"]) for row in rows if row["edge"] == name])
        assert errors.mean() <= 0.03
        assert errors.max() <= 0.15


def test_names_of_the_package_are_never_hidden_by_modules() -> None:
    folder = Path(document.__file__).parent
    assert not {path.stem for path in folder.glob("*.py")} & set(document.__all__)
    assert demo.make_demo is document.make_demo
