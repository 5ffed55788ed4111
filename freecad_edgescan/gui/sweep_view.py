# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a sweep looks in the tree and in the 3D view."""

from __future__ import annotations

from typing import Any

from .icons import icon_path

__all__ = ["ViewProviderSweep"]


class ViewProviderSweep:
    """View provider of a sweep. It keeps no state: everything lives in properties.

    The name of this class and of its module are written into users' files.
    """

    def __init__(self, view_object: Any) -> None:
        view_object.Proxy = self
        self.attach(view_object)

    def attach(self, view_object: Any) -> None:
        """FreeCAD shows the object for the first time; Part draws the shape itself."""
        self.object = view_object.Object

    def getIcon(self) -> str:
        """Icon in the tree."""
        return icon_path("EdgeScan_Sweep")

    def claimChildren(self) -> list[Any]:
        """The profile stands below its sweep; the rail stays where others can use it."""
        return list(self.object.Sections)

    def dumps(self) -> None:
        """Nothing to write into the file."""
        return None

    def loads(self, state: object) -> None:
        """Nothing to read from the file."""

    # FreeCAD before 0.21.2 asks for these instead.
    __getstate__ = dumps
    __setstate__ = loads
