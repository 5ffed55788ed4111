# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a straight rounded edge keeps its course up to its ends.

Where an edge ends under a rounding, the roundings of the edges it meets begin before it does, and
what is measured there bends away with them. A straight edge says where it would have gone; of a
bent one an end that bends away is not told from one that bends on.
"""

from __future__ import annotations

import numpy as np

from ..geometry import Line, simplest_curve
from .corner import Corners, across_axes, largest_sigma
from .edge_points import Measured
from .stop import GIVEN_ENDS, Stop

__all__ = ["on_course"]

_AT_END = 6  # sections at each end that are looked at
_ASKED, _FEWEST = 16, 8  # sections before these that say where the edge goes
_OFF = 16.0  # squared Mahalanobis distance of an edge point that is beside the edge


def on_course(measured: Measured, stops: tuple[Stop, Stop]) -> slice:
    """Sections between those at the ends of a straight edge that are beside it; of others, all.

    An end that was given is none.
    """
    seen, count = measured.corners(), len(measured.at)
    inner = slice(_AT_END, count - _AT_END)
    if count < 2 * _AT_END + _FEWEST or not _is_straight(seen, inner):
        return slice(0, count)
    ends = []
    for k, stop in enumerate(stops):
        order = np.arange(count)[::-1] if k else np.arange(count)
        asked = order[inner][:_ASKED]
        kept = _AT_END
        while kept and not _is_beside(measured, seen, int(order[kept - 1]), asked):
            kept -= 1
        ends.append(0 if stop in GIVEN_ENDS else kept)
    return slice(ends[0], count - ends[1])


def _is_straight(seen: Corners, part: slice) -> bool:
    line = simplest_curve(seen.point[part], largest_sigma(seen.covariance[part]), closed=False)
    return isinstance(line, Line)


def _is_beside(measured: Measured, seen: Corners, which: int, asked: np.ndarray) -> bool:
    """Whether an edge point is not where the line through others leads."""
    away = seen.point[asked] - seen.point[which]
    along = away @ measured.frames.tangent[which]
    across = away @ across_axes(measured.frames.normals[which]).T
    root = 1.0 / largest_sigma(seen.covariance[asked])
    power = np.column_stack([root, along / np.abs(along).max() * root])
    weight = np.linalg.pinv(power)[0] * root
    covariance = seen.covariance[which] + np.einsum("k,kab->ab", weight**2, seen.covariance[asked])
    said = weight @ across
    return bool(said @ np.linalg.solve(covariance, said) > _OFF)
