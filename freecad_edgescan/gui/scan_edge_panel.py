# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that scans an edge: click, watch, look at the evidence, accept.

A click meets a point of a visible cloud; the edge is scanned from there in the background and
drawn over the cloud as it grows. Nothing is in the document until OK, which makes or changes the
edge in one undo step; Cancel and Esc therefore have nothing to take back.
"""

from __future__ import annotations

from contextlib import suppress
from typing import Any

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.document.scan_inputs import ScanInputs, input_hash, read_inputs
from freecad_edgescan.scanning import Gate, ScanError, Start, Stop

from .clicked_cloud import Picked, visible_clouds
from .document_watch import DocumentWatch
from .live_edge import LiveEdge
from .panel_clouds import PanelClouds
from .picked_places import PickedPlaces
from .picking import Array
from .scan_commit import commit_scan
from .scan_display import ScanDisplay
from .scan_edge_form import ScanEdgeForm
from .scan_job import Found, ScanJob
from .shown import select_only
from .translation import translate
from .view_clicks import ViewClicks
from .view_panel import ViewPanel, single_shot

__all__ = ["ScanEdgePanel"]

_HOVER = 30  # ms between two looks at what is under the mouse


class ScanEdgePanel(ViewPanel):
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
        if edited is not None and edited.Cloud is None:
            input_hash(edited)  # says what to do
        title = translate("Scan edge") if edited is None else translate("Edit scanned edge")
        super().__init__(view, ScanEdgeForm(title))
        self._doc = doc
        self._edited = edited
        self._places = PickedPlaces()
        self._cloud: tuple[Any, PointCloud] | None = None
        self._at: Array | Start | None = None
        self._gate: Array | Gate | None = None
        self._min_angle: float | None = None
        self._found: Found | None = None
        self._waiting: tuple[int, int] | None = None  # a click that came before the index
        self._mouse: tuple[int, int] | None = None
        self._connect()
        self._display = ScanDisplay(view)
        self._clouds = PanelClouds(doc, view)
        self._clouds.indexed.connect(self._answer_waiting)
        self._clicks = ViewClicks(view, self._click, self.leave_soon, self._hover)
        self._document_watch = DocumentWatch(
            doc, self._object_changed, self._object_deleted, self._refresh_soon, self.vanish
        )
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
        self._refresh_timer = single_shot(self, 0, self._refresh)
        self._hover_timer = single_shot(self, _HOVER, self._follow_mouse)

    # What FreeCAD calls.

    def can_accept(self) -> bool:
        """Whether there is an edge."""
        return self._found is not None

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

    def let_go(self, restore: bool) -> None:
        """Take everything of the panel's out of the view, end its threads and observers."""
        super().let_go(restore)
        self._refresh_timer.stop()
        self._hover_timer.stop()
        with suppress(RuntimeError):  # the form may be gone
            self._form.parameters.stop_waiting()
        self._document_watch.end()
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

    # The scan.

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
        self.begin_work(ScanJob(self._cloud[1], inputs), LiveEdge.of_walk)

    def show_report(self, digest: LiveEdge) -> None:
        """The edge has grown."""
        self._form.progress_to(digest.points)
        self._display.show_growing(digest)

    def show_result(self, result: Found) -> None:
        """The edge is finished."""
        self._found = found = result
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
        self.allow_ok()

    def show_failure(self, sentence: str) -> None:
        """There is no edge; say why."""
        self._display.show_no_edge()
        self._form.show_progress(False)
        if self._places.points and len(self._places.points) == self._places.way.clicks:
            self._places.forget()
        self._form.say(sentence)

    def _forget_edge(self) -> None:
        self.end_work()
        self._found = None
        self._display.show_no_edge()
        self._form.show_progress(False)
        self._form.show_edge(None)
        self.allow_ok()

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
            self.leave_soon()
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
        else:
            sentence = self.for_clicks(sentence)
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
