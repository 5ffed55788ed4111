# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tells a panel what happens to its document meanwhile: undo, deletion, hiding, closing."""

from __future__ import annotations

from typing import Any

import FreeCAD

from .qt import QtCore

__all__ = ["DocumentWatch"]


class DocumentWatch(QtCore.QObject):
    """Watches one document until ``end``.

    Parameters
    ----------
    doc : App.Document

    Signals
    -------
    changed(item, name) : a property of an object has changed
    deleted(name) : an object is going
    shown_or_hidden() : an object has appeared on the screen or disappeared
    closed() : the document is going
    """

    changed = QtCore.Signal(object, str)
    deleted = QtCore.Signal(str)
    shown_or_hidden = QtCore.Signal()
    closed = QtCore.Signal()

    def __init__(self, doc: Any) -> None:
        super().__init__()
        self._observer: Any = _Observer(doc.Name, self)
        FreeCAD.addDocumentObserver(self._observer)

    def end(self) -> None:
        """Watch no longer."""
        if self._observer is not None:
            FreeCAD.removeDocumentObserver(self._observer)
            self._observer = None


class _Observer:
    """FreeCAD calls these, for all documents."""

    def __init__(self, name: str, watch: DocumentWatch) -> None:
        self._name, self._watch = name, watch

    def slotChangedObject(self, item: Any, name: str) -> None:
        if item.Document.Name != self._name:
            return
        # The object's own Visibility follows that of its view provider; what FreeCAD's window
        # tells of view providers it tells before they have an object, which 0.20 does not survive.
        if name == "Visibility":
            self._watch.shown_or_hidden.emit()
        else:
            self._watch.changed.emit(item, name)

    def slotCreatedObject(self, item: Any) -> None:
        # Also when its deletion is undone.
        if item.Document.Name == self._name:
            self._watch.shown_or_hidden.emit()

    def slotDeletedObject(self, item: Any) -> None:
        if item.Document.Name == self._name:
            self._watch.deleted.emit(item.Name)

    def slotDeletedDocument(self, doc: Any) -> None:
        if doc.Name == self._name:
            self._watch.closed.emit()
