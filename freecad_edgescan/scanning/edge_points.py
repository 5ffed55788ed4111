# SPDX-License-Identifier: LGPL-2.1-or-later
"""All edge points of a walked edge measured together, from all the points of its strip.

1. Sections are laid one edge pitch apart along the smooth curve of the walk, and the cloud's
   points are taken into the coordinates of the sections, which follow the edge's bend.
2. Normal equations are pooled over neighbouring sections: where a rounding begins, where a side
   ends, and how much each side is curved is decided with many times the points of one section.
3. Each section is fitted by itself on those stretches, with the pooled curvature as prior, and its
   two sides, moved by the probe radius, are intersected.
4. Where something may have rounded the edge, sides and rounding are fitted together
   (`rounded_sides`); where that finds none, the points that a measured rounding covers are left out
   and the sides are fitted once more.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.ndimage import median_filter

from ..cloud.point_cloud import PointCloud
from .aligned import in_line
from .beyond_chance import beyond_chance
from .corner import Corners, corners
from .edge_path import EdgePath
from .fillet import rounding_radius
from .neighbours import Neighbours
from .normal_equations import sum_stretches
from .patch_section import PatchSettings
from .pooling import (
    agreed_stretches,
    cleaned,
    evened_moments,
    fitted_again,
    shared_curvature,
    times_counted,
)
from .rounded_fits import RoundedFits
from .rounded_sides import fit_rounded
from .section import Frames, SectionPoints, frames_from_sides
from .side_fit import SideFits, fit_summed, moved_between
from .stop import GIVEN_ENDS, Stop
from .strip import strip_points

_NEAR_END = 8.0  # pitches from the edge in which a side's end is looked for
_SUPPLIED = 3  # smooth points of a side below which a section rests on its neighbours
_WIDER = (1, 2, 4, 8)  # sections on each side to borrow points from
_MOSTLY, _SOME = 0.5, 0.05  # shares of the sections
_BESIDE = 11  # sections whose roundings are alike
_MOST_ROUNDED = 0.6  # of a side
_SURELY = 0.2  # share of the usual doubt about where the sides are
# Where the points next to the edge are: share of the points that may lie nearer, width in pitches.
_FIRST, _TOP = 0.01, 1.5
# Standard deviations by which they lie below the sides, most of them, and their mean in its own.
_BELOW, _SURELY_BELOW = 0.5, 5.0
_BENT = 0.2  # sagitta of a side, in noise, that may be a rounding's
_MOVES = 2  # of sections that stand out of line: the first one is by sides that are badly known
_STILL_SEEN = 0.8  # of the sides, when the sections have been moved into line
_NO_NOISE = 1e-6  # reaches
_THIN = 0.25  # variance of an extrapolated side, in noise squared, that asks for more points


@dataclass(frozen=True)
class Measured:
    """Sections measured together.

    Attributes
    ----------
    frames : (m) sections
    points : cloud points in them, and removed (n,) those that are no side's: outliers, what lies
        beyond a side's end, and a rounding
    fits : the sides
    noise : (m, 2) standard deviation of the points about the sides, mm
    half_length : (m, 2) how far along the edge, to both ends, the points of each side reach, mm
    summed_over : sections on each side over which most of them have summed what they know of their
        sides' curvature, see `shared_between`
    supplied : (m,) whether both sides have smooth points in the section itself
    at : (m,) places of the sections along the edge, mm
    extent : places along the edge between which both sides have points, mm
    """

    frames: Frames
    points: SectionPoints
    removed: np.ndarray
    fits: SideFits
    noise: np.ndarray
    half_length: np.ndarray
    summed_over: tuple[int, ...]
    supplied: np.ndarray
    at: np.ndarray
    extent: tuple[float, float]

    def corners(self, offset: float = 0.0) -> Corners:
        """Edge points with both sides moved along the frames' normals, mm."""
        return corners(self.frames, self.fits, offset)

    def rounding(
        self, cloud_pitch: float, closed: bool, circular: bool = False
    ) -> tuple[np.ndarray, np.ndarray]:
        """Radius of the rounding in the cloud and its sigma, (m,) mm; nan where there is none.

        Of what is only roughly a circle, too, unless a circular one is asked for.
        """
        if isinstance(self.fits, RoundedFits):
            radius, sigma = self.fits.measured_radius()
            return radius * self.fits.reach, sigma * self.fits.reach
        return rounding_radius(
            self.frames,
            self.points,
            self.corners(),
            self.fits.coefficients[..., 2] / self.fits.reach,
            self.fits.begins,
            self.noise.max(axis=1),
            cloud_pitch,
            closed,
            circular,
        )


