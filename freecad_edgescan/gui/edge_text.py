# SPDX-License-Identifier: LGPL-2.1-or-later
"""An edge in words, for a line on the screen."""

from __future__ import annotations

import numpy as np

from freecad_edgescan.scanning import ScannedEdge
from freecad_edgescan.scanning.edge_choice import turn_of

from .quantities import angle_text, length_text
from .translation import translate

__all__ = ["edge_text"]


def edge_text(edge: ScannedEdge) -> str:
    """An edge in a few numbers."""
    text = translate("Edge of {length}, turn {turn}, sigma {sigma}").format(
        length=length_text(edge.length),
        turn=angle_text(turn_of(edge)),
        sigma=length_text(float(np.median(edge.sigma))),
    )
    radii = edge.fillet_radius[np.isfinite(edge.fillet_radius)]
    if len(radii) >= 0.5 * len(edge):
        text += translate(", rounding {radius}").format(radius=length_text(float(np.median(radii))))
    return text
