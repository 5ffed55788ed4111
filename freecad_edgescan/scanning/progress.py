# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who is told how far a scan is, and who may cancel it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

import numpy as np

if TYPE_CHECKING:
    from .section import Station


class SoFar:
    """The result of a running scan so far.

    Attributes
    ----------
    points : (m, 3) array, mm, edge points in walking order
    new_points : (k, 3) array, mm, those that are new since the last update
    stations : what was measured, in walking order
    """

    def __init__(self, stations: list[Station], reported: int) -> None:
        self.stations = tuple(stations)
        self.reported = reported

    @property
    def points(self) -> np.ndarray:
        """Edge points in walking order, (m, 3) mm."""
        return np.array([station.frame.origin for station in self.stations]).reshape(-1, 3)

    @property
    def new_points(self) -> np.ndarray:
        """Those that are new since the last update, (k, 3) mm."""
        return self.points[self.reported :]


class Progress(Protocol):
    """Anything that has ``update``; False cancels, and what was found so far is kept."""

    def update(self, fraction: float, so_far: object) -> bool:
        """Take note of the share that is done (0 … 1, nan when unknown); answer False to cancel."""
        ...