def measure_together(
    cloud: PointCloud,
    path: EdgePath,
    settings: PatchSettings,
    noise: float,
    about: float | None = None,
) -> Measured:
    """Measure all sections of an edge.

    Parameters
    ----------
    path : sections along the edge
    noise : standard deviation of the points along the normal, mm
    about : radius of a rounding that has been found between the sides, mm

    Raises
    ------
    ScanError: a rounding leaves next to nothing of a side.
    """
    points, plausible, extent = _strip(cloud, path, settings, noise)
    pooled, used = _decided(points, plausible, path, settings, noise)
    for _ in range(_MOVES):
        moved = in_line(points, used, pooled, path)
        if moved is None:
            break
        again, then = _decided(moved[0], plausible, moved[1], settings, noise)
        if np.any(again.seen < _STILL_SEEN * pooled.seen):
            break  # what the walk has followed is no edge that the sides agree about
        points, path = moved
        pooled, used = again, then
    measured = _measure(points, used, pooled, extent, path, settings)
    if about is not None or _may_be_rounded(measured, settings.cloud_pitch, path.closed):
        place = path.at[points.owner] + points.along
        within = points[(place >= extent[0]) & (place <= extent[1])]
        counted = times_counted(path, settings.half_width)
        together = fit_rounded(
            within, measured.fits, measured.noise, path, settings, counted, about
        )
        if together is not None:
            fits, borrowed, agreeing = together
            return replace(
                measured,
                fits=fits,
                removed=~used | ~fits.within(points),
                half_length=_half_length(np.stack([borrowed, borrowed], axis=1), path, settings),
                summed_over=(agreeing,),
            )
    rounded = _rounded_away(measured, settings, path.closed)
    if rounded is None:
        return measured
    used &= points.away > rounded[points.owner, points.side]
    pooled = fitted_again(points[used], path, settings, pooled)
    return _measure(points, used, pooled, extent, path, settings)


def _decided(
    points: SectionPoints,
    plausible: np.ndarray,
    path: EdgePath,
    settings: PatchSettings,
    noise: float,
) -> tuple[SideFits, np.ndarray]:
    """Sides as neighbours decide them together, and which points are theirs, (n,) bool."""
    pooled, outliers = cleaned(points[plausible], path, settings, noise)
    used = plausible.copy()
    used[plausible] = ~outliers
    return replace(pooled, stretch=agreed_stretches(pooled.stretch, path)), used


def _measure(
    points: SectionPoints,
    used: np.ndarray,
    pooled: SideFits,
    extent: tuple[float, float],
    path: EdgePath,
    settings: PatchSettings,
) -> Measured:
    """Fit every section on those points (n,) bool that are the sides', where these are smooth."""
    own = sum_stretches(evened_moments(points[used], path, settings), pooled.stretch)
    *curvature, summed_over = shared_curvature(pooled, path, settings.half_width)
    fits, borrowed_from = _supplied_fits(own, pooled, curvature, path, settings.half_width)
    removed = ~used | ~fits.within(points)
    local = np.sqrt(pooled.variance) * pooled.reach
    supplied = np.all(own[..., 0] >= _SUPPLIED, axis=1)
    return Measured(
        path.frames,
        points,
        removed,
        fits,
        local,
        _half_length(borrowed_from, path, settings),
        summed_over,
        supplied,
        path.at,
        extent,
    )


def _may_be_rounded(measured: Measured, cloud_pitch: float, closed: bool) -> bool:
    """Whether something has perhaps rounded the edge.

    The points next to it lie below the sides, or the sides bend as if they had taken a rounding
    for a part of themselves.
    """
    radius, _ = measured.rounding(cloud_pitch, closed)
    if np.mean(np.isfinite(radius)) > _MOSTLY:
        return True
    points, fits = measured.points, measured.fits
    seen = measured.corners()
    foot = np.einsum("mki,mi->mk", measured.frames.sides, seen.point - measured.frames.origin)
    beside = points.away - points.of_their_sides(foot)
    # Under a wide rounding nothing is left next to the edge.
    nearest = max(float(np.quantile(beside, _FIRST)), 0.0)
    top = points[beside < nearest + _TOP * cloud_pitch]
    below = -fits.residuals(top) / np.maximum(top.of_their_sides(measured.noise), 1e-12)
    count = np.unique(top.index).size
    if np.median(below) > _BELOW and np.mean(below) * np.sqrt(count) > _SURELY_BELOW:
        return True
    sagitta = 0.125 * fits.coefficients[..., 2] * (fits.ends - fits.begins) ** 2 / fits.reach
    noise = np.maximum(measured.noise, _NO_NOISE * fits.reach)
    return bool(np.median(sagitta / noise, axis=0).min() < -_BENT)


