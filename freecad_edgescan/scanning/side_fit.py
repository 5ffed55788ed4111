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

from dataclasses import dataclass, fields

import numpy as np

from .section import SectionPoints

BLOCKS = 14
# Blocks are narrow near the edge, where a rounding begins somewhere, and wide away from it.
BLOCK_EDGES = (np.arange(BLOCKS + 1) / BLOCKS) ** 1.5
_TERMS = 4
_PAIRS = np.triu_indices(_TERMS + 1)
_TERM_PAIRS = np.triu_indices(_TERMS)
_DIAGONAL = np.arange(_TERMS)
_TIMES = np.where(_TERM_PAIRS[0] == _TERM_PAIRS[1], 1.0, 2.0)  # that a pair is in a square form
_SQUARE = np.zeros((_TERMS + 1, _TERMS + 1), dtype=np.int64)
_SQUARE[_PAIRS] = _SQUARE.T[_PAIRS] = np.arange(len(_PAIRS[0]))

# All stretches of two and more blocks: their first and last block (exclusive), the blocks in them,
# and the number of the stretch between two blocks.
_FIRST, _LAST = np.triu_indices(BLOCKS + 1, k=2)
_WITHIN = (np.arange(BLOCKS) >= _FIRST[:, None]) & (np.arange(BLOCKS) < _LAST[:, None])
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

# How many times the expected number of points a block may hold at full weight.
_CROWD = 2.0

# Standard deviations of the coefficients before anything is measured, in units of the reach:
# they keep thin support from giving wild extrapolations.
PRIOR_SIGMA = np.array([1.0, 0.7, 0.3, 0.3])


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

    def _with(self, arrays: dict[str, np.ndarray]) -> SideFits:
        return SideFits(self.reach, **arrays)

    @property
    def begins(self) -> np.ndarray:
        """Distance from the edge where the stretch begins, (m, 2) mm."""
        return self.reach * BLOCK_EDGES[self.stretch[..., 0]]

    @property
    def ends(self) -> np.ndarray:
        """Distance from the edge where the stretch ends, (m, 2) mm."""
        return self.reach * BLOCK_EDGES[self.stretch[..., 1]]

    def residuals(self, points: SectionPoints) -> np.ndarray:
        """Height of the points above their own side's fit, (n,) mm."""
        c = self.coefficients[points.owner, points.side]
        away, height, along = (
            value / self.reach for value in (points.away, points.height, points.along)
        )
        fitted = c[:, 0] + c[:, 1] * away + 0.5 * c[:, 2] * (away**2 + height**2) + c[:, 3] * along
        return (height - fitted) * self.reach


def block_moments(points: SectionPoints, sections: int, reach: float) -> np.ndarray:
    """Normal equations of each block of each side, (m, 2, BLOCKS, 15).

    The last axis holds the upper triangle of the products of (1, s, (s²+n²)/2, u, n).
    """
    away, height, along = (value / reach for value in (points.away, points.height, points.along))
    block = block_of(away)
    inside = (block >= 0) & (block < BLOCKS)
    away, height, along = away[inside], height[inside], along[inside]
    terms = (np.ones_like(away), away, 0.5 * (away**2 + height**2), along, height)
    bins = (points.owner[inside] * 2 + points.side[inside]) * BLOCKS + block[inside]
    total = sections * 2 * BLOCKS
    moments = [
        np.bincount(bins, weights=terms[i] * terms[j], minlength=total)
        for i, j in zip(*_PAIRS, strict=True)
    ]
    return np.stack(moments, axis=-1).reshape(sections, 2, BLOCKS, -1)


def without_crowds(
    moments: np.ndarray, reach: float, half_width: float | np.ndarray, cloud_pitch: float
) -> np.ndarray:
    """Normal equations with crowded blocks weighted down to the pitch of the surfaces.

    Scans crowd points where a surface bends, as on a rounding; without this those few square
    millimetres would outvote the sides.
    """
    width = 2.0 * np.asarray(half_width)[..., None, None]
    expected = np.diff(BLOCK_EDGES) * reach * width / cloud_pitch**2
    count = np.maximum(moments[..., 0], 1e-9)
    return moments * np.minimum(1.0, _CROWD * np.maximum(expected, 1.0) / count)[..., None]


def block_of(away: np.ndarray) -> np.ndarray:
    """Block of distances from the edge in units of the reach; −1 or BLOCKS when outside."""
    return np.searchsorted(BLOCK_EDGES, away, side="right") - 1


