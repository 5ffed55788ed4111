# SPDX-License-Identifier: LGPL-2.1-or-later
"""A task panel that asks for clicks on one cloud, computes beside the window, and shows the answer.

Nothing is in the document until OK; Cancel, Esc and the window's cross have nothing to take back.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import FreeCAD
import FreeCADGui

from freecad_edgescan import document
from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.scanning import SoFar

from .background import Background
from .clicked_cloud import clicked_cloud, visible_clouds
from .edge_preview import EdgePreview
from .icons import icon_path
from .live_edge import LiveEdge
from .picking import Array
from .qt import QtCore, QtGui, QtWidgets, as_int
from .translation import translate
from .view_clicks import ViewClicks

__all__ = ["ClickPanel", "view_for_clicks"]


def view_for_clicks() -> Any:
    """The 3D view in front.

    Raises
    ------
    ValueError: another window is in front.
    """
    view = FreeCADGui.ActiveDocument.ActiveView
    if not hasattr(view, "getSceneGraph"):
        raise ValueError(translate("Bring a 3D view to the front, then start again."))
    return view


class ClickPanel(QtCore.QObject):
    """The panel; a command gives it its questions, its calculation and its answer.

    Parameters
    ----------
    doc : App.Document whose visible clouds can be clicked
    view : the 3D view that is clicked in
    icon : name of the command
    title : of the panel
    questions : what to click, one sentence for each click

    Raises
    ------
    ValueError: the document shows no cloud.
    """

    def __init__(
        self, doc: Any, view: Any, icon: str, title: str, questions: Sequence[str]
    ) -> None:
        super().__init__()
        self.clouds = visible_clouds(doc)
        if not self.clouds:
            raise ValueError(
                translate(
                    "This document shows no point cloud. Import one (EdgeScan → Import cloud), "
                    "or make a hidden one visible."
                )
            )
        self.doc, self.title, self.questions = doc, title, questions
        self._view = view
        self._open = True
        self.cloud: Any = None
        self.numbers: PointCloud | None = None
        self.places: list[Array] = []
        self.result: Any = None
        self.buttons: Any = None
        self._work: Background | None = None
        self.form = _ClickForm(title, icon)
        self.preview = EdgePreview(view)
        self._clicks = ViewClicks(view, self._click, self._escape)
        self._ctrl = view.getNavigationType() == "Gui::InventorNavigationStyle"
        self._ask()
        FreeCAD.addDocumentObserver(self)

    # What a command's own panel does.

    def calculate(self, numbers: PointCloud, places: list[Array], progress: Any) -> Any:
        """Compute from the places clicked; in a thread, on arrays only."""
        raise NotImplementedError

    def show_result(self, result: Any) -> str:
        """Draw a result in the preview; rich text that says what it is."""
        raise NotImplementedError

    def after_result(self) -> str:
        """What can be done now that there is a result."""
        return translate("OK keeps this. Click elsewhere to begin again.")

    def keep(self) -> None:
        """Put the result into the document.

        Raises
        ------
        ValueError: that cannot be; the panel stays open.
        """
        raise NotImplementedError

    # What FreeCAD calls.

    def getStandardButtons(self) -> int:
        """OK and Cancel."""
        buttons = QtWidgets.QDialogButtonBox
        return as_int(buttons.Ok | buttons.Cancel)

    def modifyStandardButtons(self, box: Any) -> None:
        """OK waits until there is a result."""
        self.buttons = box
        self._allow_ok()

    def accept(self) -> bool:
        """Keep the result; the panel stays open when that fails."""
        if self.result is None:
            return False
        try:
            self.keep()
        except ValueError as error:
            self.form.say(str(error))
            return False
        self.close()
        return True

    def reject(self) -> bool:
        """Leave no trace."""
        self.close()
        return True

    def slotDeletedDocument(self, doc: Any) -> None:
        """The document is being closed under the panel."""
        if self._open and doc.Name == self.doc.Name:
            self.close()
            QtCore.QTimer.singleShot(0, FreeCADGui.Control.closeDialog)

    def slotDeletedObject(self, item: Any) -> None:
        """A cloud is being deleted under the panel."""
        if not self._open:
            return
        self.clouds = [cloud for cloud in self.clouds if cloud.Name != item.Name]
        if self.cloud is not None and item.Name == self.cloud.Name:
            self._start_over()
            self.form.say(translate("The cloud was deleted.") + " " + self._question())

    # What the user does.

    def _click(self, position: tuple[int, int]) -> None:
        if len(self.places) == len(self.questions):
            self._start_over()
        clouds = self.clouds if self.cloud is None else [self.cloud]
        numbers = [(item, document.point_cloud(item)) for item in clouds]
        picked = clicked_cloud(self._view, position, numbers)
        if picked is None:
            missed = translate("There is no point of a visible cloud under the cursor.")
            self.form.say(f"{missed} {self._question()}")
            return
        self.cloud, self.numbers = picked.item, picked.numbers
        self.places.append(picked.point)
        self.preview.show_clicks(self.places)
        if len(self.places) < len(self.questions):
            self._ask()
        else:
            self._compute()

    def _compute(self) -> None:
        numbers, places = self.numbers, list(self.places)
        assert numbers is not None
        self.form.show_progress(True)
        self.form.say(translate("Computing. Cancel gives it up."))
        work = Background(lambda progress: self.calculate(numbers, places, progress), _drawn)
        work.advanced.connect(self._advance)
        work.succeeded.connect(self._succeed)
        work.failed.connect(self._fail)
        self._work = work
        work.begin()

    def _advance(self) -> None:
        if self._work is None or self.sender() is not self._work:
            return
        report = self._work.take()
        if report is not None and report[1] is not None:
            self.preview.show_edge(report[1])

    def _succeed(self, result: Any) -> None:
        if self.sender() is not self._work:
            return
        self._work = None
        self.result = result
        self.form.show_progress(False)
        self.form.show_text(self.show_result(result))
        self.form.say(self.after_result())
        self._allow_ok()

    def _fail(self, sentence: str) -> None:
        if self.sender() is not self._work:
            return
        self._start_over()
        self.form.say(f"{sentence} {self._question()}")

    def _escape(self) -> None:
        # The view is still handling the key: the panel goes when it is done.
        QtCore.QTimer.singleShot(0, self._close_by_key)

    def _close_by_key(self) -> None:
        if self._open:
            self.reject()
            FreeCADGui.Control.closeDialog()

    # The rest.

    def up_to_date(self) -> bool:
        """Whether the cloud is still the one the result belongs to."""
        return document.point_cloud(self.cloud) is self.numbers

    def close(self) -> None:
        """Take everything of the panel's out of the view and end its thread."""
        if not self._open:
            return
        self._open = False
        self.buttons = None  # FreeCAD's own, which Python must not keep longer than FreeCAD
        FreeCAD.removeDocumentObserver(self)
        self._end_work()
        self._clicks.close()
        self.preview.close()

    def _start_over(self) -> None:
        self._end_work()
        self.cloud = self.numbers = self.result = None
        self.places = []
        self.preview.show_clicks(())
        self.preview.clear_edge()
        self.form.show_progress(False)
        self.form.show_text("")
        self._allow_ok()
        self._ask()

    def _question(self) -> str:
        sentence = self.questions[min(len(self.places), len(self.questions) - 1)]
        return sentence + (" " + translate("Hold Ctrl while clicking.") if self._ctrl else "")

    def _ask(self) -> None:
        self.form.say(self._question())

    def _end_work(self) -> None:
        if self._work is not None:
            self._work.abandon()
            self._work = None

    def _allow_ok(self) -> None:
        if self.buttons is not None:
            ok = self.buttons.button(QtWidgets.QDialogButtonBox.Ok)
            ok.setEnabled(self.result is not None)


