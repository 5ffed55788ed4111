# SPDX-License-Identifier: LGPL-2.1-or-later
"""The context menu of a scanned edge in the tree."""

from __future__ import annotations

from typing import Any

from .edit_scanned_edge import edit_scanned_edge
from .scanned_edge_view import BY_SIGMA, SCAN_LINES
from .translation import translate

__all__ = ["fill_edge_menu"]


def fill_edge_menu(view_object: Any, menu: Any) -> None:
    """Add what can be done with a scanned edge to a QMenu."""
    edit = menu.addAction(translate("Edit the scan"))
    edit.triggered.connect(lambda: edit_scanned_edge(view_object.Object))
    for name, title in (
        (BY_SIGMA, translate("Colour by sigma")),
        (SCAN_LINES, translate("Show scan lines")),
    ):
        action = menu.addAction(title)
        action.setCheckable(True)
        action.setChecked(bool(getattr(view_object, name)))
        action.toggled.connect(lambda on, name=name: setattr(view_object, name, on))
