# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loft through edges: a native Part::Loft through sections or scanned edges."""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from .icons import icon_path
from .message import problems_shown
from .recorded_step import object_line, run_as_one_step
from .selected_shapes import selected_shapes

__all__ = ["LoftCommand"]

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class LoftCommand:
    """The command EdgeScan_Loft."""

    def GetResources(self) -> dict[str, str]:
        """Icon, menu text and tooltip."""
        return {
            "Pixmap": icon_path("EdgeScan_Loft"),
            "MenuText": QT_TRANSLATE_NOOP("EdgeScan_Loft", "Loft through edges"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "EdgeScan_Loft",
                "Make a skin through edges or sections. Select two or more of them, in order.",
            ),
        }

    def IsActive(self) -> bool:
        """With a document; what is to be selected is said when it is not."""
        return FreeCAD.ActiveDocument is not None and not FreeCADGui.Control.activeDialog()

    def Activated(self) -> None:
        """Make the loft of what is selected."""
        doc = FreeCAD.ActiveDocument
        sections = selected_shapes(doc)
        with problems_shown("Loft through edges"):
            if len(sections) < 2:
                raise ValueError(
                    f"{len(sections)} objects with a shape are selected. Select two or more "
                    "edges or sections, in the order the skin goes through them."
                )
            through = ", ".join(object_line(section) for section in sections)
            run_as_one_step(doc, "Loft through edges", [f"document.make_loft(doc, [{through}])"])
