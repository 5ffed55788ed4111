# SPDX-License-Identifier: LGPL-2.1-or-later
"""Normal equations of the two sides of an edge, block by block.

The terms are those of `side_fit`: (1, s, (s² + n²)/2, u) and n, in units of the reach. Points are
summed into blocks by their distance from the edge; sums of blocks, of sections and of neighbours
are sums of these equations, also in the terms of another section.
"""

from __future__ import annotations

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

# How many times the expected number of points a block may hold at full weight.
_CROWD = 2.0

# Standard deviations of the coefficients before anything is measured, in units of the reach:
# they keep thin support from giving wild extrapolations.
PRIOR_SIGMA = np.array([1.0, 0.7, 0.3, 0.3])


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
    share = _share_of_crowds(moments[..., 0], reach, half_width, cloud_pitch)
    return np.asarray(moments * share[..., None])


def crowd_weights(
    points: SectionPoints, sections: int, reach: float, half_width: float, cloud_pitch: float
) -> np.ndarray:
    """The weight (n,) by which the same is done to the points themselves."""
    share = _share_of_crowds(block_counts(points, sections, reach), reach, half_width, cloud_pitch)
    block = np.clip(block_of(points.away / reach), 0, BLOCKS - 1)
    return np.asarray(share[points.owner, points.side, block])


def _share_of_crowds(
    count: np.ndarray, reach: float, half_width: float | np.ndarray, cloud_pitch: float
) -> np.ndarray:
    """Weight (m, 2, BLOCKS) of blocks that hold so many points."""
    width = 2.0 * np.asarray(half_width)[..., None, None]
    expected = np.diff(BLOCK_EDGES) * reach * width / cloud_pitch**2
    return np.minimum(1.0, _CROWD * np.maximum(expected, 1.0) / np.maximum(count, 1e-9))


def block_of(away: np.ndarray) -> np.ndarray:
    """Block of distances from the edge in units of the reach; −1 or BLOCKS when outside."""
    return np.searchsorted(BLOCK_EDGES, away, side="right") - 1


def block_counts(points: SectionPoints, sections: int, reach: float) -> np.ndarray:
    """Number of points in each block of each side, (m, 2, BLOCKS)."""
    block = block_of(points.away / reach)
    inside = (block >= 0) & (block < BLOCKS)
    bins = ((points.owner * 2 + points.side) * BLOCKS + block)[inside]
    return np.bincount(bins, minlength=sections * 2 * BLOCKS).reshape(sections, 2, BLOCKS)


def sums_of_terms(moments: np.ndarray) -> np.ndarray:
    """Sums (…, 5) of the points' terms themselves, the first one their number."""
    return np.asarray(moments[..., _SQUARE[0]])


def square_forms(matrices: np.ndarray, vectors: np.ndarray) -> np.ndarray:
    """Values vᵀ M v (…, b, k) of symmetric matrices (…, k, 4, 4) and vectors (…, b, 4)."""
    products = vectors[..., _TERM_PAIRS[0]] * vectors[..., _TERM_PAIRS[1]] * _TIMES
    return np.asarray(products @ np.swapaxes(matrices[..., _TERM_PAIRS[0], _TERM_PAIRS[1]], -1, -2))


def sum_stretches(moments: np.ndarray, stretch: np.ndarray) -> np.ndarray:
    """Normal equations of given stretches of blocks, (m, 2, 15)."""
    block = np.arange(BLOCKS)
    within = (block >= stretch[..., :1]) & (block < stretch[..., 1:])
    return np.einsum("mkb,mkbq->mkq", within.astype(float), moments)


def moved_moments(summed: np.ndarray, moves: np.ndarray) -> np.ndarray:
    """Normal equations (…, b, 15) in other terms: moves (…, 5, 5) times (1, s, q, u, n)."""
    # The first term, the block, the second term: one product for all blocks moves a term.
    full = np.swapaxes(summed.take(_SQUARE, axis=-1), -3, -2)
    moved = moves @ full.reshape(*moves.shape[:-1], -1)
    moved = moved.reshape(*moves.shape[:-2], -1, _TERMS + 1) @ np.swapaxes(moves, -1, -2)
    return np.swapaxes(moved.reshape(full.shape), -3, -2)[..., _PAIRS[0], _PAIRS[1]]


