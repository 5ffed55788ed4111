# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a deviation map looks: coloured points, and a legend while they are seen."""

from __future__ import annotations

from typing import Any

import FreeCADGui
import numpy as np

from freecad_edgescan import document
from freecad_edgescan.document.declared_properties import Declared, declare

from .computed_view import ViewProviderComputed
from .deviation_legend import DeviationLegend
from .message import problems_shown
from .qt import QtWidgets
from .translation import translate

__all__ = ["ViewProviderDeviationMap"]

_LEGEND = Declared("Bool", "Legend", "Object Style", "Show colour bar and histogram")


class ViewProviderDeviationMap(ViewProviderComputed):
    """View provider of a deviation map. It keeps no state but the legend's drawing.

    The name of this class and of its module are written into users' files.
    """

    def attach(self, view_object: Any) -> None:
        """FreeCAD shows the map for the first time: the legend becomes part of its scene."""
        super().attach(view_object)
        if "Legend" not in view_object.PropertiesList:
            declare(view_object, (_LEGEND,))
            view_object.Legend = True
        if not hasattr(self, "legend"):
            self.legend = DeviationLegend()
            view_object.RootNode.addChild(self.legend.node)
        self._draw()

    def updateData(self, obj: Any, name: str) -> None:
        """The map was measured anew, or has another name."""
        super().updateData(obj, name)
        if name in ("Color", "Label") and hasattr(self, "legend"):
            self._draw()

    def onChanged(self, view_object: Any, name: str) -> None:
        """The map, or its legend, is shown or hidden: all legends make room for each other."""
        if name in ("Visibility", "Legend") and hasattr(self, "legend"):
            _arrange(view_object.Object.Document)

    def setupContextMenu(self, view_object: Any, menu: Any) -> None:
        """Offer to write the deviations into a file."""
        action = menu.addAction(translate("Save deviations…"))
        action.triggered.connect(lambda *_: _save(view_object.Object))

    def _draw(self) -> None:
        if _is_measured(self.object):
            counts = np.array(self.object.Histogram, dtype=float)
            self.legend.draw(self.object.Label, self.object.LimitUsed.Value, counts)
        _arrange(self.object.Document)


def _is_measured(obj: Any) -> bool:
    """Whether a map has deviations; a new one has not even its properties yet."""
    return getattr(obj, "PointCount", 0) > 0


def _arrange(doc: Any) -> None:
    """Show the legends of a document's visible maps beside each other."""
    slot = 0
    for item in doc.Objects:
        view = getattr(getattr(item, "ViewObject", None), "Proxy", None)
        if isinstance(view, ViewProviderDeviationMap) and hasattr(view, "legend"):
            shown = item.ViewObject
            visible = bool(shown.Visibility and shown.Legend and _is_measured(item))
            view.legend.show(visible, slot)
            slot += visible


def _save(obj: Any) -> None:
    """Ask for a file, and write the deviations into it."""
    title = translate("Save deviations")
    kinds = (
        f"{translate('Table')} (*.csv);;{translate('Picture with histogram')} (*.png *.svg *.pdf)"
    )
    path, _ = QtWidgets.QFileDialog.getSaveFileName(
        FreeCADGui.getMainWindow(), title, f"{obj.Label}.csv", kinds
    )
    if path:
        with problems_shown(title):
            document.save_deviation_map(obj, path)
