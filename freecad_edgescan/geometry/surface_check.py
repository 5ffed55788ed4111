# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether poles, knots, degrees and weights make a B-spline surface."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["DIRECTIONS", "check_surface"]

Array = NDArray[np.float64]

DIRECTIONS = ("u", "v")


def check_surface(
    poles: Array, knots: tuple[Array, Array], degree: tuple[int, int], weights: Array | None
) -> None:
    """Refuse what does not belong together, with the numbers (see `BSplineSurface`)."""
    if poles.ndim != 3 or poles.shape[2] != 3:
        raise ValueError(
            f"Poles of a surface are a (nu, nv, 3) array, not one of shape {poles.shape}."
        )
    if not np.all(np.isfinite(poles)):
        raise ValueError("A pole of the surface is not a finite number; remove or mend it.")
    for axis in (0, 1):
        _check_direction(axis, poles.shape[axis], knots[axis], degree[axis])
    if weights is not None and not (
        weights.shape == poles.shape[:2] and np.all((weights > 0.0) & (weights < np.inf))
    ):
        nu, nv = poles.shape[:2]
        raise ValueError(f"Weights are {nu} × {nv} positive numbers, one for each pole.")


def _check_direction(axis: int, count: int, knots: Array, degree: int) -> None:
    name = DIRECTIONS[axis]
    if degree < 1:
        raise ValueError(f"The degree in {name} is {degree}; it must be 1 or more.")
    if count < degree + 1:
        raise ValueError(
            f"Degree {degree} in {name} needs at least {degree + 1} poles, not {count}."
        )
    if knots.shape != (count + degree + 1,):
        raise ValueError(
            f"{count} poles of degree {degree} in {name} need {count + degree + 1} knots, not "
            f"{knots.size}; repeat them by their multiplicity, or use "
            "BSplineSurface.from_distinct_knots."
        )
    if not (np.all(np.diff(knots) >= 0.0) and knots[0] < knots[-1]):
        raise ValueError(f"Knots in {name} must not decrease, and must span more than one value.")
    if knots[degree] != knots[0] or knots[-degree - 1] != knots[-1]:
        raise ValueError(
            f"The first and the last {degree + 1} knots in {name} must be equal; open a periodic "
            "surface before."
        )
    inner, counts = np.unique(knots[degree + 1 : -degree - 1], return_counts=True)
    if np.any(counts > degree):
        raise ValueError(
            f"The knot {inner[counts > degree][0]:g} in {name} counts {counts.max()} times; more "
            f"than {degree}, the degree, would tear the surface apart."
        )
