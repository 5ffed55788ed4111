# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user has selected, in the order of selecting."""

from __future__ import annotations

from typing import Any

import FreeCADGui

__all__ = ["is_scanned_edge", "selected_shapes"]


def selected_shapes(doc: Any) -> list[Any]:
    """Selected objects of the document that have a shape, each once."""
    chosen = FreeCADGui.Selection.getSelection(doc.Name)
    return [item for item in dict.fromkeys(chosen) if hasattr(item, "Shape")]


def is_scanned_edge(item: Any) -> bool:
    """Whether an object is one of our edges."""
    return type(getattr(item, "Proxy", None)).__name__ == "ScannedEdgeProxy"
