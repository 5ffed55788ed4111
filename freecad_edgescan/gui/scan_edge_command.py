# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scan edge: opens the panel that finds an edge from one click on a cloud."""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from .icons import icon_path
from .message import problems_shown

__all__ = ["ScanEdgeCommand"]

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class ScanEdgeCommand:
    """The command EdgeScan_ScanEdge."""

    def GetResources(self) -> dict[str, str]:
        """Icon, menu text and tooltip."""
        return {
            "Pixmap": icon_path("EdgeScan_ScanEdge"),
            "MenuText": QT_TRANSLATE_NOOP("EdgeScan_ScanEdge", "Scan edge"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "EdgeScan_ScanEdge",
                "Click on a visible cloud, near an edge: the edge is followed both ways until it "
                "ends. Nothing needs to be selected before.",
            ),
        }

    def IsActive(self) -> bool:
        """With a document, and no other panel open."""
        return FreeCAD.ActiveDocument is not None and not FreeCADGui.Control.activeDialog()

    def Activated(self) -> None:
        """Open the panel, or say why it cannot work."""
        doc, view = FreeCAD.ActiveDocument, FreeCADGui.ActiveDocument.ActiveView
        with problems_shown("Scan edge"):
            from .scan_edge_panel import ScanEdgePanel, clouds_in

            if not hasattr(view, "getSceneGraph"):
                raise ValueError("Bring a 3D view to the front, then start again.")
            if not clouds_in(doc):
                raise ValueError(
                    "This document shows no point cloud. Import one (EdgeScan → Import cloud), "
                    "or make a hidden one visible."
                )
            FreeCADGui.Control.showDialog(ScanEdgePanel(doc, view))
