# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench shows its commands, each with an icon and a sentence on what to select."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Gui = pytest.importorskip("FreeCADGui")

COMMANDS = [
    *("EdgeScan_ImportCloud", "EdgeScan_SimulatedCloud", "EdgeScan_CompensateCloud"),
    *("EdgeScan_ThinCloud", "EdgeScan_CloudSegment"),
    *("EdgeScan_ScanEdge", "EdgeScan_ScanBoundary", "EdgeScan_ScanAllEdges"),
    *("EdgeScan_RecommendParameters", "EdgeScan_EdgeWire"),
    *("EdgeScan_CloudSection", "EdgeScan_Sweep", "EdgeScan_Loft", "EdgeScan_SweptSurface"),
    *("EdgeScan_FittedSurface", "EdgeScan_ExtendSurface", "EdgeScan_IntersectSurfaces"),
    *("EdgeScan_TrimmedShell", "EdgeScan_DeviationMap", "EdgeScan_Export", "EdgeScan_Report"),
    "EdgeScan_TryIt",
]
MOST_IN_A_TOOLBAR = 6


def test_the_workbench_opens_with_toolbars_and_a_menu_of_all_commands(workbench: Any) -> None:
    from freecad_edgescan.gui.commands import TOOLBARS, menu

    assert workbench.name() == "EdgeScanWorkbench"
    assert set(TOOLBARS) <= set(workbench.listToolbars())
    assert "EdgeScan" in workbench.listMenus()
    assert Path(type(workbench).Icon).is_file()
    assert all(len(names) <= MOST_IN_A_TOOLBAR for names in TOOLBARS.values())
    assert {name for name in menu() if name != "Separator"} == set(COMMANDS)
    assert {name for name in Gui.listCommands() if name.startswith("EdgeScan_")} == set(COMMANDS)


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_has_an_icon_and_says_what_to_select(workbench: Any, name: str) -> None:
    info = Gui.Command.get(name).getInfo()
    assert Path(info["pixmap"]).is_file()
    assert info["menuText"]
    assert any(word in info["toolTip"] for word in ("elect", "lick"))
    assert info["statusTip"]
    assert info["statusTip"] != info["toolTip"]


@pytest.mark.parametrize("name", COMMANDS)
def test_a_command_that_cannot_run_says_why_in_its_tooltip(workbench: Any, name: str) -> None:
    command = Gui.Command.get(name)
    assert not FreeCAD.listDocuments()
    works_without = {"EdgeScan_ImportCloud", "EdgeScan_SimulatedCloud", "EdgeScan_TryIt"}
    assert command.isActive() == (name in works_without)
    (action,) = command.getAction()
    reason = "Open a document first"
    assert (reason in action.toolTip()) == (name not in works_without)
    assert (reason in action.statusTip()) == (name not in works_without)


def test_the_reason_changes_with_the_document(workbench: Any) -> None:
    doc = FreeCAD.newDocument("Empty")
    for name, missing in (("EdgeScan_ScanEdge", "no point cloud"), ("EdgeScan_Loft", "no edge")):
        command = Gui.Command.get(name)
        assert not command.isActive()
        assert missing in command.getAction()[0].toolTip()
    doc.addObject("Points::Feature", "Cloud")
    doc.addObject("Part::Box", "Box")
    for name in ("EdgeScan_ScanEdge", "EdgeScan_Loft"):
        command = Gui.Command.get(name)
        assert command.isActive()
        assert "no point cloud" not in command.getAction()[0].toolTip()
    FreeCAD.closeDocument(doc.Name)


def test_icons_are_small() -> None:
    from freecad_edgescan.gui.icons import icon_path

    icons = list(Path(icon_path("any")).parent.glob("*.svg"))
    assert len(icons) >= len(COMMANDS) + 2
    assert all(icon.stat().st_size <= 10_000 for icon in icons)
