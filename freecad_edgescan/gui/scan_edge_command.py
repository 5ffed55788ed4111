# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scan edge: opens the panel that finds an edge from one click on a cloud."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from .command import Command
from .obstacles import no_cloud
from .translation import translate
from .view_in_front import view_for_clicks

__all__ = ["scan_edge_command"]

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


def scan_edge_command() -> Command:
    """The command EdgeScan_ScanEdge."""
    return Command(
        "EdgeScan_ScanEdge",
        QT_TRANSLATE_NOOP("EdgeScan_ScanEdge", "Scan edge"),
        QT_TRANSLATE_NOOP(
            "EdgeScan_ScanEdge",
            "Click on a visible cloud, near an edge: the edge is followed both ways until it "
            "ends. Nothing needs to be selected before.",
        ),
        QT_TRANSLATE_NOOP("EdgeScan_ScanEdge", "Click on a cloud, near an edge"),
        _open_panel,
        no_cloud,
    )


def _open_panel(doc: Any) -> None:
    """Open the panel, or say why it cannot work."""
    view = view_for_clicks()
    from .clicked_cloud import visible_clouds
    from .scan_edge_panel import ScanEdgePanel

    if not visible_clouds(doc):
        raise ValueError(
            translate(
                "This document shows no point cloud. Import one (EdgeScan → Import cloud), or "
                "make a hidden one visible."
            )
        )
    FreeCADGui.Control.showDialog(ScanEdgePanel(doc, view))
