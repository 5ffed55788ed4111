# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that scans an edge: click, watch, accept.

A click meets a point of a visible cloud; the edge is scanned from there in the background and
drawn over the cloud as it grows. Nothing is in the document until OK, which makes the edge in
one undo step; Cancel and Esc therefore have nothing to take back.
"""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui
import numpy as np

from freecad_edgescan import document
from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.document.scanned_edge import write_result
from freecad_edgescan.scanning import ScannedEdge, scan_edge

from .background import Background
from .edge_preview import EdgePreview
from .picking import Array, front_hit, nearest_to_ray
from .qt import QtCore, QtWidgets, as_int
from .recorded_step import as_literal, object_line, run_as_one_step
from .scan_edge_form import ScanEdgeForm
from .shown import select_only
from .view_clicks import ViewClicks
from .view_ray import view_ray

__all__ = ["ScanEdgePanel", "clouds_in"]

CLICK_NEAR_AN_EDGE = "Click on the cloud, near the edge you want."
CTRL_CLICK_NEAR_AN_EDGE = "Hold Ctrl and click on the cloud, near the edge you want."
SCANNING = "The edge is being followed. Stop or Cancel give it up."
KEEP_OR_CLICK_AGAIN = "OK keeps this edge. Click elsewhere to scan another one instead."
MISSED = "There is no point of a visible cloud under the cursor. Click on the cloud, near an edge."
STOPPED = "Stopped. Click on the cloud, near the edge you want."
CLICK_CLOSER = "Click again, closer to an edge."
_WIDER = 3.0  # a click that meets nothing is tried again with this many times the pick radius


def clouds_in(doc: Any) -> list[Any]:
    """Point clouds of a document that are visible."""
    return [
        item
        for item in doc.Objects
        if item.isDerivedFrom("Points::Feature") and item.ViewObject.Visibility
    ]


class ScanEdgePanel(QtCore.QObject):
    """Task panel; ``FreeCADGui.Control.showDialog`` shows it.

    Parameters
    ----------
    doc : App.Document whose visible clouds can be clicked
    view : the 3D view that is clicked in

    Attributes
    ----------
    form : the widget FreeCAD shows
    buttons : FreeCAD's OK and Cancel, while the panel is open
    """

    def __init__(self, doc: Any, view: Any) -> None:
        super().__init__()
        self.form = ScanEdgeForm()
        self.form.stop.clicked.connect(self._stop)
        rotates = view.getNavigationType() == "Gui::InventorNavigationStyle"
        self.form.say(CTRL_CLICK_NEAR_AN_EDGE if rotates else CLICK_NEAR_AN_EDGE)
        self._doc = doc
        self._view = view
        self._open = True
        self.buttons: Any = None
        self._work: Background | None = None
        self._cloud: Any = None
        self._numbers: PointCloud | None = None
        self._at: Array | None = None
        self._edge: ScannedEdge | None = None
        self._preview = EdgePreview(view)
        self._clicks = ViewClicks(view, self._click, self._escape)
        self._index = self._indexing()
        FreeCAD.addDocumentObserver(self)

    # What FreeCAD calls.

    def getStandardButtons(self) -> int:
        """OK and Cancel."""
        buttons = QtWidgets.QDialogButtonBox
        return as_int(buttons.Ok | buttons.Cancel)

    def modifyStandardButtons(self, box: Any) -> None:
        """OK waits until there is an edge."""
        self.buttons = box
        self._allow_ok()

    def accept(self) -> bool:
        """Make the edge in the document; the panel stays open when that fails."""
        if self._edge is None or self._at is None:
            return False
        line = (
            f"edge = document.make_scanned_edge(doc, {object_line(self._cloud)}, "
            f"at={as_literal(self._at)})"
        )
        try:
            made = run_as_one_step(self._doc, "Scan edge", [line], self._hand_over)
        except ValueError as error:
            self.form.say(str(error))
            return False
        self.close()
        select_only(made)
        return True

    def reject(self) -> bool:
        """Leave no trace."""
        self.close()
        return True

    def slotDeletedDocument(self, doc: Any) -> None:
        """The document is being closed under the panel."""
        if self._open and doc.Name == self._doc.Name:
            self.close()
            QtCore.QTimer.singleShot(0, FreeCADGui.Control.closeDialog)

    def slotDeletedObject(self, item: Any) -> None:
        """A cloud is being deleted under the panel."""
        if self._open and self._cloud is not None and item.Name == self._cloud.Name:
            self._forget_edge()
            self.form.say(f"The cloud was deleted. {CLICK_NEAR_AN_EDGE}")

    # What the user does.

    def _click(self, position: tuple[int, int]) -> None:
        picked = self._pick(position)
        if picked is None:
            self.form.say(MISSED)
            return
        self._forget_edge()
        self._cloud, self._numbers, self._at = picked
        numbers, at = self._numbers, self._at
        self._preview.show_click(at)
        self.form.say(SCANNING)
        self.form.show_progress(True)
        work = Background(lambda progress: scan_edge(numbers, at=at, progress=progress), self)
        work.advanced.connect(self._show_so_far)
        work.succeeded.connect(self._show_edge)
        work.failed.connect(self._show_failure)
        self._work = work
        work.start()

    def _stop(self) -> None:
        self._forget_edge()
        self.form.say(STOPPED)

    def _escape(self) -> None:
        # The view is still handling the key: the panel goes when it is done.
        QtCore.QTimer.singleShot(0, self._close_by_key)

    def _close_by_key(self) -> None:
        if self._open:
            self.reject()
            FreeCADGui.Control.closeDialog()

    # What the background reports; all of it arrives in the main thread.

    def _show_so_far(self, fraction: float, so_far: Any) -> None:
        if self.sender() is self._work:
            self.form.progress_to(fraction)
            points = getattr(so_far, "points", None)
            if points is not None and len(points) > 1:
                self._preview.show_edge(points)

    def _show_edge(self, edge: ScannedEdge) -> None:
        if self.sender() is not self._work:
            return
        self._work = None
        self._edge = edge
        points = edge.points
        self._preview.show_edge(np.vstack([points, points[:1]]) if edge.closed else points)
        self.form.show_progress(False)
        self.form.show_edge(edge)
        self.form.say(KEEP_OR_CLICK_AGAIN)
        self._allow_ok()

    def _show_failure(self, sentence: str) -> None:
        if self.sender() is not self._work:
            return
        self._work = None
        self._preview.show_edge(np.zeros((0, 3)))
        self.form.show_progress(False)
        self.form.say(f"{sentence} {CLICK_CLOSER}")

    # The rest.

    def _hand_over(self, made: list[Any]) -> None:
        """Give the edge object the result, unless its cloud has changed since."""
        if self._edge is not None and document.point_cloud(self._cloud) is self._numbers:
            write_result(made[0], self._edge)

    def close(self) -> None:
        """Take everything of the panel's out of the view and end its threads."""
        if not self._open:
            return
        self._open = False
        self.buttons = None  # FreeCAD's own, which Python must not keep longer than FreeCAD
        FreeCAD.removeDocumentObserver(self)
        self._end_work()
        self._index.abandon()
        self._clicks.close()
        self._preview.close()

    def _indexing(self) -> Background:
        """Index the clouds while the user looks for the edge."""
        clouds = [document.point_cloud(item) for item in clouds_in(self._doc)]

        def index(progress: Background) -> None:
            for cloud in clouds:
                _ = cloud.tree, cloud.pitch

        work = Background(index, self)
        work.start()
        return work

    def _pick(self, position: tuple[int, int]) -> tuple[Any, PointCloud, Array] | None:
        """The cloud that is clicked on, as object and as numbers, and the point."""
        self._index.wait()
        ray = view_ray(self._view, position)
        items = clouds_in(self._doc)
        clouds = [document.point_cloud(item) for item in items]
        for seen in (ray, ray.widened(_WIDER)):
            hits = [nearest_to_ray(cloud.tree, seen, 1.5 * cloud.pitch) for cloud in clouds]
            number = front_hit(hits)
            if number is not None:
                hit = hits[number]
                assert hit is not None
                return items[number], clouds[number], clouds[number].points[hit.index]
        return None

    def _forget_edge(self) -> None:
        self._end_work()
        self._edge = self._at = self._cloud = self._numbers = None
        self._preview.clear()
        self.form.show_progress(False)
        self.form.show_edge(None)
        self._allow_ok()

    def _end_work(self) -> None:
        if self._work is not None:
            self._work.abandon()
            self._work = None

    def _allow_ok(self) -> None:
        if self.buttons is not None:
            ok = self.buttons.button(QtWidgets.QDialogButtonBox.Ok)
            ok.setEnabled(self._edge is not None)
