# SPDX-License-Identifier: LGPL-2.1-or-later
"""Telling the user that a command could not do what was asked."""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from .qt import QtWidgets

__all__ = ["show_problem"]


def show_problem(title: str, sentence: str) -> None:
    """Write one sentence to the report view and show it in a message box."""
    FreeCAD.Console.PrintError(f"{title}: {sentence}\n")
    QtWidgets.QMessageBox.warning(FreeCADGui.getMainWindow(), title, sentence)
