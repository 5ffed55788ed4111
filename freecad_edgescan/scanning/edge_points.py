# SPDX-License-Identifier: LGPL-2.1-or-later
"""All edge points of a walked edge measured together, from all the points of its strip.

1. Sections are laid one edge pitch apart along the smooth curve of the walk, and the cloud's
   points are taken into the coordinates of the sections, which follow the edge's bend.
2. Normal equations are pooled over neighbouring sections: where a rounding begins, where a side
   ends, and how much each side is curved is decided with many times the points of one section.
3. Each section is fitted by itself on those stretches, with the pooled curvature as prior, and its
   two sides, moved by the probe radius, are intersected.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.ndimage import convolve1d, percentile_filter

from ..cloud.point_cloud import PointCloud
from .corner import Corners, corners
from .edge_path import EdgePath
from .patch_section import PatchSettings
from .section import Frames, SectionPoints
from .side_fit import (
    PRIOR_SIGMA,
    SideFits,
    block_counts,
    block_moments,
    choose_stretches,
    fit_summed,
    shift_along,
    sum_stretches,
    without_crowds,
)
from .stop import Stop
from .strip import strip_points

_POOLED = 4  # sections on each side that decide together
_CLEANINGS = 2
_NEAR_END = 8.0  # pitches from the edge in which a side's end is looked for
_STRIDE = 3  # sections from one decision to the next
_POOLED_CURVATURE = 8
_WIDER = (1, 2, 4, 8)  # sections on each side to borrow points from
_THIN = 0.25  # variance of an extrapolated side, in noise squared, that asks for more points


@dataclass(frozen=True)
class Measured:
    """Sections measured together.

    Attributes
    ----------
    frames : (m) sections
    points : cloud points in them, and removed (n,) those that no fit used
    fits : the sides
    noise : (m, 2) standard deviation of the points about the sides, mm
    at : (m,) places of the sections along the edge, mm
    extent : places along the edge between which both sides have points, mm
    """

    frames: Frames
    points: SectionPoints
    removed: np.ndarray
    fits: SideFits
    noise: np.ndarray
    at: np.ndarray
    extent: tuple[float, float]

    def corners(self, offset: float = 0.0) -> Corners:
        """Edge points with both sides moved along the frames' normals, mm."""
        return corners(self.frames, self.fits, offset)


def measure_together(
    cloud: PointCloud, path: EdgePath, settings: PatchSettings, noise: float
) -> Measured:
    """Measure all sections of an edge.

    Parameters
    ----------
    path : sections along the edge
    noise : standard deviation of the points along the normal, mm
    """
    frames, reach, closed = path.frames, settings.reach, path.closed
    everything = strip_points(cloud, path, reach, settings.half_width)
    plausible = _plausible(frames, everything, settings, noise)
    extent = _extent(everything[plausible], path, settings.cloud_pitch)
    place = path.at[everything.owner] + everything.along
    clear = [settings.cloud_pitch * (end is Stop.CORNER) for end in path.ends]
    # At a corner the points at the very end may belong to the next surface.
    plausible &= (place >= extent[0] + clear[0]) & (place <= extent[1] - clear[1])
    points = everything[plausible]
    mode = "wrap" if closed else "constant"
    pooled = _pooled_fits(points, frames, settings, noise, mode, None)
    removed = np.zeros(len(points.index), dtype=bool)
    for _ in range(_CLEANINGS):
        spread = np.sqrt(pooled.variance) * reach
        limit = 3.5 * np.maximum(spread, 0.5 * noise)
        removed = np.abs(pooled.residuals(points)) > limit[points.owner, points.side]
        lost = block_counts(points[removed], len(frames), reach)
        left = block_counts(points[~removed], len(frames), reach)
        lost, left = (_pool(x.astype(float), _POOLED, mode) for x in (lost, left))
        pooled = _pooled_fits(
            points[~removed], frames, settings, noise, mode, lost > 0.25 * (lost + left)
        )
    moments = _evened_moments(points[~removed], frames, settings)
    stretch = _agreed_stretches(pooled.stretch, "wrap" if closed else "nearest")
    curvature, curvature_sigma = _shared_curvature(pooled, mode)
    local = np.maximum(np.sqrt(pooled.variance) * reach, 1e-6 * reach)
    fits = _supplied_fits(
        sum_stretches(moments, stretch),
        replace(pooled, stretch=stretch),
        (curvature, curvature_sigma),
        path,
        settings.half_width,
    )
    gone = np.ones(len(everything.index), dtype=bool)
    gone[np.flatnonzero(plausible)[~removed]] = False
    outside = ~_in_stretch(everything, fits)
    return Measured(frames, everything, gone | outside, fits, local, path.at, extent)


