# SPDX-License-Identifier: LGPL-2.1-or-later
"""What neighbouring sections decide together: outliers, stretches, and how the sides are curved.

A rounding begins at the same distance from the edge along many sections, and the sides keep their
curvature. Normal equations summed over a few sections on each side see it with many times the
points of one section.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.ndimage import convolve1d, median_filter, percentile_filter, uniform_filter1d

from .beyond_chance import beyond_chance
from .edge_path import EdgePath
from .neighbours import Neighbours
from .normal_equations import BLOCK_EDGES, PRIOR_SIGMA, block_counts, block_moments, without_crowds
from .patch_section import PatchSettings
from .section import SectionPoints
from .side_fit import (
    LATER,
    MOST_CURVED,
    SideFits,
    choose_stretches,
    fit_summed,
    moved_between,
)

_POOLED = 4  # sections on each side that decide together
_STRIDES = (8, 6, 4)  # sections from one decision to the next, first to last
_AT_ONCE = 40  # decisions whose stretches the processor's cache holds together
_ALIKE_CURVED = (8, 24, 72)  # sections on each side that may share their curvature
_ALIKE = 6 * (2 * _POOLED + 1)  # sections over which what is left of a rounding is much the same
_BESIDE = 5  # decisions that judge the one in their middle
_LEAST_SEEN = 0.5  # of what they see, below which it is a stray
# Of where the walk has seen a side begin. A single section rather runs into a rounding than that
# it begins too late, and what lies far inside of that is the rounding itself.
_NOT_BEFORE = 0.85


def cleaned(
    points: SectionPoints, path: EdgePath, settings: PatchSettings, noise: float
) -> tuple[SideFits, np.ndarray]:
    """Pooled sides without outliers, and which points are outliers (n,).

    A block that loses many of its points, as where a rounding begins, is not used: the points it
    keeps only look like the side.
    """
    neighbours = Neighbours(path, settings.reach)
    all_of_them = block_moments(points, len(path), settings.reach)
    pooled = _decide(all_of_them, path, neighbours, settings, noise, None, _STRIDES[0])
    removed = np.zeros(len(points.index), dtype=bool)
    for stride in _STRIDES[1:]:
        limit = 3.5 * np.maximum(np.sqrt(pooled.variance) * pooled.reach, 0.5 * noise)
        removed = np.abs(pooled.residuals(points)) > points.of_their_sides(limit)
        lost, left = (
            _pool(block_counts(points[part], len(path), pooled.reach).astype(float), path)
            for part in (removed, ~removed)
        )
        doubtful = lost > 0.25 * (lost + left)
        kept = all_of_them - block_moments(points[removed], len(path), settings.reach)
        pooled = _decide(kept, path, neighbours, settings, noise, doubtful, stride)
    return pooled, removed


def fitted_again(
    points: SectionPoints, path: EdgePath, settings: PatchSettings, pooled: SideFits
) -> SideFits:
    """Pooled sides fitted on other points, on the stretches that were decided."""
    own = evened_moments(points, path, settings)
    neighbours = Neighbours(path, settings.reach)
    noise = np.sqrt(pooled.variance) * settings.reach

    def fit(without: int, curvature: np.ndarray, sigma: np.ndarray) -> SideFits:
        first, last = pooled.stretch[..., 0], pooled.stretch[..., 1]
        stretch = np.stack([np.minimum(first + without, last - 2), last], axis=-1)
        summed = neighbours.pooled_stretches(own, stretch, _POOLED)
        return fit_summed(summed, settings.reach, noise, stretch, curvature, sigma)

    walked = path.frames.curvature * settings.reach
    expected = walked, np.full(walked.shape, PRIOR_SIGMA[2])
    fits = fit(0, *expected)
    astray = np.zeros_like(fits.variance)
    for without in LATER:
        moved = moved_between(fits, fit(without, *expected))
        astray = np.maximum(astray, beyond_chance(*moved, _ALIKE, path.closed))
    return replace(fits, accepted=fits.accepted & pooled.accepted, astray=astray)


def agreed_stretches(stretch: np.ndarray, path: EdgePath) -> np.ndarray:
    """Begin late and end early where neighbours differ: a rounding in the fit costs more."""
    window = (min(2 * _POOLED + 1, len(stretch)), 1)
    mode = "wrap" if path.closed else "nearest"
    begins = percentile_filter(stretch[..., 0], 75, size=window, mode=mode)
    ends = percentile_filter(stretch[..., 1], 25, size=window, mode=mode)
    narrow = (ends - begins < 2)[..., None]
    return np.where(narrow, stretch, np.stack([begins, ends], axis=-1))


def shared_curvature(
    pooled: SideFits, path: EdgePath, half_width: float
) -> tuple[np.ndarray, np.ndarray, tuple[int, int]]:
    """Curvature of each side that neighbours agree on, and how far one may be from it.

    Each section asks as many neighbours as know it best. And over how many sections on each side
    it has mostly been summed, see `shared_between`.
    """
    own = pooled.coefficients[..., 2]
    counted = times_counted(path, half_width)
    variance = np.maximum(counted * pooled.variance * pooled.inverse[..., 2, 2], 1e-12)
    # What curls like a rounding says nothing about the side.
    weight = np.where(np.abs(own) > 2.0 * MOST_CURVED, 1e-9, 1.0) / variance
    means, variances = zip(
        *(_agreed_by(width, own, weight, path) for width in _ALIKE_CURVED), strict=True
    )
    best = np.argmin(variances, axis=0)
    mean, variance = (
        np.take_along_axis(np.stack(values), best[None], axis=0)[0] for values in (means, variances)
    )
    asked = int(np.median(np.array(_ALIKE_CURVED)[best]))
    return *_perhaps_plane(mean, variance + 1e-8), (_POOLED, asked)


def _agreed_by(
    width: int, own: np.ndarray, weight: np.ndarray, path: EdgePath
) -> tuple[np.ndarray, np.ndarray]:
    """Weighted mean over neighbours, and variance of one of them about it beyond its own."""
    total = _pool(weight, path, width)
    mean = _pool(weight * own, path, width) / total
    # Pooled windows overlap; what scatters beyond chance is real change.
    scatter = _pool(weight * np.square(own - mean), path, width) / total
    shares = np.convolve(np.ones(2 * _POOLED + 1), np.ones(2 * width + 1))
    # How many times larger than that of independent windows the variance of their mean is.
    known = float(np.square(shares).sum() / shares.sum()) / total
    by_chance = np.maximum(_pool(np.ones_like(own), path, width) / total - known, 0.0)
    return mean, np.maximum(scatter - by_chance, 0.0) + known


def _perhaps_plane(mean: np.ndarray, variance: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Curvature and its sigma when half of all sides are planes and the others bent somehow.

    The two models are averaged with their posterior probabilities (spike and slab; Hoeting and
    others, Statistical Science 14, 1999), so that a side becomes a plane as the evidence says so,
    and neighbours never differ in the model.
    """
    bent = variance + PRIOR_SIGMA[2] ** 2
    # Logarithm of the odds of a plane; its ends are certain enough.
    odds = 0.5 * np.log(bent / variance) - 0.5 * mean**2 * (1.0 / variance - 1.0 / bent)
    curved = 1.0 / (1.0 + np.exp(np.clip(odds, -50.0, 50.0)))
    return curved * mean, np.sqrt(curved * (variance + (1.0 - curved) * mean**2) + 1e-8)


