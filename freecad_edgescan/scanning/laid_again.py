# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections laid once more, along the edge points that were measured in the first ones.

A walk that cannot see where a rounding begins wavers. So do the sections that stand on it, and
what neighbours are to agree on is blurred.
"""

from __future__ import annotations

import numpy as np

from .corner import largest_sigma
from .edge_path import EdgePath, path_along
from .edge_points import Measured
from .section import Station, frames_from_sides
from .trace import Trace

__all__ = ["laid_again", "wavers"]

_FEWEST = 6  # edge points
_STRAIGHT = 0.3  # noise, by which sections may be beside their neighbours
_BADLY_KNOWN = 3.0  # times the usual sigma, of edge points that are not asked


def wavers(measured: Measured) -> bool:
    """Whether the sections stand beside their edge points, one here and one there.

    By more than a share of the noise.
    """
    shift = measured.corners().shift
    beside = shift - np.median(shift, axis=0)
    return bool(np.median(np.linalg.norm(beside, axis=1)) > _STRAIGHT * np.median(measured.noise))


def laid_again(
    measured: Measured,
    path: EdgePath,
    edge_pitch: float,
    least_pitch: float,
    chord_height: float | None,
) -> EdgePath:
    """Lay the sections of a path again.

    Parameters
    ----------
    measured : what was measured in them
    path : where they were laid
    edge_pitch, least_pitch, chord_height : see `path_along`
    """
    seen, fits, frames = measured.corners(), measured.fits, measured.frames
    sigma = largest_sigma(seen.covariance)
    asked = sigma < _BADLY_KNOWN * np.median(sigma)
    asked[[0, -1]] = True  # however badly its ends are known, the edge does not become shorter
    known = np.flatnonzero(seen.found & asked)
    if len(known) < _FEWEST:
        return path
    standing = frames_from_sides(
        seen.point, frames.tangent, seen.sides, frames.bend, fits.coefficients[..., 2] / fits.reach
    )
    stations = [
        Station(standing[int(k)], sigma=float(sigma[k]), begins=tuple(fits.begins[k]))
        for k in known
    ]
    return path_along(Trace(stations, path.ends), edge_pitch, least_pitch, chord_height)
