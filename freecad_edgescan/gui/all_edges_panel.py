# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that finds all edges of a cloud: watch, choose among them, accept.

The cloud is searched beside the window as soon as the panel opens, and edges are drawn as they are
found. Which of them are kept is chosen by their length, turn and sigma, and by clicks, without
another search. Nothing is in the document until OK.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freecad_edgescan import document
from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.document.edge_network import choice_of
from freecad_edgescan.document.network_search import NetworkSearch
from freecad_edgescan.scanning.automatic import MIN_ANGLE
from freecad_edgescan.scanning.edge_choice import EdgeChoice

from .all_edges_form import AllEdgesForm
from .edge_text import edge_text
from .find_job import EdgesSoFar, FindJob, FoundNetwork
from .message import CancelledError
from .network_commit import change_network, make_group, make_network
from .network_display import NetworkDisplay
from .preferences import makes_one_network, remember_one_network
from .shown import select_only
from .single_shot import single_shot
from .thinned_clouds import is_shown
from .translation import translate
from .view_clicks import ViewClicks
from .view_panel import ViewPanel

__all__ = ["AllEdgesPanel"]

_HOVER = 30  # ms between two looks at what is under the mouse
# What of a cloud, or of a part it is in, its numbers depend on.
_MATTERS = ("Points", "Placement", "ProbeRadius", "Approach", "Group")


