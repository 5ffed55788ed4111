# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scan all edges: opens the panel that finds the edges of a whole cloud."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from .command import Command
from .obstacles import no_cloud
from .selected import clouds_of, only_cloud, selected_objects
from .view_in_front import view_for_clicks

__all__ = ["all_edges_command"]

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


def all_edges_command() -> Command:
    """The command EdgeScan_ScanAllEdges."""
    return Command(
        "EdgeScan_ScanAllEdges",
        QT_TRANSLATE_NOOP("EdgeScan_ScanAllEdges", "Scan all edges"),
        QT_TRANSLATE_NOOP(
            "EdgeScan_ScanAllEdges",
            "Find all edges of a cloud and where they meet, and choose which to keep. Select the "
            "cloud; when only one is shown nothing needs to be selected.",
        ),
        QT_TRANSLATE_NOOP("EdgeScan_ScanAllEdges", "Select a cloud, unless only one is shown"),
        _open_panel,
        no_cloud,
    )


def _open_panel(doc: Any) -> None:
    """Open the panel, or say why it cannot work."""
    view = view_for_clicks()
    from .all_edges_panel import AllEdgesPanel

    chosen = clouds_of(selected_objects(doc))
    cloud = chosen[0] if len(chosen) == 1 else only_cloud(doc)
    FreeCADGui.Control.showDialog(AllEdgesPanel(doc, view, cloud))
