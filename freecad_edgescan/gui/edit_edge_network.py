# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opens the panel of all edges for a network that is there already."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from .message import problems_shown
from .translation import translate
from .view_in_front import view_of

__all__ = ["edit_edge_network"]


def edit_edge_network(network: Any) -> None:
    """Open the panel that made a network, to change it; or say why that cannot be."""
    from .all_edges_panel import AllEdgesPanel

    with problems_shown(translate("Edit network of edges")):
        if FreeCADGui.Control.activeDialog():
            raise ValueError(translate("Finish or cancel the open task panel first."))
        if network.Cloud is None:
            raise ValueError(
                translate(
                    "The cloud of {label} is gone. Choose another one in its property Cloud, or "
                    "undo the deletion."
                ).format(label=network.Label)
            )
        doc = network.Document
        FreeCADGui.Control.showDialog(AllEdgesPanel(doc, view_of(doc), network.Cloud, network))
