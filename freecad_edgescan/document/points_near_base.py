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
    ValueError: nothing is linked, a segment of probe centres, or a distance that is not positive.
    """
    if cloud is None:
        raise ValueError("There is no cloud; choose one, or undo its deletion.")
    numbers, label = point_cloud(cloud), cloud.Label
    if type(getattr(cloud, "Proxy", None)).__name__ == "CloudSegmentProxy":
        if numbers.probe_radius > 0.0:
            raise ValueError(
                f"The segment {label!r} holds centres of a probe; set its Compensated, so "
                "that a surface can be fitted to it."
            )
        return lambda _base, _progress: numbers.points
    if not distance > 0.0:
        raise ValueError(
            f"The distance is {distance:g} mm; give a positive one, within which points of the "
            "cloud belong to the base surface."
        )

    def near(base: BSplineSurface, progress: Progress | None) -> Array:
        points = compensated_segment(numbers, base, distance, progress=progress)
        if len(points) == 0:
            raise ValueError(
                f"No point of the cloud {label!r} lies within {distance:g} mm of the base "
                "surface; choose another cloud, or a larger distance."
            )
        return points

    return near
