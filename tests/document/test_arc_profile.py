# SPDX-License-Identifier: LGPL-2.1-or-later
"""An arc profile is the circle of the surface, not that of the probe's centres."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402
from freecad_edgescan.cloud import PointCloud  # noqa: E402

V = FreeCAD.Vector
NOISE = 0.01
RADIUS, HALF_WIDTH = 10.0, 8.0


def channel(probe_radius: float, sign: float = -1.0, approach: Any = (0, 0, -1)) -> PointCloud:
    """Probe centres over a straight channel (sign -1) or ridge (1) along x, rims at y = ±8."""
    rng = np.random.default_rng(0)
    reach = np.arcsin(HALF_WIDTH / RADIUS)
    x, turn = rng.uniform(0, 40, 20000), rng.uniform(-reach, reach, 20000)
    radius = RADIUS + sign * probe_radius + rng.normal(0, NOISE, 20000)
    depth = np.sqrt(RADIUS**2 - HALF_WIDTH**2)
    y, z = radius * np.sin(turn), sign * (radius * np.cos(turn) - depth)
    return PointCloud(np.column_stack([x, y, z]), probe_radius, approach)


def rails(doc: Any) -> tuple[Any, Any]:
    made = []
    for y in (-HALF_WIDTH, HALF_WIDTH):
        rail = doc.addObject("Part::Feature", "Rail")
        rail.Shape = Part.makeLine(V(0, y, 0), V(40, y, 0))
        made.append(rail)
    return made[0], made[1]


@pytest.mark.parametrize("probe_radius", [0.0, 1.0])
@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_the_radius_is_that_of_the_surface(doc: Any, probe_radius: float, sign: float) -> None:
    cloud = document.make_cloud(doc, channel(probe_radius, sign))
    profile = document.make_arc_profile(doc, cloud, rails(doc), 0.5)
    (arc,) = profile.Shape.Edges
    assert arc.Curve.Radius == pytest.approx(RADIUS, abs=0.02)
    first, last = (vertex.Point for vertex in arc.Vertexes)
    assert (first - V(20, -HALF_WIDTH, 0)).Length < 0.03
    assert (last - V(20, HALF_WIDTH, 0)).Length < 0.03
    deepest = arc.BoundBox.ZMin if sign < 0 else arc.BoundBox.ZMax
    assert deepest == pytest.approx(sign * 4.0, abs=0.03)


def test_without_an_approach_the_radius_is_not_guessed(doc: Any) -> None:
    cloud = document.make_cloud(doc, channel(1.0, approach=None))
    with pytest.raises(ValueError, match="set the cloud's Approach"):
        document.make_arc_profile(doc, cloud, rails(doc), 0.5)


@pytest.mark.parametrize(
    ("share", "said"), [(1.5, "share of the rail is 1.5"), (0.0, "Only . cloud points|Only 0")]
)
def test_a_place_without_points_is_said(doc: Any, share: float, said: str) -> None:
    beside = channel(0.0).points + np.array([30.0, 0, 0])
    cloud = document.make_cloud(doc, beside)
    with pytest.raises(ValueError, match=said):
        document.make_arc_profile(doc, cloud, rails(doc), share)


def test_a_rail_that_is_no_edge_is_named(doc: Any) -> None:
    cloud = document.make_cloud(doc, channel(0.0))
    box = doc.addObject("Part::Box", "Box")
    doc.recompute()
    with pytest.raises(ValueError, match="rail 'Box' is not one edge"):
        document.make_arc_profile(doc, cloud, (box, box), 0.5)
