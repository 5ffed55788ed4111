# SPDX-License-Identifier: LGPL-2.1-or-later
"""What ``--region`` has to do with a result: told, where it looks like the part's own end."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from freecad_edgescan.cloud.region import Region
from freecad_edgescan.geometry.place_text import place_text
from freecad_edgescan.scanning import ScannedEdge, Stop

__all__ = ["cut_by_region", "outside_region"]

_NO_MORE_POINTS = (Stop.CLOUD_END, Stop.OFF_OBJECT)

Corners = Sequence[Sequence[float]]


def outside_region(place: Sequence[float] | np.ndarray, corners: Corners | None) -> str:
    """A sentence about a place (3,), mm, outside the box that was read; "" about others."""
    if corners is None or Region.of(corners).holds(np.atleast_2d(place)).all():
        return ""
    low, high = (place_text(corner) for corner in corners)
    return (
        f"The place lies outside the --region ({low}) to ({high}), of which alone points were "
        "read; give one that holds it."
    )


def cut_by_region(edges: dict[int, ScannedEdge], corners: Corners | None) -> str:
    """A sentence about the edges, by number, that end where the box does; "" where none does."""
    if corners is None:
        return ""
    box = Region.of(corners)
    cut = [number for number, edge in edges.items() if _ends_at(box, edge)]
    if not cut:
        return ""
    which = ", ".join(map(str, cut))
    return (
        f"Edge{'s' * (len(cut) > 1)} {which} may go on: the points end where --region does, or "
        "near it; give a larger one to see."
    )


def _ends_at(box: Region, edge: ScannedEdge) -> bool:
    """Whether an edge ends for want of points within its sides' reach of the box."""
    reach = 0.5 * (edge.parameters.amplitude or 0.0)
    inner = Region(box.lowest + reach, box.highest - reach)
    ends = np.array([edge.points[0], edge.points[-1]])
    near = ~inner.holds(ends)
    return any(stop in _NO_MORE_POINTS and at for stop, at in zip(edge.stops, near, strict=True))
