# SPDX-License-Identifier: LGPL-2.1-or-later
"""The legend of a deviation map: colour bar, numbers and histogram at the left of the 3D view.

It is drawn over everything with a camera of its own, whose view is a square from -1 to 1 over the
whole window, and takes no part in picking nor in what "fit all" shows.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import FreeCAD
import numpy as np
from numpy.typing import NDArray
from pivy import coin

from freecad_edgescan.document.deviation_map import deviation_colours

from .translation import translate

__all__ = ["DeviationLegend", "tick_labels"]

Array = NDArray[np.float64]

_LEFT, _WIDTH = -0.985, 0.27  # of the panel
_LOW, _HIGH = -0.55, 0.55  # of the bar
_BAR = (0.085, 0.11)  # from the panel's left; the histogram ends where the bar begins
_ROOM = 0.1  # of the panel above the bar and below
_STEPS = 64  # colours of the bar
_TICKS = 7
_FONT = 14.0  # pixels


class DeviationLegend:
    """Coin nodes that draw the legend; whoever owns `node` shows it.

    Attributes
    ----------
    node : to be added to a scene
    """

    def __init__(self) -> None:
        self.node = coin.SoSwitch()
        self.node.setName("EdgeScanLegend")
        skipped = coin.SoType.fromName("SoSkipBoundingGroup")  # FreeCAD's own
        self._content = coin.SoSeparator() if skipped.isBad() else skipped.createInstance()
        over = coin.SoAnnotation()
        camera = coin.SoOrthographicCamera()
        camera.viewportMapping.setValue(coin.SoCamera.LEAVE_ALONE)
        camera.position.setValue(0.0, 0.0, 1.0)
        camera.nearDistance.setValue(0.1)
        camera.farDistance.setValue(2.0)
        light = coin.SoLightModel()
        light.model.setValue(coin.SoLightModel.BASE_COLOR)
        unpickable = coin.SoPickStyle()
        unpickable.style.setValue(coin.SoPickStyle.UNPICKABLE)
        filled = coin.SoDrawStyle()  # the map around it draws points
        filled.style.setValue(coin.SoDrawStyle.FILLED)
        font = coin.SoFont()
        font.name.setValue("sans")
        font.size.setValue(_FONT)
        self._place = coin.SoTranslation()
        self._drawn = coin.SoSeparator()
        reset = coin.SoResetTransform()
        for child in (reset, unpickable, camera, light, filled, font, self._place, self._drawn):
            over.addChild(child)
        self._content.addChild(over)
        self.node.addChild(self._content)

    def show(self, visible: bool, slot: int = 0) -> None:
        """Show or hide it; slots count the legends beside each other."""
        self._place.translation.setValue(1.05 * _WIDTH * slot, 0.0, 0.0)
        self.node.whichChild.setValue(coin.SO_SWITCH_ALL if visible else coin.SO_SWITCH_NONE)

    def draw(self, title: str, limit: float, histogram: Array) -> None:
        """Draw it anew.

        Parameters
        ----------
        title : of the map
        limit : mm, deviation of the strongest colours
        histogram : numbers of points in equal steps from -limit to limit
        """
        self._drawn.removeAllChildren()
        right, top = _LEFT + _WIDTH, _HIGH + 1.7 * _ROOM
        self._add(_rectangles([(_LEFT, _LOW - _ROOM, right, top)], [(1.0, 1.0, 1.0)], 0.25))
        levels = np.linspace(-1.0, 1.0, _STEPS + 1)
        heights = _LOW + (levels + 1.0) / 2.0 * (_HIGH - _LOW)
        colours = deviation_colours((levels[1:] + levels[:-1]) / 2.0, 1.0)
        begin, end = _LEFT + _BAR[0], _LEFT + _BAR[1]
        bar = [(begin, low, end, high) for low, high in pairwise(heights.tolist())]
        self._add(_rectangles(bar, [tuple(row) for row in colours.tolist()]))
        self._add(_histogram(np.asarray(histogram, dtype=float)))
        unit, labels = tick_labels(limit, _TICKS)
        for height, label in zip(np.linspace(_LOW, _HIGH, _TICKS), labels, strict=True):
            self._add(_text(label, end + 0.012, float(height) - 0.012))
        self._add(_text(title, _LEFT + 0.012, _HIGH + 1.1 * _ROOM))
        self._add(
            _text(
                translate("deviation, {unit}").format(unit=unit), _LEFT + 0.012, _HIGH + 0.5 * _ROOM
            )
        )

    def _add(self, node: Any) -> None:
        self._drawn.addChild(node)


def tick_labels(limit: float, count: int) -> tuple[str, list[str]]:
    """The user's unit of length for a limit, mm, and even numbers from -limit to limit in it."""
    _, factor, unit = FreeCAD.Units.Quantity(limit, FreeCAD.Units.Length).getUserPreferred()
    values = np.linspace(-limit, limit, count) / factor
    digits = max(0, 2 - int(np.floor(np.log10(limit / factor))))
    return unit, [f"{value:+.{digits}f}" if value else "0" for value in values.round(digits) + 0.0]


def _histogram(counts: Array) -> Any:
    """Bars that grow from the colour bar to the left."""
    longest = max(float(counts.max(initial=0.0)), 1.0)
    edges = np.linspace(_LOW, _HIGH, len(counts) + 1)
    reach = _LEFT + _BAR[0] - 0.006
    most = _BAR[0] - 0.018
    bars = [
        (reach - most * float(count) / longest, low, reach, high)
        for count, (low, high) in zip(counts, pairwise(edges.tolist()), strict=True)
    ]
    return _rectangles(bars, [(0.4, 0.4, 0.4)] * len(bars))


def _rectangles(
    boxes: list[tuple[float, float, float, float]],
    colours: list[tuple[float, float, float]],
    transparency: float = 0.0,
) -> Any:
    """Rectangles (left, low, right, high), each in its colour."""
    group = coin.SoSeparator()
    material = coin.SoMaterial()
    material.diffuseColor.setValues(0, len(colours), colours)
    material.transparency.setValue(transparency)
    binding = coin.SoMaterialBinding()
    binding.value.setValue(coin.SoMaterialBinding.PER_FACE)
    corners = [
        (x, y, 0.0)
        for left, low, right, high in boxes
        for x, y in ((left, low), (right, low), (right, high), (left, high))
    ]
    places = coin.SoCoordinate3()
    places.point.setValues(0, len(corners), corners)
    faces = coin.SoFaceSet()
    faces.numVertices.setValues(0, len(boxes), [4] * len(boxes))
    for child in (material, binding, places, faces):
        group.addChild(child)
    return group


def _text(words: str, x: float, y: float) -> Any:
    """Black words that begin at a place."""
    group = coin.SoSeparator()
    colour = coin.SoBaseColor()
    colour.rgb.setValue(0.0, 0.0, 0.0)
    place = coin.SoTranslation()
    place.translation.setValue(x, y, 0.0)
    text = coin.SoText2()
    text.string.setValue(words)
    for child in (colour, place, text):
        group.addChild(child)
    return group
