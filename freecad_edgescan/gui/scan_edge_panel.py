# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that scans an edge: click, watch, look at the evidence, accept.

A click meets a point of a visible cloud; the edge is scanned from there in the background and
drawn over the cloud as it grows. Nothing is in the document until OK, which makes or changes the
edge in one undo step; Cancel and Esc therefore have nothing to take back.
"""

from __future__ import annotations

from contextlib import suppress
from typing import Any

import FreeCADGui

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.document.scan_inputs import ScanInputs, input_hash, read_inputs
from freecad_edgescan.scanning import Gate, ScanError, Start, Stop

from .background import Background
from .clicked_cloud import Picked, visible_clouds
from .closing import ClosingWatch
from .document_watch import DocumentWatch
from .live_edge import LiveEdge
from .panel_clouds import PanelClouds
from .picked_places import PickedPlaces
from .picking import Array
from .qt import QtCore, QtWidgets, as_int
from .scan_commit import commit_scan
from .scan_display import ScanDisplay
from .scan_edge_form import ScanEdgeForm
from .scan_job import Found, ScanJob
from .shown import select_only
from .translation import translate
from .view_clicks import ViewClicks, is_open

__all__ = ["ScanEdgePanel"]

_HOVER = 30  # ms between two looks at what is under the mouse


class ScanEdgePanel(QtCore.QObject):
    """Task panel; ``FreeCADGui.Control.showDialog`` shows it.

    Parameters
    ----------
    doc : App.Document whose visible clouds can be clicked
    view : the 3D view that is clicked in
    edited : scanned edge that is changed; None: a new one is made

    Attributes
    ----------
    form : the widget FreeCAD shows
    buttons : FreeCAD's OK and Cancel, while the panel is open

    Raises
    ------
    ScanError: an edge that cannot be edited, because its cloud is gone.
    """

    def __init__(self, doc: Any, view: Any, edited: Any = None) -> None:
        super().__init__()
        if edited is not None and edited.Cloud is None:
            input_hash(edited)  # says what to do
        self._doc = doc
        self._view = view
        self._edited = edited
        self._open = True
        self.buttons: Any = None
        self._places = PickedPlaces()
        self._cloud: tuple[Any, PointCloud] | None = None
        self._at: Array | Start | None = None
        self._gate: Array | Gate | None = None
        self._min_angle: float | None = None
        self._work: Background | None = None
        self._found: Found | None = None
        self._waiting: tuple[int, int] | None = None  # a click that came before the index
        self._mouse: tuple[int, int] | None = None
        title = translate("Scan edge") if edited is None else translate("Edit scanned edge")
        # FreeCAD takes away what it finds as ``form``, and the form itself, when it is done.
        self.form = self._form = ScanEdgeForm(title)
        self._form.destroyed.connect(self.close)
        self._connect()
        self._display = ScanDisplay(view)
        self._clouds = PanelClouds(doc, view)
        self._clouds.indexed.connect(self._answer_waiting)
        self._clicks = ViewClicks(view, self._click, self._escape, self._hover)
        self._document_watch = DocumentWatch(
            doc, self._object_changed, self._object_deleted, self._refresh_soon, self._vanish
        )
        self._closing = ClosingWatch(self._close_if_left)
        self._closing.watch_active_view()
        self._show_clouds()
        if edited is None:
            self._say_what_to_click()
        else:
            self._begin_editing()

    def _connect(self) -> None:
        form = self._form
        form.stop.clicked.connect(self._stop_here)
        form.way_changed.connect(self._change_way)
        form.parameters.changed.connect(self._scan_again)
        form.view.changed.connect(self._change_view)
        form.view.look_along.connect(self._look_along)
        form.evidence.chosen.connect(self._show_section)
        self._refresh_timer = _single_shot(self, 0, self._refresh)
        self._hover_timer = _single_shot(self, _HOVER, self._follow_mouse)
        self._escape_timer = _single_shot(self, 0, self._cancel)
        self._shown_timer = _single_shot(self, 0, self._watch_dock)

    # What FreeCAD calls.

    def getStandardButtons(self) -> int:
        """OK and Cancel."""
        buttons = QtWidgets.QDialogButtonBox
        return as_int(buttons.Ok | buttons.Cancel)

    def modifyStandardButtons(self, box: Any) -> None:
        """OK waits until there is an edge."""
        self.buttons = box
        self._allow_ok()
        self._shown_timer.start()

    def accept(self) -> bool:
        """Make or change the edge in the document; the panel stays open when that fails."""
        if self._found is None or self._cloud is None:
            return False
        try:
            kept = commit_scan(self._doc, self._edited, *self._cloud, self._found)
        except (ValueError, ReferenceError) as error:
            self._form.say(str(error))
            return False
        self.close()
        select_only(kept)
        return True

    def reject(self) -> bool:
        """Leave no trace."""
        self.close()
        return True

    def close(self, *_: object) -> None:
        """Take everything of the panel's out of the view, and let go of its threads."""
        if self._open:
            self._let_go(restore=True)

    def _let_go(self, restore: bool) -> None:
        self._open = False
        self.buttons = None  # FreeCAD's own, which Python must not keep longer than FreeCAD
        timers = (self._refresh_timer, self._hover_timer, self._escape_timer, self._shown_timer)
        for timer in timers:
            timer.stop()
        with suppress(RuntimeError):  # the form may be gone
            self._form.parameters.stop_waiting()
        self._document_watch.end()
        self._closing.end()
        self._end_work()
        self._clouds.close()
        self._clicks.close()
        self._display.close(restore)
        if restore:
            self._set_aside(False)

    # What the user does.

    def _click(self, position: tuple[int, int]) -> None:
        if not self._clouds.ready:
            self._waiting = position
            self._form.say(translate("The cloud is being prepared; your click will be answered."))
            return
        picked = self._clouds.pick(position)
        if picked is None:
            self._form.say(self._what_was_missed(position))
        else:
            self._take(picked)

    def _take(self, picked: Picked) -> None:
        if self._cloud is not None and self._cloud[0] is not picked.item:
            self._places.forget()
        self._cloud = picked.item, picked.numbers
        self._places.add(picked.point)
        self._show_places()
        if not self._places.changes_the_scan():
            self._say_what_to_click()
            return
        try:
            self._at, self._gate = self._places.at, self._places.gate
        except ScanError as error:
            self._places.forget()
            self._form.say(str(error))
            return
        self._scan()

    def _stop_here(self) -> None:
        if self._work is not None:
            self._work.stop()
            self._form.stop.setEnabled(False)

    def _change_way(self) -> None:
        self._places = PickedPlaces(self._form.way)
        self._say_what_to_click()

    def _scan_again(self) -> None:
        if self._at is not None and self._cloud is not None:
            self._scan()

    def _change_view(self) -> None:
        self._display.choose(self._form.view)

    def _look_along(self) -> None:
        self._display.look_along()

    def _hover(self, position: tuple[int, int]) -> None:
        self._mouse = position
        if self._found is not None and not self._hover_timer.isActive():
            self._hover_timer.start()

    def _follow_mouse(self) -> None:
        if self._mouse is not None:
            number = self._display.edge_point_at(self._mouse)
            if number is not None:
                self._form.evidence.show_number(number)

    def _escape(self) -> None:
        # The view is still handling the key: the panel goes when it is done.
        self._escape_timer.start()

    def _cancel(self) -> None:
        if self._open:
            self.reject()
            FreeCADGui.Control.closeDialog()

    # The scan; all that it reports arrives in the main thread.

    def _scan(self) -> None:
        assert self._at is not None and self._cloud is not None
        self._forget_edge()
        try:
            given = self._form.parameters.given()
        except ScanError as error:
            self._form.say(str(error))
            return
        method = self._form.parameters.method
        inputs = ScanInputs(self._at, self._gate, given, method, self._min_angle)
        self._form.say(translate("The edge is being followed."))
        self._form.show_progress(True)
        work = Background(ScanJob(self._cloud[1], inputs), LiveEdge.of_walk)
        work.advanced.connect(self._show_so_far)
        work.succeeded.connect(self._show_found)
        work.failed.connect(self._show_failure)
        self._work = work
        work.begin()

    def _show_so_far(self) -> None:
        if self._work is None or self.sender() is not self._work:
            return
        report = self._work.take()
        if report is not None:
            _, edge = report
            self._form.progress_to(edge.points)
            self._display.show_growing(edge)

    def _show_found(self, found: Found) -> None:
        if self._work is None or self.sender() is not self._work:
            return
        self._work = None
        self._found = found
        self._at, self._gate = found.inputs.at, found.inputs.gate
        self._display.show_found(found.edge, found.drawn)
        self._form.show_progress(False)
        self._form.parameters.show_used(found.edge.parameters, found.edge.reasons)
        self._form.show_edge(found.edge)
        if found.stopped and Stop.GATE in found.edge.stops:
            self._display.preview.show_clicks(self._places.points[:1], [found.edge.points[-1]])
            self._form.say(translate("Kept as far as it was scanned: a gate ends it there now."))
        else:
            self._say_what_to_click()
        self._allow_ok()

    def _show_failure(self, sentence: str) -> None:
        if self._work is None or self.sender() is not self._work:
            return
        self._work = None
        self._display.show_no_edge()
        self._form.show_progress(False)
        if self._places.points and len(self._places.points) == self._places.way.clicks:
            self._places.forget()
        self._form.say(sentence)

    def _forget_edge(self) -> None:
        self._end_work()
        self._found = None
        self._display.show_no_edge()
        self._form.show_progress(False)
        self._form.show_edge(None)
        self._allow_ok()

    def _end_work(self) -> None:
        if self._work is not None:
            self._work.abandon()
            self._work = None

    # What happens to the document meanwhile.

    def _object_changed(self, item: Any, name: str) -> None:
        if self._open and self._clouds.changed(item, name):
            if self._cloud is not None and not self._clouds.knows(self._cloud[0]):
                self._lose_cloud(translate("The cloud has changed. Click near an edge again."))
            self._refresh_timer.start()

    def _object_deleted(self, name: str) -> None:
        if not self._open:
            return
        if self._edited is not None and name == self._edited.Name:
            self._edited = None
            self._escape_timer.start()
        elif self._clouds.deleted(name):
            if self._cloud is not None and name == self._cloud[0].Name:
                self._lose_cloud(
                    translate("The cloud was deleted. Click on another one, near an edge.")
                )
            self._refresh_timer.start()

    def _lose_cloud(self, sentence: str) -> None:
        self._cloud = self._at = self._gate = None
        self._places.forget()
        self._forget_edge()
        self._show_places()
        self._form.say(sentence)

    def _refresh_soon(self) -> None:
        if self._open:
            self._refresh_timer.start()

    def _refresh(self) -> None:
        """Follow clouds that have come, gone, or become another size."""
        if self._open:
            self._clouds.prepare()
            self._show_clouds()

    def _vanish(self) -> None:
        """The document is being closed under the panel."""
        if self._open:
            self._let_go(restore=False)
            QtCore.QTimer.singleShot(0, FreeCADGui.Control.closeDialog)

    def _close_if_left(self) -> None:
        """The panel's dock or its 3D view was told to close; the view may have refused."""
        if self._open and (not is_open(self._view) or not self._form.isVisible()):
            self._cancel()

    # Editing.

    def _begin_editing(self) -> None:
        """Scan with the inputs of the edge that is edited."""
        edge = self._edited
        self._set_aside(True)
        try:
            inputs = read_inputs(edge)
            numbers = self._clouds.numbers(edge.Cloud)
        except ValueError as error:
            self._form.say(str(error))
            return
        self._at, self._gate, self._min_angle = inputs.at, inputs.gate, inputs.min_angle
        self._cloud = edge.Cloud, numbers
        self._form.parameters.set_given(inputs.parameters, inputs.method)
        start = inputs.at.point if isinstance(inputs.at, Start) else inputs.at
        gate = inputs.gate.point if isinstance(inputs.gate, Gate) else inputs.gate
        self._display.preview.show_clicks([start], [] if gate is None else [gate])
        self._scan()

    def _set_aside(self, wanted: bool) -> None:
        """Take the edge that is edited off the screen, or bring it back."""
        if self._edited is not None:
            with suppress(ReferenceError, AttributeError):
                self._edited.ViewObject.Proxy.set_aside(self._edited.ViewObject, wanted)

    # The rest.

    def _show_clouds(self) -> None:
        shown = self._clouds.shown()
        self._display.show_clouds(shown)
        self._display.choose(self._form.view)
        whole = sum(len(numbers) for _, numbers in shown)
        self._form.view.show_counts(self._display.clouds.count, whole)

    def _show_places(self) -> None:
        first = self._places.way.value[0]
        points = self._places.points
        self._display.preview.show_clicks(points[:first], points[first:])

    def _show_section(self, number: int) -> None:
        self._display.show_section(number)

    def _answer_waiting(self) -> None:
        if self._open and self._waiting is not None:
            position, self._waiting = self._waiting, None
            self._click(position)

    def _say_what_to_click(self) -> None:
        sentence = self._places.what_to_click()
        if self._edited is not None and self._found is not None and not self._places.points:
            sentence = translate(
                "Change what you like; OK keeps it. A click on the cloud scans another edge."
            )
        elif self._view.getNavigationType() == "Gui::InventorNavigationStyle":
            sentence = translate("Hold Ctrl for clicks.") + " " + sentence
        self._form.say(sentence)

    def _what_was_missed(self, position: tuple[int, int]) -> str:
        """What to say about a click that met no cloud."""
        met = self._view.getObjectInfo(position)
        name = met.get("Object") if met else None
        item = self._doc.getObject(name) if name else None
        if item is not None:
            text = translate("That is {label}, no point cloud. Click on a cloud, near an edge.")
            return text.format(label=item.Label)
        if not visible_clouds(self._doc):
            return translate("No point cloud can be seen. Show one in the tree, then click on it.")
        return translate("There is no point of a visible cloud there. Click on one, near an edge.")

    def _watch_dock(self) -> None:
        if self._open:
            self._closing.watch_dock_of(self._form)

    def _allow_ok(self) -> None:
        if self.buttons is not None:
            ok = self.buttons.button(QtWidgets.QDialogButtonBox.Ok)
            ok.setEnabled(self._found is not None)


def _single_shot(parent: Any, milliseconds: int, answer: Any) -> Any:
    """A timer that, once started, calls back once."""
    timer = QtCore.QTimer(parent)
    timer.setSingleShot(True)
    timer.setInterval(milliseconds)
    timer.timeout.connect(answer)
    return timer
