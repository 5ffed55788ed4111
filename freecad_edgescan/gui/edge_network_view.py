# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a network of edges looks in the tree and in the 3D view, and how it is edited."""

from __future__ import annotations

from typing import Any

from .computed_view import ViewProviderComputed
from .translation import translate

__all__ = ["ViewProviderEdgeNetwork"]


class ViewProviderEdgeNetwork(ViewProviderComputed):
    """View provider of a network of edges. It keeps no state: everything lives in properties.

    The name of this class and of its module are written into users' files.
    """

    def doubleClicked(self, view_object: Any) -> bool:
        """Open the panel the network was made with."""
        from .edit_edge_network import edit_edge_network

        edit_edge_network(view_object.Object)
        return True

    def setupContextMenu(self, view_object: Any, menu: Any) -> None:
        """Choose its edges anew."""
        action = menu.addAction(translate("Edit network of edges"))
        action.triggered.connect(lambda: self.doubleClicked(view_object))
