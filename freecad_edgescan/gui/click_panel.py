# SPDX-License-Identifier: LGPL-2.1-or-later
"""A task panel that asks for clicks on one cloud, computes beside the window, and shows the answer.

Nothing is in the document until OK; Cancel, Esc and the window's cross have nothing to take back.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from freecad_edgescan import document
from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.scanning import SoFar

from .clicked_cloud import Picked
from .cloud_panel import CloudPanel
from .edge_preview import EdgePreview
from .live_edge import LiveEdge
from .picking import Array
from .qt import QtWidgets
from .sentence_form import SentenceForm
from .translation import translate

__all__ = ["ClickPanel"]


class ClickPanel(CloudPanel):
    """The panel; a command gives it its questions, its calculation and its answer.

    Parameters
    ----------
    doc : App.Document whose visible clouds can be clicked
    view : the 3D view that is clicked in
    icon : name of the command
    title : of the panel
    questions : what to click, one sentence for each click
    """

    def __init__(
        self, doc: Any, view: Any, icon: str, title: str, questions: Sequence[str]
    ) -> None:
        super().__init__(doc, view, _ClickForm(title, icon))
        self.title, self.questions = title, questions
        self.cloud: Any = None
        self.numbers: PointCloud | None = None
        self.places: list[Array] = []
        self.result: Any = None
        self.preview = EdgePreview(view)
        self.ask()

    # What a command's own panel does.

    def calculate(self, numbers: PointCloud, places: list[Array], progress: Any) -> Any:
        """Compute from the places clicked; in a thread, on arrays only."""
        raise NotImplementedError

    def draw_result(self, result: Any) -> str:
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

    # What FreeCAD calls, and what the 3D view and the document tell.

    def can_accept(self) -> bool:
        """Whether there is a result."""
        return self.result is not None

    def accept(self) -> bool:
        """Keep the result; the panel stays open when that fails."""
        if self.result is None:
            return False
        try:
            self.keep()
        except ValueError as error:
            self._form.say(str(error))
            return False
        self.close()
        return True

    def let_go(self, restore: bool) -> None:
        """Take everything of the panel's out of the view and end its thread."""
        super().let_go(restore)
        self.preview.close()

    def question(self) -> str:
        """The question of the next click, or what to wait for, or what can be done then."""
        if len(self.places) < len(self.questions):
            return self.questions[len(self.places)]
        if self.result is None:
            return translate("Computing. Cancel gives it up.")
        return self.after_result()

    def take(self, picked: Picked) -> None:
        """Keep a place that was clicked on; compute when it was the last one."""
        elsewhere = self.cloud is not None and picked.item is not self.cloud
        if elsewhere or len(self.places) == len(self.questions):
            self._start_over()
        self.cloud, self.numbers = picked.item, picked.numbers
        self._clicks.used = picked.item
        self.places.append(picked.point)
        self.preview.show_clicks(self.places)
        self.ask()
        if len(self.places) == len(self.questions):
            self._compute()

    def lose(self, sentence: str) -> None:
        """Begin again."""
        self._start_over()
        self.say_and_ask(sentence)

    def _compute(self) -> None:
        numbers, places = self.numbers, list(self.places)
        assert numbers is not None
        self.begin_work(lambda progress: self.calculate(numbers, places, progress), _drawn)

    def show_report(self, digest: LiveEdge | None) -> None:
        """Draw how far an edge was followed."""
        if digest is not None:
            self.preview.show_edge(digest)

    def show_result(self, result: Any) -> None:
        """Draw the result and say what it is."""
        self.result = result
        self._form.show_text(self.draw_result(result))
        self.ask()
        self.allow_ok()

    def show_failure(self, sentence: str) -> None:
        """Say what went wrong, and ask again."""
        self._start_over()
        self.say_and_ask(sentence)

    # The rest.

    def up_to_date(self) -> bool:
        """Whether the cloud is still the one the result belongs to."""
        return document.point_cloud(self.cloud) is self.numbers

    def _start_over(self) -> None:
        self.end_work()
        self.cloud = self.numbers = self.result = None
        self._clicks.used = None
        self.places = []
        self.preview.show_clicks(())
        self.preview.clear_edge()
        self._form.show_text("")
        self.allow_ok()


class _ClickForm(SentenceForm):
    """The widget inside the panel: a sentence and the answer."""

    def __init__(self, title: str, icon: str) -> None:
        super().__init__(title, icon)
        self._text = QtWidgets.QTextEdit()
        self._text.setReadOnly(True)
        self.column.addWidget(self._text)
        self.column.addStretch()
        self.show_text("")

    @property
    def text(self) -> str:
        """The answer that is shown."""
        return str(self._text.toPlainText())

    def show_text(self, text: str) -> None:
        """Show the answer, or hide the field when there is none."""
        self._text.setHtml(text)
        self._text.setVisible(bool(text))
        self._fit()

    def resizeEvent(self, event: Any) -> None:
        """The answer may take more lines now, or fewer."""
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        """As high as the answer is, so that nobody has to scroll in it."""
        page = self._text.document()
        page.setTextWidth(self._text.viewport().width())
        self._text.setMinimumHeight(int(page.size().height()) + 2 * self._text.frameWidth())


def _drawn(so_far: object) -> LiveEdge | None:
    """What the preview shows of a report: an edge that is being walked along."""
    return LiveEdge.of_walk(so_far) if isinstance(so_far, SoFar) else None
