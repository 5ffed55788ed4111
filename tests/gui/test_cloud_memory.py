# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much memory a window holds for each point of a large cloud that is shown, indexed, scanned.

    EDGESCAN_MEMORY_POINTS=10000000 ./edgescan test tests/gui/test_cloud_memory.py

prints the figures for ten million points; without a number it takes one million.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")

from freecad_edgescan import document  # noqa: E402
from freecad_edgescan.experiments.cloud_sizes import write_copies  # noqa: E402
from freecad_edgescan.experiments.peak_memory import memory_now, peak_memory  # noqa: E402
from freecad_edgescan.experiments.speed import simulated_cloud  # noqa: E402

from .conftest import Window  # noqa: E402

POINTS = int(os.environ.get("EDGESCAN_MEMORY_POINTS", "1000000"))
WANTED = 100  # bytes a point, at the most at any time
# Bytes of drawings, threads and buffers, which do not grow with the cloud: about 130e6 were seen.
# The bound says something from some millions of points on.
OWN = 200e6


def scan(doc: Any, cloud: Any, numbers: Any) -> Any:
    edge = numbers.edges[0]
    made = document.make_scanned_edge(doc, cloud, at=edge.points[len(edge) // 2])
    doc.recompute()
    return made


def open_panel(window: Window) -> None:
    Gui.runCommand("EdgeScan_ScanEdge")
    window.wait_until(lambda: window.panel._clicks.ready)


def close_panel(window: Window) -> None:
    window.panel.close()
    Gui.Control.closeDialog()
    window.settle()


@pytest.mark.slow
def test_a_point_takes_at_most_a_hundred_bytes(
    workbench: Any, panels: list[Any], capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    one = simulated_cloud(100_000)
    count = write_copies(one, POINTS, tmp_path / "cloud.ply")
    doc = FreeCAD.newDocument("Memory")
    few = simulated_cloud(20_000)
    small = document.make_cloud(doc, few.points)
    doc.recompute()
    window = Window(doc, panels)
    try:
        open_panel(window)  # loads what it needs
        close_panel(window)
        scan(doc, small, few)
        before, told = memory_now(), []

        def tell(step: str) -> None:
            window.pass_time(0.5)
            now, most = ((own - before) / count for own in (memory_now(), peak_memory()))
            told.append(f"  {step:<22} {now:5.1f} now, {most:5.1f} at the most so far")

        cloud = document.make_cloud(doc, tmp_path / "cloud.ply")
        doc.recompute()
        tell("read")
        window.view.viewIsometric()
        window.view.fitAll()
        window.pass_time(0.5)
        window.viewport.repaint()
        tell("shown")
        open_panel(window)
        tell("indexed, in the panel")
        close_panel(window)
        edge = scan(doc, cloud, one)
        tell("one edge scanned")
        with capsys.disabled():
            print(f"\nBytes for each of {count} points (at most {WANTED} are wanted):")
            print("\n".join(told))
        assert small.Points.CountPoints < count == cloud.Points.CountPoints
        assert edge.isValid() and edge.PointCount > 100
        assert peak_memory() - before < WANTED * count + OWN
    finally:
        FreeCAD.closeDocument("Memory")
