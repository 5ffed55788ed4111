# SPDX-License-Identifier: LGPL-2.1-or-later
"""What task panels have in common that are answered by clicks in a 3D view.

Nothing is in the document until OK; Cancel, Esc and any window that is closed have nothing to take
back. At most one calculation runs beside the window.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCADGui

from .background import Background
from .closing import ClosingWatch
from .document_watch import DocumentWatch
from .qt import QtCore, QtWidgets, as_int
from .single_shot import call_later, single_shot
from .translation import translate
from .view_clicks import is_open

__all__ = ["ViewPanel"]


class ViewPanel(QtCore.QObject):
    """Task panel; ``FreeCADGui.Control.showDialog`` shows it.

    Parameters
    ----------
    doc : App.Document
    view : the 3D view in front, which is clicked in
    form : the widget FreeCAD shows

    Attributes
    ----------
    form : the same; FreeCAD takes it away when it is done
    buttons : FreeCAD's OK and Cancel, while the panel is open
    """

    def __init__(self, doc: Any, view: Any, form: Any) -> None:
        super().__init__()
        self._doc = doc
        self._view = view
        self._open = True
        self.buttons: Any = None
        self._work: Background | None = None
        # FreeCAD takes away what it finds as ``form``, and the form itself, when it is done.
        self.form = self._form = form
        form.destroyed.connect(self.close)
        self._escape_timer = single_shot(self, 0, self._cancel)
        self._shown_timer = single_shot(self, 0, self._watch_dock)
        self._closing = ClosingWatch(self._close_if_left)
        self._closing.watch_active_view()
        self._document_watch = DocumentWatch(doc)
        self._document_watch.closed.connect(self.vanish)

    # What each panel does.

    def can_accept(self) -> bool:
        """Whether there is something OK can keep."""
        raise NotImplementedError

    def question(self) -> str:
        """What the user is to click on now."""
        raise NotImplementedError

    def show_share(self, share: float) -> None:
        """A calculation has done this share of its work, 0 … 1; nan where nobody knows."""

    def show_report(self, digest: Any) -> None:
        """A calculation has got farther."""

    def show_result(self, result: Any) -> None:
        """A calculation has ended."""
        raise NotImplementedError

    def show_failure(self, sentence: str) -> None:
        """A calculation has ended without a result."""
        raise NotImplementedError

    def let_go(self, restore: bool) -> None:
        """Take everything out of the view, end threads and observers.

        Parameters
        ----------
        restore : the view stays and shall look as before; False: its document is being closed
        """
        self._open = False
        self.buttons = None  # FreeCAD's own, which Python must not keep longer than FreeCAD
        self._escape_timer.stop()
        self._shown_timer.stop()
        self._closing.end()
        self._document_watch.end()
        self.end_work()

    # What FreeCAD calls.

    def getStandardButtons(self) -> int:
        """OK and Cancel."""
        buttons = QtWidgets.QDialogButtonBox
        return as_int(buttons.Ok | buttons.Cancel)

    def modifyStandardButtons(self, box: Any) -> None:
        """OK waits until there is something to keep."""
        self.buttons = box
        self.allow_ok()
        self._shown_timer.start()

    def reject(self) -> bool:
        """Leave no trace."""
        self.close()
        return True

    def close(self, *_: object) -> None:
        """Take everything of the panel's out of the view, and let go of its threads."""
        if self._open:
            self.let_go(restore=True)

    # For the panels.

    def allow_ok(self) -> None:
        """Let OK be pressed if there is something to keep."""
        if self.buttons is not None:
            self.buttons.button(QtWidgets.QDialogButtonBox.Ok).setEnabled(self.can_accept())

    def begin_work(self, calculate: Callable[..., Any], digest: Callable[[Any], Any]) -> None:
        """Calculate beside the window; see `Background`. Its reports arrive in the main thread."""
        self.end_work()
        work = self._work = Background(calculate, digest)
        work.advanced.connect(self._advance)
        work.succeeded.connect(self._succeed)
        work.failed.connect(self._fail)
        work.begin()

    def end_work(self) -> None:
        """Give up what is calculated, if anything is."""
        if self._work is not None:
            self._work.abandon()
            self._work = None

    def ask(self) -> None:
        """Tell the user what to do now."""
        self._form.say(self._asked())

    def say_and_ask(self, sentence: str) -> None:
        """Say what has happened, and what to do now."""
        self._form.say(f"{sentence} {self._asked()}")

    def leave_soon(self) -> None:
        """Cancel, when the view has handled the event that is answered now."""
        self._escape_timer.start()

    def vanish(self) -> None:
        """The document is being closed under the panel."""
        if self._open:
            self.let_go(restore=False)
            call_later(FreeCADGui.Control.closeDialog)

    def _asked(self) -> str:
        """What asks for clicks, with what the navigation style wants for them."""
        if self._view.getNavigationType() == "Gui::InventorNavigationStyle":
            return translate("Hold Ctrl for clicks.") + " " + self.question()
        return self.question()

    def _advance(self) -> None:
        report = self._work.take() if self._is_current() and self._work is not None else None
        if report is not None:
            self.show_share(report[0])
            self.show_report(report[1])

    def _succeed(self, result: Any) -> None:
        if self._is_current():
            self._work = None
            self.show_result(result)

    def _fail(self, sentence: str) -> None:
        if self._is_current():
            self._work = None
            self.show_failure(sentence)

    def _is_current(self) -> bool:
        """Whether the signal that is answered comes from the calculation that still counts."""
        return self._work is not None and self.sender() is self._work

    def _cancel(self) -> None:
        if self._open:
            self.reject()
            FreeCADGui.Control.closeDialog()

    def _watch_dock(self) -> None:
        if self._open:
            self._closing.watch_dock_of(self._form)

    def _close_if_left(self) -> None:
        """The panel's dock or its 3D view was told to close; the view may have refused."""
        if self._open and (not is_open(self._view) or not self._form.isVisible()):
            self._cancel()
