# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that need clicks on a cloud, besides Scan edge: Scan boundary and Recommend."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from .command import Command
from .obstacles import no_cloud
from .translation import translate
from .view_in_front import view_for_clicks

__all__ = ["clicked_commands"]

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


def clicked_commands() -> list[Command]:
    """All of them, in the order of the toolbar."""
    return [
        Command(
            "EdgeScan_ScanBoundary",
            QT_TRANSLATE_NOOP("EdgeScan_ScanBoundary", "Scan boundary"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_ScanBoundary",
                "Scan all edges round one face. Click near one of its edges, then on the face; "
                "nothing needs to be selected before.",
            ),
            QT_TRANSLATE_NOOP("EdgeScan_ScanBoundary", "Click near an edge, then on the face"),
            _scan_boundary,
            no_cloud,
        ),
        Command(
            "EdgeScan_RecommendParameters",
            QT_TRANSLATE_NOOP("EdgeScan_RecommendParameters", "Recommend parameters"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_RecommendParameters",
                "Measure the cloud near an edge and say how to scan it, why, and which error to "
                "expect. Click near the edge; nothing needs to be selected before.",
            ),
            QT_TRANSLATE_NOOP("EdgeScan_RecommendParameters", "Click near an edge"),
            _recommend,
            no_cloud,
        ),
    ]


def _scan_boundary(doc: Any) -> None:
    from .boundary_panel import BoundaryPanel

    FreeCADGui.Control.showDialog(BoundaryPanel(doc, view_for_clicks(), translate("Scan boundary")))


def _recommend(doc: Any) -> None:
    from .recommend_panel import RecommendPanel

    title = translate("Recommend parameters")
    FreeCADGui.Control.showDialog(RecommendPanel(doc, view_for_clicks(), title))
