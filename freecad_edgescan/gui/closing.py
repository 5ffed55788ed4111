# SPDX-License-Identifier: LGPL-2.1-or-later
"""Notices when what a panel needs is closed: its dock by the cross, its 3D view, its view's window.

FreeCAD keeps a task panel alive when its dock is closed, where nobody could end it any more.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCADGui

from .qt import QtCore, QtWidgets
from .single_shot import call_later

__all__ = ["ClosingWatch"]


class ClosingWatch(QtCore.QObject):
    """Calls ``closed`` after one of some windows was told to close, until ``end``."""

    def __init__(self, closed: Callable[[], None]) -> None:
        super().__init__()
        self._closed: Callable[[], None] | None = closed
        self._watched: list[Any] = []

    def watch_dock_of(self, widget: Any) -> None:
        """Watch the dock a widget is in."""
        while widget is not None and not isinstance(widget, QtWidgets.QDockWidget):
            widget = widget.parentWidget()
        self._watch(widget)

    def watch_active_view(self) -> None:
        """Watch the window of the 3D view in front."""
        self._watch(FreeCADGui.getMainWindow().centralWidget().currentSubWindow())

    def end(self) -> None:
        """Watch nothing."""
        for watched in self._watched:
            try:
                watched.removeEventFilter(self)
            except RuntimeError:  # gone with its C++ object
                continue
        self._watched = []
        self._closed = None

    def eventFilter(self, watched: Any, event: Any) -> bool:
        """Qt asks this about every event; none is held back."""
        if event.type() == QtCore.QEvent.Close and self._closed is not None:
            # The window has yet to say whether it really closes.
            call_later(self._tell)
        return False

    def _tell(self) -> None:
        if self._closed is not None:
            self._closed()

    def _watch(self, window: Any) -> None:
        if window is not None:
            window.installEventFilter(self)
            self._watched.append(window)
