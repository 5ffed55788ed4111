# SPDX-License-Identifier: LGPL-2.1-or-later
"""A place given in the unit of the file, where places are in mm."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from freecad_edgescan.cloud import PointCloud

__all__ = ["place_in_unit"]

_FAR = 1.0  # sizes of the cloud beside it


def place_in_unit(place: Sequence[float] | np.ndarray, cloud: PointCloud, unit: str | None) -> str:
    """A sentence about a place (3,) that lies as far off as one in another unit; "" about others.

    Parameters
    ----------
    place : mm
    cloud : brought to mm
    unit : of its file
    """
    low, high = cloud.bounds
    room = _FAR * float(np.max(high - low))
    at = np.asarray(place, dtype=float)
    if unit in (None, "mm") or np.all((at >= low - room) & (at <= high + room)):
        return ""
    return "Places are given in mm, whatever the --unit."