def _supplied_fits(
    own: np.ndarray,
    pooled: SideFits,
    curvature: tuple[np.ndarray, np.ndarray],
    path: EdgePath,
    half_width: float,
) -> SideFits:
    """Fit each section on its own points, and on its neighbours' too where these are too few."""
    reach = pooled.reach
    local = np.maximum(np.sqrt(pooled.variance) * reach, 1e-6 * reach)
    # Slabs wider than the spacing share points; sums over neighbours must not count them twice.
    overlap = max(1.0, 2.0 * half_width / path.spacing)

    def fit(summed: np.ndarray) -> SideFits:
        fits = fit_summed(summed, reach, local, pooled.stretch, *curvature)
        # One section alone knows its own scatter badly; its neighbours' is the same.
        return replace(fits, variance=pooled.variance, accepted=fits.accepted & pooled.accepted)

    fits, summed, width = fit(own), own, 0
    for wider in _WIDER:
        thin = fits.inverse[..., 0, 0] > _THIN
        if not thin.any() or wider >= len(own) // 2:
            break
        steps = [sign * k for k in range(width + 1, wider + 1) for sign in (-1, 1)]
        borrowed = sum(_neighbours(own, path, step, reach) for step in steps)
        summed = summed + borrowed / overlap
        width = wider
        wide = fit(summed)
        fits = SideFits(
            reach,
            *(
                np.where(thin.reshape(thin.shape + (1,) * (new.ndim - 2)), new, old)
                for new, old in (
                    (getattr(wide, name), getattr(fits, name))
                    for name in (
                        "coefficients",
                        "inverse",
                        "variance",
                        "count",
                        "stretch",
                        "accepted",
                    )
                )
            ),
        )
    return fits


def _neighbours(own: np.ndarray, path: EdgePath, step: int, reach: float) -> np.ndarray:
    """Normal equations of the sections a number of steps further, seen from each section."""
    ahead = path.ahead(step)
    there = np.isfinite(ahead)
    seen = shift_along(np.roll(own, -step, axis=0), np.where(there, ahead, 0.0) / reach)
    return seen * there[:, None, None]


