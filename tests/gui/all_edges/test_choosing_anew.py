# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of all edges on a network that is already in the document."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui as Gui

from .steps import TOP_FRONT, edit, kept_and_left_out, networks


def test_a_double_click_chooses_anew_in_one_undo_step(
    known: Any, network: Any, recorded: list[str]
) -> None:
    steps = known.doc.UndoCount
    edit(known, network)
    assert network.ViewObject.SwitchNode.whichChild.getValue() == -1
    known.click(TOP_FRONT)
    known.ok()
    assert network.EdgeCount == 11 and networks(known) == [network]
    assert network.ViewObject.SwitchNode.whichChild.getValue() != -1
    assert known.doc.UndoCount == steps + 1
    assert any("change_edge_network" in line for line in recorded)
    known.doc.undo()
    assert network.EdgeCount == 12 and network.Dropped == []
    known.doc.redo()
    assert network.EdgeCount == 11
    edit(known, network)
    assert kept_and_left_out(known) == (11, 1)
    known.click(TOP_FRONT)
    known.ok()
    assert network.EdgeCount == 12


def test_editing_without_a_change_makes_no_undo_step(known: Any, network: Any) -> None:
    before = known.trace()
    edit(known, network)
    known.ok()
    assert known.trace() == before


def test_editing_that_is_given_up_leaves_no_trace(known: Any, network: Any) -> None:
    before = known.trace()
    edit(known, network)
    known.click(TOP_FRONT)
    known.press_escape()
    known.wait_until(lambda: not Gui.Control.activeDialog())
    assert known.trace() == before and network.EdgeCount == 12


def test_a_network_deleted_while_it_is_edited_takes_the_panel_along(
    known: Any, network: Any
) -> None:
    edit(known, network)
    known.doc.removeObject(network.Name)
    known.wait_until(lambda: not Gui.Control.activeDialog())


def test_a_network_whose_cloud_is_gone_says_so(
    known: Any, network: Any, problems: list[str]
) -> None:
    known.doc.removeObject(known.cloud.Name)
    network.ViewObject.Proxy.doubleClicked(network.ViewObject)
    assert not Gui.Control.activeDialog()
    assert "is gone" in problems[0]


def test_a_network_can_be_edited_after_save_and_reopen(
    known: Any, network: Any, tmp_path: Path
) -> None:
    edit(known, network)
    known.click(TOP_FRONT)
    known.ok()
    name, path = network.Name, str(tmp_path / "box.FCStd")
    known.doc.saveAs(path)
    FreeCAD.closeDocument(known.doc.Name)
    doc = FreeCAD.openDocument(path)
    known.doc, known.view = doc, Gui.getDocument(doc.Name).ActiveView
    known.pass_time(0.3)
    edit(known, doc.getObject(name))
    assert kept_and_left_out(known) == (11, 1)
    known.ok()
    assert doc.UndoCount == 0
    FreeCAD.closeDocument(doc.Name)
