# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plane in which a scan line is scanned (Schreve 4.2.1)."""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot

import numpy as np

__all__ = ["ScanPlane"]


@dataclass(frozen=True)
class ScanPlane:
    """The plane of a scan line: x across the edge in the direction of travel, y into the part.

    Attributes
    ----------
    origin : (3,) mm
    across, inward : (3,) unit vectors of x and y, square to each other
    wedge : 1 when the smaller wedge of the two surfaces lies on the side of y, -1 when it lies
        on the other, 0 when that is not known yet
    """

    origin: np.ndarray
    across: np.ndarray
    inward: np.ndarray
    wedge: float = 0.0

    def place(self, x: float, y: float) -> np.ndarray:
        """The point (3,) at two coordinates."""
        return self.origin + x * self.across + y * self.inward

    def coordinates(self, point: np.ndarray) -> tuple[float, float]:
        """Both coordinates of a point, moved square into the plane."""
        offset = point - self.origin
        return float(offset @ self.across), float(offset @ self.inward)

    def direction(self, vector: np.ndarray) -> tuple[float, float]:
        """Unit coordinates of a direction, moved into the plane."""
        x, y = float(vector @ self.across), float(vector @ self.inward)
        size = hypot(x, y)
        return x / size, y / size
