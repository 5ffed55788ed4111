# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the sides of a rounded edge reach, away from it and along it.

A side that is known beside its rounding shows where it ends: at the next rounding, where another
surface crosses it, where it begins to bend otherwise; and along the edge where the roundings of
other edges begin before this one ends.
"""

from __future__ import annotations

import numpy as np
from scipy.ndimage import convolve1d

from .agreed_shape import curvatures_of_each
from .beyond_chance import beyond_chance
from .normal_equations import BLOCK_EDGES, BLOCKS, block_of
from .rounded_rows import Rounded
from .rounded_strip import FAR, FINE, POOLED, Expected, RoundedStrip, moved

__all__ = ["beyond_rounding", "even_stretch", "moved_by_last_block", "without_far_ends"]

_ROUNDS = 5
_FAR_END = 3.5  # standard deviations by which the mean of a block, or of a pitch, may be off
_SLACK = 0.3  # noise, by which they may be off for other reasons
_BENDING = 12.0  # standard deviations, farther off than which is another surface
_OF_A_BLOCK = 8.0  # the same, of a side's last block
_MOST_BENT = 0.25  # of an edge, at each end
_LEAST_SIDE = 2.0  # pitches
_ALIKE = 2 * POOLED + 1  # sections over which what is left of another surface is much the same
_FEW = 3  # points of a block that count
_LOST = 0.25  # share of them that may be off
_NEARER, _OTHERWISE = 0.65, 2.3  # share of a side, and standard deviations it may be bent otherwise


def beyond_rounding(strip: RoundedStrip, model: Rounded, lasts: np.ndarray) -> np.ndarray:
    """Last blocks (m, 2) of the sides; where one ends in the rounding, where most others end."""
    begins = strip.rows(model)[0].begins
    inside = BLOCK_EDGES[lasts] < begins + _LEAST_SIDE * strip.pitch
    return np.where(inside, np.maximum(lasts, np.median(lasts, axis=0).astype(np.int64)), lasts)


def without_far_ends(
    strip: RoundedStrip, model: Rounded, expected: Expected, lasts: np.ndarray
) -> np.ndarray:
    """Last blocks (m, 2) of the sides without those that bend away at their far ends."""
    cuts: tuple[float, ...] = FAR + FINE
    for _ in range(_ROUNDS):
        mine = strip.within(BLOCK_EDGES[lasts])
        model, _ = moved(mine, model, expected, cuts)
        cuts = FINE
        shorter = np.minimum(_shorter(mine, model, lasts), _evenly_bent(mine, model, lasts))
        if np.array_equal(shorter, lasts):
            break
        lasts = shorter
    return lasts


def _evenly_bent(strip: RoundedStrip, model: Rounded, lasts: np.ndarray) -> np.ndarray:
    """Last blocks (m, 2) of the sides, nearer where a side is bent otherwise farther out."""
    begins = strip.rows(model)[0].begins
    near = begins + _NEARER * (BLOCK_EDGES[lasts] - begins)
    firsts = np.minimum(np.searchsorted(BLOCK_EDGES, near), lasts)
    nearer = strip.within(BLOCK_EDGES[firsts])
    (all_of_it, known), (seen, less_known) = (
        curvatures_of_each(part.summed(model, FINE[0]), model.coefficients, model.radius)
        for part in (strip, nearer)
    )
    # A side may be bent otherwise at the other end of the edge; each section is asked by itself.
    weight = 1.0 / np.maximum(less_known - known, 1e-3 * known)
    other = np.abs(np.sum(weight * (seen - all_of_it), axis=0)) / weight.sum(axis=0)
    sagitta = 0.125 * other * np.square(BLOCK_EDGES[lasts] - begins)
    by_chance = _OTHERWISE * np.sqrt(strip.counted / weight.sum(axis=0))
    bent = (other > by_chance) & (sagitta > _SLACK * strip.noise)
    return np.where(bent, firsts, lasts)


def _shorter(strip: RoundedStrip, model: Rounded, lasts: np.ndarray) -> np.ndarray:
    """Last blocks (m, 2) of the sides, nearer where another surface or a bend begins before them.

    A far end that bends away is the next rounding; where a block loses many of its points another
    surface crosses the side, and those that are left only look like it.
    """
    rows, off = strip.rows(model)
    points, away = strip.points, strip.points.away / strip.reach
    block = np.clip(block_of(away), 0, BLOCKS - 1)
    bins = (points.owner * 2 + points.side) * BLOCKS + block
    mode = "wrap" if strip.closed else "constant"

    def pooled(part: np.ndarray, values: np.ndarray) -> np.ndarray:
        total = np.bincount(bins[part], weights=values[part], minlength=lasts.size * BLOCKS)
        window = np.ones(2 * POOLED + 1)
        return convolve1d(total.reshape(-1, 2, BLOCKS), window, axis=0, mode=mode)

    beside = ~rows.on_arc
    seen = beside & (np.abs(off) < FINE[0])
    mean_noise = strip.noise.mean(axis=1)[points.owner]
    # Farther off is no point of a side that is seen badly.
    near = beside & ~seen & (np.abs(off) < 4.0 + (0.5 * strip.pitch + 0.1 * away) / mean_noise)
    left, lost = pooled(seen, strip.crowd), pooled(near, strip.crowd)
    number = np.arange(BLOCKS)
    room = BLOCK_EDGES[:-1] > (rows.begins + _LEAST_SIDE * strip.pitch)[..., None]
    crossed = room & (lost > _LOST * (lost + left)) & (lost >= _FEW)
    lasts = np.minimum(lasts, np.where(crossed, number, BLOCKS).min(axis=2))
    # Blocks beyond the last point are no part of a side; where it has none, its neighbours' are.
    supplied = room & (left >= _FEW) & (number < lasts[..., None])
    last = np.where(supplied.any(axis=2), np.where(supplied, number, 0).max(axis=2), lasts - 1)
    wide = beside & (np.abs(off) < _OF_A_BLOCK)
    total, count = pooled(wide, strip.crowd * off), pooled(wide, strip.crowd)
    bent, beyond = (
        np.take_along_axis(part, last[..., None], axis=2)[..., 0]
        for part in (_is_off(strip, total, count), room)
    )
    return np.asarray(last + 1 - (bent & beyond))


def _is_off(strip: RoundedStrip, total: np.ndarray, count: np.ndarray) -> np.ndarray:
    """Whether the mean of so many residuals is off, by more than chance and by enough to matter."""
    by_chance = _FAR_END * np.sqrt(np.maximum(count, 1.0) * strip.counted)
    return np.asarray(np.abs(total) > np.maximum(by_chance, _SLACK * count))


def even_stretch(
    strip: RoundedStrip, model: Rounded, open_ends: tuple[bool, ...]
) -> tuple[float, float]:
    """Places along the edge, in pitches, between which the sides and the rounding go on as before.

    Where an edge ends under a rounding, the next roundings begin before it does.
    """
    rows, off = strip.rows(model)
    near = np.abs(off) < _BENDING
    first = float(np.floor(strip.place.min()))
    kind = np.where(rows.on_arc, 2, strip.points.side)[near]
    bins = np.floor(strip.place[near] - first).astype(np.int64)
    pitches = int(np.floor(strip.place.max() - first)) + 1
    total, count = (
        np.bincount(3 * bins + kind, weights=part, minlength=3 * pitches).reshape(-1, 3)
        for part in (strip.crowd[near] * off[near], strip.crowd[near])
    )
    bent = _is_off(strip, total, count)
    even = np.flatnonzero(~bent.any(axis=1) & (count.sum(axis=1) > 0))
    most = _MOST_BENT * pitches
    if not len(even) or even[0] > most or pitches - 1 - even[-1] > most:
        return -np.inf, np.inf
    return (
        first + even[0] if open_ends[0] and even[0] else -np.inf,
        first + even[-1] + 1 if open_ends[1] and even[-1] < pitches - 1 else np.inf,
    )


def moved_by_last_block(strip: RoundedStrip, model: Rounded, lasts: np.ndarray) -> np.ndarray:
    """Variance (m, 2) by which the sides' last blocks move the edge beyond what noise does.

    Where another rounding has begun unnoticed within the scatter, the side turns towards it: the
    same question as at its beginning (Hausman, Econometrica 46, 1978; see `choose_stretches`).
    Where nothing is left without the last block it is not asked. In reaches².
    """
    expected = Expected.nothing(len(lasts))
    together, covariance = moved(strip, model, expected, FINE)
    begins = strip.rows(together)[0].begins
    astray = np.zeros(lasts.shape)
    for side, position in ((0, 0), (1, 4)):
        nearer = lasts.copy()
        nearer[:, side] -= 1
        left = BLOCK_EDGES[nearer[:, side]] - begins[:, side] > _LEAST_SIDE * strip.pitch
        if not left.any():
            continue
        without, wider = moved(strip.within(BLOCK_EDGES[nearer]), together, expected, FINE)
        gap = without.coefficients[:, side, 0] - together.coefficients[:, side, 0]
        by_chance = np.maximum(wider[:, position, position] - covariance[:, position, position], 0)
        square, by_chance = (np.where(left, part, 0.0) for part in (gap**2, by_chance))
        astray[:, side] = beyond_chance(square, by_chance, _ALIKE, strip.closed)
    return astray