def _pooled_fits(
    points: SectionPoints,
    frames: Frames,
    settings: PatchSettings,
    noise: float,
    mode: str,
    doubtful: np.ndarray | None,
) -> SideFits:
    """Stretches decided on pooled points at every few sections, and fitted at every one."""
    reach = settings.reach
    moments = _pool(_evened_moments(points, frames, settings), _POOLED, mode)
    expected = frames.curvature * reach
    few = np.arange(0, len(frames), _STRIDE)
    chosen = choose_stretches(
        moments[few],
        reach,
        noise,
        expected[few],
        slack=0.05,
        scatter=1.8,
        doubtful=None if doubtful is None else doubtful[few],
    )
    nearest = np.minimum((np.arange(len(frames)) + _STRIDE // 2) // _STRIDE, len(few) - 1)
    stretch = chosen.stretch[nearest]
    fits = fit_summed(
        sum_stretches(moments, stretch),
        reach,
        np.full(expected.shape, noise),
        stretch,
        expected,
        np.full(expected.shape, PRIOR_SIGMA[2]),
    )
    return replace(fits, accepted=fits.accepted & chosen.accepted[nearest])


def _evened_moments(points: SectionPoints, frames: Frames, settings: PatchSettings) -> np.ndarray:
    moments = block_moments(points, len(frames), settings.reach)
    return without_crowds(moments, settings.reach, settings.half_width, settings.cloud_pitch)


def _pool(values: np.ndarray, width: int, mode: str) -> np.ndarray:
    """Sum over the neighbouring sections."""
    width = min(width, (len(values) - 1) // 2)
    if width < 1:
        return values
    return convolve1d(values, np.ones(2 * width + 1), axis=0, mode=mode, cval=0.0)


def _agreed_stretches(stretch: np.ndarray, mode: str) -> np.ndarray:
    """Begin late and end early where neighbours differ: a rounding in the fit costs more."""
    window = (min(2 * _POOLED + 1, len(stretch)), 1)
    begins = percentile_filter(stretch[..., 0], 75, size=window, mode=mode)
    ends = percentile_filter(stretch[..., 1], 25, size=window, mode=mode)
    narrow = (ends - begins < 2)[..., None]
    return np.where(narrow, stretch, np.stack([begins, ends], axis=-1))


def _shared_curvature(pooled: SideFits, mode: str) -> tuple[np.ndarray, np.ndarray]:
    """Curvature of each side that neighbours agree on, and how far one may be from it."""
    own = pooled.coefficients[..., 2]
    variance = np.maximum(pooled.variance * pooled.inverse[..., 2, 2], 1e-12)
    weight = 1.0 / variance
    total = _pool(weight, _POOLED_CURVATURE, mode)
    mean = _pool(weight * own, _POOLED_CURVATURE, mode) / total
    # Pooled windows overlap 2·_POOLED + 1 times; what scatters beyond that is real change.
    scatter = _pool(weight * np.square(own - mean), _POOLED_CURVATURE, mode) / total
    known = (2 * _POOLED + 1) / total
    return mean, np.sqrt(scatter + known + 1e-8)


def _plausible(
    frames: Frames, points: SectionPoints, settings: PatchSettings, noise: float
) -> np.ndarray:
    """Points near enough to the surfaces that the walk has seen."""
    expected = 0.5 * frames.curvature[points.owner, points.side] * points.away**2
    allowed = 4.0 * noise + 0.5 * settings.cloud_pitch + 0.1 * points.away
    begins = frames.rolled_over(settings.probe_radius)[points.owner]
    return (points.away > begins) & (np.abs(points.height - expected) <= allowed)


def _extent(points: SectionPoints, path: EdgePath, cloud_pitch: float) -> tuple[float, float]:
    """Places along the edge between which both sides have points, mm.

    An end that was given, or a gate, is no end of the sides; at a corner a face may well reach
    farther away from the edge, and only points near the edge count.
    """
    place = path.at[points.owner] + points.along
    extent = [-np.inf, np.inf]
    for k, end in enumerate(path.ends):
        if end in (Stop.START, Stop.GATE, Stop.CLOSED, Stop.CANCELLED):
            continue
        near = points.away < (_NEAR_END * cloud_pitch if end is Stop.CORNER else np.inf)
        sides = [np.sort(place[near & (points.side == side)]) for side in range(2)]
        if min(len(side) for side in sides) < 10:
            continue
        # Not the outermost points of all: one may be an outlier.
        extent[k] = min(s[-3] for s in sides) if k else max(s[2] for s in sides)
    return extent[0], extent[1]


def _in_stretch(points: SectionPoints, fits: SideFits) -> np.ndarray:
    begins = fits.begins[points.owner, points.side]
    ends = fits.ends[points.owner, points.side]
    return (points.away >= begins) & (points.away < ends)
