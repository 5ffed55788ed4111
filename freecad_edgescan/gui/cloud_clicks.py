# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a panel is told while it waits for clicks on clouds: what is clicked, what has changed."""

from __future__ import annotations

from typing import Any

from freecad_edgescan.cloud import PointCloud

from .clicked_cloud import clicked_cloud, visible_clouds
from .document_watch import DocumentWatch
from .panel_clouds import PanelClouds
from .qt import QtCore
from .single_shot import single_shot
from .translation import translate
from .view_clicks import Pixel, ViewClicks

__all__ = ["CloudClicks"]


class CloudClicks(QtCore.QObject):
    """Tells which point of which visible cloud is clicked on, until ``close``.

    The clouds are indexed beside the window; a click that comes before that is done is answered
    as soon as it is.

    Parameters
    ----------
    doc : App.Document whose visible clouds can be clicked
    view : the 3D view that is clicked in
    watch : tells what happens to the document

    Attributes
    ----------
    used : cloud object whose loss matters, because it was clicked on; None: none

    Signals
    -------
    picked(Picked) : a point of a cloud was clicked on
    missed(sentence) : a click met no cloud, or has to wait
    lost(sentence) : the cloud that is used has changed or is gone
    changed() : other clouds can be seen now, or the same ones have other points
    moved(pixel) : the mouse is moved over the view with no button pressed
    escaped() : Esc is pressed over the view
    """

    picked = QtCore.Signal(object)
    missed = QtCore.Signal(str)
    lost = QtCore.Signal(str)
    changed = QtCore.Signal()
    moved = QtCore.Signal(object)
    escaped = QtCore.Signal()

    def __init__(self, doc: Any, view: Any, watch: DocumentWatch) -> None:
        super().__init__()
        self._doc = doc
        self._view = view
        self.used: Any = None
        self._waiting: Pixel | None = None  # a click that came before the index
        self._refresh_timer = single_shot(self, 0, self._refresh)
        self._clouds = PanelClouds(doc)
        self._clouds.indexed.connect(self._answer_waiting)
        self._clicks = ViewClicks(view, self._click, self.escaped.emit, self.moved.emit)
        watch.changed.connect(self._object_changed)
        watch.deleted.connect(self._object_deleted)
        watch.shown_or_hidden.connect(self._refresh_soon)

    @property
    def ready(self) -> bool:
        """Whether a click is answered at once."""
        return self._clouds.ready

    def shown(self) -> list[tuple[Any, PointCloud]]:
        """The clouds that can be clicked on, objects with their numbers."""
        return self._clouds.shown()

    def numbers(self, item: Any) -> PointCloud:
        """The points of a cloud object as numbers.

        Raises
        ------
        ScanError: it has none that can be worked with.
        """
        return self._clouds.numbers(item)

    def close(self) -> None:
        """Listen no longer, and give everything back."""
        self._refresh_timer.stop()
        self._clicks.close()
        self._clouds.close()
        self.used = self._waiting = None

    def _click(self, position: Pixel) -> None:
        if not self.ready:
            self._waiting = position
            self.missed.emit(translate("The cloud is being prepared; your click will be answered."))
            return
        picked = clicked_cloud(self._view, position, self.shown())
        if picked is None:
            self.missed.emit(self._what_was_missed(position))
        else:
            self.picked.emit(picked)

    def _answer_waiting(self) -> None:
        if self._waiting is not None:
            position, self._waiting = self._waiting, None
            self._click(position)

    def _what_was_missed(self, position: Pixel) -> str:
        """What to say about a click that met no cloud."""
        met = self._view.getObjectInfo(position)
        name = met.get("Object") if met else None
        item = self._doc.getObject(name) if name else None
        if item is not None:
            return translate("That is {label}, no point cloud.").format(label=item.Label)
        if not visible_clouds(self._doc):
            return translate("No point cloud can be seen; show one in the tree.")
        return self._clouds.refusal or translate("There is no point of a visible cloud there.")

    # What happens to the document meanwhile.

    def _object_changed(self, item: Any, name: str) -> None:
        if self._clouds.changed(item, name):
            if self.used is not None and not self._clouds.knows(self.used):
                self._lose(translate("The cloud has changed."))
            self._refresh_soon()

    def _object_deleted(self, name: str) -> None:
        if self._clouds.deleted(name):
            if self.used is not None and name == self.used.Name:
                self._lose(translate("The cloud was deleted."))
            self._refresh_soon()

    def _lose(self, sentence: str) -> None:
        self.used = None
        self.lost.emit(sentence)

    def _refresh_soon(self) -> None:
        self._refresh_timer.start()

    def _refresh(self) -> None:
        """Follow clouds that have come, gone, or become another size."""
        self._clouds.prepare()
        self.changed.emit()
        if self.ready:
            self._answer_waiting()
