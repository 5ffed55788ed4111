# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a running scan tells its progress of the result so far."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..cloud.progress import Progress

if TYPE_CHECKING:
    from .section import Station

__all__ = ["Progress", "SoFar"]


class SoFar:
    """The result of a running scan so far.

    Attributes
    ----------
    stations : what was measured, along the edge
    new_stations : those that are new since the last update, as they were found
    """

    def __init__(self, stations: Sequence[Station], new_stations: Sequence[Station]) -> None:
        self.stations = tuple(stations)
        self.new_stations = tuple(new_stations)

    @property
    def points(self) -> np.ndarray:
        """Edge points along the edge, (m, 3) mm."""
        return _points(self.stations)

    @property
    def new_points(self) -> np.ndarray:
        """Those that are new since the last update, (k, 3) mm."""
        return _points(self.new_stations)

    @property
    def sigma(self) -> np.ndarray:
        """Standard deviation of each edge point as the walk knows it, (m,) mm."""
        return np.array([station.sigma for station in self.stations])

    @property
    def scan_lines(self) -> list[np.ndarray]:
        """Where each edge point was measured: (k, 3) mm, across the edge.

        The contacts of a probe; without a probe both sides as far as they were used, straight.
        """
        return [_scan_line(station) for station in self.stations]


def _scan_line(station: Station) -> np.ndarray:
    if station.line is not None:
        return station.line.contacts
    frame = station.frame
    ends = frame.origin + np.asarray(station.ends)[:, None] * frame.sides[0]
    return np.array([ends[0], frame.origin[0], ends[1]])


def _points(stations: Sequence[Station]) -> np.ndarray:
    return np.array([station.frame.origin[0] for station in stations]).reshape(-1, 3)
