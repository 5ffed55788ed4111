# SPDX-License-Identifier: LGPL-2.1-or-later
"""The exact sharp edge of a simulated part: what a scanned edge is compared with."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..geometry.polyline import distance_to_polyline

__all__ = ["TrueEdge"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False, repr=False)
class TrueEdge:
    """A sharp edge known exactly, as a dense polyline (chord error below 1e-5 mm).

    Attributes
    ----------
    name : what the edge is called, for tables
    points : (k, 3) samples on the edge, mm, in order; the first is not repeated when closed
    tangents : (k, 3) unit tangents there
    angle : (k,) rad, the smaller wedge between the two surfaces; one number serves all
    convex : whether that wedge is material (True) or air (False), None when unknown
    closed : whether the edge goes on from the last sample to the first
    room : (k,) mm, distance to the nearest other edge, nan when unknown

    Raises
    ------
    ValueError: fewer than two points, or arrays that do not match.
    """

    name: str
    points: Array
    tangents: Array
    angle: Array
    convex: bool | None = None
    closed: bool = False
    room: Array | float = np.nan

    def __post_init__(self) -> None:
        points = np.array(self.points, dtype=np.float64)
        if points.ndim != 2 or points.shape[1] != 3 or len(points) < 2:
            raise ValueError(
                f"The points of edge {self.name!r} have the shape {points.shape}; "
                "give (k, 3) with at least two."
            )
        for field, shape in (
            ("points", points.shape),
            ("tangents", points.shape),
            ("angle", (len(points),)),
            ("room", (len(points),)),
        ):
            values: Array = np.asarray(getattr(self, field), dtype=np.float64)
            try:
                values = np.array(np.broadcast_to(values, shape))
            except ValueError:
                raise ValueError(
                    f"The {field} of edge {self.name!r} have the shape {values.shape}; "
                    f"give {shape} to match its points."
                ) from None
            values.setflags(write=False)
            object.__setattr__(self, field, values)

    def __len__(self) -> int:
        return len(self.points)

    def __repr__(self) -> str:
        return f"TrueEdge({self.name!r}, {len(self)} samples, {self.length:.1f} mm)"

    @property
    def length(self) -> float:
        """Length of the edge, mm."""
        return float(self._steps.sum())

    def distance(self, points: ArrayLike) -> Array:
        """Distance of points (m, 3) to the edge, (m,), mm."""
        return distance_to_polyline(points, self.points, self.closed)[0]

    def nearest(self, points: ArrayLike) -> Array:
        """The places on the edge nearest to points (m, 3), (m, 3), mm."""
        _, index, fraction = distance_to_polyline(points, self.points, self.closed)
        start, end = self.points[index], self.points[(index + 1) % len(self)]
        return np.asarray(start + fraction[:, None] * (end - start), dtype=np.float64)

    def residuals(self, points: ArrayLike) -> Array:
        """Vectors from the edge to points (m, 3), (m, 3), mm."""
        return np.asarray(points, dtype=np.float64) - self.nearest(points)

    def nearest_sample(self, points: ArrayLike) -> NDArray[np.intp]:
        """Index of the sample nearest along the edge to points (m, 3), for its tangent or angle."""
        _, index, fraction = distance_to_polyline(points, self.points, self.closed)
        return np.asarray((index + (fraction > 0.5)) % len(self), dtype=np.intp)

    def traced_share(self, points: ArrayLike, pitch: float, closed: bool = False) -> float:
        """Share of this edge within one pitch of the polyline through edge points.

        Parameters
        ----------
        points : (m, 3) array
            Edge points found, in order, mm.
        pitch : float
            The cloud pitch, mm.
        closed : bool
            Whether the polyline goes on from its last point to its first.

        Returns
        -------
        Share in [0, 1] of the edge's length; 0 without any edge point.
        """
        found: Array = np.asarray(points, dtype=np.float64).reshape(-1, 3)
        if len(found) == 0:
            return 0.0
        near = distance_to_polyline(self.points, found, closed)[0] <= pitch
        weight = self._weights
        return float(weight[near].sum() / weight.sum())

    @property
    def _steps(self) -> Array:
        """Lengths from each sample to the next."""
        points = self.points if not self.closed else np.vstack([self.points, self.points[:1]])
        return np.asarray(np.linalg.norm(np.diff(points, axis=0), axis=1), dtype=np.float64)

    @property
    def _weights(self) -> Array:
        """Length of edge that each sample stands for: half the step on either side."""
        steps = self._steps
        if self.closed:
            return (steps + np.roll(steps, 1)) / 2
        padded = np.concatenate([[0.0], steps, [0.0]])
        return np.asarray((padded[:-1] + padded[1:]) / 2, dtype=np.float64)
