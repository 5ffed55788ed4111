# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rails and profiles brought into order: directions that agree, ends that meet.

A profile runs from the first rail to the second, and both rails from the first profile to the last.
Curves that were drawn the other way are turned, and that is said.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..geometry import BSplineCurve
from ..geometry.place_text import place_text
from ..geometry.plain_number import plain
from .rail_frame import OneRailFrame

__all__ = ["cut_to_profiles", "distances_beside", "in_order", "refuse_crossing"]

Array = NDArray[np.float64]

_SAMPLES = 50  # of a profile


def in_order(
    rails: Sequence[BSplineCurve], profiles: Sequence[BSplineCurve]
) -> tuple[tuple[BSplineCurve, ...], tuple[BSplineCurve, ...], tuple[str, ...]]:
    """Rails and profiles over [0, 1] in directions that agree, and what was turned for it.

    Raises
    ------
    ValueError: not one or two rails, no profile or only one between two rails, or a closed rail.
    """
    if len(rails) not in (1, 2):
        raise ValueError(f"A sweep has one or two rails, not {len(rails)}.")
    least = 2 if len(rails) == 2 else 1
    if len(profiles) < least:
        raise ValueError(
            f"A sweep along {len(rails)} rail(s) needs {least} or more profiles, not "
            f"{len(profiles)}."
        )
    for number, rail in enumerate(rails, 1):
        ends = rail.evaluate(np.array(rail.parameter_range))
        if rail.periodic or np.linalg.norm(ends[1] - ends[0]) < 1e-9 * rail.length():
            raise ValueError(f"Rail {number} is closed; split it, and sweep along its parts.")
    own_rails = [rail.opened().over_range(0.0, 1.0) for rail in rails]
    own_profiles = [profile.opened().over_range(0.0, 1.0) for profile in profiles]
    if len(own_rails) == 1:
        return (own_rails[0],), *_turned_like_the_first(own_rails[0], own_profiles)
    said = []
    if _turn_is_better(own_rails, own_profiles):
        own_rails[1] = own_rails[1].reversed()
        said.append("Rail 2 was turned round.")
    if _gaps(own_rails, own_profiles[::-1]) < _gaps(own_rails, own_profiles):
        own_profiles = own_profiles[::-1]
        said.append("The profiles were taken in the opposite order.")
    for number, profile in enumerate(own_profiles):
        starts = profile.evaluate(np.array([0.0, 1.0]))
        off = [rail.closest(starts)[1] for rail in own_rails]
        if off[0][0] + off[1][1] > off[0][1] + off[1][0]:
            own_profiles[number] = profile.reversed()
            said.append(f"Profile {number + 1} was turned round.")
    return tuple(own_rails), tuple(own_profiles), tuple(said)


def cut_to_profiles(
    rails: tuple[BSplineCurve, ...], profiles: tuple[BSplineCurve, ...], largest_gap: float
) -> tuple[tuple[BSplineCurve, ...], tuple[str, ...]]:
    """Two rails in order, ended where the outer profiles meet them, and what was cut off.

    Only ends that are farther from their profiles than the largest gap, mm, are cut.
    """
    if len(rails) != 2:
        return rails, ()
    cut, said = [], []
    for number, rail in enumerate(rails):
        ends = _outer_ends(profiles, number)
        at, off = rail.closest(ends)
        apart = np.linalg.norm(rail.evaluate(np.array([0.0, 1.0])) - ends, axis=1)
        over = (apart > largest_gap) & (off <= largest_gap)
        first, last = np.where(over, at, [0.0, 1.0])
        if over.any() and first < last:
            kept = rail.restricted(float(first), float(last))
            off_it = rail.length() - kept.length()
            said.append(
                f"Rail {number + 1} was cut by {plain(off_it, 3)} mm to end at the profiles."
            )
            rail = kept.over_range(0.0, 1.0)
        cut.append(rail)
    return tuple(cut), tuple(said)


def distances_beside(
    rails: Sequence[BSplineCurve], profiles: tuple[BSplineCurve, ...]
) -> NDArray[np.float64]:
    """How far, (2, 2) mm, the outer profiles end beside either rail, wherever along it."""
    return np.array(
        [rail.closest(_outer_ends(profiles, number))[1] for number, rail in enumerate(rails)]
    )


def _outer_ends(profiles: tuple[BSplineCurve, ...], number: int) -> Array:
    """Ends (2, 3) of the first and of the last profile at one of the rails."""
    return np.array([profiles[k].evaluate(float(number)) for k in (0, -1)])


def _turned_like_the_first(
    rail: BSplineCurve, profiles: list[BSplineCurve]
) -> tuple[tuple[BSplineCurve, ...], tuple[str, ...]]:
    """Profiles along one rail, all in the direction of the first one, seen from the rail."""
    frames = OneRailFrame(rail)
    local = []
    for profile in profiles:
        points = profile.evaluate(np.linspace(0.0, 1.0, _SAMPLES))
        at, off = rail.closest(points)
        place = at[[np.argmin(off)]]
        local.append((points - rail.evaluate(place)) @ frames(place)[0])
    turned, said = list(profiles), []
    for number, points in enumerate(local):
        as_given, as_turned = (
            np.linalg.norm(own - local[0], axis=1).sum() for own in (points, points[::-1])
        )
        if as_turned < as_given:
            turned[number] = profiles[number].reversed()
            said.append(f"Profile {number + 1} was turned round.")
    return tuple(turned), tuple(said)


def _turn_is_better(rails: list[BSplineCurve], profiles: list[BSplineCurve]) -> bool:
    turned = [rails[0], rails[1].reversed()]
    as_given, as_turned = (
        min(_gaps(own, profiles), _gaps(own, profiles[::-1])) for own in (rails, turned)
    )
    return as_turned < as_given


def _gaps(rails: list[BSplineCurve], profiles: list[BSplineCurve]) -> float:
    """How far the outer profiles are from the rails' ends, whichever way each of them runs."""
    total = 0.0
    for end, profile in ((0.0, profiles[0]), (1.0, profiles[-1])):
        corners = np.array([rail.evaluate(end) for rail in rails])
        ends = profile.evaluate(np.array([0.0, 1.0]))
        total += min(
            float(np.linalg.norm(corners - order, axis=1).sum()) for order in (ends, ends[::-1])
        )
    return total


def refuse_crossing(rails: Sequence[BSplineCurve], name: str) -> None:
    """Two rails, or opposite edges, that all but meet anywhere leave no room between them."""
    points = rails[0].sample(200)
    u, width = rails[1].closest(points)
    point, usual = rails[1].evaluate(u[[np.argmin(width)]]), float(np.median(width))
    for _ in range(50):  # to and fro between the rails
        point = rails[0].evaluate(rails[0].closest(point)[0])
        u, width = rails[1].closest(point)
        point = rails[1].evaluate(u)
    if width[0] < 1e-3 * usual:
        where = place_text(point[0])
        raise ValueError(
            f"The {name} meet or cross near ({where}); end them before, or choose {name} beside "
            "each other."
        )
