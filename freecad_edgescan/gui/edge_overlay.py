# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a scanned edge can show besides its curve: the colours of sigma, and its scan lines."""

from __future__ import annotations

from typing import Any

import numpy as np
from pivy import coin

from .colours import EDGE, LEFT_OUT, sigma_colours
from .drawing import Lines, Points, on_screen, unpickable
from .picking import Array

__all__ = ["EdgeOverlay"]


class EdgeOverlay:
    """Nodes beside the edge's own in its part of the scene, so that they move with it.

    Parameters
    ----------
    view_object : of the scanned edge
    """

    def __init__(self, view_object: Any) -> None:
        self._switch = coin.SoSwitch()
        self._switch.setName("EdgeScanOverlay")
        inside = coin.SoSeparator()
        inside.addChild(unpickable())
        self._lines = Lines(LEFT_OUT, on_screen(1.0))
        self._coloured = Lines(EDGE, on_screen(5.0))
        self._points = Points(EDGE, on_screen(6.0))
        for drawing in (self._lines, self._coloured, self._points):
            inside.addChild(drawing.node)
        self._switch.addChild(inside)
        self._root = view_object.RootNode
        self._root.addChild(self._switch)

    def draw(self, edge: Any, by_sigma: bool, scan_lines: bool, visible: bool) -> None:
        """Draw what is wanted of a scanned edge object."""
        shown = visible and (by_sigma or scan_lines)
        self._switch.whichChild.setValue(coin.SO_SWITCH_ALL if shown else coin.SO_SWITCH_NONE)
        if not shown:
            return
        points = _rows(edge.Points)
        self._lines.draw(_scan_lines(edge, points) if scan_lines else [])
        sigma = np.array(edge.Sigma, dtype=float)
        if not by_sigma or len(sigma) != len(points) or not len(points):
            self._coloured.draw()
            self._points.draw()
            return
        colours = sigma_colours(sigma)
        self._points.draw(points, colours)
        if edge.Closed:
            points, colours = (np.vstack([rows, rows[:1]]) for rows in (points, colours))
        self._coloured.draw([points], colours)


def _scan_lines(edge: Any, points: Array) -> list[Array]:
    """Lines across the edge, half an amplitude along each side."""
    tangents = _rows(edge.Tangents)
    half = 0.5 * float(edge.AmplitudeUsed)
    ends = []
    normals = [_rows(edge.FirstNormals), _rows(edge.SecondNormals)]
    if not len(points) or any(len(rows) != len(points) for rows in (tangents, *normals)):
        return []
    inside = -1.0 if edge.Convex != "no" else 1.0
    for own, other in (normals, normals[::-1]):
        side = np.cross(own, tangents)
        # A side lies behind the other one's surface, seen out of the smaller wedge.
        behind = np.einsum("mi,mi->m", side, other) * inside
        ends.append(points + half * np.where(behind < 0.0, -1.0, 1.0)[:, None] * side)
    return list(np.stack([ends[0], points, ends[1]], axis=1))


def _rows(vectors: Any) -> Array:
    return np.array([tuple(vector) for vector in vectors], dtype=float).reshape(-1, 3)