def block_counts(points: SectionPoints, sections: int, reach: float) -> np.ndarray:
    """Number of points in each block of each side, (m, 2, BLOCKS)."""
    block = block_of(points.away / reach)
    inside = (block >= 0) & (block < BLOCKS)
    bins = ((points.owner * 2 + points.side) * BLOCKS + block)[inside]
    return np.bincount(bins, minlength=sections * 2 * BLOCKS).reshape(sections, 2, BLOCKS)


def choose_stretches(
    moments: np.ndarray,
    reach: float,
    noise: float | np.ndarray,
    curvature: np.ndarray,
    curvature_sigma: float | np.ndarray = PRIOR_SIGMA[2],
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
    noise : standard deviation of the points along the normal, mm, one or (m, 2)
    curvature, curvature_sigma : expected curvature of each side (m, 2) and its sigma, times reach
    slack : systematic misfit of a block that is tolerated, in noise
    scatter : variance of a stretch's points that is tolerated, in noise squared
    doubtful : (m, 2, BLOCKS) blocks that lost many of their points as outliers: where a rounding
        begins, the points that are left only look like the side
    together : whether the points are those of many sections, which see far smaller departures
    least_begin : distance from the edge, mm, within which no stretch begins, one or (2,)
    """
    sections = len(moments)
    variance = np.broadcast_to(np.square(np.asarray(noise, dtype=float) / reach), (sections, 2))
    cumulated = np.zeros((sections, 2, BLOCKS + 1, moments.shape[-1]))
    np.cumsum(moments, axis=2, out=cumulated[:, :, 1:])
    summed = cumulated[:, :, _LAST] - cumulated[:, :, _FIRST]
    fits = _solve(summed, variance[..., None], curvature[..., None], curvature_sigma)
    coefficients, inverse, misfit, count = fits
    degrees = np.maximum(count - 3.0, 1.0)
    ratio = misfit / degrees / variance[..., None]
    # Mean residual of every block under every stretch's fit.
    blocks = moments[..., _SQUARE[0]]
    number = np.maximum(blocks[..., 0], 1e-9)
    mean = (
        blocks[:, :, None, :, 4] - coefficients @ np.swapaxes(blocks[..., :4], -1, -2)
    ) / number[:, :, None]
    filled = blocks[..., 0] > 0
    # A block pulls the fit towards itself; what is left of its misfit is that of a fit without it.
    centre = blocks[..., :4] / number[..., None]
    products = centre[..., _TERM_PAIRS[0]] * centre[..., _TERM_PAIRS[1]] * _TIMES
    leverage = inverse[..., _TERM_PAIRS[0], _TERM_PAIRS[1]] @ np.swapaxes(products, -1, -2)
    free = np.maximum(1.0 / number[:, :, None] - leverage, 1e-3 / number[:, :, None])
    tolerated = slack * free * number[:, :, None]
    allowed = variance[..., None, None] * (free + tolerated**2)
    populated = _WITHIN & filled[:, :, None]
    worst = np.max(np.where(populated, np.square(mean) / allowed, 0.0), axis=-1)
    populated = np.count_nonzero(populated, axis=-1)
    enough = (count >= 8) & (populated >= 2) & filled[..., _FIRST] & filled[..., _LAST - 1]
    # How far a stretch departs from one smooth surface, 1 where it may just be one.
    badness = np.maximum(
        ratio / (scatter * (1.0 + 3.0 * np.sqrt(2.0 / degrees))), worst / _WORST**2
    )
    # A rounding is a smooth stretch too; its curvature, and the points it leaves over, tell.
    bent = variance[..., None] * inverse[..., 2, 2] + np.square(curvature_sigma)
    side = np.square(coefficients[..., 2] - curvature[..., None]) <= 9.0 * bent
    side &= np.abs(coefficients[..., 2]) <= MOST_CURVED
    side &= BLOCK_EDGES[_FIRST] * reach >= np.broadcast_to(least_begin, (2,))[:, None]
    if doubtful is not None:
        side &= ~np.any(_WITHIN & doubtful[:, :, None], axis=-1)
    # Share of the length, not of the points: scans crowd points on roundings.
    length = np.diff(BLOCK_EDGES) * filled
    share = length @ _WITHIN.T
    share = share / np.maximum(length.sum(axis=-1), 1e-9)[..., None]
    extrapolated = variance[..., None] * inverse[..., 0, 0] / np.maximum(share, 0.05) ** _COVERAGE
    badness, astray = np.maximum(badness, 1.0), np.zeros_like(badness)
    even = side & (badness <= 1.0)
    if together:
        # Many points see the smallest unevenness: a little of it is put up with where those
        # stretches that have none know far less.
        # Tolerated misfits of the blocks count as if their points were fewer.
        known = variance[..., None] * (1.0 + slack**2 * count / np.maximum(populated, 1))
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
        variance / np.square(np.broadcast_to(curvature_sigma, variance.shape)),
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


def moved_by_first_blocks(fits: SideFits, rest: SideFits) -> tuple[np.ndarray, np.ndarray]:
    """Squared distance (m, 2) of the edge by two fits, and the variance noise gives it, reaches².

    Parameters
    ----------
    rest : fits of the same stretches without their first block, or blocks
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
    coefficients, inverse, misfit, count = _solve(summed, variance, curvature, curvature_sigma)
    spread = misfit / np.maximum(count - 3.0, 1.0)
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


def sum_stretches(moments: np.ndarray, stretch: np.ndarray) -> np.ndarray:
    """Normal equations of given stretches of blocks, (m, 2, 15)."""
    block = np.arange(BLOCKS)
    within = (block >= stretch[..., :1]) & (block < stretch[..., 1:])
    return np.einsum("mkb,mkbq->mkq", within.astype(float), moments)


def moved_moments(summed: np.ndarray, moves: np.ndarray) -> np.ndarray:
    """Normal equations (…, 15) in other terms: moves (…, 5, 5) times (1, s, q, u, n)."""
    moved = moves @ summed[..., _SQUARE] @ np.swapaxes(moves, -1, -2)
    return np.asarray(moved[..., _PAIRS[0], _PAIRS[1]])


def _solve(
    summed: np.ndarray,
    variance: np.ndarray,
    curvature: np.ndarray,
    curvature_sigma: float | np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Coefficients, inverse normal matrix, sum of squares and count of (…, 15) moments."""
    full = summed[..., _SQUARE]
    normal, right = full[..., :_TERMS, :_TERMS], full[..., :_TERMS, _TERMS]
    weight = np.empty((*normal.shape[:-2], _TERMS))
    weight[:] = variance[..., None] / PRIOR_SIGMA**2
    weight[..., 2] = variance / np.square(curvature_sigma)
    weight = np.maximum(weight, 1e-12)
    normal[..., _DIAGONAL, _DIAGONAL] += weight
    inverse = _inverse(normal)
    pulled = right.copy()
    pulled[..., 2] += weight[..., 2] * curvature
    coefficients = (inverse @ pulled[..., None])[..., 0]
    # Of the sum of squares, what the expectation has taken is left to the points.
    pull = -weight * coefficients
    pull[..., 2] += weight[..., 2] * curvature
    misfit = full[..., _TERMS, _TERMS] - np.sum(coefficients * (right - pull), axis=-1)
    return coefficients, inverse, np.maximum(misfit, 0.0), summed[..., 0]


def _inverse(normal: np.ndarray) -> np.ndarray:
    """Inverse of symmetric positive definite matrices (…, 4, 4), by blocks of two rows.

    For so many so small ones LAPACK's time goes into being called.
    """
    a, b, c, d = (normal[..., 0, k] for k in range(4))
    e, f, g = (normal[..., 1, k] for k in range(1, 4))
    h, i, j = normal[..., 2, 2], normal[..., 2, 3], normal[..., 3, 3]
    size = a * e - b * b
    p, q, r = e / size, -b / size, a / size
    # What the last two terms are in terms of the first two, and what of them is their own.
    w, x, y, z = p * c + q * f, p * d + q * g, q * c + r * f, q * d + r * g
    h, i, j = h - c * w - f * y, i - c * x - f * z, j - d * x - g * z
    size = h * j - i * i
    h, i, j = j / size, -i / size, h / size
    wh, xh, yh, zh = w * h + x * i, w * i + x * j, y * h + z * i, y * i + z * j
    inverse = np.empty(normal.shape)
    inverse[..., 0, 0] = p + wh * w + xh * x
    inverse[..., 0, 1] = inverse[..., 1, 0] = q + wh * y + xh * z
    inverse[..., 1, 1] = r + yh * y + zh * z
    inverse[..., 0, 2] = inverse[..., 2, 0] = -wh
    inverse[..., 0, 3] = inverse[..., 3, 0] = -xh
    inverse[..., 1, 2] = inverse[..., 2, 1] = -yh
    inverse[..., 1, 3] = inverse[..., 3, 1] = -zh
    inverse[..., 2, 2], inverse[..., 3, 3] = h, j
    inverse[..., 2, 3] = inverse[..., 3, 2] = i
    return inverse
