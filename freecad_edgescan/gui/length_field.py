# SPDX-License-Identifier: LGPL-2.1-or-later
"""A field for a length in whatever unit the user works in; mm inside."""

from __future__ import annotations

from typing import Any

import FreeCADGui

__all__ = ["length_field", "length_in", "set_length"]


def length_field(millimetres: float, tooltip: str = "") -> Any:
    """FreeCAD's own field for quantities, with a length in it."""
    field = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
    field.setProperty("unit", "mm")
    field.setToolTip(tooltip)
    set_length(field, millimetres)
    return field


def set_length(field: Any, millimetres: float) -> None:
    """Show a length."""
    field.setProperty("rawValue", float(millimetres))


def length_in(field: Any) -> float:
    """What was entered, mm."""
    return float(field.property("rawValue"))
