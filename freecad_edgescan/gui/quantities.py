# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths and angles in the units the user works in."""

from __future__ import annotations

import math
from typing import Any

import FreeCAD
import FreeCADGui

from .qt import QtCore

__all__ = ["LengthBox", "angle_text", "length_scale", "length_text"]

_SMALL = 0.1  # of a unit


def length_text(millimetres: float) -> str:
    """A length as the user writes it; a dash where there is none."""
    if not math.isfinite(millimetres):
        return "–"
    factor, unit = length_scale(millimetres)
    size = abs(millimetres) / factor
    if 0.0 < size < _SMALL:  # with FreeCAD's two decimals it would be next to nothing
        return f"{QtCore.QLocale().toString(millimetres / factor, 'g', 3)} {unit}"
    return str(FreeCAD.Units.Quantity(millimetres, FreeCAD.Units.Length).UserString)


def length_scale(millimetres: float) -> tuple[float, str]:
    """Unit that suits a length of this size: how many mm it has, and its name."""
    quantity = FreeCAD.Units.Quantity(millimetres, FreeCAD.Units.Length)
    _, factor, unit = quantity.getUserPreferred()
    return float(factor), str(unit)


def angle_text(radians: float) -> str:
    """An angle in degrees; a dash where there is none."""
    return f"{math.degrees(radians):.1f}°" if math.isfinite(radians) else "–"


class LengthBox(QtCore.QObject):
    """FreeCAD's own spin box for lengths, which takes any unit and expressions.

    Attributes
    ----------
    widget : the spin box

    Signals
    -------
    changed() : the user has entered another length
    """

    changed = QtCore.Signal()

    def __init__(self, parent: Any = None) -> None:
        super().__init__(parent)
        self.widget = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
        self.widget.setProperty("unit", "mm")
        self.widget.setProperty("minimum", 0.0)
        self._keep(0.0)
        self.widget.editingFinished.connect(self._entered)
        # The arrows of the box end no editing.
        QtCore.QObject.connect(self.widget, QtCore.SIGNAL("valueChanged(double)"), self._entered)

    @property
    def value(self) -> float:
        """The length, mm: what was set, bit for bit, until the user enters another one."""
        # The box rounds its value to what it shows as soon as it gets the focus.
        if self.widget.text() == self._text:
            return self._set
        return float(self.widget.property("rawValue"))

    def set(self, millimetres: float) -> None:
        """Show a length; this is no change by the user."""
        self.widget.blockSignals(True)
        self.widget.setProperty("rawValue", millimetres)
        self.widget.setProperty("singleStep", _step(millimetres))
        self.widget.blockSignals(False)
        self._keep(millimetres)

    def _entered(self, *_: object) -> None:
        value = self.value
        if value != self._set:
            self._keep(value)
            self.changed.emit()

    def _keep(self, millimetres: float) -> None:
        self._set, self._text = millimetres, self.widget.text()


def _step(millimetres: float) -> float:
    """A round tenth of a length."""
    if millimetres <= 0.0:
        return 0.1
    return float(10.0 ** math.floor(math.log10(millimetres / 5.0)))
