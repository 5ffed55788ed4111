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

_HOME_OF = {
    "ScannedEdgeProxy": ("scanned_edge_view", "ViewProviderScannedEdge"),
    "SweepProxy": ("sweep_view", "ViewProviderSweep"),
    **dict.fromkeys(
        (
            "SweptSurfaceProxy",
            "FittedSurfaceProxy",
            "ExtendedSurfaceProxy",
            "SurfaceIntersectionProxy",
            "CloudSegmentProxy",
            "CloudSectionProxy",
            "TrimmedShellProxy",
            "SimulatedCloudProxy",
            "ThinnedCloudProxy",
            "CompensatedCloudProxy",
            "ScannedBoundaryProxy",
            "EdgeWireProxy",
        ),
        ("computed_view", "ViewProviderComputed"),
    ),
    "EdgeNetworkProxy": ("edge_network_view", "ViewProviderEdgeNetwork"),
    "DeviationMapProxy": ("deviation_map_view", "ViewProviderDeviationMap"),
}

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
        if name == "Proxy" and not item.Document.Restoring and _is_bare(item):
            _dress(item)

    def slotActivateDocument(self, doc: Any) -> None:
        # Opening a file ends with this; FreeCAD tells Python nothing of restoring.
        if not doc.Restoring:
            _dress_all(doc)


def _dress_all(doc: Any) -> None:
    bare = [item for item in doc.Objects if _is_bare(item)]
    for item in bare:
        _dress(item)
    if bare:  # a file written without a screen, of which FreeCAD hides everything
        for kind in ("Part::Feature", "Points::Feature"):
            for item in doc.findObjects(kind):
                item.ViewObject.show()
        _fit_soon(doc.Name)


def _fit_soon(name: str) -> None:
    """Fit the view of a document when it is open; FreeCAD makes it after the objects."""
    from .shown import fit_view
    from .single_shot import call_later

    def fit() -> None:
        if name in FreeCAD.listDocuments():
            fit_view(FreeCAD.getDocument(name))

    call_later(fit)


def _is_bare(item: Any) -> bool:
    """Whether an object is ours and has no view provider yet; FreeCAD says None or 1 then."""
    ours = type(getattr(item, "Proxy", None)).__name__ in _HOME_OF
    return ours and getattr(getattr(item, "ViewObject", None), "Proxy", 0) in (None, 1)


def _dress(item: Any) -> None:
    module, name = _HOME_OF[type(item.Proxy).__name__]
    getattr(import_module(f".{module}", __package__), name)(item.ViewObject)
