# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Recommend parameters: a click, and how to scan the edge there."""

from __future__ import annotations

from html import escape
from typing import Any

import numpy as np

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.scanning import recommend_parameters

from .click_panel import ClickPanel
from .html_table import html_table
from .picking import Array
from .quantities import length_text
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

    def draw_result(self, result: Any) -> str:
        """What was measured, the error to expect, and each parameter with its reason."""
        rounding = result.fillet_radius
        measured = html_table(
            (),
            (
                (translate("Error to expect"), length_text(result.expected_error)),
                (translate("Angle"), f"{np.degrees(result.angle):.1f}°"),
                (translate("Rounding"), length_text(rounding) if rounding else translate("none")),
                (translate("Cloud pitch"), length_text(result.cloud_pitch)),
                (translate("Noise level"), length_text(result.noise_level)),
            ),
        )
        chosen = "".join(
            f"<p><b>{name.replace('_', ' ')}: {escape(_text(value))}</b><br>"
            f"{escape(result.reasons[name])}</p>"
            for name, value in vars(result.parameters).items()
            if name in result.reasons and value is not None
        )
        said = "".join(
            f"<p>{escape(sentence)}</p>" for sentence in (*result.contradictions, *result.warnings)
        )
        return measured + said + chosen

    def after_result(self) -> str:
        """What OK does."""
        return translate(
            "OK scans this edge with these parameters, line by line. Click elsewhere to measure "
            "there instead."
        )

    def keep(self) -> None:
        """Scan the edge by the method the parameters are for, in one undo step."""
        line = (
            f"document.make_scanned_edge(doc, {object_line(self.cloud)}, "
            f"at={as_literal(self.places[0])}, method='probe')"
        )
        select_only(run_as_one_step(self._doc, translate("Scan edge"), [line]))


def _text(value: Any) -> str:
    """A parameter as the user writes it."""
    if isinstance(value, float):
        return length_text(value)
    if isinstance(value, np.ndarray | tuple):
        return ", ".join(f"{own:.3g}" for own in value)
    return str(getattr(value, "value", value))
