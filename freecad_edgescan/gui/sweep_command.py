# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sweep along edge: a profile moved along a scanned edge."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from .icons import icon_path
from .message import problems_shown
from .recorded_step import object_line, run_as_one_step
from .selected_shapes import is_scanned_edge, selected_shapes

__all__ = ["SweepCommand"]

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class SweepCommand:
    """The command EdgeScan_Sweep."""

    def GetResources(self) -> dict[str, str]:
        """Icon, menu text and tooltip."""
        return {
            "Pixmap": icon_path("EdgeScan_Sweep"),
            "MenuText": QT_TRANSLATE_NOOP("EdgeScan_Sweep", "Sweep along edge"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "EdgeScan_Sweep",
                "Sweep a profile along an edge. Select the profile (a sketch, wire or edge), "
                "then the scanned edge.",
            ),
        }

    def IsActive(self) -> bool:
        """With a document; what is to be selected is said when it is not."""
        return FreeCAD.ActiveDocument is not None and not FreeCADGui.Control.activeDialog()

    def Activated(self) -> None:
        """Make the sweep of what is selected."""
        doc = FreeCAD.ActiveDocument
        with problems_shown("Sweep along edge"):
            profile, rail = profile_and_rail(selected_shapes(doc))
            line = f"document.make_sweep(doc, {object_line(profile)}, {object_line(rail)})"
            run_as_one_step(doc, "Sweep along edge", [line])


def profile_and_rail(shapes: list[Any]) -> tuple[Any, Any]:
    """Tell profile and rail apart: the only scanned edge is the rail, else the second object.

    Raises
    ------
    ValueError: not two objects.
    """
    if len(shapes) != 2:
        raise ValueError(
            f"{len(shapes)} objects with a shape are selected. Select two: the profile (a "
            "sketch, wire or edge), then the scanned edge to sweep it along."
        )
    first, second = shapes
    if is_scanned_edge(first) and not is_scanned_edge(second):
        return second, first
    return first, second
