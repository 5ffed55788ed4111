# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scan all edges: watch, choose by figures and by clicks, keep in one undo step, edit again."""

from __future__ import annotations

from typing import Any

import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")
Part = pytest.importorskip("Part")

from freecad_edgescan import document  # noqa: E402

SIZE = (24.0, 18.0, 12.0)
ON_THE_FRONT_TOP = (10.0, 0.0, 12.0)


@pytest.fixture(scope="module")
def box_points() -> Any:
    return document.simulate_cloud(Part.makeBox(*SIZE), pitch=0.5, noise=0.05)


@pytest.fixture
def box(window: Any, box_points: Any) -> Any:
    """A scanned box in place of the roof."""
    window.doc.removeObject(window.cloud.Name)
    document.make_cloud(window.doc, box_points.points)
    window.doc.recompute()
    window.doc.clearUndos()
    window.view.fitAll()
    window.settle()
    return window


def opened(window: Any) -> Any:
    Gui.runCommand("EdgeScan_ScanAllEdges")
    window.settle()
    return window.panel


def found(window: Any) -> Any:
    panel = opened(window)
    window.wait_until(lambda: panel._work is None)
    return panel


def test_the_panel_shows_what_it_does(box: Any) -> None:
    panel = opened(box)
    box.wait_until(lambda: len(panel._known.edges) > 2)
    box.picture("all_edges_running")
    box.wait_until(lambda: panel._work is None)
    box.picture("all_edges_found")
    box.hover(ON_THE_FRONT_TOP)
    box.picture("all_edges_hover")
    box.click(ON_THE_FRONT_TOP)
    box.picture("all_edges_dropped")
    panel.form._length.widget.setProperty("rawValue", 15.0)
    box.settle()
    box.picture("all_edges_filtered")
    box.ok()
    box.picture("all_edges_made")
    print(panel.form)
