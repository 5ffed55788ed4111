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

from .clicked_cloud import Picked
from .cloud_panel import CloudPanel
from .live_edge import LiveEdge
from .picked_places import PickedPlaces
from .picking import Array
from .scan_commit import commit_scan
from .scan_display import ScanDisplay
from .scan_edge_form import ScanEdgeForm
from .scan_job import Found, ScanJob
from .shown import select_only
from .single_shot import single_shot
from .translation import translate
from .view_clicks import Pixel

__all__ = ["ScanEdgePanel"]

_HOVER = 30  # ms between two looks at what is under the mouse


class ScanEdgePanel(CloudPanel):
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
        super().__init__(doc, view, ScanEdgeForm(title))
        self._edited = edited
        self._places = PickedPlaces()
        self._cloud: tuple[Any, PointCloud] | None = None
        self._at: Array | Start | None = None
        self._gate: Array | Gate | None = None
        self._min_angle: float | None = None
        self._found: Found | None = None
        self._mouse: Pixel | None = None
        self._display = ScanDisplay(view)
        self._connect()
        self._show_clouds()
        if edited is None:
            self.ask()
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
        self._clicks.changed.connect(self._show_clouds)
        self._clicks.moved.connect(self._hover)
        self._document_watch.deleted.connect(self._object_deleted)
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
        self._hover_timer.stop()
        with suppress(RuntimeError):  # the form may be gone
            self._form.parameters.stop_waiting()
        self._display.close(restore)
        if restore:
            self._set_aside(False)

    # What the user does.

    def question(self) -> str:
        """What the user can do now."""
        if self._edited is not None and self._found is not None and not self._places.points:
            return translate(
                "Change what you like; OK keeps it. A click on the cloud scans another edge."
            )
        return self._places.what_to_click()

    def take(self, picked: Picked) -> None:
        """Scan from a place that was clicked on, once all have been that are wanted."""
        if self._cloud is not None and self._cloud[0] is not picked.item:
            self._places.forget()
        self._cloud = picked.item, picked.numbers
        self._clicks.used = picked.item
        self._places.add(picked.point)
        self._show_places()
        if not self._places.changes_the_scan():
            self.ask()
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
        self.ask()

    def _scan_again(self) -> None:
        if self._at is not None and self._cloud is not None:
            self._scan()

    def _change_view(self) -> None:
        self._display.choose(self._form.view)

    def _look_along(self) -> None:
        self._display.look_along()

    def _hover(self, position: Pixel) -> None:
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
        self.begin_work(ScanJob(self._cloud[1], inputs), LiveEdge.of_walk)
        self._form.say(translate("The edge is being followed."))
        self._form.show_progress(True)

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
            self.ask()
        self.allow_ok()

    def show_failure(self, sentence: str) -> None:
        """There is no edge; say why."""
        self._display.show_no_edge()
        self._form.show_progress(False)
        if self._places.points and len(self._places.points) == self._places.way.clicks:
            self._places.forget()
        self.say_and_ask(sentence)

    def _forget_edge(self) -> None:
        self.end_work()
        self._found = None
        self._display.show_no_edge()
        self._form.show_progress(False)
        self._form.show_edge(None)
        self.allow_ok()

    # What happens to the document meanwhile.

    def lose(self, sentence: str) -> None:
        """The cloud has changed or is gone, and the edge with it."""
        self._cloud = self._at = self._gate = None
        self._places.forget()
        self._forget_edge()
        self._show_places()
        self.say_and_ask(sentence)

    def _object_deleted(self, name: str) -> None:
        if self._edited is not None and name == self._edited.Name:
            self._edited = None
            self.leave_soon()

    # Editing.

    def _begin_editing(self) -> None:
        """Scan with the inputs of the edge that is edited."""
        edge = self._edited
        self._set_aside(True)
        try:
            inputs = read_inputs(edge)
            numbers = self._clicks.numbers(edge.Cloud)
        except ValueError as error:
            self._form.say(str(error))
            return
        self._at, self._gate, self._min_angle = inputs.at, inputs.gate, inputs.min_angle
        self._cloud = edge.Cloud, numbers
        self._clicks.used = edge.Cloud
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
        shown = self._clicks.shown()
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
