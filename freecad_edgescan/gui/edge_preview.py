# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is drawn over the cloud while an edge is being scanned; never part of a document."""

from __future__ import annotations

from typing import Any

import numpy as np
from pivy import coin

from .colours import CLICK, EDGE
from .picking import Array

__all__ = ["EdgePreview"]


class EdgePreview:
    """The clicked point and the edge as a polyline, drawn in front of everything.

    Parameters
    ----------
    view : the 3D view to draw in, until ``close``
    """

    def __init__(self, view: Any) -> None:
        self._edge = _Drawing(EDGE, coin.SoLineSet(), line_width=3.0)
        self._points = _Drawing(EDGE, coin.SoPointSet(), point_size=5.0)
        self._click = _Drawing(CLICK, coin.SoPointSet(), point_size=9.0)
        self._root = coin.SoAnnotation()
        self._root.setName("EdgeScanPreview")
        unpickable = coin.SoPickStyle()
        unpickable.style.setValue(coin.SoPickStyle.UNPICKABLE)
        self._root.addChild(unpickable)
        for drawing in (self._edge, self._points, self._click):
            self._root.addChild(drawing.node)
        self._scene: Any = view.getSceneGraph()
        self._scene.addChild(self._root)

    def show_click(self, point: Array) -> None:
        """Mark where the user has clicked."""
        self._click.draw(point[None])

    def show_edge(self, points: Array) -> None:
        """Draw edge points (m, 3) and the line through them."""
        self._edge.draw(points)
        self._edge.shape.numVertices.setValue(len(points))
        self._points.draw(points)

    def clear(self) -> None:
        """Draw nothing."""
        self.show_edge(np.zeros((0, 3)))
        self._click.draw(np.zeros((0, 3)))

    def close(self) -> None:
        """Take the drawing out of the view."""
        if self._scene is not None:
            self._scene.removeChild(self._root)
            self._scene = None


class _Drawing:
    """Coordinates with a colour and a shape that joins them."""

    def __init__(
        self,
        colour: tuple[float, float, float],
        shape: Any,
        line_width: float = 1.0,
        point_size: float = 1.0,
    ) -> None:
        self.node = coin.SoSeparator()
        self.shape = shape
        self._coordinates = coin.SoCoordinate3()
        self._coordinates.point.deleteValues(0)
        material = coin.SoBaseColor()
        material.rgb.setValue(*colour)
        style = coin.SoDrawStyle()
        style.lineWidth.setValue(line_width)
        style.pointSize.setValue(point_size)
        light = coin.SoLightModel()
        light.model.setValue(coin.SoLightModel.BASE_COLOR)
        for child in (light, material, style, self._coordinates, shape):
            self.node.addChild(child)

    def draw(self, points: Array) -> None:
        self._coordinates.point.deleteValues(0)
        if len(points):
            rows = np.ascontiguousarray(points, dtype=np.float32)
            self._coordinates.point.setValues(0, len(rows), rows)