class _ClickForm(QtWidgets.QWidget):
    """The widget inside the panel: a sentence, a bar while it computes, the answer."""

    def __init__(self, title: str, icon: str) -> None:
        super().__init__()
        self.setWindowTitle(title)
        self.setWindowIcon(QtGui.QIcon(icon_path(icon)))
        self._sentence = QtWidgets.QLabel()
        self._sentence.setWordWrap(True)
        bold = self._sentence.font()
        bold.setBold(True)
        self._sentence.setFont(bold)
        self._progress = QtWidgets.QProgressBar()
        self._progress.setRange(0, 0)
        self._text = QtWidgets.QTextEdit()
        self._text.setReadOnly(True)
        self._text.setMinimumHeight(18 * self.fontMetrics().lineSpacing())
        column = QtWidgets.QVBoxLayout(self)
        for widget in (self._sentence, self._progress, self._text):
            column.addWidget(widget)
        column.addStretch()
        self.show_progress(False)
        self.show_text("")

    @property
    def sentence(self) -> str:
        """What the user is told at the top."""
        return str(self._sentence.text())

    @property
    def text(self) -> str:
        """The answer that is shown."""
        return str(self._text.toPlainText())

    def say(self, sentence: str) -> None:
        """Tell the user what to do now, or what went wrong."""
        self._sentence.setText(sentence)

    def show_progress(self, running: bool) -> None:
        """Show or hide the bar."""
        self._progress.setVisible(running)

    def show_text(self, text: str) -> None:
        """Show the answer, or hide the field when there is none."""
        self._text.setHtml(text)
        self._text.setVisible(bool(text))


def _drawn(so_far: object) -> LiveEdge | None:
    """What the preview shows of a report: an edge that is being walked along."""
    return LiveEdge.of_walk(so_far) if isinstance(so_far, SoFar) else None
