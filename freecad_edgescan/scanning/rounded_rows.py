# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points as measurements of both sides of an edge and of the rounding between them.

A rounding is the circle that rolls on both sides: its centre is where the two sides, moved inwards
by its radius, meet, and it touches them where it leaves them. With the direction d from the centre
to a point on it written in the normals at the touching points, d = wA nA + wB nB, the circle moves
outwards under the point by

    wA (height of side A at its touching point) + wB (that of side B) + (1 − wA − wB) (radius)

of what these three are changed by: the point is a linear measurement of them. Points with both
weights positive lie on the rounding and all others on their side, so that nobody has to say where
the rounding begins.

The rows of the points of a section are summed into one matrix over the terms (1, s, q, u, n) of
side A, those of side B, the radius and the residual (see `normal_equations` for the terms);
sections, and neighbours turned to where a section stands, are sums of such matrices.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .corner import Meeting, inverse_2x2
from .normal_equations import owed_to_noise
from .positive_definite import inverses
from .section import Frames, SectionPoints

__all__ = ["CURVATURES_AND_RADIUS", "Rounded", "Rows", "equations", "rows_of", "solved"]

_TERMS = 5
_SIZE = 2 * _TERMS + 2
_RADIUS, _RESIDUAL = 2 * _TERMS, 2 * _TERMS + 1
# Of the rows, what is unknown, and what was measured.
_UNKNOWN = np.array([0, 1, 2, 3, 5, 6, 7, 8, _RADIUS])
_MEASURED = np.array([4, 9, _RESIDUAL])
# Of the unknowns, those that neighbouring sections share.
CURVATURES_AND_RADIUS = np.array([2, 6, 8])
_ON_ARC = 6  # terms of a point on the rounding
# Farther out than so many times where the rounding touches, and so many reaches, no point is on it.
_BEYOND, _ASIDE = 1.2, 0.1


@dataclass(frozen=True)
class Rounded:
    """The sides and the rounding of m sections, lengths in reaches.

    Attributes
    ----------
    coefficients : (m, 2, 4) of the sides, see `SideFits`
    radius : (m,)
    """

    coefficients: np.ndarray
    radius: np.ndarray


@dataclass(frozen=True)
class Rows:
    """Points as measurements near a model, lengths in reaches.

    Attributes
    ----------
    residual : (n,) distance from the model, outwards
    on_arc : (n,) whether the point is on the rounding
    weights : (n, 2) of the two sides there
    touch : (m, 2, 5) terms of the touching points, but for their place along the edge
    coefficients : (m, 2, 4) of the sides
    """

    residual: np.ndarray
    on_arc: np.ndarray
    weights: np.ndarray
    touch: np.ndarray
    coefficients: np.ndarray

    @property
    def begins(self) -> np.ndarray:
        """Distance from the edge where the rounding touches, (m, 2)."""
        return np.asarray(self.touch[..., 1])

    def summed(
        self,
        points: SectionPoints,
        reach: float,
        weight: np.ndarray,
        variance: np.ndarray | float = 0.0,
    ) -> np.ndarray:
        """Matrices (m, 12, 12) of the points' rows.

        Parameters
        ----------
        points : the same points
        reach : mm
        weight : (n,) of each point
        variance : (m, 2) of their noise, whose bias is taken off (see `without_bias`); a point on
            the rounding has none
        """
        sections = len(self.touch)
        part = ~self.on_arc & (weight > 0.0)
        away, height, along = (x[part] / reach for x in (points.away, points.height, points.along))
        terms = (np.ones_like(away), away, 0.5 * (away**2 + height**2), along, height)
        bins = points.owner[part] * 2 + points.side[part]
        sides = _products(terms, bins, weight[part], 2 * sections).reshape(sections, 2, 5, 5)
        owed = owed_to_noise(self.coefficients, sides[..., 0, :])
        owed *= np.broadcast_to(variance, owed.shape[:2])[..., None]
        sides[..., :-1, -1] -= owed
        sides[..., -1, :-1] -= owed
        total = np.zeros((sections, _SIZE, _SIZE))
        for side in range(2):
            at = slice(_TERMS * side, _TERMS * (side + 1))
            total[:, at, at] = sides[:, side]
        part = self.on_arc & (weight > 0.0)
        along, (a, b) = points.along[part] / reach, self.weights[part].T
        of_arc = (a, a * along, b, b * along, 1.0 - a - b, self.residual[part])
        arc = _products(of_arc, points.owner[part], weight[part], sections)
        spread = self._spread()
        return total + spread @ arc @ np.swapaxes(spread, 1, 2)

    def _spread(self) -> np.ndarray:
        """From the terms of points on the rounding to those of the rows, (m, 12, 6)."""
        spread = np.zeros((len(self.touch), _SIZE, _ON_ARC))
        for side in range(2):
            spread[:, _TERMS * side : _TERMS * (side + 1), 2 * side] = self.touch[:, side]
            spread[:, _TERMS * side + 3, 2 * side + 1] = 1.0
            spread[:, _TERMS * side + 4, 2 * side + 1] = self.coefficients[:, side, 3]
        spread[:, _RADIUS, 4] = spread[:, _RESIDUAL, 5] = 1.0
        return spread