class AllEdgesPanel(ViewPanel):
    """Task panel; ``FreeCADGui.Control.showDialog`` shows it.

    Parameters
    ----------
    doc : App.Document
    view : the 3D view that is clicked in
    cloud : Points::Feature whose edges are wanted
    edited : network that is changed; None: a new one is made

    Attributes
    ----------
    form : the widget FreeCAD shows
    buttons : FreeCAD's OK and Cancel, while the panel is open

    Raises
    ------
    ValueError: a cloud that cannot be searched.
    """

    def __init__(self, doc: Any, view: Any, cloud: Any, edited: Any = None) -> None:
        numbers = document.point_cloud(cloud)  # says what to do
        title = translate("Scan all edges")
        if edited is not None:
            title = translate("Edit network of edges")
        super().__init__(doc, view, AllEdgesForm(title, edited is not None))
        self._edited = edited
        self._cloud: Any = cloud
        self._cloud_name = cloud.Name
        self._numbers: PointCloud = numbers
        self._choice = EdgeChoice(min_angle=MIN_ANGLE) if edited is None else choice_of(edited)
        self._most = 0 if edited is None else int(edited.MostEdges)
        self._known = EdgesSoFar()
        self._found: FoundNetwork | None = None
        self._searched: NetworkSearch | None = None  # what was searched for last
        self._mask: NDArray[np.bool_] = np.zeros(0, dtype=bool)
        self._mouse: tuple[int, int] | None = None
        self._connect()
        self._display = NetworkDisplay(view)
        self._clicks = ViewClicks(view, self._click, self.leave_soon, self._hover)
        self._document_watch.changed.connect(self._object_changed)
        self._document_watch.deleted.connect(self._object_deleted)
        self._document_watch.shown_or_hidden.connect(self._refresh_soon)
        if edited is None:
            self._form.choose_kind(makes_one_network())
        else:
            self._display.set_aside(edited.ViewObject)
        self._form.show_choice(self._choice)
        self._show_cloud()
        self._search()

    def _connect(self) -> None:
        form = self._form
        form.stop.clicked.connect(self._stop_here)
        form.again.clicked.connect(self._search_all)
        form.forget.clicked.connect(self._forget_clicks)
        form.filters_changed.connect(self._filter)
        self._refresh_timer = single_shot(self, 0, self._refresh)
        self._hover_timer = single_shot(self, _HOVER, self._follow_mouse)

    # What FreeCAD calls.

    def can_accept(self) -> bool:
        """Whether edges are kept, and the search has ended."""
        return self._found is not None and bool(self._mask.any())

    def question(self) -> str:
        """What can be clicked on."""
        if self._found is None:
            return translate("The cloud is searched. Click on an edge to drop it.")
        return translate("Click on an edge to drop or keep it. OK keeps those in orange.")

    def accept(self) -> bool:
        """Put the edges into the document; the panel stays open when that fails."""
        if self._found is None or not self._mask.any():
            return False
        kept = self._found.network.part(self._mask)
        given = self._choice, self._found.search.most
        try:
            if self._edited is not None:
                made = change_network(self._edited, self._numbers, *given, kept)
            elif self._form.one_network:
                made = make_network(self._doc, self._cloud, self._numbers, *given, kept)
            else:
                made = make_group(self._doc, self._cloud, self._numbers, kept)
        except CancelledError:
            return False
        except (ValueError, ReferenceError) as error:
            self._form.say(str(error))
            return False
        if self._edited is None:
            remember_one_network(self._form.one_network)
        self.close()
        select_only(made)
        return True

    def let_go(self, restore: bool) -> None:
        """Take everything of the panel's out of the view, end its threads and observers."""
        super().let_go(restore)
        self._refresh_timer.stop()
        self._hover_timer.stop()
        self._clicks.close()
        self._display.close(restore)

    # The search.

    def _search(self) -> None:
        self._found = self._searched = None
        self._show_edges(EdgesSoFar())
        self._form.show_again(False)
        self._form.show_progress(True)
        self.ask()
        self.begin_work(FindJob(self._numbers, self._choice, self._most), EdgesSoFar.of)

    def _search_all(self) -> None:
        self._most = 0
        self._search()

    def _stop_here(self) -> None:
        if self._work is not None:
            self._work.stop()
            self._form.stop.setEnabled(False)

    def show_share(self, share: float) -> None:
        """The search has got farther."""
        self._form.progress_to(share)

    def show_report(self, digest: EdgesSoFar) -> None:
        """More edges are known."""
        if len(digest.edges) != len(self._known.edges):
            self._show_edges(digest)

    def show_result(self, result: FoundNetwork) -> None:
        """The search has ended."""
        network, self._searched = result.network, result.search
        self._form.show_progress(False)
        self._form.show_again(result.stopped or result.search.most > 0)
        if not len(network):
            self._show_edges(EdgesSoFar())
            self._form.say(
                translate("Stopped before an edge was found.")
                if result.stopped
                else network.message
            )
            return
        self._found = result
        self._most = result.search.most
        if result.stopped:
            self._form.say(translate("Stopped: OK keeps the edges found so far."))
        else:
            self.ask()
        self._show_edges(result.drawn)

    def show_failure(self, sentence: str) -> None:
        """There are no edges; say why."""
        self._form.show_progress(False)
        self._form.show_again(True)
        self._form.say(sentence)

    # What the user does.

    def _click(self, position: tuple[int, int]) -> None:
        number = self._display.edge_at(position)
        if number is None:
            self.say_and_ask(translate("There is no edge."))
            return
        edges = self._known.edges
        self._choose(self._choice.toggled(edges, number, self._numbers.pitch))
        self._show_under_mouse(number)
        self.ask()

    def _forget_clicks(self) -> None:
        none = np.zeros((0, 3))
        self._choose(replace(self._choice, dropped=none, kept=none))

    def _filter(self) -> None:
        self._choose(self._form.filtered(self._choice))

    def _choose(self, choice: EdgeChoice) -> None:
        """Keep other edges; those shorter or blunter than were sought need another search."""
        before, self._choice = self._choice, choice
        self._form.show_choice(choice)
        if self._wider(before, choice):
            self._search()
        else:
            self._show_edges(self._known)

    def _wider(self, before: EdgeChoice, choice: EdgeChoice) -> bool:
        if (before.min_angle, before.min_length) == (choice.min_angle, choice.min_length):
            return False
        if self._cloud is None:
            return False
        pitch = self._numbers.pitch
        searched = self._searched or NetworkSearch.wide_enough(before, pitch, self._most)
        return NetworkSearch.wide_enough(choice, pitch, self._most) != searched

    def _hover(self, position: tuple[int, int]) -> None:
        self._mouse = position
        if not self._hover_timer.isActive():
            self._hover_timer.start()

    def _follow_mouse(self) -> None:
        if self._mouse is not None:
            self._show_under_mouse(self._display.edge_at(self._mouse))

    # What happens to the document meanwhile.

    def _object_changed(self, item: Any, name: str) -> None:
        if self._open and name in _MATTERS:
            self._refresh_timer.start()

    def _object_deleted(self, name: str) -> None:
        if not self._open:
            return
        if self._edited is not None and name == self._edited.Name:
            self._edited = None
            self.leave_soon()
        elif name == self._cloud_name and self._cloud is not None:
            self._lose_cloud(translate("The cloud was deleted. Undo that, or press Cancel."))

    def _lose_cloud(self, sentence: str) -> None:
        self.end_work()
        self._cloud = self._found = None
        self._display.clouds.show([])
        self._show_edges(EdgesSoFar())
        self._form.show_progress(False)
        self._form.show_again(False)
        self._form.say(sentence)

    def _refresh_soon(self) -> None:
        if self._open:
            self._refresh_timer.start()

    def _refresh(self) -> None:
        """Follow a cloud that has changed, was shown or hidden, or is there again."""
        if not self._open:
            return
        cloud = self._doc.getObject(self._cloud_name)
        if cloud is None:
            return
        try:
            numbers = document.point_cloud(cloud)
        except ValueError as error:
            self._lose_cloud(str(error))
            return
        is_new = self._cloud is None or numbers is not self._numbers
        self._cloud, self._numbers = cloud, numbers
        self._show_cloud()
        if is_new:
            self._search()
            self.say_and_ask(translate("The cloud has changed."))

    # The rest.

    def _show_cloud(self) -> None:
        shown = [(self._cloud, self._numbers)] if is_shown(self._cloud) else []
        self._display.clouds.show(shown)
        self._form.show_points(
            self._display.clouds.count, sum(len(numbers) for _, numbers in shown)
        )

    def _show_edges(self, known: EdgesSoFar) -> None:
        self._known = known
        edges = known.edges
        self._mask = np.zeros(0, dtype=bool)
        if edges:
            self._mask = self._choice.mask(edges, self._numbers.pitch)
        corners = np.zeros((0, 3))
        if self._found is not None:
            corners = self._found.network.part(self._mask).corners
        self._display.show_edges(known.lines, self._mask, corners)
        length = sum(edge.length for edge, kept in zip(edges, self._mask, strict=True) if kept)
        self._form.show_counts(int(self._mask.sum()), len(edges), float(length))
        self._form.show_largest_sigma(
            max((float(np.median(edge.sigma)) for edge in edges), default=0.0)
        )
        self.allow_ok()

    def _show_under_mouse(self, number: int | None) -> None:
        self._display.point_at(number)
        self._form.show_edge("" if number is None else self._described(number))

    def _described(self, number: int) -> str:
        edge = self._known.edges[number]
        kept = bool(self._mask[number])
        done = (
            translate("Kept. Click to drop it.")
            if kept
            else translate("Left out. Click to keep it.")
        )
        return f"{edge_text(edge)}\n{done}"
