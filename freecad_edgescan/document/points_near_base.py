# SPDX-License-Identifier: LGPL-2.1-or-later
"""The points of a cloud object to which a surface is fitted."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..geometry import BSplineSurface
from ..scanning import Progress
from ..surfacing.compensated_segment import compensated_segment
from .cloud_cache import point_cloud
from .given_numbers import positive_length

__all__ = ["points_near_base"]

Array = NDArray[np.float64]


def points_near_base(
    cloud: Any, distance: float
) -> Callable[[BSplineSurface, Progress | None], Array]:
    """What finds the points (n, 3) of a cloud object that belong to a base surface.

    Parameters
    ----------
    cloud : Points::Feature; of a cloud segment all points are taken, of any other those nearer to
        the base surface than the distance, after they were moved onto the part
    distance : mm

    Returns
    -------
    A function of the base surface and progress, in document coordinates, mm. It raises a ValueError
    when there is no such point.

    Raises
    ------
    ValueError: nothing is linked, or a distance that is not positive.
    """
    numbers, label = point_cloud(cloud), cloud.Label
    if type(getattr(cloud, "Proxy", None)).__name__ == "CloudSegmentProxy":
        return lambda _base, _progress: numbers.points
    distance = positive_length("distance", distance)

    def near(base: BSplineSurface, progress: Progress | None) -> Array:
        points = compensated_segment(numbers, base, distance, progress=progress)
        if len(points) == 0:
            raise ValueError(
                f"No point of the cloud {label!r} lies within {distance:g} mm of the base "
                "surface; choose another cloud, or a larger distance."
            )
        return points

    return near