def _rounded_away(measured: Measured, settings: PatchSettings, closed: bool) -> np.ndarray | None:
    """How far from the edge a rounding that was measured reaches on each side, (m, 2) mm.

    Blocks are wider than the stretch within which a rounding leaves the side unnoticed; its radius,
    which all its points tell, says better where that is. None where nothing more is to be left out.
    """
    seen = measured.corners()
    radius, _ = measured.rounding(settings.cloud_pitch, closed)
    known = np.isfinite(radius)
    if np.mean(known) < _MOSTLY:
        return None
    radius = np.interp(measured.at, measured.at[known], radius[known])
    frames = measured.frames
    foot = np.einsum("mki,mi->mk", frames.sides, seen.point - frames.origin)
    # The sides as they were measured: the walk may have seen them with a rounding in them.
    standing = frames_from_sides(seen.point, seen.tangent, seen.sides)
    touch = foot + standing.rolled_over(radius)[:, None]
    mode = "wrap" if closed else "nearest"
    touch = median_filter(touch, (min(_BESIDE, len(touch)), 1), mode=mode)
    touch = np.where(touch < _MOST_ROUNDED * measured.fits.ends, touch, 0.0)
    return touch if np.mean(touch > measured.fits.begins) > _SOME else None


def _strip(
    cloud: PointCloud, path: EdgePath, settings: PatchSettings, noise: float
) -> tuple[SectionPoints, np.ndarray, tuple[float, float]]:
    """Points of the strip, which of them may belong to the sides, and where the sides end."""
    points = strip_points(cloud, path, settings.reach, settings.half_width)
    plausible = _plausible(path.frames, points, settings, noise)
    first, last = extent = _extent(points[plausible], path, settings.cloud_pitch)
    place = path.at[points.owner] + points.along
    # The points at the very end may belong to the next surface. At a corner they do; where the
    # cloud ends they may still, and only those that are clearly on the sides are taken.
    clear = [settings.cloud_pitch * (end is Stop.CORNER) for end in path.ends]
    plausible &= (place >= first + clear[0]) & (place <= last - clear[1])
    clear = [settings.cloud_pitch * (end not in GIVEN_ENDS) for end in path.ends]
    inside = (place >= first + clear[0]) & (place <= last - clear[1])
    plausible &= inside | _plausible(path.frames, points, settings, noise, _SURELY)
    return points, plausible, extent


def _supplied_fits(
    own: np.ndarray,
    pooled: SideFits,
    curvature: Sequence[np.ndarray],
    path: EdgePath,
    half_width: float,
) -> tuple[SideFits, np.ndarray]:
    """Fit each section on its own points, and on its neighbours' too where these are too few.

    And how many neighbours before and behind were asked for points of each side, (m, 2).
    """
    reach = pooled.reach
    local = np.maximum(np.sqrt(pooled.variance), _NO_NOISE) * reach
    overlap, neighbours = times_counted(path, half_width), Neighbours(path, reach)

    def fit(summed: np.ndarray) -> SideFits:
        fits = fit_summed(summed, reach, local, pooled.stretch, *curvature)
        # One section alone knows its own scatter badly; its neighbours' is the same.
        return replace(
            fits,
            variance=pooled.variance,
            accepted=fits.accepted & pooled.accepted,
            astray=pooled.astray,
        )

    fits, summed, width, asked = fit(own), own, 0, np.zeros(own.shape[:2])
    for wider in _WIDER:
        thin = fits.inverse[..., 0, 0] > _THIN
        if not thin.any() or wider >= len(own) // 2:
            break
        steps = [sign * k for k in range(width + 1, wider + 1) for sign in (-1, 1)]
        more = sum(neighbours.borrowed(own, step) for step in steps)
        summed = summed + more / overlap
        width = wider
        lent = fit(summed)
        # What neighbours say may be another thing than chance, since sides change along the edge.
        gap, by_chance = (np.where(thin, part, 0.0) for part in moved_between(lent, fits))
        more = beyond_chance(gap, by_chance, 2 * wider + 1, path.closed)
        lent = replace(lent, astray=fits.astray + more)
        fits = fits.or_where(thin, lent)
        asked[thin] = wider
    return fits, asked


def _half_length(borrowed: np.ndarray, path: EdgePath, settings: PatchSettings) -> np.ndarray:
    return np.asarray(settings.half_width + borrowed * path.spacing)


def _plausible(
    frames: Frames,
    points: SectionPoints,
    settings: PatchSettings,
    noise: float,
    share: float = 1.0,
) -> np.ndarray:
    """Points near enough to the surfaces that the walk has seen.

    The share is that of what is allowed besides noise.
    """
    expected = 0.5 * points.of_their_sides(frames.curvature) * points.away**2
    allowed = 4.0 * noise + share * (0.5 * settings.cloud_pitch + 0.1 * points.away)
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
        if end in GIVEN_ENDS:
            continue
        near = points.away < (_NEAR_END * cloud_pitch if end is Stop.CORNER else np.inf)
        sides = [place[near & (points.side == side)] for side in range(2)]
        if min(len(side) for side in sides) < 10:
            continue
        # Not the outermost points of all: one may be an outlier.
        third = -3 if k else 2
        ends = [float(np.partition(side, third)[third]) for side in sides]
        extent[k] = min(ends) if k else max(ends)
    return extent[0], extent[1]
