# SPDX-License-Identifier: LGPL-2.1-or-later
"""Average, maximum and root mean square of deviations, as all results state them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["DeviationFigures"]

Array = NDArray[np.float64]


class DeviationFigures:
    """Figures of the signed deviations of points over a surface; nan where there are none."""

    deviation: Array
    outside: NDArray[np.bool_]

    @property
    def _inside(self) -> Array:
        inside = self.deviation[~self.outside]
        return inside if len(inside) else np.array([np.nan])

    @property
    def average(self) -> float:
        """Mean absolute deviation of the points within the surface's rim, mm."""
        return float(np.abs(self._inside).mean())

    @property
    def maximum(self) -> float:
        """Largest absolute deviation of the points within the surface's rim, mm."""
        return float(np.abs(self._inside).max())

    @property
    def rms(self) -> float:
        """Root mean square of the deviations of the points within the surface's rim, mm."""
        return float(np.sqrt(np.mean(self._inside**2)))
