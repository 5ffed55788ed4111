# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Scan boundary: two clicks, and all edges round the face between them."""

from __future__ import annotations

from html import escape
from typing import Any

import numpy as np

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.document.computed_object import write_computed
from freecad_edgescan.document.scanned_boundary import is_closed
from freecad_edgescan.scanning import ScannedEdge, scan_boundary

from .click_panel import ClickPanel
from .html_table import html_table
from .live_edge import LiveEdge
from .picking import Array
from .quantities import length_text
from .recorded_step import as_literal, object_line, run_as_one_step
from .shown import select_only
from .translation import translate

__all__ = ["BoundaryPanel"]


class BoundaryPanel(ClickPanel):
    """Asks for a place near an edge and for one on the face."""

    def __init__(self, doc: Any, view: Any, title: str) -> None:
        super().__init__(
            doc,
            view,
            "EdgeScan_ScanBoundary",
            title,
            (
                translate("1 of 2: click near an edge of the face."),
                translate("2 of 2: click on the face, beside that edge."),
            ),
        )

    def calculate(self, numbers: PointCloud, places: list[Array], progress: Any) -> Any:
        """Scan round the face."""
        return scan_boundary(numbers, places[0], places[1], progress=progress)

    def draw_result(self, result: list[ScannedEdge]) -> str:
        """Draw all edge points; say what was found."""
        points = np.vstack([edge.points for edge in result])
        sigma = np.concatenate([edge.sigma for edge in result])
        self.preview.show_edge(LiveEdge(points, sigma, curve=points))
        rows = [
            (
                translate("Edge {number}").format(number=number),
                length_text(_length(edge)),
                length_text(float(edge.sigma.mean())),
            )
            for number, edge in enumerate(result, start=1)
        ]
        titles = (
            translate("{count} edges").format(count=len(result)),
            translate("Length"),
            translate("Mean sigma"),
        )
        if is_closed(result):
            said = [translate("The boundary is closed.")]
        else:
            said = list(dict.fromkeys(edge.message for edge in (result[0], result[-1])))
        return html_table(titles, rows) + "".join(f"<p>{escape(text)}</p>" for text in said)

    def keep(self) -> None:
        """Make the boundary in one undo step."""
        at, inside = (as_literal(place) for place in self.places)
        line = (
            f"document.make_scanned_boundary(doc, {object_line(self.cloud)}, at={at}, "
            f"inside={inside})"
        )
        select_only(run_as_one_step(self._doc, self.title, [line], self._hand_over))

    def _hand_over(self, made: list[Any]) -> None:
        if self.up_to_date():
            write_computed(made[0], self.result)


def _length(edge: ScannedEdge) -> float:
    """From vertex to vertex, mm."""
    return float(np.linalg.norm(np.diff(edge.vertex_to_vertex, axis=0), axis=1).sum())
