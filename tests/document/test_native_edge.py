# SPDX-License-Identifier: LGPL-2.1-or-later
"""Native edges are as long as the part's own."""

from __future__ import annotations

from typing import Any

import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402


def test_the_edges_of_a_box_end_in_its_corners(doc: Any) -> None:
    """An edge point stands up to a pitch before them; the native edge is as long as the box's."""
    cloud = document.make_cloud(doc, document.simulate_cloud(Part.makeBox(20, 14, 10), 0.5, 0.02))
    for at, length in (((10, 0, 10), 20.0), ((0, 7, 10), 14.0), ((20, 14, 5), 10.0)):
        edge = document.make_scanned_edge(doc, cloud, at=at)
        doc.recompute()
        assert edge.Shape.Length == pytest.approx(length, abs=0.06)
