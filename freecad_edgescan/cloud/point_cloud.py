# SPDX-License-Identifier: LGPL-2.1-or-later
"""The point cloud everything else starts from: an immutable array that knows its own statistics.

Points are float64 millimetres, far from the origin or not. The KD-tree, the pitch and the noise
are worked out when first asked for and kept.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial import cKDTree

from ..geometry.place_text import place_text
from ..geometry.plain_number import plain
from . import statistics

__all__ = ["FEWEST_POINTS", "PointCloud", "require_surface"]

Array = NDArray[np.float64]

_SOME = 1000  # points that tell whether a cloud extends in all directions
FEWEST_POINTS = 20  # below this no local surface can be told from noise
_FEW = 8  # points that tell whether all of them are there many times
_MANY = 4  # times, from which on neighbourhoods of a few points are hardly more than one place
_LARGE = 2_000_000  # points from which on memory counts
_LEAVES = (16, 32)  # points in a leaf of the tree, and of a large cloud: 10 bytes a point less
FARTHEST = 1e12  # mm; beyond it squares and differences lose their meaning


@dataclass(frozen=True, eq=False, repr=False)
class PointCloud:
    """Scanned points of a part.

    Parameters
    ----------
    points : (n, 3) array of finite numbers, mm, n >= 1. They are copied and made read-only; an
        array that is read-only and no view of another one is taken as it is. Rows that hold nan
        or inf are left out and counted in ``dropped``, with a warning.
    probe_radius : mm; above 0 the points are the centres of a probing ball of this radius
    approach : (3,) direction the probe came along (any length); the air lies at ``-approach``

    Raises
    ------
    ValueError: points that are no (n, 3) array of numbers or hold no finite row; a negative
        probe radius; an approach without a direction.
    """

    points: Array
    probe_radius: float = 0.0
    approach: Array | None = None
    dropped: int = field(default=0, init=False)

    def __init__(
        self, points: ArrayLike, probe_radius: float = 0.0, approach: ArrayLike | None = None
    ) -> None:
        rows = _rows(points)
        finite = np.isfinite(rows).all(axis=1)
        dropped = len(rows) - int(np.count_nonzero(finite))
        kept = rows[finite] if dropped else rows
        _check_kept(kept, dropped)
        if dropped:
            warnings.warn(
                f"{dropped} of {len(rows)} points were left out: they hold nan or inf.",
                stacklevel=2,
            )
        kept.setflags(write=False)
        object.__setattr__(self, "points", kept)
        object.__setattr__(self, "probe_radius", _radius(probe_radius))
        object.__setattr__(self, "approach", _direction(approach))
        object.__setattr__(self, "dropped", dropped)

    def __len__(self) -> int:
        return len(self.points)

    def __repr__(self) -> str:
        size = " x ".join(f"{extent:.6g}" for extent in self.size)
        return f"PointCloud({len(self)} points, {size} mm, probe_radius={self.probe_radius:g})"

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Arrays come out of a pickle writable; a cloud's are not."""
        self.__dict__.update(state)
        self.points.setflags(write=False)
        if self.approach is not None:
            self.approach.setflags(write=False)

    @cached_property
    def tree(self) -> cKDTree:
        """KD-tree of the points, built once."""
        leaf = _LEAVES[len(self) >= _LARGE]
        return cKDTree(self.points, leafsize=leaf, balanced_tree=False)

    @cached_property
    def bounds(self) -> tuple[Array, Array]:
        """Lowest and highest corner of the bounding box, (3,) each, mm."""
        # One coordinate after the other: along the short rows NumPy takes ten times as long.
        lowest = np.array([coordinate.min() for coordinate in self.points.T])
        highest = np.array([coordinate.max() for coordinate in self.points.T])
        lowest.setflags(write=False)
        highest.setflags(write=False)
        return lowest, highest

    @property
    def size(self) -> Array:
        """Extents of the bounding box, (3,), mm."""
        lowest, highest = self.bounds
        return np.asarray(highest - lowest, dtype=np.float64)

    @cached_property
    def principal_extents(self) -> Array:
        """Extents along the cloud's own principal axes, (3,) mm, largest first."""
        return _principal_extents(self.points)

    @property
    def origin_hint(self) -> Array:
        """A local origin in whole mm, (3,), to subtract before going through float32.

        Zero while the cloud lies near the origin for its size, so that coordinates stay as they
        are wherever nothing is won by moving them.
        """
        lowest, highest = self.bounds
        centre = (lowest + highest) / 2
        if np.linalg.norm(centre) <= 10 * np.linalg.norm(highest - lowest):
            return np.zeros(3)
        return np.asarray(np.round(centre), dtype=np.float64)

    @cached_property
    def pitch(self) -> float:
        """1 / sqrt(points per mm² of surface), the median over neighbourhoods, mm."""
        return self._pitch_and_noise[0]

    @cached_property
    def noise(self) -> float:
        """Standard deviation of the points along the surface normal, mm."""
        return self._pitch_and_noise[1]

    @cached_property
    def _pitch_and_noise(self) -> tuple[float, float]:
        return statistics.estimate_pitch_and_noise(self.tree)

    def local_pitch(self, points: ArrayLike) -> Array:
        """Two principal pitches round each of some places, larger first.

        Parameters
        ----------
        points : (m, 3) or (3,) array, mm, places on the surface

        Returns
        -------
        (m, 2) array, mm: spacing in the direction where points lie farthest apart and across it;
        their product is the area of surface per point.
        """
        places = np.asarray(points, dtype=np.float64).reshape(-1, 3)
        return statistics.estimate_local_pitch(self.tree, places)

    def largest_gap(self, points: ArrayLike) -> float:
        """How far a place on the surface may be from its nearest point, mm.

        All but one place in 1000 lie nearer. For a grid it is about 0.7 pitches, for points strewn
        at random 1.5, for scan lines half of what lies between two lines.

        Parameters
        ----------
        points : (m, 3) array, mm, places on the surface to look round
        """
        places = np.asarray(points, dtype=np.float64).reshape(-1, 3)
        return statistics.estimate_largest_gap(self.tree, places)


