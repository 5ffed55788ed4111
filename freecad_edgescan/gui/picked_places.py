# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the clicks of a scan stand for: a place near an edge, a start, a gate.

One click is enough, and the walk goes both ways. A second one may say where it is to end. Or three
clicks touch the start as a person at a measuring machine does - the first point of the first scan
line, a point across the edge, a point along it - and two more the gate (Schreve 4.6).
"""

from __future__ import annotations

from enum import Enum

from freecad_edgescan.scanning import Gate, Start

from .picking import Array
from .translation import translate

__all__ = ["PickedPlaces", "Way"]


class Way(Enum):
    """How many clicks tell where a scan begins, and how many where it ends."""

    WHOLE_EDGE = (1, 0)
    TO_A_GATE = (1, 1)
    START_AND_GATE = (3, 2)

    @property
    def clicks(self) -> int:
        """All its clicks."""
        return self.value[0] + self.value[1]


class PickedPlaces:
    """Collects clicks.

    Attributes
    ----------
    way : what the clicks stand for
    points : (3,) each, mm, in the order of clicking
    """

    def __init__(self, way: Way = Way.WHOLE_EDGE) -> None:
        self.way = way
        self.points: list[Array] = []

    def add(self, point: Array) -> None:
        """One more click; when all have been made it is the first one of another scan."""
        if len(self.points) == self.way.clicks:
            self.points = []
        self.points.append(point)

    def forget(self) -> None:
        """No click counts any more."""
        self.points = []

    @property
    def at(self) -> Array | Start | None:
        """Where the scan begins; None until it is known.

        Raises
        ------
        ScanError: three points that tell no directions across and along an edge.
        """
        first = self.way.value[0]
        if len(self.points) < first:
            return None
        return self.points[0] if first == 1 else Start.from_points(*self.points[:3])

    @property
    def gate(self) -> Array | Gate | None:
        """Where the scan ends; None until that is known, or where the edge ends.

        Raises
        ------
        ScanError: two points that are the same.
        """
        if len(self.points) < self.way.clicks or not self.way.value[1]:
            return None
        ends = self.points[self.way.value[0] :]
        return ends[0] if len(ends) == 1 else Gate.from_points(*ends)

    def changes_the_scan(self) -> bool:
        """Whether the last click has told where a scan begins or where it ends."""
        return len(self.points) in (self.way.value[0], self.way.clicks)

    def what_to_click(self) -> str:
        """What the user is told to click on next."""
        done = len(self.points)
        if done == self.way.clicks:
            return translate("OK keeps this edge. Click elsewhere to scan another one instead.")
        if self.way is Way.WHOLE_EDGE:
            return translate("Click on the cloud, near the edge you want.")
        if self.way is Way.TO_A_GATE:
            return (
                translate("Click on the cloud, near the edge you want, where the scan begins."),
                translate("Click near the edge where the scan is to end. OK keeps all of it."),
            )[done]
        return (
            translate("1 of 3: click beside the edge, where the first scan line begins."),
            translate("2 of 3: click across the edge, where that line leads."),
            translate("3 of 3: click along the edge, where the walk goes."),
            translate("Gate, 1 of 2: click beside the edge on the same side. OK needs no gate."),
            translate("Gate, 2 of 2: click across the edge."),
        )[done]
