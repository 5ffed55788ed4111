# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clouds drawn with fewer points while a panel is open; what is computed uses all of them.

The clouds themselves are taken off the screen by their switch in the scene, not by their property
Visibility: that would be a change of the document, to be saved, undone and asked about.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from pivy import coin

from freecad_edgescan.cloud import PointCloud

from .drawing import Points, unpickable
from .picking import Array

__all__ = ["MOST_POINTS", "ThinnedClouds", "is_shown"]

MOST_POINTS = 100_000
_COLOURED = ("Color", "Shaded")


def is_shown(item: Any) -> bool:
    """Whether an object can be seen: itself and all the groups it is in."""
    while item is not None:
        if not item.ViewObject.Visibility:
            return False
        item = item.getParentGeoFeatureGroup()
    return True


class ThinnedClouds:
    """Shows clouds in a view until ``close``, in at most 100 000 points together.

    Parameters
    ----------
    view : the 3D view
    """

    def __init__(self, view: Any) -> None:
        self._hidden: dict[str, Any] = {}
        self._drawings: dict[str, Points] = {}
        self._size: float | None = None
        self._root = coin.SoSeparator()
        self._root.setName("EdgeScanThinnedClouds")
        self._root.addChild(unpickable())
        self._planes = [coin.SoClipPlane(), coin.SoClipPlane()]
        for plane in self._planes:
            plane.on.setValue(False)
            self._root.addChild(plane)
        self._clouds = coin.SoGroup()
        self._root.addChild(self._clouds)
        self._scene: Any = view.getSceneGraph()
        self._scene.addChild(self._root)

    @property
    def count(self) -> int:
        """How many points are drawn."""
        return sum(drawing.count for drawing in self._drawings.values())

    def show(self, clouds: Sequence[tuple[Any, PointCloud]]) -> None:
        """Show these clouds, objects with their numbers, and none of those before."""
        self._restore()
        whole = sum(len(numbers) for _, numbers in clouds)
        for item, numbers in clouds:
            most = max(1, MOST_POINTS * len(numbers) // max(whole, MOST_POINTS))
            drawing = Points(tuple(item.ViewObject.ShapeColor[:3]), self._size_of(item))
            rows = _some_rows(len(numbers), most)
            drawing.draw(numbers.points[rows], _own_colours(item, len(numbers), rows))
            self._clouds.addChild(drawing.node)
            self._drawings[item.Name] = drawing
            switch = item.ViewObject.SwitchNode
            self._hidden[item.Name] = (item, switch, switch.whichChild.getValue())
            switch.whichChild.setValue(coin.SO_SWITCH_NONE)

    def resize(self, size: float | None) -> None:
        """Size of the points, pixels; None: each cloud's own."""
        self._size = size
        for name, drawing in self._drawings.items():
            drawing.resize(self._size_of(self._hidden[name][0]))

    def clip(self, slab: tuple[Array, Array, float] | None) -> None:
        """Show the points of a slab only: its middle (3,), direction (3,) and half width, mm."""
        for plane, way in zip(self._planes, (1.0, -1.0), strict=True):
            plane.on.setValue(slab is not None)
            if slab is not None:
                middle, direction, half_width = slab
                normal = way * direction
                inside = coin.SbVec3f(*normal.tolist())
                place = coin.SbVec3f(*(middle - half_width * normal).tolist())
                plane.plane.setValue(coin.SbPlane(inside, place))

    def close(self, restore: bool = True) -> None:
        """Show the clouds themselves again, unless their document is going."""
        if self._scene is None:
            return
        if restore:
            self._restore()
        self._scene.removeChild(self._root)
        self._scene = None

    def _size_of(self, item: Any) -> float:
        return float(item.ViewObject.PointSize) if self._size is None else self._size

    def _restore(self) -> None:
        for item, switch, child in self._hidden.values():
            if _is_wanted(item):
                switch.whichChild.setValue(child)
        self._hidden = {}
        self._drawings = {}
        self._clouds.removeAllChildren()


def _is_wanted(item: Any) -> bool:
    """Whether an object is still there and has not been hidden meanwhile."""
    try:
        return bool(item.ViewObject.Visibility)
    except (ReferenceError, RuntimeError, AttributeError):
        return False


def _some_rows(count: int, most: int) -> np.ndarray:
    """Rows spread at random over all, always the same ones: every so-many-th would be streaky."""
    if count <= most:
        return np.arange(count)
    return np.sort(np.random.default_rng(0).choice(count, most, replace=False, shuffle=False))


def _own_colours(item: Any, count: int, rows: np.ndarray) -> Array | None:
    """Colours of the points where the cloud is shown in its own, (n, 3)."""
    if item.ViewObject.DisplayMode not in _COLOURED or not hasattr(item, "Color"):
        return None
    colours = item.Color
    if len(colours) != count:
        return None
    return np.array([colours[row][:3] for row in rows.tolist()])
