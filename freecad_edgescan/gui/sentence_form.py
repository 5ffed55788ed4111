# SPDX-License-Identifier: LGPL-2.1-or-later
"""The widget inside a task panel that tells the user at its top what to do now."""

from __future__ import annotations

from .icons import icon_path
from .qt import QtCore, QtGui, QtWidgets

__all__ = ["SentenceForm"]


class SentenceForm(QtWidgets.QWidget):
    """A sentence in bold above whatever else a panel shows.

    Parameters
    ----------
    title : of the panel
    icon : name of the command
    lines : that the sentence may take before what is below moves

    Attributes
    ----------
    column : the layout that holds the sentence; a panel's own widgets follow it
    """

    def __init__(self, title: str, icon: str, lines: int = 1) -> None:
        super().__init__()
        self.setWindowTitle(title)
        self.setWindowIcon(QtGui.QIcon(icon_path(icon)))
        self._sentence = QtWidgets.QLabel()
        self._sentence.setWordWrap(True)
        self._sentence.setMinimumHeight(lines * self.fontMetrics().lineSpacing())
        self._sentence.setAlignment(QtCore.Qt.AlignLeft | QtCore.Qt.AlignTop)
        bold = self._sentence.font()
        bold.setBold(True)
        self._sentence.setFont(bold)
        self.column = QtWidgets.QVBoxLayout(self)
        self.column.addWidget(self._sentence)

    @property
    def sentence(self) -> str:
        """What the user is told at the top."""
        return str(self._sentence.text())

    def say(self, sentence: str) -> None:
        """Tell the user what to do now, or what went wrong."""
        self._sentence.setText(sentence)
