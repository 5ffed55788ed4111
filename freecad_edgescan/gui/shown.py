# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows the user what a command has made: seen as a whole, and selected."""

from __future__ import annotations

from typing import Any

import FreeCADGui

__all__ = ["fit_view", "select_only"]


def fit_view(doc: Any) -> None:
    """Let the 3D view of a document show all of it, if it has one."""
    view = FreeCADGui.getDocument(doc.Name).ActiveView
    if hasattr(view, "fitAll"):
        view.fitAll()


def select_only(items: list[Any]) -> None:
    """Select these objects and nothing else."""
    FreeCADGui.Selection.clearSelection()
    for item in items:
        FreeCADGui.Selection.addSelection(item)