def require_surface(cloud: PointCloud) -> None:
    """Refuse a cloud that cannot hold an edge.

    Raises
    ------
    ValueError: fewer than 20 points, all of them equal, on one line or on one plane, or each
        of them there so often that it has no neighbours but itself.
    """
    if len(cloud) < FEWEST_POINTS:
        raise ValueError(
            f"The cloud holds {len(cloud)} points; an edge needs at least {FEWEST_POINTS}. "
            "Take a larger region or a denser scan."
        )
    _refuse_repetitions(cloud.points)
    # Some points never extend farther than all of them.
    some = cloud.points[:: max(1, len(cloud) // _SOME)]
    long, _, thick = _principal_extents(some)
    if thick > 1e-3 * long and thick > 1e-6 * float(np.abs(some).max()):
        return
    extents = cloud.principal_extents
    blur = 1e-6 * extents[0] + 16 * np.finfo(float).eps * float(np.abs(cloud.bounds).max())
    if extents[0] <= blur:
        raise ValueError(
            f"All {len(cloud)} points of the cloud are equal ({place_text(cloud.points[0])}). "
            "Check how the file was written."
        )
    if extents[1] <= blur:
        raise ValueError(
            f"All {len(cloud)} points of the cloud lie on one line, {plain(extents[0], 4)} mm "
            "long. An edge needs a scan of the two surfaces that meet in it."
        )
    if extents[2] <= blur:
        raise ValueError(
            f"All {len(cloud)} points of the cloud lie on one plane "
            f"({plain(extents[0], 4)} x {plain(extents[1], 4)} mm), which has no edge between two "
            "surfaces. Scan the second surface too, or take a larger region."
        )


def _refuse_repetitions(points: Array) -> None:
    """Refuse points of which each one's neighbours are itself again: pitch and noise are wrong."""
    times = len(points)
    for place in points[:: max(1, len(points) // _FEW)]:
        times = min(times, _count_of(place, points))
        if times < _MANY:
            return
    if times < len(points):
        raise ValueError(
            f"Each place of the cloud is there {times} times or more among its {len(points)} "
            "points, so that a point's neighbours are itself again. Write each point once "
            "(numpy.unique(points, axis=0) keeps one of each)."
        )


def _count_of(place: Array, points: Array) -> int:
    same = points[np.flatnonzero(points[:, 0] == place[0])]
    return int(np.count_nonzero((same == place).all(axis=1)))


def _is_constant(points: ArrayLike) -> TypeGuard[Array]:
    """Whether an array is what a cloud would make of it: a large one is not to be there twice."""
    return (
        isinstance(points, np.ndarray)
        and points.dtype == np.float64
        and points.flags.c_contiguous
        and points.flags.owndata
        and not points.flags.writeable
    )


def _rows(points: ArrayLike) -> Array:
    """The points as C-contiguous (n, 3) float64 that nobody can change: themselves, or a copy."""
    try:
        rows = points if _is_constant(points) else np.array(points, dtype=np.float64, order="C")
    except (TypeError, ValueError) as error:
        raise ValueError(
            f"The points are not an array of numbers ({error}). Give an (n, 3) array in mm."
        ) from None
    if rows.size == 0:
        raise ValueError("The cloud holds no points. Give an (n, 3) array in mm.")
    if rows.ndim != 2 or rows.shape[1] != 3:
        raise ValueError(
            f"The points have the shape {rows.shape}. Give an (n, 3) array in mm: one row x, y, z "
            "for each point."
        )
    return rows


def _check_kept(kept: Array, dropped: int) -> None:
    if len(kept) == 0:
        raise ValueError(
            f"None of the {dropped} points is finite: every one holds nan or inf. "
            "Check how the file was written."
        )
    farthest = float(max(kept.max(), -kept.min()))
    if farthest > FARTHEST:
        raise ValueError(
            f"A coordinate of the cloud is {farthest:g} mm; at most {FARTHEST:g} mm can be worked "
            "with. Check the units and how the file was written."
        )


def _radius(probe_radius: float) -> float:
    try:
        radius = float(probe_radius)
    except (TypeError, ValueError):
        radius = np.nan
    if not 0.0 <= radius < np.inf:
        raise ValueError(
            f"The probe radius is {probe_radius!r} mm. Give 0 for surface points or the positive "
            "radius of the probing ball."
        )
    return radius


def _direction(approach: ArrayLike | None) -> Array | None:
    if approach is None:
        return None
    try:
        vector = np.array(approach, dtype=np.float64)
    except (TypeError, ValueError):
        vector = np.empty(0)
    length = float(np.linalg.norm(vector)) if vector.shape == (3,) else 0.0
    if not 0.0 < length < np.inf:
        raise ValueError(
            f"The approach {approach!r} has no direction. Give the direction the probe came along "
            "as three numbers that are not all zero, for example (0, 0, -1)."
        )
    vector /= length
    vector.setflags(write=False)
    return vector


def _principal_extents(points: Array) -> Array:
    """Lengths of the cloud along its principal axes, (3,), largest first, mm."""
    centred = points - points.mean(axis=0)
    scale = float(np.abs(centred).max()) or 1.0
    _, axes = np.linalg.eigh(centred.T @ centred / scale**2)
    return np.asarray(np.ptp(centred @ axes, axis=0)[::-1], dtype=np.float64)