def _products(
    terms: Sequence[np.ndarray], bins: np.ndarray, weight: np.ndarray, count: int
) -> np.ndarray:
    """Sums (count, k, k) of the weighted products of k terms."""
    total = np.empty((count, len(terms), len(terms)))
    for i, j in zip(*np.triu_indices(len(terms)), strict=True):
        total[:, i, j] = total[:, j, i] = np.bincount(
            bins, weights=weight * terms[i] * terms[j], minlength=count
        )
    return total


def rows_of(frames: Frames, model: Rounded, points: SectionPoints, reach: float) -> Rows:
    """Take the points as measurements that are linear near a model."""
    c, radius = model.coefficients, model.radius
    centre = Meeting.of(frames, c, -radius)
    place = centre.shift[:, None] + radius[:, None, None] * centre.gradient
    height = np.einsum("mka,mka->mk", centre.along_normal, place)
    touch = np.concatenate([centre.terms(place), height[..., None]], axis=-1)
    away, height, along = (x / reach for x in (points.away, points.height, points.along))
    mine = points.of_their_sides(c)
    flat = mine[:, 0] + mine[:, 1] * away + 0.5 * mine[:, 2] * (away**2 + height**2)
    residual = height - flat - mine[:, 3] * along
    on_arc, weights = np.zeros(len(away), dtype=bool), np.zeros((len(away), 2))
    # Points clearly beyond where the rounding touches need not be asked.
    begins = touch[..., 1]
    near = np.flatnonzero(away < points.of_their_sides(_BEYOND * np.abs(begins)) + _ASIDE)
    owner, beside = points.owner[near], points[near]
    to_side, to_normal = (
        beside.of_their_sides(axes) for axes in (centre.along_side, centre.along_normal)
    )
    arm = away[near, None] * to_side + height[near, None] * to_normal
    arm -= centre.shift.take(owner, axis=0)
    distance = np.maximum(np.hypot(arm[:, 0], arm[:, 1]), 1e-12)
    inverse = inverse_2x2(centre.gradient).take(owner, axis=0)
    share = (arm[:, :1] * inverse[:, 0] + arm[:, 1:] * inverse[:, 1]) / distance[:, None]
    rounded = (share > 0.0).all(axis=1) & centre.found.take(owner)
    arc, owner, share = near[rounded], owner[rounded], share[rounded]
    on_arc[arc], weights[arc] = True, share
    drift = np.sum(share * c[..., 3].take(owner, axis=0), axis=1) * along[arc]
    residual[arc] = distance[rounded] - radius.take(owner) - drift
    return Rows(residual, on_arc, weights, touch, c)


def equations(summed: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Normal matrix (m, 9, 9) and right side (m, 9) of the coefficients and the radius' change."""
    rows = summed[:, _UNKNOWN]
    return rows[:, :, _UNKNOWN], rows[:, :, _MEASURED].sum(axis=-1)


def solved(
    summed: np.ndarray, mean: np.ndarray, precision: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Coefficients and change of the radius (m, 9), and their covariance (m, 9, 9).

    Parameters
    ----------
    summed : (m, 12, 12), weighted with the inverse variance of the points
    mean, precision : (m, 9) what is expected of them, and the inverse (m, 9, 9) of its covariance
    """
    normal, right = equations(summed)
    normal = normal + precision
    # Of unit diagonal: what is known to a millionth stands beside what is hardly known.
    scale = 1.0 / np.sqrt(np.einsum("mii->mi", normal))
    scale = scale[:, :, None] * scale[:, None]
    covariance = scale * inverses(scale * normal)
    pulled = right + np.einsum("mij,mj->mi", precision, mean)
    return np.einsum("mij,mj->mi", covariance, pulled), covariance
