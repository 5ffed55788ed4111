# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is drawn over the cloud while an edge is being scanned; never part of a document."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from pivy import coin

from .colours import CLICK, EDGE, GATE, LEFT_OUT, sigma_colours
from .drawing import Lines, Points, on_screen, unpickable
from .live_edge import LiveEdge
from .picking import Array

__all__ = ["EdgePreview"]

_DARK = (0.08, 0.08, 0.08)
_NOTHING = LiveEdge(np.zeros((0, 3)), np.zeros(0))


class EdgePreview:
    """Clicks, scan lines, edge points and curve, drawn in front of everything.

    Parameters
    ----------
    view : the 3D view to draw in, until ``close``

    Attributes
    ----------
    edge : the LiveEdge that is drawn
    """

    def __init__(self, view: Any) -> None:
        self.edge = _NOTHING
        self._coloured = True
        self._scan_lines = Lines(LEFT_OUT, on_screen(1.0))
        self._curve = Lines(EDGE, on_screen(3.0))
        # Dark rims let points of any colour be seen on any ground.
        self._rims = Points(_DARK, on_screen(8.0))
        self._points = Points(EDGE, on_screen(5.0))
        self._section = Lines((1.0, 1.0, 1.0), on_screen(2.5))
        self._starts = Points(CLICK, on_screen(10.0))
        self._gates = Points(GATE, on_screen(10.0))
        self._root = coin.SoAnnotation()
        self._root.setName("EdgeScanPreview")
        self._root.addChild(unpickable())
        self._lines_shown = coin.SoSwitch()
        self._lines_shown.whichChild.setValue(coin.SO_SWITCH_ALL)
        self._lines_shown.addChild(self._scan_lines.node)
        self._root.addChild(self._lines_shown)
        for drawing in (self._curve, self._rims, self._points, self._section):
            self._root.addChild(drawing.node)
        for drawing in (self._starts, self._gates):
            self._root.addChild(drawing.node)
        self._scene: Any = view.getSceneGraph()
        self._scene.addChild(self._root)

    def show_clicks(self, starts: Sequence[Array], gates: Sequence[Array] = ()) -> None:
        """Mark where the user has clicked, points (3,) each."""
        for drawing, places in ((self._starts, starts), (self._gates, gates)):
            drawing.draw(np.array(places, dtype=float).reshape(-1, 3))

    def show_edge(self, edge: LiveEdge) -> None:
        """Draw an edge, whole or as far as it is known."""
        self.edge = edge
        self._scan_lines.draw(edge.scan_lines)
        self._curve.draw([edge.curve])
        self._rims.draw(edge.points)
        self._draw_points()

    def show_section(self, line: Array | None) -> None:
        """Mark the section that is looked at, as a polyline (k, 3) across the edge."""
        self._section.draw([] if line is None else [line])

    def show_scan_lines(self, wanted: bool) -> None:
        """Show or hide the scan lines."""
        self._lines_shown.whichChild.setValue(coin.SO_SWITCH_ALL if wanted else coin.SO_SWITCH_NONE)

    def colour_by_sigma(self, wanted: bool) -> None:
        """Give edge points the colour of their sigma, or one colour to all."""
        self._coloured = wanted
        self._draw_points()

    def clear_edge(self) -> None:
        """Draw no edge."""
        self.show_edge(_NOTHING)
        self.show_section(None)

    def close(self) -> None:
        """Take the drawing out of the view."""
        if self._scene is not None:
            self._scene.removeChild(self._root)
            self._scene = None

    def _draw_points(self) -> None:
        colours = sigma_colours(self.edge.sigma) if self._coloured else None
        self._points.draw(self.edge.points, colours)
