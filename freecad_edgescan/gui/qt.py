# SPDX-License-Identifier: LGPL-2.1-or-later
"""Qt as FreeCAD hands it out: Qt 5 or 6, and FreeCAD 0.20's PySide without QtWidgets."""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:  # FreeCAD 0.20 keeps the widgets in QtGui
    from PySide import QtGui as QtWidgets

__all__ = ["QtCore", "QtGui", "QtWidgets", "as_int"]


def as_int(flags: Any) -> int:
    """Qt flags as the number FreeCAD expects; enums of Qt 6 refuse int()."""
    try:
        return int(flags)
    except TypeError:
        return int(flags.value)
