# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scanned edges carry native sweeps and lofts, and go into STEP files as curves."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402

V = FreeCAD.Vector


@pytest.fixture(scope="module")
def numbers() -> Any:
    return document.simulate_cloud(Part.makeCylinder(10, 12), 0.4, 0.01)


@pytest.fixture
def rim(doc: Any, numbers: Any) -> Any:
    made = document.make_scanned_edge(doc, document.make_cloud(doc, numbers), at=(10, 0, 12))
    doc.recompute()
    return made


def line(doc: Any, start: tuple[float, ...], end: tuple[float, ...]) -> Any:
    made = doc.addObject("Part::Feature", "Line")
    made.Shape = Part.makeLine(V(*start), V(*end))
    return made


def test_a_sweep_on_a_scanned_edge_follows_it_when_it_is_scanned_again(doc: Any, rim: Any) -> None:
    start = rim.Shape.Vertexes[0].Point
    profile = line(doc, tuple(start), tuple(start + V(0, 0, 2)))
    sweep = document.make_sweep(doc, profile, rim)
    doc.recompute()
    assert sweep.TypeId == "Part::Sweep"
    assert sweep.Shape.isValid()
    assert sweep.Shape.Area == pytest.approx(20 * np.pi * 2, rel=0.01)
    rim.Cloud.Placement.Base = V(0, 0, 30)
    rim.At = rim.At + V(0, 0, 30)
    profile.Placement.Base = V(0, 0, 30)
    doc.recompute()
    assert sweep.Shape.CenterOfMass.z == pytest.approx(43.0, abs=0.1)


def test_a_loft_joins_two_rims(doc: Any, rim: Any) -> None:
    other = document.make_scanned_edge(doc, rim.Cloud, at=(10, 0, 0))
    loft = document.make_loft(doc, [rim, other])
    doc.recompute()
    assert loft.TypeId == "Part::Loft"
    assert loft.Shape.Area == pytest.approx(20 * np.pi * 12, rel=0.01)


@pytest.mark.parametrize("sections", [[], ["rim"], ["rim", "rim"]])
def test_a_loft_needs_two_different_sections(doc: Any, rim: Any, sections: list[str]) -> None:
    before = list(doc.Objects)
    with pytest.raises(ValueError, match=r"sections|follows itself"):
        document.make_loft(doc, [rim for _ in sections])
    assert doc.Objects == before


def test_profile_and_rail_must_differ_and_have_shapes(doc: Any, rim: Any) -> None:
    with pytest.raises(ValueError, match="both 'ScannedEdge'"):
        document.make_sweep(doc, rim, rim)
    with pytest.raises(ValueError, match="'Cloud' has no shape"):
        document.make_sweep(doc, rim.Cloud, rim)


def test_a_step_file_holds_the_native_circle(doc: Any, rim: Any, tmp_path: Path) -> None:
    path = tmp_path / "rim.step"
    document.export_step([rim], path)
    read = Part.Shape()
    read.read(str(path))
    (edge,) = read.Edges
    assert isinstance(edge.Curve, Part.Circle)
    assert edge.Curve.Radius == pytest.approx(rim.Shape.Curve.Radius, abs=1e-9)


def test_results_and_shapes_can_be_written_too(numbers: Any, tmp_path: Path) -> None:
    from freecad_edgescan.scanning import scan_edge

    path = tmp_path / "both.step"
    document.export_step([scan_edge(numbers, at=(10, 0, 12)), Part.makeBox(1, 1, 1)], path)
    read = Part.Shape()
    read.read(str(path))
    assert len(read.Edges) == 13


def test_a_far_edge_is_written_at_its_true_place(doc: Any, numbers: Any, tmp_path: Path) -> None:
    far = np.array([500000.0, 4500000.0, 0.0])
    cloud = document.make_cloud(doc, numbers.points + far)
    at = np.array([10, 0, 12]) + far - np.array(cloud.Origin)
    rim = document.make_scanned_edge(doc, cloud, at=at)
    doc.recompute()
    path = tmp_path / "far.step"
    document.export_step([rim], path)
    read = Part.Shape()
    read.read(str(path))
    np.testing.assert_allclose(
        tuple(read.Edges[0].Curve.Center), far + np.array([0, 0, 12]), atol=0.05
    )


def test_nothing_to_write_is_said(doc: Any, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="no shape among 0"):
        document.export_step([], tmp_path / "nothing.step")
    with pytest.raises(ValueError, match="cannot be written"):
        document.export_step([Part.makeBox(1, 1, 1)], tmp_path / "no" / "box.step")
