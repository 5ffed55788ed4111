# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a probed scan does beyond the algorithm as printed, each measure by its name."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from .errors import ScanError

__all__ = ["Safeguards"]

_RANGES = {
    "baseline": (0.0, 10.0),
    "smoothing": (0.0, 0.99),
    "largest_turn": (0.0, np.pi),
    "coasting": (0, 100),
    "largest_gap": (1.0, 10.0),
}


@dataclass(frozen=True)
class Safeguards:
    """Measures that keep a probed scan on its edge; `Safeguards.none()` is the printed algorithm.

    Attributes
    ----------
    slide : points are moved along the edge's tangent into the plane across the edge, instead of
        square to the plane that fits them best; along the tangent a surface does not change
    signed_split : a line is split at the point that stands out farthest from the smaller wedge,
        not at the one farthest from the chord on either side
    quadratic_cleaning : the points on a rounding are found with a quadratic, also where a line is
        fitted afterwards; on a curved side a line would give up good points
    agreed_cleaning : where the rounding begins is decided by all lines of the edge together,
        whatever the tolerance lets pass; not for lines, which follow no curved side and do better
        with points near the edge
    near_points : a line that does not hold the tolerance gives up its points far from the edge,
        where the surface has bent away, instead of those near it
    spare_points : points a section keeps when the tolerance is below the noise; cleaning to the
        last point would leave a curve through noise
    plausible : an edge point aside of its prediction by more than the step, or a side that leans
        against the last one by more than 40°, comes from a bad line
    level_ends : the step from line to line, which tells a surface's normal, is taken between places
        level with each other, not between the curves' ends; these may lie a line pitch apart
    baseline : amplitudes that the line lies behind from which a surface's normal is read; from
        lines much closer than they are long, the smallest deviation of a curve turns the normal;
        until half of it is walked, the start's direction is kept
    smoothing : share of the last tangent and sides in the new ones, 0 … 1
    largest_turn : of a line's own tangent against the last one, before they are averaged, rad
    steady_pitch : the chord height is that between two edge points, which grows with the square of
        the edge pitch, and so the pitch changes by the root of what it asks for; as printed it is
        that over two steps, and the pitch swings about the right one
    coasting : lines without an edge point in sequence that are passed over
    short_lines : a line that could not be scanned to its end is used as far as it goes
    largest_gap : line pitches between two contacts, above which points are filled in between; as
        printed, every contact that lies a little too far asks for another one
    step_on : a point touched twice is passed over in a longer step
    feel_round : where nothing is touched the probe is led round the edge in small turns, instead
        of once across half the search distance
    near_collisions : a collision on the way to a line's first point is measured there when it lies
        near the target; only one far from it means that the scan has lost its way
    restore : each line begins half an amplitude from the edge, and a zigzag half an edge pitch
        ahead, instead of wherever the line before has ended (Schreve figures 4.5 and 4.14); the
        plane of a zigzag line holds the bisector of the two surfaces, so that the line gets on
        as far behind the edge as before it
    sharp_edge : once several lines have shown no rounding, contacts close to the edge are of use:
        the gap in which it is expected is filled in to half a line pitch, the point a line is split
        at is kept, and a line has its length along the surface, to half a line pitch. Then the
        error without noise is that of the model. A line that shows a rounding ends it
    """

    slide: bool = True
    signed_split: bool = True
    quadratic_cleaning: bool = True
    agreed_cleaning: bool = True
    near_points: bool = True
    spare_points: bool = True
    plausible: bool = True
    level_ends: bool = True
    baseline: float = 0.1
    smoothing: float = 0.5
    largest_turn: float = float(np.radians(15.0))
    steady_pitch: bool = True
    coasting: int = 3
    short_lines: bool = True
    largest_gap: float = 1.5
    step_on: bool = True
    feel_round: bool = True
    near_collisions: bool = True
    restore: bool = True
    sharp_edge: bool = True

    @classmethod
    def none(cls) -> Safeguards:
        """The algorithm as printed."""
        off = {field.name: False for field in fields(cls) if field.type == "bool"}
        return cls(
            **off,
            baseline=0.0,
            smoothing=0.0,
            largest_turn=float(np.pi),
            coasting=0,
            largest_gap=1.0,
        )

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if field.type == "bool":
                good, wanted = isinstance(value, bool), "True or False"
            else:
                low, high = _RANGES[field.name]
                number = isinstance(value, int | float | np.number) and not isinstance(value, bool)
                good, wanted = number and low <= value <= high, f"a number from {low:g} to {high:g}"
            if not good:
                words = field.name.replace("_", " ")
                raise ScanError(f"The safeguard {words!r} is {value!r}; give {wanted}.")
