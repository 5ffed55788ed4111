# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points and lines in a 3D view, as Coin nodes that are filled from arrays."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import FreeCADGui
import numpy as np
from pivy import coin

from .picking import Array

__all__ = ["Lines", "Points", "on_screen", "unpickable"]

_NONE = np.zeros((0, 3))


class _Drawing:
    """Coordinates and colours with a shape that joins them.

    Attributes
    ----------
    node : what is put into the scene
    count : how many points it has
    """

    def __init__(self, shape: Any, colour: Sequence[float], size: float) -> None:
        self.node = coin.SoSeparator()
        self._shape = shape
        self._coordinates = coin.SoCoordinate3()
        self._coordinates.point.deleteValues(0)
        self._colours = coin.SoMaterial()
        self._binding = coin.SoMaterialBinding()
        self._colour = tuple(colour)
        self._style = coin.SoDrawStyle()
        self.count = 0
        self.resize(size)
        light = coin.SoLightModel()
        light.model.setValue(coin.SoLightModel.BASE_COLOR)
        parts = (light, self._style, self._binding, self._colours, self._coordinates, shape)
        for child in parts:
            self.node.addChild(child)

    def resize(self, size: float) -> None:
        """Width of lines and size of points, pixels of the screen."""
        self._style.lineWidth.setValue(size)
        self._style.pointSize.setValue(size)

    def _draw(self, points: Array, colours: Array | None) -> None:
        self.count = len(points)
        self._coordinates.point.deleteValues(0)
        if len(points):
            rows = np.ascontiguousarray(points, dtype=np.float32)
            self._coordinates.point.setValues(0, len(rows), rows)
        if colours is None or not len(points):
            self._binding.value.setValue(coin.SoMaterialBinding.OVERALL)
            self._colours.diffuseColor.setValue(*self._colour)
            return
        rows = np.ascontiguousarray(colours, dtype=np.float32)
        self._colours.diffuseColor.setValues(0, len(rows), rows)
        self._colours.diffuseColor.deleteValues(len(rows))
        self._binding.value.setValue(coin.SoMaterialBinding.PER_VERTEX)


class Points(_Drawing):
    """Points of one colour, or of one each."""

    def __init__(self, colour: Sequence[float], size: float) -> None:
        super().__init__(coin.SoPointSet(), colour, size)

    def draw(self, points: Array = _NONE, colours: Array | None = None) -> None:
        """Draw points (n, 3), with colours (n, 3) or in the one colour."""
        self._draw(points, colours)


class Lines(_Drawing):
    """Polylines of one colour, or with one at each of their points."""

    def __init__(self, colour: Sequence[float], width: float) -> None:
        super().__init__(coin.SoLineSet(), colour, width)

    def draw(self, lines: Sequence[Array] = (), colours: Array | None = None) -> None:
        """Draw polylines (k, 3) each, with colours for all their points in order."""
        lines = [line for line in lines if len(line)]
        self._shape.numVertices.deleteValues(0)
        self._draw(np.vstack(lines) if lines else _NONE, colours)
        if lines:
            counts = [len(line) for line in lines]
            self._shape.numVertices.setValues(0, len(counts), counts)


def on_screen(pixels: float) -> float:
    """Logical pixels as pixels of the screen, which are smaller on finer screens."""
    return pixels * float(FreeCADGui.getMainWindow().devicePixelRatioF())


def unpickable() -> Any:
    """A node after which clicks go through what is drawn."""
    style = coin.SoPickStyle()
    style.style.setValue(coin.SoPickStyle.UNPICKABLE)
    return style
