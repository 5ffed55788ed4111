# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surface between four edges: Coons' bilinearly blended patch.

Coons 1967, Surfaces for computer-aided design of space forms; Piegl and Tiller, The NURBS Book
(1997), section 10.6. Edges that run the wrong way are turned; ends that do not quite meet are moved
to the middle between them.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import permutations, product

import numpy as np
from numpy.typing import NDArray

from ..geometry import BSplineCurve, BSplineSurface
from ..geometry.knot_vectors import merged_knots
from ..geometry.surface_approximation import approximated_surface
from .sweep_joints import refuse_crossing

__all__ = ["coons_surface"]

Array = NDArray[np.float64]

_DEGREE = 3
_NO_LENGTH = 1e-9
_ENDS = np.array([0.0, 1.0])


def coons_surface(
    edges: Sequence[BSplineCurve], largest_gap: float = 1.0, tolerance: float = 1e-3
) -> tuple[BSplineSurface, str]:
    """The Coons surface between four edges, and what was done to bring them together.

    Parameters
    ----------
    edges : four open curves round a patch, in any order and direction
    largest_gap : float
        How far apart, mm, the ends of neighbouring edges may be.
    tolerance : float
        mm; the surface is exact where the edges are polynomial splines.

    Returns
    -------
    The surface, u in [0, 1] along the first edge, v in [0, 1] away from it, and a message.

    Raises
    ------
    ValueError: not four edges, one that is closed, ends that do not meet, with the gaps, or
        opposite edges that cross.
    """
    if len(edges) != 4:
        raise ValueError(
            f"A surface between edges takes four of them, not {len(edges)}; split or join edges, "
            "or use rails and profiles."
        )
    curves = []
    for number, edge in enumerate(edges, 1):
        curve = edge.opened().over_range(0.0, 1.0)
        ends = curve.evaluate(_ENDS)
        if np.linalg.norm(ends[1] - ends[0]) <= _NO_LENGTH * curve.length():
            raise ValueError(f"Edge {number} is closed; split it where the patch has corners.")
        curves.append(curve)
    loop, gaps, said = _loop(curves)
    if gaps.max() > largest_gap:
        listed = ", ".join(f"{gap:.3g}" for gap in gaps)
        raise ValueError(
            f"The four edges do not meet: the gaps round the patch are {listed} mm. Let the edges "
            f"meet, or allow more than {largest_gap:g} mm by largest_gap."
        )
    first, right, last, left = loop
    sides = [first, last.reversed(), left.reversed(), right]
    for pair in (sides[:2], sides[2:]):
        refuse_crossing(pair, "opposite edges")
    corners = np.stack(
        [
            [_middle(sides[0], 0, sides[2], 0), _middle(sides[2], 1, sides[1], 0)],
            [_middle(sides[0], 1, sides[3], 0), _middle(sides[3], 1, sides[1], 1)],
        ]
    )  # [u, v]
    moves = [
        corners[:, 0] - sides[0].evaluate(_ENDS),
        corners[:, 1] - sides[1].evaluate(_ENDS),
        corners[0] - sides[2].evaluate(_ENDS),
        corners[1] - sides[3].evaluate(_ENDS),
    ]

    def side(number: int, t: Array) -> Array:
        share = t[..., None]
        start, end = moves[number]
        return sides[number].evaluate(t) + (1.0 - share) * start + share * end

    def shape(u: Array, v: Array) -> Array:
        s, t = u[..., None], v[..., None]
        between = (1.0 - t) * side(0, u) + t * side(1, u) + (1.0 - s) * side(2, v) + s * side(3, v)
        return between - (
            (1.0 - s) * ((1.0 - t) * corners[0, 0] + t * corners[0, 1])
            + s * ((1.0 - t) * corners[1, 0] + t * corners[1, 1])
        )

    knots, degrees = [], []
    for pair in (sides[:2], sides[2:]):
        degree = max(_DEGREE, *(curve.degree for curve in pair))
        knots.append(merged_knots([curve.elevated(degree).knots for curve in pair], degree))
        degrees.append(degree)
    surface = approximated_surface(shape, (knots[0], knots[1]), (degrees[0], degrees[1]), tolerance)
    return surface, said


def _loop(curves: list[BSplineCurve]) -> tuple[list[BSplineCurve], Array, str]:
    """The curves in order round the patch, each from the end of the one before; the gaps (4,)."""
    ends = np.stack([curve.evaluate(_ENDS) for curve in curves])
    best: tuple[float, tuple[int, ...], tuple[int, ...], Array] | None = None
    for order in permutations((1, 2, 3)):
        for ways in product((0, 1), repeat=3):
            rows, flips = (0, *order), (0, *ways)
            gaps = np.array(
                [
                    np.linalg.norm(ends[rows[k], 1 - flips[k]] - ends[rows[k - 3], flips[k - 3]])
                    for k in range(4)
                ]
            )
            if best is None or gaps.sum() < best[0] * (1.0 - 1e-12):
                best = float(gaps.sum()), rows, flips, gaps
    assert best is not None
    _, rows, flips, gaps = best
    loop = [
        curves[k].reversed() if flip else curves[k] for k, flip in zip(rows, flips, strict=True)
    ]
    turned = sorted(k for k, flip in zip(rows, flips, strict=True) if flip)
    said = [f"Edge {k + 1} was turned round." for k in turned]
    if rows != (0, 1, 2, 3):
        listed = ", ".join(str(k + 1) for k in rows)
        said.insert(0, f"The edges were taken in the order {listed}.")
    return loop, gaps, " ".join(said)


def _middle(one: BSplineCurve, at: int, other: BSplineCurve, other_at: int) -> Array:
    return np.asarray((one.evaluate(float(at)) + other.evaluate(float(other_at))) / 2)
