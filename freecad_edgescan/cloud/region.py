# SPDX-License-Identifier: LGPL-2.1-or-later
"""A region of interest: a box, and the points of a cloud that lie in it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..geometry.plain_number import plain
from .point_cloud import PointCloud

__all__ = ["Reach", "Region", "cropped"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Region:
    """All places between two corners, the faces included.

    Attributes
    ----------
    lowest, highest : (3,) corners, mm; infinite where there is no limit
    """

    lowest: Array
    highest: Array

    @classmethod
    def of(cls, corners: ArrayLike) -> Region:
        """The region between ((xmin, ymin, zmin), (xmax, ymax, zmax)), mm.

        Raises
        ------
        ValueError: no such two corners.
        """
        try:
            box = np.array(corners, dtype=np.float64)
        except (TypeError, ValueError):
            box = np.empty(0)
        if box.shape != (2, 3) or not np.all(box[0] <= box[1]):
            raise ValueError(
                f"The region {corners!r} is no box. Give its lowest and highest corner, "
                "((xmin, ymin, zmin), (xmax, ymax, zmax)) in mm."
            )
        return cls(box[0], box[1])

    def holds(self, points: Array) -> NDArray[np.bool_]:
        """Which of the points (n, 3) lie in it, (n,). A coordinate that is nan lies anywhere."""
        inside = np.ones(len(points), dtype=bool)
        for axis in range(3):  # a column at a time needs a third of the memory
            inside &= ~(points[:, axis] < self.lowest[axis])
            inside &= ~(points[:, axis] > self.highest[axis])
        return inside

    def is_empty_of(self, name: str, bounds: tuple[Array, Array] | None) -> ValueError:
        """What to raise when no point of a cloud, which has these bounds, lies in it."""
        reach = ""
        if bounds is not None:
            low, high = (_text(corner) for corner in bounds)
            reach = f", which reaches from ({low}) to ({high}),"
        corners = f"({_text(self.lowest)}) to ({_text(self.highest)})"
        return ValueError(
            f"No point of {name}{reach} lies in the region {corners}. Take a region that overlaps "
            "the cloud."
        )


class Reach:
    """How far points reach that are seen some at a time.

    Attributes
    ----------
    bounds : lowest and highest corner of their box, (3,) each, mm; None before there is a point
    """

    def __init__(self) -> None:
        self.bounds: tuple[Array, Array] | None = None

    def widen(self, points: Array) -> None:
        """Take note of points (k, 3); rows that hold nan or inf are none."""
        finite = points[np.isfinite(points).all(axis=1)]
        if len(finite):
            corners = [] if self.bounds is None else list(self.bounds)
            seen = np.vstack([finite.min(axis=0), finite.max(axis=0), *corners])
            self.bounds = seen.min(axis=0), seen.max(axis=0)


def cropped(cloud: PointCloud, region: ArrayLike) -> PointCloud:
    """The points of a cloud in ((xmin, ymin, zmin), (xmax, ymax, zmax)), mm.

    Raises
    ------
    ValueError: no box, or one without points.
    """
    box = Region.of(region)
    inside = box.holds(cloud.points)
    if not inside.any():
        raise box.is_empty_of("the cloud", cloud.bounds)
    return PointCloud(cloud.points[inside], cloud.probe_radius, cloud.approach)


def _text(corner: Array) -> str:
    return ", ".join(plain(value, 6) for value in corner)
