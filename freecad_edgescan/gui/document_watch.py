# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tells a panel what happens to its document meanwhile: undo, deletion, hiding, closing."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCAD

__all__ = ["DocumentWatch"]


class DocumentWatch:
    """Watches one document until ``end``.

    Parameters
    ----------
    doc : App.Document
    changed : called with an object and the name of the property that has changed
    deleted : called with the name of an object that is going
    shown_or_hidden : called when an object appears on the screen or disappears
    closed : called when the document is going
    """

    def __init__(
        self,
        doc: Any,
        changed: Callable[[Any, str], None],
        deleted: Callable[[str], None],
        shown_or_hidden: Callable[[], None],
        closed: Callable[[], None],
    ) -> None:
        self._observer: Any = _Observer(doc.Name, changed, deleted, shown_or_hidden, closed)
        FreeCAD.addDocumentObserver(self._observer)

    def end(self) -> None:
        """Watch no longer."""
        if self._observer is not None:
            FreeCAD.removeDocumentObserver(self._observer)
            self._observer = None


class _Observer:
    """FreeCAD calls these, for all documents."""

    def __init__(
        self,
        name: str,
        changed: Callable[[Any, str], None],
        deleted: Callable[[str], None],
        shown_or_hidden: Callable[[], None],
        closed: Callable[[], None],
    ) -> None:
        self._name, self._changed, self._deleted = name, changed, deleted
        self._shown_or_hidden, self._closed = shown_or_hidden, closed

    def slotChangedObject(self, item: Any, name: str) -> None:
        if item.Document.Name != self._name:
            return
        # The object's own Visibility follows that of its view provider; what FreeCAD's window
        # tells of view providers it tells before they have an object, which 0.20 does not survive.
        if name == "Visibility":
            self._shown_or_hidden()
        else:
            self._changed(item, name)

    def slotCreatedObject(self, item: Any) -> None:
        # Also when its deletion is undone.
        if item.Document.Name == self._name:
            self._shown_or_hidden()

    def slotDeletedObject(self, item: Any) -> None:
        if item.Document.Name == self._name:
            self._deleted(item.Name)

    def slotDeletedDocument(self, doc: Any) -> None:
        if doc.Name == self._name:
            self._closed()
