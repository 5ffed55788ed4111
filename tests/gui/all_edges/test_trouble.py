# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever happens while all edges are searched for or chosen leaves nothing behind."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui as Gui
import pytest

from freecad_edgescan import document
from freecad_edgescan.gui.background import running

from ..ways_out import by_cancel, by_escape, by_freecad, by_the_cross
from .steps import PITCH, TOP_FRONT, ended, found, kept_and_left_out, networks, opened


def before_the_first_report(known: Any) -> None:
    Gui.runCommand("EdgeScan_ScanAllEdges")


def while_it_searches(known: Any) -> None:
    panel = opened(known)
    known.wait_until(lambda: len(panel._known.edges) > 0)


def when_stopped(known: Any) -> None:
    while_it_searches(known)
    known.panel.form.stop.click()
    ended(known)


def when_found(known: Any) -> None:
    found(known)
    known.click(TOP_FRONT)


MOMENTS = [before_the_first_report, while_it_searches, when_stopped, when_found]


@pytest.mark.parametrize(
    ("way_out", "moment"),
    [
        *((by_escape, moment) for moment in MOMENTS),
        *((by_cancel, moment) for moment in (before_the_first_report, when_found)),
        *((by_the_cross, moment) for moment in (while_it_searches, when_found)),
        (by_freecad, while_it_searches),
    ],
)
def test_no_way_out_at_any_moment_leaves_a_trace(
    box: Any, moment: Callable[[Any], None], way_out: Callable[[Any], None]
) -> None:
    document.point_cloud(box.cloud)
    before, threads = box.trace(), box.threads
    moment(box)
    way_out(box)
    box.wait_until(lambda: not Gui.Control.activeDialog(), 20)
    box.wait_until(lambda: box.trace() == before and running() == 0, 20)
    if way_out is by_the_cross:
        box.pass_time(0.6)  # until the dock is back
    assert box.threads <= threads
    scene = box.view.getSceneGraph()
    assert not any(scene.getByName(n) for n in ("EdgeScanNetwork", "EdgeScanThinnedClouds"))


@pytest.mark.parametrize("moment", MOMENTS)
def test_a_document_may_be_closed_at_any_moment(box: Any, moment: Callable[[Any], None]) -> None:
    moment(box)
    FreeCAD.closeDocument(box.doc.Name)
    box.wait_until(lambda: not Gui.Control.activeDialog(), 20)
    box.wait_until(lambda: running() == 0, 20)


@pytest.mark.parametrize("moment", MOMENTS)
def test_a_cloud_may_be_deleted_at_any_moment_and_its_deletion_undone(
    box: Any, moment: Callable[[Any], None]
) -> None:
    moment(box)
    box.doc.openTransaction("Delete")
    box.doc.removeObject(box.cloud.Name)
    box.doc.commitTransaction()
    box.settle()
    assert "deleted" in box.sentence
    assert not box.button("Ok").isEnabled()
    assert kept_and_left_out(box) == (0, 0)
    box.doc.undo()
    ended(box)
    assert sum(kept_and_left_out(box)) > 0
    box.ok()
    assert len(networks(box)) == 1


@pytest.mark.parametrize("moment", [while_it_searches, when_found])
def test_a_cloud_that_is_moved_is_searched_again(box: Any, moment: Callable[[Any], None]) -> None:
    moment(box)
    box.cloud.Placement = FreeCAD.Placement(FreeCAD.Vector(0, 0, 70), FreeCAD.Rotation())
    box.settle()
    assert "has changed" in box.sentence
    assert not box.button("Ok").isEnabled()
    ended(box)
    box.ok()
    (network,) = networks(box)
    assert network.EdgeCount == 12
    assert network.Shape.BoundBox.ZMin == pytest.approx(70.0, abs=PITCH)


def test_looking_at_edges_does_not_change_the_document(known: Any, tmp_path: Path) -> None:
    known.doc.saveAs(str(tmp_path / "box.FCStd"))
    Gui.SendMsgToActiveView("Save")
    assert not Gui.getDocument(known.doc.Name).Modified
    when_found(known)
    by_cancel(known)
    known.settle()
    assert not Gui.getDocument(known.doc.Name).Modified


def test_a_large_cloud_is_drawn_with_fewer_points(
    box: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("freecad_edgescan.gui.thinned_clouds.MOST_POINTS", 1000)
    panel = opened(box)
    assert panel._display.clouds.count <= 1000
    assert "1,000 of" in panel.form._shown.text()
    ended(box)
    assert kept_and_left_out(box) == (12, 0)
