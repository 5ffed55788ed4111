# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far places are from the exact wall of a half-pipe."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from ..cloud.half_pipe import HalfPipe
from ..geometry import BSplineSurface

__all__ = ["deviation_from_wall", "surface_from_wall"]

Array = NDArray[np.float64]

_FINER = 4  # samples of the spine between two of the pipe's own
_BESIDE = 24  # samples to both sides of the nearest one that are looked at
_GRID = (160, 24)  # places on a surface, along and across


def deviation_from_wall(pipe: HalfPipe, places: Array) -> Array:
    """Distances (k,) of places (k, 3) from the wall of a pipe, mm.

    The wall is the envelope of spheres along the spine: near it, the distance is that to the
    nearest sphere. The radius changes so slowly that it is one of those beside the nearest centre.
    """
    own = pipe.parameters
    fine = np.interp(np.arange(0, len(own) - 1, 1.0 / _FINER), np.arange(len(own)), own)
    spheres = pipe.spine(fine)
    nearest = cKDTree(spheres[:, :2]).query(places[:, :2])[1]
    number = nearest[:, None] + np.arange(-_BESIDE, _BESIDE + 1)
    near = spheres[np.clip(number, 0, len(spheres) - 1)]
    offset = places[:, None, :2] - near[..., :2]
    distance = np.sqrt((offset**2).sum(axis=2) + places[:, None, 2] ** 2)
    return np.asarray(np.abs((distance - near[..., 2]).min(axis=1)))


def surface_from_wall(pipe: HalfPipe, surface: BSplineSurface) -> Array:
    """Distances (k,) of a grid of places on a surface, rims and all, from the wall of a pipe, mm.

    The surface's u runs along the pipe.
    """
    u, v = (
        np.linspace(*limits, count)
        for limits, count in zip(surface.parameter_range, _GRID, strict=True)
    )
    return deviation_from_wall(pipe, surface.evaluate(u[:, None], v).reshape(-1, 3))
