# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a cloud is from a surface, point by point, and on which side."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..cloud import PointCloud
from ..geometry import BSplineSurface
from .deviation_figures import DeviationFigures
from .fit_result import signed_deviation
from .parameterised import beyond_the_rim

if TYPE_CHECKING:
    from ..scanning import Progress

__all__ = ["Deviation", "deviation", "points_of"]

Array = NDArray[np.float64]

_AT_ONCE = 200_000


@dataclass(frozen=True, eq=False)
class Deviation(DeviationFigures):
    """Deviations of points from a surface.

    Attributes
    ----------
    deviation : (n,) mm, distance of each point, positive on the side of the surface's normal
    outside : (n,) bool, points beyond the surface's rim; the figures leave them out
    parameters : u (n,) and v (n,) of the closest points
    """

    deviation: Array
    outside: NDArray[np.bool_]
    parameters: tuple[Array, Array] = field(repr=False)

    def __len__(self) -> int:
        return len(self.deviation)

    @classmethod
    def joined(cls, parts: Sequence[Deviation]) -> Deviation:
        """Deviations of points that follow each other, in parts, as one."""
        nothing = cls(np.zeros(0), np.zeros(0, dtype=bool), (np.zeros(0), np.zeros(0)))
        parts = list(parts) or [nothing]
        return cls(
            np.concatenate([part.deviation for part in parts]),
            np.concatenate([part.outside for part in parts]),
            (
                np.concatenate([part.parameters[0] for part in parts]),
                np.concatenate([part.parameters[1] for part in parts]),
            ),
        )

    def to_csv(self, points: ArrayLike, path: str | PathLike[str]) -> None:
        """Write points (n, 3), mm, their deviations, and whether they lie beyond the rim."""
        table = np.column_stack([np.asarray(points, dtype=float), self.deviation, self.outside])
        header = "x_mm,y_mm,z_mm,deviation_mm,beyond_rim"
        with Path(path).open("w", encoding="utf-8", newline="") as file:
            np.savetxt(file, table, ["%.6f"] * 4 + ["%d"], ",", header=header, comments="")

    def histogram(self, bins: int = 60, limit: float | None = None) -> tuple[Array, Array]:
        """Counts (bins,) and limits (bins + 1,), mm, of the deviations within the rim.

        Parameters
        ----------
        bins : int
        limit : float, optional
            mm to both sides of zero; points beyond count at the ends. By default the largest.
        """
        if not bins >= 1:
            raise ValueError(f"A histogram cannot have {bins} bins; give 1 or more.")
        if limit is not None and not 0.0 < limit < np.inf:
            raise ValueError(f"The limit of the histogram is {limit} mm; give a positive length.")
        inside = self.deviation[~self.outside]
        widest = limit or float(np.abs(inside).max(initial=0.0)) or 1e-9
        counts, limits = np.histogram(np.clip(inside, -widest, widest), bins, (-widest, widest))
        return counts.astype(float), limits


def deviation(
    cloud: PointCloud | ArrayLike, surface: BSplineSurface, progress: Progress | None = None
) -> Deviation:
    """Signed distances of a cloud's points from a surface.

    Parameters
    ----------
    cloud : PointCloud or (n, 3) array, mm
        Points on the part's surface; compensate a cloud of probe centres first.
    surface : BSplineSurface
    progress : object with ``update(fraction, so_far) -> bool``, optional
        Told the deviations so far; when it answers False those of the first points are the result.

    Returns
    -------
    Deviation. Beyond the surface's rim it is the distance to the rim.

    Raises
    ------
    ValueError: no points, or a cloud of probe centres.
    """
    x = points_of(cloud)
    parts: list[Deviation] = []
    for start in range(0, len(x), _AT_ONCE):
        part = x[start : start + _AT_ONCE]
        u, v, distance = surface.closest(part)
        signed = signed_deviation(surface, part, u, v, distance)
        parts.append(Deviation(signed, beyond_the_rim(part, surface, u, v), (u, v)))
        if progress and not progress.update((start + len(part)) / len(x), parts[-1]):
            break
    return Deviation.joined(parts)


def points_of(cloud: PointCloud | ArrayLike) -> Array:
    """The surface points (n, 3) of a cloud or an array.

    Raises
    ------
    ValueError: no points, not (n, 3) finite numbers, or a cloud of probe centres.
    """
    if isinstance(cloud, PointCloud):
        if cloud.probe_radius > 0.0:
            raise ValueError(
                f"The cloud holds the centres of a ball of {cloud.probe_radius:g} mm radius, not "
                "points of the surface; give compensate_cloud(cloud)."
            )
        return cloud.points
    x: Array = np.asarray(cloud, dtype=float)
    if x.ndim != 2 or x.shape[1] != 3 or len(x) == 0:
        raise ValueError(f"Points are an (n, 3) array with n > 0, not one of shape {x.shape}.")
    if not np.isfinite(x).all():
        raise ValueError("A coordinate of the points is not a finite number; remove the point.")
    return x
