# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a scanned edge looks in the tree and in the 3D view."""

from __future__ import annotations

from typing import Any

from .colours import EDGE
from .icons import icon_path

__all__ = ["ViewProviderScannedEdge"]


class ViewProviderScannedEdge:
    """View provider of a scanned edge. It keeps no state: everything lives in properties.

    The name of this class and of its module are written into users' files.
    """

    def __init__(self, view_object: Any) -> None:
        view_object.Proxy = self
        view_object.LineColor = EDGE
        view_object.LineWidth = 3.0
        view_object.PointColor = EDGE

    def attach(self, view_object: Any) -> None:
        """FreeCAD shows the object for the first time; Part draws the shape itself."""

    def getIcon(self) -> str:
        """Icon in the tree."""
        return icon_path("EdgeScan_ScannedEdge")

    def dumps(self) -> None:
        """Nothing to write into the file."""
        return None

    def loads(self, state: object) -> None:
        """Nothing to read from the file."""

    # FreeCAD before 0.21.2 asks for these instead.
    __getstate__ = dumps
    __setstate__ = loads
