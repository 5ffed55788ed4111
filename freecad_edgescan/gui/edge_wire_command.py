# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wire of edges: joins edges of a network that were clicked on."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from .command import Command
from .obstacles import no_shape
from .recorded_step import object_line, run_as_one_step
from .shown import select_only
from .translation import translate

__all__ = ["edge_wire_command"]

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


def edge_wire_command() -> Command:
    """The command EdgeScan_EdgeWire."""
    return Command(
        "EdgeScan_EdgeWire",
        QT_TRANSLATE_NOOP("EdgeScan_EdgeWire", "Wire of edges"),
        QT_TRANSLATE_NOOP(
            "EdgeScan_EdgeWire",
            "Join edges that follow each other to a wire, for sweeps, lofts and sketches. Select "
            "the edges of a network in the 3D view, the others with Ctrl held.",
        ),
        QT_TRANSLATE_NOOP("EdgeScan_EdgeWire", "Select edges of a network, from corner to corner"),
        _make,
        no_shape,
    )


def _make(doc: Any) -> None:
    network, names = _selected_edges(doc)
    given = f", edges={names!r}" if names else ""
    line = f"wire = document.make_edge_wire(doc, {object_line(network)}{given})"
    select_only(run_as_one_step(doc, translate("Wire of edges", "EdgeScan_EdgeWire"), [line]))


def _selected_edges(doc: Any) -> tuple[Any, list[str]]:
    """The object whose edges are selected, and their names in the order of selecting.

    Raises
    ------
    ValueError: edges of no object, or of several.
    """
    chosen = [item for item in FreeCADGui.Selection.getSelectionEx(doc.Name) if _has_edges(item)]
    if len(chosen) != 1:
        raise ValueError(
            translate(
                "Edges of {count} objects are selected. Select edges of one network in the 3D "
                "view, the others with Ctrl held."
            ).format(count=len(chosen))
        )
    names = [name for name in chosen[0].SubElementNames if name.startswith("Edge")]
    return chosen[0].Object, names


def _has_edges(item: Any) -> bool:
    return bool(getattr(getattr(item.Object, "Shape", None), "Edges", None))
