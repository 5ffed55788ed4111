# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench shows its commands, each with an icon and a sentence on what to select."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

Gui = pytest.importorskip("FreeCADGui")

COMMANDS = [
    *("EdgeScan_ImportCloud", "EdgeScan_ScanEdge", "EdgeScan_Sweep", "EdgeScan_Loft"),
    *("EdgeScan_CloudSection", "EdgeScan_SweptSurface", "EdgeScan_CloudSegment"),
    *("EdgeScan_FittedSurface", "EdgeScan_ExtendSurface", "EdgeScan_IntersectSurfaces"),
    "EdgeScan_DeviationMap",
]


def test_the_workbench_opens_with_a_toolbar_and_a_menu(workbench: Any) -> None:
    assert workbench.name() == "EdgeScanWorkbench"
    assert "EdgeScan" in workbench.listToolbars()
    assert "EdgeScan" in workbench.listMenus()
    assert Path(type(workbench).Icon).is_file()


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_is_registered_with_an_icon_and_says_what_to_select(
    workbench: Any, name: str
) -> None:
    info = Gui.Command.get(name).getInfo()
    assert Path(info["pixmap"]).is_file()
    assert info["menuText"]
    assert "elect" in info["toolTip"]


def test_icons_are_small() -> None:
    from freecad_edgescan.gui.icons import icon_path

    icons = list(Path(icon_path("any")).parent.glob("*.svg"))
    assert len(icons) >= len(COMMANDS) + 2
    assert all(icon.stat().st_size <= 10_000 for icon in icons)
