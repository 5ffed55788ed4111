# SPDX-License-Identifier: LGPL-2.1-or-later
"""Everything the panel of all edges shows in the 3D view, and takes away again."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pivy import coin

from freecad_edgescan.scanning import ScannedEdge

from .colours import CLICK, EDGE, LEFT_OUT
from .drawing import Lines, Points, on_screen, unpickable
from .edge_picking import LinePicker
from .picking import Array
from .thinned_clouds import ThinnedClouds
from .view_clicks import is_open
from .view_ray import view_ray

__all__ = ["NetworkDisplay", "line_of"]

_NEAR = 8  # logical pixels within which the mouse is over an edge
_DARK = (0.08, 0.08, 0.08)
_NONE = np.zeros((0, 3))


def line_of(edge: ScannedEdge) -> Array:
    """An edge as a polyline from vertex to vertex, (k, 3) mm."""
    line = edge.vertex_to_vertex
    return np.vstack([line, line[:1]]) if edge.closed else line


class NetworkDisplay:
    """A thinned cloud, the edges that are kept, those that are not, and the one under the mouse.

    Parameters
    ----------
    view : the 3D view to show it in, until ``close``

    Attributes
    ----------
    clouds : the thinned cloud
    counts : how many edges are drawn as kept, and how many as left out
    """

    def __init__(self, view: Any) -> None:
        self._view = view
        self.counts = 0, 0
        self._lines: Sequence[Array] = ()
        self._picker = LinePicker()
        self._aside: tuple[Any, Any, int] | None = None
        self._left_out = Lines(LEFT_OUT, on_screen(2.0))
        self._rims = Lines(_DARK, on_screen(5.0))
        self._kept = Lines(EDGE, on_screen(3.0))
        self._meant = Lines(CLICK, on_screen(11.0))
        self._corners = Points(EDGE, on_screen(8.0))
        self._root = coin.SoAnnotation()
        self._root.setName("EdgeScanNetwork")
        self._root.addChild(unpickable())
        for drawing in (self._meant, self._rims, self._left_out, self._kept, self._corners):
            self._root.addChild(drawing.node)
        self._scene: Any = view.getSceneGraph()
        self._scene.addChild(self._root)
        self.clouds = ThinnedClouds(view)

    def show_edges(
        self, lines: Sequence[Array], mask: NDArray[np.bool_], corners: Array = _NONE
    ) -> None:
        """Show polylines, those that are kept and those that are not, and corners (k, 3)."""
        if lines is not self._lines:
            self._lines = lines
            self._picker = LinePicker(lines)
            self.point_at(None)
        kept = [line for line, wanted in zip(lines, mask, strict=True) if wanted]
        left_out = [line for line, wanted in zip(lines, mask, strict=True) if not wanted]
        self._kept.draw(kept)
        self._rims.draw(kept)
        self._left_out.draw(left_out)
        self._corners.draw(corners)
        self.counts = len(kept), len(left_out)

    def edge_at(self, position: tuple[int, int]) -> int | None:
        """Number of the edge under a pixel, or None."""
        if not is_open(self._view):
            return None
        return self._picker.under(view_ray(self._view, position, _NEAR))

    def point_at(self, number: int | None) -> None:
        """Mark an edge as the one that is meant, or none."""
        self._meant.draw([] if number is None else [self._lines[number]])

    def set_aside(self, view_object: Any) -> None:
        """Take an object off the screen without hiding it, until ``close``."""
        switch = view_object.SwitchNode.whichChild
        self._aside = view_object, switch, switch.getValue()
        switch.setValue(coin.SO_SWITCH_NONE)

    def close(self, restore: bool = True) -> None:
        """Leave the view as it was; without restoring, when the document is going."""
        self.clouds.close(restore)
        if self._aside is not None and restore:
            view_object, switch, child = self._aside
            with suppress(ReferenceError, RuntimeError, AttributeError):  # deleted meanwhile
                if view_object.Visibility:
                    switch.setValue(child)
        self._aside = None
        if self._scene is not None:
            self._scene.removeChild(self._root)
            self._scene = None
