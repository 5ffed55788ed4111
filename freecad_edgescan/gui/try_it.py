# SPDX-License-Identifier: LGPL-2.1-or-later
"""Try it: the core box, and three steps over the 3D view from a cloud to an edge.

The guide only watches: it goes on when the user has done what it asks for, whichever way, and
goes away with its button, its document or its 3D view.
"""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from .command import Command
from .obstacles import panel_open
from .qt import QtCore, QtWidgets
from .recorded_step import run_as_one_step
from .selected import is_scanned_edge
from .translation import translate

__all__ = ["GUIDE_NAME", "try_it_command"]

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

GUIDE_NAME = "EdgeScanGuide"
_PITCH = 0.5  # mm
_LOOK = 300  # ms between two looks at what the user has done
_MARGIN = 24  # pixels
# Its own colours: themes, light or dark, let frames and labels shine through.
_STYLE = f"""
#{GUIDE_NAME} {{ background: #204a87; border: 1px solid #729fcf; border-radius: 6px; }}
#{GUIDE_NAME} QLabel {{ color: #ffffff; background: transparent; border: none; }}
"""


def try_it_command() -> Command:
    """The command EdgeScan_TryIt."""
    return Command(
        "EdgeScan_TryIt",
        QT_TRANSLATE_NOOP("EdgeScan_TryIt", "Try it"),
        QT_TRANSLATE_NOOP(
            "EdgeScan_TryIt",
            "Open the simulated scan of a core box and find its first edge in three steps. "
            "Nothing needs to be selected.",
        ),
        QT_TRANSLATE_NOOP("EdgeScan_TryIt", "Opens an example with a short guide"),
        _try_it,
        panel_open,
    )


def _try_it(_doc: Any) -> None:
    from .cloud_looks import dress_clouds

    FreeCADGui.doCommand('FreeCAD.newDocument("CoreBox")')
    doc = FreeCAD.ActiveDocument
    line = f"document.make_core_box(doc, {_PITCH!r}, small=True)"
    try:
        run_as_one_step(doc, translate("Try it"), [line], dress_clouds)
    except BaseException:
        FreeCAD.closeDocument(doc.Name)
        raise
    view = FreeCADGui.getDocument(doc.Name).ActiveView
    view.setCameraOrientation(_oblique())
    view.fitAll()
    window = FreeCADGui.getMainWindow()
    area = window.findChild(QtWidgets.QMdiArea)
    for older in area.findChildren(QtWidgets.QFrame, GUIDE_NAME):
        older.finish.click()
    guide = _Guide(area, doc.Name)
    guide.show()
    guide.raise_()


def _oblique() -> Any:
    """Looking down into the pipe."""
    return FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 40)


class _Guide(QtWidgets.QFrame):
    """The steps, in a corner of the documents' area."""

    def __init__(self, area: Any, doc_name: str) -> None:
        super().__init__(area)
        self.setObjectName(GUIDE_NAME)
        self._doc_name = doc_name
        self._step = -1
        self.setStyleSheet(_STYLE)
        self._count = QtWidgets.QLabel()
        self._text = QtWidgets.QLabel()
        self._text.setWordWrap(True)
        self._text.setMinimumWidth(52 * self.fontMetrics().averageCharWidth())
        bold = self._count.font()
        bold.setBold(True)
        self._count.setFont(bold)
        self.action = QtWidgets.QPushButton(translate("Scan edge"))
        self.action.clicked.connect(lambda: FreeCADGui.runCommand("EdgeScan_ScanEdge"))
        self.finish = QtWidgets.QPushButton(translate("Close the guide"))
        self.finish.clicked.connect(self._end)
        row = QtWidgets.QHBoxLayout()
        row.addStretch()
        row.addWidget(self.action)
        row.addWidget(self.finish)
        column = QtWidgets.QVBoxLayout(self)
        column.addWidget(self._count)
        column.addWidget(self._text)
        column.addLayout(row)
        self._timer = QtCore.QTimer(self)
        self._timer.timeout.connect(self._look)
        self._timer.start(_LOOK)
        self._look()

    @property
    def sentence(self) -> str:
        """What the user is told."""
        return str(self._text.text())

    def _look(self) -> None:
        """See what the user has done, and go on."""
        if self._doc_name not in FreeCAD.listDocuments():
            self._end()
            return
        doc = FreeCAD.getDocument(self._doc_name)
        if any(is_scanned_edge(item) for item in doc.Objects):
            step = 2
        else:
            step = 1 if FreeCADGui.Control.activeDialog() else 0
        if step != self._step:
            self._step = step
            self._show()
        self._place()

    def _show(self) -> None:
        texts = (
            translate(
                "This cloud was scanned by a ball probe, with gaps and noise. Start the command "
                "Scan edge: here, in the toolbar, or in the menu EdgeScan."
            ),
            translate(
                "Click on the cloud near a rim of the pipe: the edge is followed both ways until "
                "it ends. Then OK keeps it; Undo takes it away again."
            ),
            translate(
                "That is an edge: a native curve in the tree. Its properties say how exact it is "
                "and why it ends. Scan the other rim, too; Cross-section then finds the pipe's "
                "profile between them. With your own scan, begin with Import cloud."
            ),
        )
        self._count.setText(translate("Step {number} of 3").format(number=self._step + 1))
        self._text.setText(texts[self._step])
        self.action.setVisible(self._step == 0)

    def _place(self) -> None:
        """Upper left corner of the area, in front of a view that was opened since."""
        self.adjustSize()
        self.move(_MARGIN, _MARGIN)
        self.raise_()

    def _end(self) -> None:
        self._timer.stop()
        self.hide()
        self.setParent(None)
        self.deleteLater()
