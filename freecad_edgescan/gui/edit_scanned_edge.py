# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opens the scan panel for an edge that is there already."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from .message import problems_shown
from .translation import translate
from .view_in_front import view_of

__all__ = ["edit_scanned_edge"]


def edit_scanned_edge(edge: Any) -> None:
    """Open the panel that made an edge, to change it; or say why that cannot be."""
    from .scan_edge_panel import ScanEdgePanel

    with problems_shown(translate("Edit scanned edge")):
        if FreeCADGui.Control.activeDialog():
            raise ValueError(translate("Finish or cancel the open task panel first."))
        FreeCADGui.Control.showDialog(ScanEdgePanel(edge.Document, view_of(edge.Document), edge))
