# SPDX-License-Identifier: LGPL-2.1-or-later
"""A virtual measuring machine that touches the points of a cloud (Schreve 3.3).

The dissertation finds points with an octree; here SciPy's KD-tree answers which ones lie round a
stretch of the search line.
"""

from __future__ import annotations

from math import hypot, isfinite

import numpy as np

from ..cloud.point_cloud import PointCloud
from .cloud_touch import BallTouch, ClosestTouch, Touch, TriangleTouch
from .errors import ScanError
from .first_contact import first_of_several

__all__ = ["KINDS", "PointCloudCmm"]

KINDS = ("closest", "ball", "triangle")

_BALL = 4.0  # pitches, radius of the virtual ball: large enough not to dip deep between points
_STRIDE = 8.0  # pitches that a search looks ahead at a time, where nothing is expected
_APPROACH = (0.0, 0.0, -1.0)  # Schreve appendix F


class PointCloudCmm:
    """A machine for `scan_edge(..., method="probe")` whose part is a cloud (a `Cmm`).

    Parameters
    ----------
    cloud : what is touched
    kind : "closest" answers points of the cloud; "ball" the centre of a virtual ball that rolls on
        a cloud of surface points; "triangle" the surface between three points
    pitch : mm, up to which distance of its points the cloud is surface and not a gap; the cloud's
        own pitch unless given. Walls with few points want a larger one (Schreve 7.2)
    probe_radius : mm, of the virtual ball, four pitches unless given

    Attributes
    ----------
    probe_radius : mm, of what it answers: the ball's, or that of the cloud's own probe
    approach : (3,) unit vector, the cloud's, or straight down

    Raises
    ------
    ScanError: no cloud, an unknown kind, a pitch or radius that is not positive, or a ball for
        points that are ball centres already.
    """

    def __init__(
        self,
        cloud: PointCloud,
        kind: str = "closest",
        pitch: float | None = None,
        probe_radius: float | None = None,
    ) -> None:
        if not isinstance(cloud, PointCloud):
            raise ScanError(
                f"A PointCloudCmm needs a PointCloud and was given {type(cloud).__name__}; make "
                "one with read_cloud(path) or PointCloud(points)."
            )
        if kind not in KINDS:
            names = ", ".join(repr(name) for name in KINDS)
            raise ScanError(f"The kind of machine is {kind!r}; choose one of {names}.")
        self.cloud, self.kind = cloud, kind
        self.pitch = _length("pitch", pitch) if pitch is not None else cloud.pitch
        self.probe_radius = cloud.probe_radius
        approach = _APPROACH if cloud.approach is None else cloud.approach
        self.approach = np.asarray(approach, dtype=float)
        self._touch = self._make_touch(probe_radius)

    def __repr__(self) -> str:
        return f"PointCloudCmm({self.cloud!r}, {self.kind!r}, pitch={self.pitch:g})"

    @property
    def selection(self) -> float:
        """How far too early its contacts lie on the average, in their standard deviations.

        The kind "closest" takes the first of all points within its pitch. The first of several
        normally distributed ones lies early, and scatters less than any one of them.
        """
        if self.kind != "closest":
            return 0.0
        early, scatter = first_of_several(self.pitch, self.cloud.pitch)
        return early / scatter

    def move(self, start: np.ndarray, end: np.ndarray) -> np.ndarray | None:
        """Travel without measuring; where it collides, or None (see `Cmm.move`)."""
        way = end - start
        length = float(np.sqrt(way @ way))
        if length == 0.0:
            return None
        return self._first(start, way / length, 0.0, length)

    def touch(
        self,
        start: np.ndarray,
        direction: np.ndarray,
        prehit_distance: float,
        search_distance: float,
    ) -> np.ndarray | None:
        """Search along a line; the contact, or None (see `Cmm.touch`)."""
        end = prehit_distance + search_distance
        # The part is expected after the prehit distance: as far again is looked at first.
        low, high = 0.0, min(2.0 * prehit_distance, end)
        stride = max(_STRIDE * self.pitch, 2.0 * prehit_distance)
        while low < end:
            contact = self._first(start, direction, low, high)
            if contact is not None:
                return contact
            low, high = high, min(high + stride, end)
        return None

    def _make_touch(self, probe_radius: float | None) -> Touch:
        if self.kind != "ball":
            if probe_radius is not None:
                raise ScanError(
                    f"A probe radius of {probe_radius!r} mm was given for a machine of the kind "
                    f"{self.kind!r}, which has no ball; leave it out, or take kind='ball'."
                )
            if self.kind == "closest":
                return ClosestTouch(self.pitch)
            return TriangleTouch(self.pitch)
        if self.cloud.probe_radius > 0.0:
            raise ScanError(
                f"The cloud holds the centres of a ball of radius {self.cloud.probe_radius:g} mm; "
                "a second ball cannot roll on them. Take kind='closest', or compensate the cloud."
            )
        radius = _BALL * self.pitch if probe_radius is None else probe_radius
        self.probe_radius = _length("probe radius", radius)
        return BallTouch(self.probe_radius)

    def _first(
        self, start: np.ndarray, way: np.ndarray, low: float, high: float
    ) -> np.ndarray | None:
        """The first contact on a stretch of a search line."""
        touch = self._touch
        reach = hypot(0.5 * (high - low) + touch.depth, touch.corridor)
        index = self.cloud.tree.query_ball_point(
            start + (0.5 * (low + high)) * way, reach, return_sorted=False
        )
        if not index:
            return None
        return touch.first(self.cloud.points[index], start, way, high)


def _length(name: str, value: float) -> float:
    good = isinstance(value, int | float | np.number) and isfinite(value) and value > 0.0
    if not good:
        raise ScanError(f"The {name} of the machine is {value!r}; give a positive length in mm.")
    return float(value)
