# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gives our objects their view providers.

Objects are made by functions that know no screen, and files may have been written without one.
So the screen watches the documents instead, and dresses each object of ours that it finds bare.
Nothing heavy is imported until there is one.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

import FreeCAD

__all__ = ["start_watching", "stop_watching"]

_HOME_OF = {"ScannedEdgeProxy": ("scanned_edge_view", "ViewProviderScannedEdge")}

_watching: list[Any] = []


def start_watching() -> None:
    """Dress the objects of all open documents, now and from now on."""
    if not _watching:
        _watching.append(_Observer())
        FreeCAD.addDocumentObserver(_watching[0])
    for doc in FreeCAD.listDocuments().values():
        _dress_all(doc)


def stop_watching() -> None:
    """Leave the documents alone."""
    while _watching:
        FreeCAD.removeDocumentObserver(_watching.pop())


class _Observer:
    """FreeCAD calls these when documents change."""

    def slotChangedObject(self, item: Any, name: str) -> None:
        if name == "Proxy":
            _dress(item)

    def slotFinishRestoreDocument(self, doc: Any) -> None:
        _dress_all(doc)


def _dress_all(doc: Any) -> None:
    for item in doc.Objects:
        _dress(item)


def _dress(item: Any) -> None:
    home = _HOME_OF.get(type(getattr(item, "Proxy", None)).__name__)
    view_object = getattr(item, "ViewObject", None)
    if home is None or view_object is None or getattr(view_object, "Proxy", 0) is not None:
        return
    module = import_module(f".{home[0]}", __package__)
    getattr(module, home[1])(view_object)