def solve(
    summed: np.ndarray,
    variance: float | np.ndarray,
    curvature: np.ndarray,
    curvature_sigma: float | np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Coefficients, inverse normal matrix, sum of squares and count of (…, 15) moments.

    Parameters
    ----------
    summed : (…, 15) normal equations
    variance : of the points, in units of reach², one or (…)
    curvature, curvature_sigma : expected curvature and its sigma, times reach, (…) or one
    """
    # Terms first, so that what is done with one of them is done with neighbours in memory.
    full = np.moveaxis(summed, -1, 0)[_SQUARE]
    normal, right = full[:_TERMS, :_TERMS], full[:_TERMS, _TERMS]
    weight = np.empty(right.shape)
    for term, sigma in enumerate((*PRIOR_SIGMA[:2], curvature_sigma, PRIOR_SIGMA[3])):
        weight[term] = np.maximum(variance / np.square(sigma), 1e-12)
    normal[_DIAGONAL, _DIAGONAL] += weight
    inverse = _inverse(normal)
    pulled = right.copy()
    pulled[2] += weight[2] * curvature
    coefficients = np.einsum("ij...,j...->i...", inverse, pulled)
    # Of the sum of squares, what the expectation has taken is left to the points.
    pull = -weight * coefficients
    pull[2] += weight[2] * curvature
    misfit = full[_TERMS, _TERMS] - np.sum(coefficients * (right - pull), axis=0)
    return (
        np.moveaxis(coefficients, 0, -1),
        np.moveaxis(inverse, (0, 1), (-2, -1)),
        np.maximum(misfit, 0.0),
        summed[..., 0],
    )


def without_bias(
    coefficients: np.ndarray, inverse: np.ndarray, summed: np.ndarray, variance: np.ndarray
) -> np.ndarray:
    """Coefficients (…, 4) without what they owe to noise in the terms themselves.

    A point's noise moves s and q = (s² + n²)/2 as well as the residual F. Their products have the
    mean variance · ∇t · ∇F for each term t, which a least-squares fit takes for slope and curvature
    (errors in variables; Fuller, Measurement Error Models, 1987). A bent side that begins far from
    the edge for its length seems too bent, and where it is drawn out to the edge it is off by as
    much as the noise, however many points there are. To first order: noise is small beside the
    side's length.

    Parameters
    ----------
    coefficients, inverse : as `solve` gives them
    summed, variance : as it takes them
    """
    shared = owed_to_noise(coefficients, summed)
    return np.asarray(coefficients - variance[..., None] * (inverse @ shared[..., None])[..., 0])


def owed_to_noise(coefficients: np.ndarray, summed: np.ndarray) -> np.ndarray:
    """What a unit of noise variance adds to the right sides (…, 4) of normal equations (…, 15)."""
    number, away, half_square, height = (summed[..., k] for k in (0, 1, 2, 4))
    c1, c2, c3 = (coefficients[..., k] for k in range(1, _TERMS))
    shared = np.zeros(coefficients.shape)
    shared[..., 1] = -c1 * number - c2 * away
    shared[..., 2] = height - c1 * away - 2.0 * c2 * half_square
    shared[..., 3] = -c3 * number
    return shared


def _inverse(normal: np.ndarray) -> np.ndarray:
    """Inverse of symmetric positive definite matrices (4, 4, …), by blocks of two rows.

    For so many so small ones LAPACK's time goes into being called.
    """
    a, b, c, d = normal[0]
    e, f, g = normal[1, 1:]
    h, i, j = normal[2, 2], normal[2, 3], normal[3, 3]
    size = a * e - b * b
    p, q, r = e / size, -b / size, a / size
    # What the last two terms are in terms of the first two, and what of them is their own.
    w, x, y, z = p * c + q * f, p * d + q * g, q * c + r * f, q * d + r * g
    h, i, j = h - c * w - f * y, i - c * x - f * z, j - d * x - g * z
    size = h * j - i * i
    h, i, j = j / size, -i / size, h / size
    wh, xh, yh, zh = w * h + x * i, w * i + x * j, y * h + z * i, y * i + z * j
    inverse = np.empty(normal.shape)
    inverse[0, 0] = p + wh * w + xh * x
    inverse[0, 1] = inverse[1, 0] = q + wh * y + xh * z
    inverse[1, 1] = r + yh * y + zh * z
    inverse[0, 2] = inverse[2, 0] = -wh
    inverse[0, 3] = inverse[3, 0] = -xh
    inverse[1, 2] = inverse[2, 1] = -yh
    inverse[1, 3] = inverse[3, 1] = -zh
    inverse[2, 2], inverse[3, 3] = h, j
    inverse[2, 3] = inverse[3, 2] = i
    return inverse
