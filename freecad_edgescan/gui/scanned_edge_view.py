# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a scanned edge looks in the tree and in the 3D view, and what its context menu offers."""

from __future__ import annotations

from typing import Any

from freecad_edgescan.document.declared_properties import Declared, declare

from .colours import EDGE
from .icons import icon_path

__all__ = ["ViewProviderScannedEdge"]

BY_SIGMA, SCAN_LINES = "ColourBySigma", "ShowScanLines"
_PROPERTIES = (
    Declared(
        "Bool",
        BY_SIGMA,
        "EdgeScan",
        "Show each edge point in the colour of its sigma, from blue (well known) to yellow",
    ),
    Declared(
        "Bool",
        SCAN_LINES,
        "EdgeScan",
        "Show where across the edge each of its points was measured",
    ),
)
_NO_CHILD = -1  # of a switch: nothing is drawn
# What is drawn depends on these properties of the edge.
_DRAWN = ("Points", "Sigma", "FirstNormals", "SecondNormals", "AmplitudeUsed")


class ViewProviderScannedEdge:
    """View provider of a scanned edge. It keeps no state: everything lives in properties.

    The name of this class and of its module are written into users' files.
    """

    def __init__(self, view_object: Any) -> None:
        view_object.Proxy = self
        view_object.LineColor = EDGE
        view_object.LineWidth = 3.0
        view_object.PointColor = EDGE
        self.attach(view_object)

    def attach(self, view_object: Any) -> None:
        """FreeCAD shows the object for the first time; Part draws the shape itself."""
        self.object = view_object.Object
        self._overlay: Any = None
        self._aside: int | None = None  # what was on the screen while it is not
        declare(view_object, _PROPERTIES)

    def getIcon(self) -> str:
        """Icon in the tree."""
        return icon_path("EdgeScan_ScannedEdge")

    def doubleClicked(self, view_object: Any) -> bool:
        """Open the panel the edge was made with."""
        from .edit_scanned_edge import edit_scanned_edge

        edit_scanned_edge(view_object.Object)
        return True

    def setupContextMenu(self, view_object: Any, menu: Any) -> None:
        """Edit the scan, and what is drawn of it."""
        from .edge_menu import fill_edge_menu

        fill_edge_menu(view_object, menu)

    def onChanged(self, view_object: Any, name: str) -> None:
        """Draw what is wanted now."""
        if name in (BY_SIGMA, SCAN_LINES, "Visibility", "Proxy"):
            self._draw(view_object)

    def updateData(self, obj: Any, name: str) -> None:
        """Draw the edge as it is now."""
        if name in _DRAWN and getattr(self, "_overlay", None) is not None:
            self._draw(obj.ViewObject)

    def set_aside(self, view_object: Any, wanted: bool) -> None:
        """Take the edge off the screen without hiding it, or bring it back."""
        switch = view_object.SwitchNode.whichChild
        if wanted:
            self._aside = switch.getValue()
            switch.setValue(_NO_CHILD)
        elif self._aside is not None and view_object.Visibility:
            switch.setValue(self._aside)
            self._aside = None
        self._draw(view_object)

    def dumps(self) -> None:
        """Nothing to write into the file."""
        return None

    def loads(self, state: object) -> None:
        """Nothing to read from the file."""

    # FreeCAD before 0.21.2 asks for these instead.
    __getstate__ = dumps
    __setstate__ = loads

    def _draw(self, view_object: Any) -> None:
        # FreeCAD calls this before all properties exist, too.
        wanted = [name for name in (BY_SIGMA, SCAN_LINES) if getattr(view_object, name, False)]
        overlay = getattr(self, "_overlay", None)
        if overlay is None and not wanted:
            return
        if overlay is None:
            from .edge_overlay import EdgeOverlay

            overlay = self._overlay = EdgeOverlay(view_object)
        overlay.draw(
            view_object.Object,
            by_sigma=BY_SIGMA in wanted,
            scan_lines=SCAN_LINES in wanted,
            visible=view_object.Visibility and self._aside is None,
        )
