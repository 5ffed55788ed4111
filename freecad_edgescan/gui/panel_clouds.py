# SPDX-License-Identifier: LGPL-2.1-or-later
"""The clouds a panel can be clicked on: their numbers at hand, indexed while the user looks."""

from __future__ import annotations

from contextlib import suppress
from functools import cache
from typing import Any

import numpy as np

from freecad_edgescan import document
from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.cloud.point_cloud import require_surface

from .background import Background
from .clicked_cloud import visible_clouds
from .live_edge import LiveEdge
from .qt import QtCore

__all__ = ["PanelClouds"]

# What of a cloud, or of a part it is in, its numbers depend on.
_MATTERS = ("Points", "Placement", "ProbeRadius", "Approach", "Group")


class PanelClouds(QtCore.QObject):
    """The visible clouds of a document, until ``close``.

    Attributes
    ----------
    refusal : why the first cloud that is seen but cannot be worked with cannot; "": all can

    Signals
    -------
    indexed() : a click can be answered at once
    """

    indexed = QtCore.Signal()

    def __init__(self, doc: Any) -> None:
        super().__init__()
        self._doc = doc
        self._numbers: dict[str, PointCloud] = {}
        self._index: Background | None = None
        self.refusal = ""
        self.prepare()

    def prepare(self) -> None:
        """Take the numbers of the clouds that can be seen now, and index them in the background."""
        self._end_index()
        clouds = [numbers for _, numbers in self.shown()]
        if not clouds:
            return

        def index(progress: Background) -> None:
            for cloud in clouds:
                _ = cloud.tree, cloud.pitch, cloud.noise
                with suppress(ValueError):  # said when it is scanned
                    require_surface(cloud)
            _warm_up()

        self._index = Background(index)
        self._index.succeeded.connect(self._is_ready)
        self._index.failed.connect(self._is_ready)
        self._index.begin()

    @property
    def ready(self) -> bool:
        """Whether all clouds are indexed."""
        return self._index is None

    def shown(self) -> list[tuple[Any, PointCloud]]:
        """The clouds that can be seen and worked with, objects with their numbers."""
        self.refusal = ""
        usable = []
        for item in visible_clouds(self._doc):
            try:
                usable.append((item, self.numbers(item)))
            except ValueError as error:
                self.refusal = self.refusal or str(error)
        return usable

    def numbers(self, item: Any) -> PointCloud:
        """The points of a cloud object as numbers; looked up once, until it changes.

        Raises
        ------
        ScanError: it has none that can be worked with.
        """
        if item.Name not in self._numbers:
            self._numbers[item.Name] = document.point_cloud(item)
        return self._numbers[item.Name]

    def knows(self, item: Any) -> bool:
        """Whether the numbers of a cloud object are at hand and as it is now."""
        return item.Name in self._numbers

    def changed(self, item: Any, name: str) -> bool:
        """Take note of a property that has changed; True when clouds are to be looked at anew."""
        if name not in _MATTERS:
            return False
        if item.isDerivedFrom("Points::Feature"):
            self._numbers.pop(item.Name, None)
            return True
        if name in ("Placement", "Group") and item.hasExtension("App::GeoFeatureGroupExtension"):
            self._numbers.clear()
            return True
        return False

    def deleted(self, name: str) -> bool:
        """Take note of an object that is gone; True when it was one of the clouds."""
        return self._numbers.pop(name, None) is not None

    def close(self) -> None:
        """Give everything back."""
        self._end_index()
        self._numbers.clear()

    def _end_index(self) -> None:
        if self._index is not None:
            self._index.abandon()
            self._index = None

    def _is_ready(self) -> None:
        if self.sender() is self._index:
            self._index = None
            self.indexed.emit()


@cache
def _warm_up() -> None:
    """Scan something tiny: the first scan of all imports and sets up what the others find ready."""
    from freecad_edgescan.scanning import ScanError, scan_edge

    x, y = (
        axis.ravel() for axis in np.meshgrid(np.linspace(-3.0, 3.0, 25), np.arange(0.0, 6, 0.25))
    )
    rough = 0.01 * np.sin(40.0 * x + 7.0 * y)
    tent = PointCloud(np.column_stack([x, y, rough - np.abs(x)]))
    with suppress(ScanError):
        LiveEdge.of_edge(scan_edge(tent, at=(0.0, 3.0, 0.0)))
