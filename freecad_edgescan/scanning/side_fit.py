# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fits of the two sides of an edge: which stretch of a side is one smooth surface, and its shape.

A side is the implicit section

    height = c0 + c1·away + c2·(away² + height²)/2 + c3·along,

a circle (a line when c2 = 0) whose distance residuals are linear in the coefficients, with a
drift along the edge. Points are summed into blocks by their distance from the edge; every stretch
of consecutive blocks is then a difference of cumulated normal equations, and all stretches of all
sections are solved in one batch. Lengths are divided by the reach, so that everything is of
order one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

from .normal_equations import (
    BLOCK_EDGES,
    BLOCKS,
    PRIOR_SIGMA,
    solve,
    square_forms,
    sums_of_terms,
    without_bias,
)
from .section import SectionPoints

# All stretches of two and more blocks: their first and last block (exclusive), which blocks are in
# them, (BLOCKS, stretches), and the number of the stretch between two blocks.
_FIRST, _LAST = np.triu_indices(BLOCKS + 1, k=2)
_WITHIN = (np.arange(BLOCKS)[:, None] >= _FIRST) & (np.arange(BLOCKS)[:, None] < _LAST)
_NUMBER = np.full((BLOCKS + 1, BLOCKS + 1), -1)
_NUMBER[_FIRST, _LAST] = np.arange(len(_FIRST))

# How much better a stretch that covers little of the side must know it (a power of its share).
_COVERAGE = 4

# Reach over radius of curvature beyond which a stretch is a rounding, not a side.
MOST_CURVED = 1.3

# Blocks that are left out, one after the other, to see whether they move the edge, and by how many
# standard deviations they may.
LATER = (1, 2)
# Where there are many points: powers of a stretch's misfit, and of how far its first blocks move
# the edge, by which it is taken less gladly, and how many times less gladly if there is any.
_UNEVEN = (12, 6)
_UNEVEN_AT_ALL = 30.0
_MOST_MOVED = 3.0
_WORST = 3.3  # standard deviations that the mean of a block may be off
_BY_CHANCE = 2.5  # variances by which they may be taken to move it by chance


