# SPDX-License-Identifier: LGPL-2.1-or-later
"""On which side of an edge the air is: needed to take the probe radius off, never guessed."""

from __future__ import annotations

import numpy as np

from ..geometry.plain_number import plain
from .errors import ScanError

_CLEARLY = np.sin(np.radians(10.0))


def convex_by_approach(normals: np.ndarray, approach: np.ndarray) -> bool:
    """Whether material fills the smaller wedge, when the probe came along the approach.

    The air is the wedge that holds −approach. Where that direction lies along one of the sides
    (a floor and an upright wall, probed from above) the other side decides: the probe came from
    its air.

    Parameters
    ----------
    normals : (m, 2, 3) unit vectors out of the smaller wedge
    approach : (3,) unit vector
    """
    from_air = -np.einsum("mki,i->mk", normals, approach)
    outermost = from_air.max(axis=1)
    decisive = np.take_along_axis(from_air, np.abs(from_air).argmax(axis=1)[:, None], axis=1)[:, 0]
    votes = np.where(np.abs(outermost) > _CLEARLY, outermost, decisive)
    return bool(np.median(votes) > 0.0)


def convex_by_rounding(probe_radius: float, rounding: np.ndarray, sigma: np.ndarray) -> bool:
    """Whether material fills the smaller wedge, read off the rounding of probe centres.

    A ball rolls round a sharp convex edge with its own radius; in a concave edge its centre turns
    sharply.

    Raises
    ------
    ScanError: the rounding fits a rounded convex edge as well as a fillet in a concave one.
    """
    seen = np.isfinite(rounding)
    if seen.mean() < 0.3:
        return False
    radius = float(np.median(rounding[seen]))
    margin = 0.25 * probe_radius + 3.0 * float(np.median(sigma[seen]))
    if radius < 0.5 * probe_radius:
        return False
    if abs(radius - probe_radius) <= margin:
        return True
    raise ScanError(
        f"The cloud holds probe centres (probe radius {probe_radius:g} mm) and its rim is rounded "
        f"by {plain(radius, 3)} mm: that may be a rounded outer edge or a fillet in a corner. Give "
        "the direction the probe came along, for example approach=(0, 0, -1)."
    )
