# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points with parameters: those of the closest points of a base surface (Schreve 6.3)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..cloud.progress import Progress
from ..geometry import BSplineSurface

__all__ = ["Parameterised", "beyond_the_rim", "parameterised"]

Array = NDArray[np.float64]

_AT_ONCE = 200_000  # points
_ON_THE_RIM = 1e-6  # of the surface's size: no farther beyond the rim is still on it


@dataclass(frozen=True, eq=False)
class Parameterised:
    """Points (n, 3), mm, their parameters u (n,), v (n,), and which lie beyond the rim (n,)."""

    points: Array
    u: Array
    v: Array
    outside: NDArray[np.bool_]


def parameterised(
    points: ArrayLike, base: BSplineSurface, progress: Progress | None = None
) -> Parameterised:
    """Parameters of the base surface's closest points.

    A point is outside when its closest point is on the rim and the point lies beyond it, measured
    along the surface. Where progress answers False, the result holds the first points only.

    Raises
    ------
    ValueError: no points, or not (n, 3) finite numbers.
    """
    x: Array = np.asarray(points, dtype=float)
    if x.ndim != 2 or x.shape[1] != 3 or len(x) == 0:
        raise ValueError(f"Points to fit are an (n, 3) array with n > 0, not one of {x.shape}.")
    u, v = np.empty(len(x)), np.empty(len(x))
    for start in range(0, len(x), _AT_ONCE):
        rows = slice(start, start + _AT_ONCE)
        u[rows], v[rows], _ = base.closest(x[rows])
        done = min(start + _AT_ONCE, len(x))
        if progress and not progress.update(done / len(x), None):
            x, u, v = x[:done], u[:done], v[:done]
            break
    return Parameterised(x, u, v, beyond_the_rim(x, base, u, v))


def beyond_the_rim(points: Array, base: BSplineSurface, u: Array, v: Array) -> NDArray[np.bool_]:
    """Which points (n, 3) with their feet at u (n,), v (n,) on a rim lie beyond it."""
    beyond = np.zeros(len(points), dtype=bool)
    near = _ON_THE_RIM * float(np.ptp(base.poles.reshape(-1, 3), axis=0).max())
    for axis, x in enumerate((u, v)):
        if base.closed[axis]:
            continue
        for limit, outwards in zip(base.parameter_range[axis], (-1.0, 1.0), strict=True):
            rows = np.flatnonzero(x == limit)
            tangents = base.tangents(u[rows], v[rows])
            over, rim = tangents[axis], tangents[1 - axis]
            square = np.sum(rim**2, axis=1, keepdims=True)
            along = np.sum(over * rim, axis=1, keepdims=True)
            over = over - along / np.where(square > 0.0, square, np.inf) * rim
            length = np.linalg.norm(over, axis=1)
            away = points[rows] - base.evaluate(u[rows], v[rows])
            reach = outwards * np.sum(away * over, axis=1)
            beyond[rows] |= reach > near * np.where(length > 0.0, length, np.inf)
    return beyond
