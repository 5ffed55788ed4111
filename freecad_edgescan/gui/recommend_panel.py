# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Recommend parameters: a click, and how to scan the edge there."""

from __future__ import annotations

from typing import Any

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.scanning import recommend_parameters

from .click_panel import ClickPanel
from .picking import Array
from .recorded_step import as_literal, object_line, run_as_one_step
from .shown import select_only
from .translation import translate

__all__ = ["RecommendPanel"]


class RecommendPanel(ClickPanel):
    """Asks for a place near an edge; OK scans the edge line by line as recommended."""

    def __init__(self, doc: Any, view: Any, title: str) -> None:
        super().__init__(
            doc,
            view,
            "EdgeScan_RecommendParameters",
            title,
            (translate("Click on the cloud, near the edge you want to scan."),),
        )

    def calculate(self, numbers: PointCloud, places: list[Array], progress: Any) -> Any:
        """Measure, and choose."""
        return recommend_parameters(numbers, places[0])

    def show_result(self, result: Any) -> str:
        """Everything that was measured and chosen."""
        hint = translate("OK scans this edge with these parameters, line by line.")
        return f"{hint}\n\n{result.text()}"

    def keep(self) -> None:
        """Scan the edge by the method the parameters are for, in one undo step."""
        line = (
            f"document.make_scanned_edge(doc, {object_line(self.cloud)}, "
            f"at={as_literal(self.places[0])}, method='probe')"
        )
        select_only(run_as_one_step(self.doc, translate("Scan edge"), [line]))
