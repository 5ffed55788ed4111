# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that takes one face between the edges of a network: a click, and its points."""

from __future__ import annotations

from typing import Any

import numpy as np
from pivy import coin

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.document.cloud_segment import region_task
from freecad_edgescan.document.computed_object import write_computed

from .click_panel import ClickPanel
from .clicked_cloud import Picked
from .colours import EDGE
from .drawing import Points, on_screen, unpickable
from .picking import Array
from .recorded_step import as_literal, object_line, run_as_one_step
from .shown import select_only
from .thinned_clouds import MOST_POINTS
from .translation import translate

__all__ = ["RegionPanel"]


class RegionPanel(ClickPanel):
    """Asks for a place on the face.

    Parameters
    ----------
    network : object of all edges of a cloud

    Raises
    ------
    ValueError: a network whose cloud is gone or holds centres of a probe.
    """

    def __init__(self, doc: Any, view: Any, network: Any, title: str) -> None:
        if network.Cloud is None:
            list(network.Proxy.depends_on(network))  # says what to do
        self._task = region_task(network, (0.0, 0.0, 0.0))
        super().__init__(
            doc,
            view,
            "EdgeScan_CloudSegment",
            title,
            (translate("Click on the face whose points you want, between the edges."),),
        )
        self._network = network
        self._drawn = Points(EDGE, on_screen(4.0))
        self._root = coin.SoSeparator()
        self._root.setName("EdgeScanRegion")
        self._root.addChild(unpickable())
        self._root.addChild(self._drawn.node)
        self._scene: Any = view.getSceneGraph()
        self._scene.addChild(self._root)

    def take(self, picked: Picked) -> None:
        """Only the network's own cloud has its faces."""
        self._drawn.draw()
        if picked.item is not self._network.Cloud:
            sentence = translate("These edges are not those of {label}.")
            self.say_and_ask(sentence.format(label=picked.item.Label))
            return
        self._task = region_task(self._network, picked.point)
        super().take(picked)

    def calculate(self, numbers: PointCloud, places: list[Array], progress: Any) -> Any:
        """Find the points of the face."""
        return self._task(progress)

    def draw_result(self, result: Array) -> str:
        """Draw the points; say how many."""
        step = 1 + len(result) // MOST_POINTS
        self._drawn.draw(result[::step])
        text = translate("The face has {count} of the {whole} points.")
        whole = 0 if self.numbers is None else len(self.numbers)
        return text.format(count=f"{len(result):,}", whole=f"{whole:,}")

    def keep(self) -> None:
        """Make the segment in one undo step."""
        cloud, network = object_line(self.cloud), object_line(self._network)
        inside = as_literal(self.places[0])
        line = f"document.make_cloud_segment(doc, {cloud}, {network}, inside={inside})"
        select_only(run_as_one_step(self._doc, self.title, [line], self._hand_over))

    def lose(self, sentence: str) -> None:
        """Begin again."""
        self._drawn.draw()
        super().lose(sentence)

    def let_go(self, restore: bool) -> None:
        """Take everything out of the view."""
        super().let_go(restore)
        if self._scene is not None:
            self._scene.removeChild(self._root)
            self._scene = None

    def _hand_over(self, made: list[Any]) -> None:
        if self.up_to_date():
            write_computed(made[0], np.asarray(self.result))
