# SPDX-License-Identifier: LGPL-2.1-or-later
"""A circular profile between the ends of two rails, through the cloud's points near their plane."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..cloud import PointCloud
from ..geometry import BSplineCurve, Circle, fit_circle
from ..geometry.exact_surfaces import circular_arc

__all__ = ["end_profile"]

Array = NDArray[np.float64]

_SLAB = 6.0  # cloud pitches
_FEWEST = 8


def end_profile(cloud: PointCloud, first: ArrayLike, second: ArrayLike) -> BSplineCurve:
    """An arc across a channel from one place on its rim to another.

    Parameters
    ----------
    cloud : PointCloud with an approach; the arc lies in the plane of both places and that direction
    first, second : (3,) places on the two rims, mm

    Returns
    -------
    BSplineCurve, on the surface also when the cloud holds centres of a probe.

    Raises
    ------
    ValueError: fewer than eight points near the plane between the places.
    """
    a, b = np.asarray(first, dtype=float), np.asarray(second, dtype=float)
    approach = np.array([0.0, 0.0, -1.0]) if cloud.approach is None else np.asarray(cloud.approach)
    width = float(np.linalg.norm(b - a))
    across = (b - a) / width
    along = np.cross(across, approach)
    along /= np.linalg.norm(along)
    down = np.cross(along, across)
    down *= np.sign(down @ approach)
    away = cloud.points - (a + b) / 2
    away = away[np.abs(away @ along) <= _SLAB * cloud.pitch / 2.0]
    x, y = away @ across, away @ down
    margin = 2.0 * (cloud.probe_radius + cloud.pitch)
    walls = (np.abs(x) < width / 2) & (y > margin) & (y < width)
    if int(walls.sum()) < _FEWEST:
        raise ValueError(
            f"Only {int(walls.sum())} points lie between ({_text(a)}) and ({_text(b)}) near the "
            "plane of a profile; end the rails where there are more."
        )
    flat = np.column_stack([x[walls], y[walls], np.zeros(int(walls.sum()))])
    circle = fit_circle(flat).circle
    centre = (a + b) / 2 + circle.centre[0] * across + circle.centre[1] * down
    angles = [
        float(np.arctan2((place - centre) @ down, (place - centre) @ -across)) for place in (a, b)
    ]
    if angles[1] < angles[0]:
        angles[1] += 2.0 * np.pi
    exact = Circle(centre, np.cross(-across, down), circle.radius + cloud.probe_radius, -across)
    return circular_arc(exact, angles[0], angles[1])


def _text(place: Array) -> str:
    return ", ".join(f"{value:.4g}" for value in place)
