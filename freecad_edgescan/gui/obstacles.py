# SPDX-License-Identifier: LGPL-2.1-or-later
"""Why a command cannot run now: one sentence, or none.

These look at what is in the document only. With the wrong things selected a command can be run:
it answers with a sentence that says what to select.
"""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from .translation import translate

__all__ = ["no_cloud", "no_cloud_or_shape", "no_document", "no_shape", "panel_open"]


def panel_open() -> str:
    """A task panel is open."""
    if FreeCADGui.Control.activeDialog():
        return translate("Finish or cancel the open task panel first.")
    return ""


def no_document() -> str:
    """There is none, or a panel is open."""
    if FreeCAD.ActiveDocument is None:
        return translate("Open a document first, or import a cloud.")
    return panel_open()


def no_cloud() -> str:
    """The document has no point cloud."""
    return no_document() or (
        ""
        if _any_object(lambda item: item.isDerivedFrom("Points::Feature"))
        else translate(
            "This document has no point cloud. Import one first (EdgeScan → Import cloud)."
        )
    )


def no_shape() -> str:
    """The document has nothing with a shape."""
    return no_document() or (
        ""
        if _any_object(lambda item: hasattr(item, "Shape"))
        else translate("This document has no edge or surface yet. Scan an edge first.")
    )


def no_cloud_or_shape() -> str:
    """The document has no point cloud, or nothing with a shape to go with it."""
    return no_cloud() or no_shape()


def _any_object(meant: Any) -> bool:
    return any(meant(item) for item in FreeCAD.ActiveDocument.Objects)
