# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a side ends and the rounding begins, decided by all lines of an edge together.

A single line cannot tell: within the scanning tolerance its curve follows part of the rounding and
meets the other one off the edge. Over many lines the scatter about the curves shows it. Once the
points nearer to the edge than the rounding's beginning are left out, the scatter stays at the
noise however many more are left out.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

__all__ = ["rounding_begins"]

_STEPS = 24  # places to try, on the inner part of a side
_INNER = 0.6  # of a side's length, that a rounding may take away
_ENOUGH = 0.7  # of the lines must have points left for an arc
_SPARE = 2  # points of a line beyond those an arc needs
_LIKELY = 2.0  # standard deviations by which a scatter may be above the smallest one
_NOTHING = 0.01  # of the tolerance
_LARGER = 0.03  # and what else may be, as share of it


def rounding_begins(sides: Sequence[np.ndarray], tolerance: float) -> float:
    """Distance from the edge from which on the points of a side belong to one smooth surface.

    Parameters
    ----------
    sides : for each line (n, 2) mm, its points' distance from the edge along the side, and their
        height over it
    tolerance : scanning tolerance, mm; a scatter far below it, as without noise, shows how little
        an arc differs from the side, not a rounding

    Returns
    -------
    mm; 0 when the scatter shows no rounding
    """
    widest = max(len(points) for points in sides)
    away, height = (np.zeros((len(sides), widest)) for _ in range(2))
    there = np.zeros((len(sides), widest), dtype=bool)
    for j, points in enumerate(sides):
        away[j, : len(points)], height[j, : len(points)] = points.T
        there[j, : len(points)] = True
    reach = float(np.median(np.where(there, away, 0.0).max(axis=1)))
    tried = np.linspace(0.0, _INNER * reach, _STEPS)
    scatter, freedom, supported = np.array(
        [_scatter(away / reach, height / reach, there & (away >= begin)) for begin in tried]
    ).T
    candidates = np.flatnonzero(supported >= _ENOUGH)
    if not len(candidates):
        return 0.0
    best = candidates[scatter[candidates].argmin()]
    smallest = max(float(scatter[best]), (_NOTHING * tolerance / reach) ** 2)
    # The smallest one is known worst: few points are left, and it is the luckiest of all.
    likely = 1.0 + _LARGER + _LIKELY * np.sqrt(2.0 / freedom[best])
    return float(tried[next(i for i in candidates if scatter[i] <= likely * smallest)])


def _scatter(s: np.ndarray, n: np.ndarray, used: np.ndarray) -> tuple[float, float, float]:
    """Variance about one arc for each line, its degrees of freedom, and the lines' share.

    The arc is that of the patches: linear in its coefficients, and without the error of a
    quadratic, which shrinks with every point that is left out and looks like a rounding.
    """
    enough = used.sum(axis=1) >= 3 + _SPARE
    if not enough.any():
        return 0.0, 1.0, 0.0
    s, n, used = s[enough], n[enough], used[enough]
    terms = np.stack([np.ones_like(s), s, 0.5 * (s**2 + n**2)], axis=-1)
    terms = np.where(used[..., None], terms, 0.0)
    matrix = np.einsum("mni,mnj->mij", terms, terms)
    right = np.einsum("mni,mn->mi", terms, n)
    coefficients = np.linalg.solve(matrix + 1e-12 * np.eye(3), right[..., None])[..., 0]
    off = np.where(used, n - np.einsum("mni,mi->mn", terms, coefficients), 0.0)
    freedom = float(used.sum() - 3 * len(s))
    return float(np.einsum("mn,mn->", off, off)) / freedom, freedom, float(enough.mean())
