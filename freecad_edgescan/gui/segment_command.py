# SPDX-License-Identifier: LGPL-2.1-or-later
"""Segment cloud: near a surface at once; between the edges of a network after a click."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from .selected import is_edge_network, selected_objects
from .selection_command import SelectionCommand
from .view_in_front import view_for_clicks

__all__ = ["SegmentCommand"]


class SegmentCommand(SelectionCommand):
    """The command; with a network of edges selected it asks for a click."""

    def _make(self, doc: Any) -> None:
        chosen = selected_objects(doc)
        networks = [item for item in chosen if is_edge_network(item)]
        if len(networks) != 1 or any(item not in (*networks, networks[0].Cloud) for item in chosen):
            super()._make(doc)
            return
        from .region_panel import RegionPanel

        FreeCADGui.Control.showDialog(RegionPanel(doc, view_for_clicks(), networks[0], self.title))