def times_counted(path: EdgePath, half_width: float) -> float:
    """How often sums over neighbouring sections count each point: slabs may overlap."""
    return max(1.0, 2.0 * half_width / path.spacing)


def shared_between(
    sections: int, closed: bool, farthest: int, summed_over: tuple[int, ...]
) -> np.ndarray:
    """Correlation of what sections share about their curvature.

    Parameters
    ----------
    sections : their number
    closed : whether the last one leads back to the first
    farthest : number of sections between two of them at most
    summed_over : sections on each side over which the curvature was summed; of several, the sums
        of one were summed over the next

    Returns
    -------
    (sections, farthest + 1) of each section and the one so many further. Near the ends, where
    fewer sections are asked, it is larger.
    """
    # Between the ends of a long edge it is the same everywhere.
    few = min(sections, 4 * sum(summed_over) + 2 * farthest + 2)
    together = np.eye(few)
    for width in summed_over:
        together = _summed(together, width, closed)
    together /= np.linalg.norm(together, axis=1, keepdims=True)
    alike = together @ together.T
    onward = (np.arange(few)[:, None] + np.arange(farthest + 1)) % few
    table = np.take_along_axis(alike, onward, axis=1)
    which = np.arange(sections)
    which = np.where(which < few // 2, which, np.maximum(which - sections + few, few // 2))
    return np.asarray(table[which])


def evened_moments(points: SectionPoints, path: EdgePath, settings: PatchSettings) -> np.ndarray:
    """Normal equations of every section's blocks, crowded ones weighted down."""
    moments = block_moments(points, len(path), settings.reach)
    return without_crowds(moments, settings.reach, settings.half_width, settings.cloud_pitch)


def _decide(
    moments: np.ndarray,
    path: EdgePath,
    neighbours: Neighbours,
    settings: PatchSettings,
    noise: float,
    doubtful: np.ndarray | None,
    stride: int,
) -> SideFits:
    """Stretches decided on pooled points at every few sections, and fitted at every one."""
    reach = settings.reach
    own = without_crowds(moments, reach, settings.half_width, settings.cloud_pitch)
    expected = path.frames.curvature * reach
    few = np.arange(0, len(path), stride)

    def chosen_at(rows: np.ndarray) -> SideFits:
        return choose_stretches(
            neighbours.pooled(own, _POOLED, rows),
            reach,
            noise,
            expected[rows],
            slack=0.05,
            scatter=1.8,
            doubtful=None if doubtful is None else doubtful[rows],
            together=True,
            least_begin=_NOT_BEFORE * path.begins,
        )

    pieces = np.array_split(few, -(-len(few) // _AT_ONCE))
    chosen = SideFits.join([chosen_at(rows) for rows in pieces])
    # Where a rounding is taken for the side it is so all along; each decision sees it by chance.
    astray = uniform_filter1d(chosen.astray, 3, axis=0, mode="wrap" if path.closed else "nearest")
    nearest = np.minimum((np.arange(len(path)) + stride // 2) // stride, len(few) - 1)
    stretch = _without_strays(chosen.stretch, path.closed)[nearest]
    fits = fit_summed(
        neighbours.pooled_stretches(own, stretch, _POOLED),
        reach,
        np.full(expected.shape, noise),
        stretch,
        expected,
        np.full(expected.shape, PRIOR_SIGMA[2]),
    )
    return replace(fits, accepted=fits.accepted & chosen.accepted[nearest], astray=astray[nearest])


def _without_strays(stretch: np.ndarray, closed: bool) -> np.ndarray:
    """Decisions that see far less of a side than most of those beside them see, corrected.

    Such a short stretch lies on a rounding, and would make outliers of the side's own points.
    """
    usual = median_filter(stretch, size=(_BESIDE, 1, 1), mode="wrap" if closed else "mirror")
    seen, expected = (
        BLOCK_EDGES[part[..., 1]] - BLOCK_EDGES[part[..., 0]] for part in (stretch, usual)
    )
    return np.where((seen < _LEAST_SEEN * expected)[..., None], usual, stretch)


def _pool(values: np.ndarray, path: EdgePath, width: int = _POOLED) -> np.ndarray:
    """Sum over the neighbouring sections."""
    return _summed(values, width, path.closed)


def _summed(values: np.ndarray, width: int, closed: bool) -> np.ndarray:
    width = min(width, (len(values) - 1) // 2)
    if width < 1:
        return values
    mode = "wrap" if closed else "constant"
    return convolve1d(values, np.ones(2 * width + 1), axis=0, mode=mode, cval=0.0)
