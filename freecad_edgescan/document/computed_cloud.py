# SPDX-License-Identifier: LGPL-2.1-or-later
"""What clouds that are computed from something else have in common."""

from __future__ import annotations

from typing import Any

from numpy.typing import ArrayLike

from .bridge import kernel_from_array
from .computed_object import MESSAGE, ORIGIN, ComputedProxy, result
from .native_curve import vector

__all__ = ["WRITTEN_POINTS", "ComputedCloudProxy", "write_points"]

WRITTEN_POINTS = (result("Integer", "PointCount", "Number of points"), MESSAGE, ORIGIN)
"""What `write_points` writes besides the points."""


class ComputedCloudProxy(ComputedProxy):
    """Of a Points::FeaturePython with the properties of `WRITTEN_POINTS`."""

    def is_empty(self, obj: Any) -> bool:
        """Whether it has no points."""
        return int(obj.Points.CountPoints) == 0


def write_points(obj: Any, points: ArrayLike, message: str, origin: ArrayLike) -> None:
    """Write points (n, 3), document coordinates; the object stays where it stands."""
    placement = obj.Placement
    obj.Points = kernel_from_array(points)
    obj.Placement = placement
    obj.PointCount = int(obj.Points.CountPoints)
    obj.Message = message
    obj.Origin = vector(origin)
