# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that need clicks on a cloud: Scan edge, Scan boundary, Recommend parameters."""

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
            "EdgeScan_ScanEdge",
            QT_TRANSLATE_NOOP("EdgeScan_ScanEdge", "Scan edge"),
            QT_TRANSLATE_NOOP(
                "EdgeScan_ScanEdge",
                "Click on a visible cloud, near an edge: the edge is followed both ways until it "
                "ends. Nothing needs to be selected before.",
            ),
            QT_TRANSLATE_NOOP("EdgeScan_ScanEdge", "Click on a cloud, near an edge"),
            _scan_edge,
            no_cloud,
        ),
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


def _scan_edge(doc: Any) -> None:
    view = _view_for_clicks(doc)
    from .scan_edge_panel import ScanEdgePanel

    FreeCADGui.Control.showDialog(ScanEdgePanel(doc, view))


def _scan_boundary(doc: Any) -> None:
    view = _view_for_clicks(doc)
    from .boundary_panel import BoundaryPanel

    FreeCADGui.Control.showDialog(BoundaryPanel(doc, view, translate("Scan boundary")))


def _recommend(doc: Any) -> None:
    view = _view_for_clicks(doc)
    from .recommend_panel import RecommendPanel

    FreeCADGui.Control.showDialog(RecommendPanel(doc, view, translate("Recommend parameters")))


def _view_for_clicks(doc: Any) -> Any:
    """The 3D view in front, which shows a cloud.

    Raises
    ------
    ValueError: another window is in front, or no cloud can be seen.
    """
    from .clicked_cloud import visible_clouds

    view = view_for_clicks()
    if not visible_clouds(doc):
        raise ValueError(
            translate(
                "This document shows no point cloud. Import one (EdgeScan → Import cloud), or "
                "make a hidden one visible."
            )
        )
    return view
