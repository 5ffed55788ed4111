# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles of clouds as native edges that follow their rails."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

import freecad_edgescan as es  # noqa: E402
from freecad_edgescan import document  # noqa: E402

V = FreeCAD.Vector
PROBE = 1.0


def rail(doc: Any, y: float, length: float = 60.0) -> Any:
    made = doc.addObject("Part::Feature", "Rail")
    made.Shape = Part.LineSegment(V(0, y, 0), V(length, y, 0)).toShape()
    return made


def half_pipe(doc: Any, probe: float = 0.0, radius: float = 17.0) -> Any:
    """A cloud of half a cylinder along x, or of the centres of a ball that touched it."""
    rng = np.random.default_rng(0)
    angle, x = rng.uniform(0.01, np.pi - 0.01, 12000), rng.uniform(0, 60, 12000)
    r = radius - probe
    points = np.column_stack([x, r * np.cos(angle), -r * np.sin(angle)])
    points += rng.normal(0, 0.01, points.shape)
    return document.make_cloud(doc, es.PointCloud(points, probe, (0, 0, -1) if probe else None))


@pytest.mark.parametrize("probe", [0.0, PROBE])
def test_a_profile_between_two_rails_is_the_arc_of_the_part(doc: Any, probe: float) -> None:
    cloud = half_pipe(doc, probe)
    section = document.make_cloud_section(doc, cloud, rail(doc, 17), 0.25, rail(doc, -17))
    doc.recompute()
    assert section.KindUsed == "arc" and section.Radius.Value == pytest.approx(17.0, abs=0.02)
    assert isinstance(section.Shape.Curve, Part.Circle)
    assert section.Shape.BoundBox.XMin == pytest.approx(15.0, abs=1e-6)
    assert section.Shape.BoundBox.ZMin == pytest.approx(-17.0, abs=0.02)
    section.Kind = "spline"
    doc.recompute()
    assert isinstance(section.Shape.Curve, Part.BSplineCurve)


def test_a_profile_follows_its_rail_and_carries_a_sweep(doc: Any) -> None:
    cloud = half_pipe(doc)
    rails = [rail(doc, 17), rail(doc, -17)]
    ends = [document.make_cloud_section(doc, cloud, rails[0], k, rails[1]) for k in (0.0, 1.0)]
    swept = document.make_swept_surface(doc, rails, ends)
    doc.recompute()
    assert swept.Shape.Area == pytest.approx(np.pi * 17 * 60, rel=5e-3)
    for own, y in zip(rails, (17, -17), strict=True):
        own.Shape = Part.LineSegment(V(10, y, 0), V(60, y, 0)).toShape()
    doc.recompute()
    assert ends[0].Shape.BoundBox.XMin == pytest.approx(10.0, abs=1e-6)
    assert swept.Shape.Area == pytest.approx(np.pi * 17 * 50, rel=5e-3)


def test_what_cannot_be_cut_is_refused(doc: Any) -> None:
    cloud, edge = half_pipe(doc), rail(doc, 17)
    with pytest.raises(ValueError, match="no profile of the kind 'ellipse'"):
        document.make_cloud_section(doc, cloud, edge, kind="ellipse")
    with pytest.raises(ValueError, match="share of the rail is 2"):
        document.make_cloud_section(doc, cloud, edge, 2)
    section = document.make_cloud_section(doc, cloud, rail(doc, 170))
    doc.recompute()
    assert "Invalid" in section.State and "a profile needs" in section.Message