@dataclass(frozen=True)
class SideFits:
    """Fitted sides of m sections; all arrays (m, 2, …).

    Attributes
    ----------
    reach : the length everything is divided by, mm
    coefficients : (m, 2, 4) c0 … c3, in units of the reach
    inverse : (m, 2, 4, 4) inverse of the normal matrix; times variance it is the covariance
    variance : (m, 2) variance of the points about the fit, in units of reach²
    count : (m, 2) number of points in the fit
    stretch : (m, 2, 2) first and last block (exclusive) of the stretch that was fitted
    accepted : (m, 2) whether the stretch is one smooth surface within the noise
    astray : (m, 2) variance by which the stretch's first blocks move the edge beyond what noise
        does, in units of reach²; a rounding may have begun there
    expectation : (m, 2) what the curvature that was expected weighs in the normal equations;
        neighbours share it, and its error
    """

    reach: float
    coefficients: np.ndarray
    inverse: np.ndarray
    variance: np.ndarray
    count: np.ndarray
    stretch: np.ndarray
    accepted: np.ndarray
    astray: np.ndarray
    expectation: np.ndarray

    def __getitem__(self, part: slice) -> SideFits:
        """Return the fits of some sections; a negative step puts them into the other order."""
        return self._with({name: array[part] for name, array in self._arrays().items()})

    @staticmethod
    def join(parts: Sequence[SideFits]) -> SideFits:
        """Put the fits of sections behind each other."""
        names = parts[0]._arrays()
        return parts[0]._with(
            {name: np.concatenate([getattr(part, name) for part in parts]) for name in names}
        )

    def or_where(self, chosen: np.ndarray, other: SideFits) -> SideFits:
        """These fits, and another's where chosen (m, 2)."""
        return self._with(
            {
                name: np.where(chosen.reshape(chosen.shape + (1,) * (new.ndim - 2)), new, old)
                for (name, old), new in zip(
                    self._arrays().items(), other._arrays().values(), strict=True
                )
            }
        )

    def replaced(self, rows: np.ndarray, others: SideFits) -> SideFits:
        """These fits, and those of other sections in some rows (k,)."""
        arrays = {name: array.copy() for name, array in self._arrays().items()}
        for name, new in others._arrays().items():
            arrays[name][rows] = new
        return self._with(arrays)

    def _arrays(self) -> dict[str, np.ndarray]:
        return {each.name: getattr(self, each.name) for each in fields(self)[1:]}

    def _with(self, arrays: dict[str, Any]) -> SideFits:
        return replace(self, **arrays)

    def backward(self) -> SideFits:
        """The same sections in the other order, walked the other way."""
        # The sides' drift along the edge turns round.
        turn = np.array([1.0, 1.0, 1.0, -1.0])
        fits = self[::-1]
        return replace(
            fits,
            coefficients=fits.coefficients * turn,
            inverse=fits.inverse * np.outer(turn, turn),
        )

    @property
    def begins(self) -> np.ndarray:
        """Distance from the edge where the stretch begins, (m, 2) mm."""
        return self.reach * BLOCK_EDGES[self.stretch[..., 0]]

    @property
    def ends(self) -> np.ndarray:
        """Distance from the edge where the stretch ends, (m, 2) mm."""
        return self.reach * BLOCK_EDGES[self.stretch[..., 1]]

    @property
    def seen(self) -> np.ndarray:
        """How much of each side most sections see, (2,) mm."""
        return np.asarray(np.median(self.ends - self.begins, axis=0))

    @property
    def inward_curl(self) -> np.ndarray:
        """Angle by which each side bends inwards, as a rounding does, where it is seen, (m, 2)."""
        return np.asarray(-self.coefficients[..., 2] * (self.ends - self.begins) / self.reach)

    def within(self, points: SectionPoints) -> np.ndarray:
        """Whether the points lie in the stretch of their own side, (n,) bool."""
        begins, ends = (points.of_their_sides(each) for each in (self.begins, self.ends))
        return np.asarray((points.away >= begins) & (points.away < ends))

    def position_covariance(self, terms: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Covariance (m, 2, 2) of the two sides' positions at terms (m, 2, 4), in reaches².

        And the part of it that comes from what neighbouring sections share: the expected
        curvature, and what their stretches' beginnings have in common.
        """
        leverage = np.einsum("mki,mkij,mkj->mk", terms, self.inverse, terms)
        # How far an error of the expected curvature moves the side.
        moved = np.einsum("mki,mki->mk", terms, self.inverse[..., 2])
        return tuple(
            (self.variance * part + self.astray)[..., None] * np.eye(2)
            for part in (leverage, moved**2 * self.expectation)
        )

    def residuals(self, points: SectionPoints) -> np.ndarray:
        """Height of the points above their own side's fit, (n,) mm."""
        c = points.of_their_sides(self.coefficients)
        away, height, along = (
            value / self.reach for value in (points.away, points.height, points.along)
        )
        fitted = c[:, 0] + c[:, 1] * away + 0.5 * c[:, 2] * (away**2 + height**2) + c[:, 3] * along
        return (height - fitted) * self.reach


def choose_stretches(
    moments: np.ndarray,
    reach: float,
    noise: float,
    curvature: np.ndarray,
    curvature_sigma: float = PRIOR_SIGMA[2],
    slack: float = 0.3,
    scatter: float = 1.25,
    doubtful: np.ndarray | None = None,
    together: bool = False,
    least_begin: np.ndarray | float = 0.0,
) -> SideFits:
    """Fit every stretch of blocks of every side, and keep the one that knows the edge best.

    Of the stretches that are one smooth surface within the noise (no block's mean and not the
    whole misfits), the one whose extrapolation to the edge has the smallest variance is taken;
    it neither runs into a rounding nor over the next edge, and it does not matter how narrow the
    side is.

    Parameters
    ----------
    moments : (m, 2, BLOCKS, 15) array from `block_moments`
    reach : mm
    noise : standard deviation of the points along the normal, mm
    curvature, curvature_sigma : expected curvature of each side (m, 2) and its sigma, times reach
    slack : systematic misfit of a block that is tolerated, in noise
    scatter : variance of a stretch's points that is tolerated, in noise squared
    doubtful : (m, 2, BLOCKS) blocks that lost many of their points as outliers: where a rounding
        begins, the points that are left only look like the side
    together : whether the points are those of many sections, which see far smaller departures
    least_begin : distance from the edge, mm, within which no stretch begins, one or (2,)
    """
    variance = (noise / reach) ** 2
    cumulated = np.zeros((moments.shape[-1], *moments.shape[:2], BLOCKS + 1))
    np.cumsum(np.moveaxis(moments, -1, 0), axis=-1, out=cumulated[..., 1:])
    summed = np.moveaxis(cumulated.take(_LAST, axis=-1) - cumulated.take(_FIRST, axis=-1), 0, -1)
    fits = solve(summed, variance, curvature[..., None], curvature_sigma)
    coefficients, inverse, misfit, count = fits
    degrees = np.maximum(count - 3.0, 1.0)
    if together:  # a few points scatter by more than what they are biased by
        known = np.minimum(misfit / degrees, variance)
        coefficients = without_bias(coefficients, inverse, summed, known)
    ratio = misfit / degrees / variance
    # Mean residual of every block under every stretch's fit, times the root of its points' number.
    number = moments[..., 0]
    filled = number > 0
    means = sums_of_terms(moments) / np.sqrt(np.maximum(number, 1e-9))[..., None]
    residual = means[..., 4:] - means[..., :4] @ np.swapaxes(coefficients, -1, -2)
    # A block pulls the fit towards itself; what is left of its misfit is that of a fit without it.
    free = np.maximum(1.0 - square_forms(inverse, means[..., :4]), 1e-3)
    allowed = variance * free * (1.0 + (slack**2 * number)[..., None] * free)
    populated = _WITHIN & filled[..., None]
    worst = np.max(np.where(populated, np.square(residual) / allowed, 0.0), axis=-2)
    populated = filled @ _WITHIN.astype(float)
    enough = (count >= 8) & (populated >= 2) & filled[..., _FIRST] & filled[..., _LAST - 1]
    # How far a stretch departs from one smooth surface, 1 where it may just be one.
    badness = np.maximum(
        ratio / (scatter * (1.0 + 3.0 * np.sqrt(2.0 / degrees))), worst / _WORST**2
    )
    # A rounding is a smooth stretch too; its curvature, and the points it leaves over, tell.
    bent = variance * inverse[..., 2, 2] + curvature_sigma**2
    side = np.square(coefficients[..., 2] - curvature[..., None]) <= 9.0 * bent
    side &= np.abs(coefficients[..., 2]) <= MOST_CURVED
    side &= BLOCK_EDGES[_FIRST] * reach >= np.broadcast_to(least_begin, (2,))[:, None]
    if doubtful is not None:
        side &= ~(doubtful @ _WITHIN)
    # Share of the length, not of the points: scans crowd points on roundings.
    length = np.diff(BLOCK_EDGES) * filled
    share = length @ _WITHIN
    share = share / np.maximum(length.sum(axis=-1), 1e-9)[..., None]
    extrapolated = variance * inverse[..., 0, 0] / np.maximum(share, 0.05) ** _COVERAGE
    badness, astray = np.maximum(badness, 1.0), np.zeros_like(badness)
    even = side & (badness <= 1.0)
    if together:
        # Many points see the smallest unevenness: a little of it is put up with where those
        # stretches that have none know far less.
        # Tolerated misfits of the blocks count as if their points were fewer.
        known = variance * (1.0 + slack**2 * count / np.maximum(populated, 1))
        moved, astray = _moved(coefficients[..., 0], inverse[..., 0, 0], known, enough)
        moved = np.maximum(moved / _MOST_MOVED**2, 1.0)
        score = extrapolated * badness ** _UNEVEN[0] * moved ** _UNEVEN[1]
        even &= moved <= 1.0
        score = np.where(even, score, np.where(side, _UNEVEN_AT_ALL, 1e6) * score)
    else:
        # A stretch that is not smooth is only taken when none is, and then the least bad one.
        score = np.where(even, extrapolated, 1e6 * extrapolated * badness**2)
    score = np.where(enough, score, np.inf)
    best = np.argmin(score, axis=-1)
    m, k = np.indices(best.shape)
    spread = np.maximum(misfit[m, k, best] / degrees[m, k, best], 0.0)
    return SideFits(
        reach,
        coefficients[m, k, best],
        inverse[m, k, best],
        spread,
        count[m, k, best],
        np.stack([_FIRST[best], _LAST[best]], axis=-1),
        (even & enough)[m, k, best],
        astray[m, k, best],
        np.full(best.shape, variance / curvature_sigma**2),
    )


def _moved(
    position: np.ndarray, leverage: np.ndarray, variance: np.ndarray, enough: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """How far a stretch's first blocks move the edge, (m, 2, stretches).

    Where a rounding has begun unnoticed within the scatter, the side turns towards it, and this
    moves the edge, over which the side is drawn out, many times farther. The variance of the
    difference of a fit and the fit to a part of its points is the difference of their variances
    (Hausman, Econometrica 46, 1978).

    Returns
    -------
    the square of the movement, in variances, and what of it is more than noise does
    """
    moved, astray = np.zeros((2, *enough.shape))
    for later in LATER:
        rest = _NUMBER[np.minimum(_FIRST + later, BLOCKS), _LAST]
        known = enough[..., rest] & (rest >= 0)
        gap, free = _apart(position, leverage, position[..., rest], leverage[..., rest])
        moved = np.maximum(moved, np.where(known, gap / (variance * free), 0.0))
        astray = np.maximum(astray, np.where(known, gap - _BY_CHANCE * variance * free, 0.0))
    return moved, astray


def _apart(
    position: np.ndarray, leverage: np.ndarray, rest: np.ndarray, rest_leverage: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Squared distance of the edge by a fit and by a part of its points, and its leverage."""
    free = np.maximum(rest_leverage - leverage, 1e-12 * rest_leverage)
    return np.square(rest - position), free


def moved_between(fits: SideFits, rest: SideFits) -> tuple[np.ndarray, np.ndarray]:
    """Squared distance (m, 2) of the edge by two fits, and the variance noise gives it, reaches².

    Parameters
    ----------
    rest : fits of a part of the same points: of the stretches without their first blocks, or
        without what neighbours have lent
    """
    gap, free = _apart(
        fits.coefficients[..., 0],
        fits.inverse[..., 0, 0],
        rest.coefficients[..., 0],
        rest.inverse[..., 0, 0],
    )
    known = rest.count >= 8
    return np.where(known, gap, 0.0), np.where(known, fits.variance * free, 0.0)


def fit_summed(
    summed: np.ndarray,
    reach: float,
    noise: np.ndarray,
    stretch: np.ndarray,
    curvature: np.ndarray,
    curvature_sigma: np.ndarray,
) -> SideFits:
    """Fit normal equations (m, 2, 15) that were summed over stretches; see choose_stretches."""
    variance = np.square(noise / reach)
    coefficients, inverse, misfit, count = solve(summed, variance, curvature, curvature_sigma)
    spread = misfit / np.maximum(count - 3.0, 1.0)
    coefficients = without_bias(coefficients, inverse, summed, np.minimum(spread, variance))
    return SideFits(
        reach,
        coefficients,
        inverse,
        spread,
        count,
        stretch,
        count >= 6,
        np.zeros_like(spread),
        variance / np.square(curvature_sigma),
    )
