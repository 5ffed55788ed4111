# SPDX-License-Identifier: LGPL-2.1-or-later
"""The 3D view that a panel works in."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from .translation import translate

__all__ = ["view_for_clicks", "view_of"]


def view_for_clicks() -> Any:
    """The 3D view in front.

    Raises
    ------
    ValueError: another window is in front.
    """
    view = FreeCADGui.ActiveDocument.ActiveView
    if not hasattr(view, "getSceneGraph"):
        raise ValueError(translate("Bring a 3D view to the front, then start again."))
    return view


def view_of(doc: Any) -> Any:
    """A 3D view of a document, the one in front if it is one.

    Raises
    ------
    ValueError: it has none.
    """
    gui_document = FreeCADGui.getDocument(doc.Name)
    view = gui_document.ActiveView
    if hasattr(view, "getSceneGraph"):
        return view
    views = gui_document.mdiViewsOfType("Gui::View3DInventor")
    if not views:
        raise ValueError(translate("Open a 3D view of this document first."))
    return views[0]
