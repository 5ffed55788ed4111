# SPDX-License-Identifier: LGPL-2.1-or-later
"""The face of a network that a place is on."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial import cKDTree

from ..geometry.place_text import place_text
from .errors import ScanError
from .network import EdgeNetwork, Region

__all__ = ["region_at"]

_REACH = 4.0  # pitches from a point of a face


def region_at(network: EdgeNetwork, place: ArrayLike) -> Region:
    """The region of the cloud, between edges, that a place (3,) is on or next to.

    Raises
    ------
    ScanError: there is none.
    """
    cloud, at = network.cloud, np.asarray(place, dtype=np.float64)
    of_point = np.full(len(cloud), -1)
    for number, region in enumerate(network.regions):
        of_point[region.mask] = number
    on_faces = np.flatnonzero(of_point >= 0)
    where = place_text(at)
    if len(on_faces):
        away, nearest = cKDTree(cloud.points[on_faces], balanced_tree=False).query(at)
        if away <= _REACH * cloud.pitch:
            return network.regions[int(of_point[on_faces[nearest]])]
    raise ScanError(
        f"There is no face of the network at ({where}); choose a place on the cloud, between edges."
    )
