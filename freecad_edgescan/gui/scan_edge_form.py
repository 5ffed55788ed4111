# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panel that scans an edge looks like: a sentence, a progress bar, the result."""

from __future__ import annotations

from typing import Any

import FreeCAD
import numpy as np

from .icons import icon_path
from .qt import QtCore, QtGui, QtWidgets

__all__ = ["ScanEdgeForm"]

_ROWS = ("Length", "Mean sigma", "Mean angle")


class ScanEdgeForm(QtWidgets.QWidget):
    """The widget inside the task panel; it decides nothing.

    Attributes
    ----------
    stop : the button that ends a running scan
    """

    def __init__(self) -> None:
        super().__init__()
        self.setWindowTitle("Scan edge")
        self.setWindowIcon(QtGui.QIcon(icon_path("EdgeScan_ScanEdge")))
        self._sentence = QtWidgets.QLabel()
        self._sentence.setWordWrap(True)
        self._sentence.setMinimumHeight(3 * self.fontMetrics().lineSpacing())
        self._sentence.setAlignment(QtCore.Qt.AlignLeft | QtCore.Qt.AlignTop)
        bold = self._sentence.font()
        bold.setBold(True)
        self._sentence.setFont(bold)
        self._progress = QtWidgets.QProgressBar()
        self._progress.setRange(0, 1000)
        self._progress.setTextVisible(False)
        self.stop = QtWidgets.QPushButton("Stop")
        self.stop.setToolTip("Give this scan up and click elsewhere")
        self._running = QtWidgets.QWidget()
        row = QtWidgets.QHBoxLayout(self._running)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self._progress, 1)
        row.addWidget(self.stop)
        self._result = QtWidgets.QWidget()
        table = QtWidgets.QFormLayout(self._result)
        table.setContentsMargins(0, 0, 0, 0)
        self._values = {name: QtWidgets.QLabel() for name in _ROWS}
        for name, label in self._values.items():
            label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
            table.addRow(f"{name}:", label)
        self._message = QtWidgets.QLabel()
        self._message.setWordWrap(True)
        table.addRow(self._message)
        column = QtWidgets.QVBoxLayout(self)
        for widget in (self._sentence, self._running, self._result):
            column.addWidget(widget)
        column.addStretch()
        self.show_progress(False)
        self.show_edge(None)

    @property
    def sentence(self) -> str:
        """What the user is told at the top."""
        return str(self._sentence.text())

    def value(self, name: str) -> str:
        """What the table says in a row."""
        return str(self._values[name].text())

    def say(self, sentence: str) -> None:
        """Tell the user what to do now, or what went wrong."""
        self._sentence.setText(sentence)

    def show_progress(self, running: bool) -> None:
        """Show or hide the progress bar and the stop button."""
        self._progress.setRange(0, 0)
        self._running.setVisible(running)

    def progress_to(self, fraction: float) -> None:
        """Show the share that is done; nan when nobody knows."""
        if np.isfinite(fraction):
            self._progress.setRange(0, 1000)
            self._progress.setValue(round(1000 * fraction))

    def show_edge(self, edge: Any) -> None:
        """Show the figures of a ScannedEdge, or none."""
        self._result.setVisible(edge is not None)
        if edge is None:
            return
        self._values["Length"].setText(_length(edge.length))
        self._values["Mean sigma"].setText(f"{1000 * float(np.nanmean(edge.sigma)):.1f} µm")
        self._values["Mean angle"].setText(f"{np.degrees(float(np.nanmean(edge.angle))):.1f}°")
        self._message.setText(edge.message)


def _length(millimetres: float) -> str:
    """A length in the units the user works in."""
    return str(FreeCAD.Units.Quantity(millimetres, FreeCAD.Units.Length).UserString)
