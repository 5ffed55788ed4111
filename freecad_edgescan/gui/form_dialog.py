# SPDX-License-Identifier: LGPL-2.1-or-later
"""A dialog of one sentence and some fields, with OK and Cancel."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from .icons import icon_path
from .qt import QtGui, QtWidgets

__all__ = ["FormDialog"]


class FormDialog(QtWidgets.QDialog):
    """Asks for what a command needs besides the selection.

    Parameters
    ----------
    title : of the window
    icon : name of the command
    sentence : what the dialog is about
    """

    def __init__(self, title: str, icon: str, sentence: str) -> None:
        super().__init__(FreeCADGui.getMainWindow())
        self.setWindowTitle(title)
        self.setWindowIcon(QtGui.QIcon(icon_path(icon)))
        self.setMinimumWidth(26 * self.fontMetrics().averageCharWidth() * 2)
        self.sentence = QtWidgets.QLabel(sentence)
        self.sentence.setWordWrap(True)
        self.fields = QtWidgets.QFormLayout()
        buttons = QtWidgets.QDialogButtonBox
        self.buttons = buttons(buttons.Ok | buttons.Cancel)
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self.reject)
        column = QtWidgets.QVBoxLayout(self)
        column.addWidget(self.sentence)
        column.addLayout(self.fields)
        column.addStretch()
        column.addWidget(self.buttons)

    def add(self, label: str, field: Any) -> Any:
        """Add a field under its label; Alt and the letter after & reach it."""
        self.fields.addRow(label, field)
        return field

    def asked(self) -> bool:
        """Show it until it is closed; whether that was by OK."""
        accepted = bool(self.exec_() if hasattr(self, "exec_") else self.exec())
        self.deleteLater()
        return accepted
