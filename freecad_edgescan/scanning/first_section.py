# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a click or a start to the first section of an edge."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..cloud.point_cloud import PointCloud
from ..geometry.place_text import place_text
from ..geometry.plain_number import plain
from .automatic import Chosen
from .errors import ScanError
from .parameters import ScanParameters
from .seed import Seed, find_seed, nearest_seed
from .start import Start, numbers

__all__ = ["first_section", "place_to_look"]

Point = Sequence[float] | np.ndarray
_FARTHEST_CLICK = 10.0  # pitches from the nearest cloud point
_CLOSE_CLICK = 4.0  # pitches from an edge within which a click means it
_ROUND_THE_CLICK = 6.0  # pitches
# Of these, by which the centroid of points is off: 0.42 of half a disc, below 0.1 by chance.
_ONE_SIDED = 0.2
_LOOK_AROUND = 60.0  # pitches round a click without an edge, to name the nearest one


def place_to_look(cloud: PointCloud, at: Point | Start, parameters: ScanParameters) -> np.ndarray:
    """The cloud point where to look for the edge, (3,) mm.

    Raises
    ------
    ScanError: a place that is none, or far from the cloud.
    """
    if isinstance(at, Start):
        reach = 0.5 * (parameters.amplitude or 20.0 * cloud.pitch)
        wanted, farthest = at.point + reach * at.across, 2.0 * reach
    else:
        click = numbers(at)
        if click is None:
            raise ScanError(f"The click is {at!r}; give three finite coordinates in mm.")
        wanted = click
        farthest = _FARTHEST_CLICK * cloud.pitch
    distance, index = cloud.tree.query(wanted)
    if distance > farthest:
        low, high = cloud.bounds
        raise ScanError(
            f"The place ({place_text(wanted)}) is {plain(distance, 3)} mm away from the nearest "
            f"point of the cloud, which reaches from ({place_text(low)}) to ({place_text(high)}); "
            "choose a place on it."
        )
    return cloud.points[index] if isinstance(at, Start) else wanted


def first_section(cloud: PointCloud, near: np.ndarray, start: Start | None, chosen: Chosen) -> Seed:
    """Find the edge near a place.

    Parameters
    ----------
    near : (3,) mm
    start : what the user gave, if it was a start
    chosen : parameters with their automatic values

    Raises
    ------
    ScanError: there is no edge; the text names the nearest one.
    """
    settings = chosen.for_seed
    along = None if start is None else start.along
    within = None if start is None else settings.reach
    seed = find_seed(cloud, near, settings, along, within)
    if seed is not None:
        return seed
    other = nearest_seed(cloud, near, settings, _LOOK_AROUND * settings.cloud_pitch)
    if other is not None and start is None:
        gap = float(np.linalg.norm(other.station.frame.origin[0] - near))
        if gap < _CLOSE_CLICK * settings.cloud_pitch:
            return other
    message = f"There is no edge within reach of ({place_text(near)})"
    if other is None:
        smooth = plain(_LOOK_AROUND * settings.cloud_pitch, 3)
        one_sided = (
            " The cloud ends there, and an edge needs both of its sides in the cloud."
            if _at_the_border(cloud, near)
            else ""
        )
        raise ScanError(
            f"{message}: the surface is smooth for {smooth} mm round it. Click nearer to an edge."
            f"{one_sided}"
        )
    place = other.station.frame.origin[0]
    raise ScanError(
        f"{message}: the surface is smooth there. The nearest edge found is "
        f"{plain(float(np.linalg.norm(place - near)), 3)} mm away, at ({place_text(place)})."
    )


def _at_the_border(cloud: PointCloud, near: np.ndarray) -> bool:
    """Whether the points round the one nearest to a place (3,), mm, lie to one side of it."""
    middle = cloud.points[int(cloud.tree.query(near)[1])]
    around = cloud.tree.query_ball_point(middle, _ROUND_THE_CLICK * cloud.pitch)
    off = float(np.linalg.norm(cloud.points[around].mean(axis=0) - middle))
    return off > _ONE_SIDED * _ROUND_THE_CLICK * cloud.pitch
