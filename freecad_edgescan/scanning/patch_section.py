# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edge points from all the points of a patch across the edge.

The walk needs one rough edge point after the other; `PatchSection.measure` takes the points of a
slab around the predicted section. Once the walk knows where the edge runs, `finish` measures all
sections together in the bend of the edge itself (see `strip`).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial import cKDTree

from ..cloud.point_cloud import PointCloud
from .corner import Corners, corners, largest_sigma
from .fillet import gap_under_rounding
from .measured_sections import MeasuredSections
from .normal_equations import block_counts, block_moments, without_crowds
from .section import Frames, SectionPoints, Station, frames_from_sides, section_points
from .side_fit import SideFits, choose_stretches
from .stop import Stop

# A measured section that turns more than this against its prediction is measured once more.
_REMEASURE_TURN = 0.06
_MEASUREMENTS = 3
_MOST_BENT = 0.4  # rad, turn of the edge within half a slab
_ARC = np.tan(_MOST_BENT) / _MOST_BENT
_MOST_SCATTER = 5.0  # times the noise, of the better side, at which it is no side any more
_ENDING = 6.0  # pitches round the last edge point, and of sides, to see why a walk ended
_HANGING = 3.0  # pitches: what an edge point may be off the nearest point besides a rounding
_FOREIGN = 6  # points there that make a surface
_LOOKED = 6.0  # pitches before and behind a section in which to see how far points are apart
_WIDER = (2.0, 4.0)  # of the slab, where it holds too few points


@dataclass(frozen=True)
class PatchSettings:
    """What a patch section works with, all lengths in mm.

    Attributes
    ----------
    reach : distance from the edge to look at on each side, half the amplitude
    edge_pitch : distance of the edge points
    cloud_pitch : distance of the cloud's points
    noise : standard deviation of the cloud's points along the normal
    probe_radius : radius of the probe whose centres the cloud holds
    min_angle : least turn between the two sides, rad
    spacing : how far apart points lie along the edge on the sparser side
    """

    reach: float
    edge_pitch: float
    cloud_pitch: float
    noise: float
    probe_radius: float = 0.0
    min_angle: float = 0.26
    spacing: float = 0.0

    @property
    def half_width(self) -> float:
        """Half the width of a slab, along the edge: it holds points of both sides."""
        return max(0.75 * self.edge_pitch, 1.5 * self.cloud_pitch, self.spacing)

    @property
    def longest_step(self) -> float:
        """Longest step of the walk; the edge points are laid one edge pitch apart afterwards."""
        return float(np.clip(0.25 * self.reach, self.edge_pitch, 3.0 * self.edge_pitch))

    def with_reach(self, reach: float) -> PatchSettings:
        """The same settings with another reach."""
        return replace(self, reach=reach)


class PatchSection:
    """Measures edge points from the patches on both sides (a `Section`)."""

    def __init__(self, cloud: PointCloud, settings: PatchSettings) -> None:
        self.cloud = cloud
        self.settings = settings

    def measure(self, predicted: Frames, half_width: np.ndarray, last: Station) -> list[Station]:
        """Measure an edge point in the slab around each predicted section.

        Where a slab holds too few points to know the edge well, a wider one is tried.
        """
        pitch = self.settings.cloud_pitch
        widest = _MOST_BENT / np.maximum(np.linalg.norm(predicted.bend, axis=1), 1e-12)
        best = self.settle(predicted, np.minimum(half_width, np.maximum(widest, pitch)))
        known = self.settings.noise + 0.05 * pitch
        for wider in _WIDER:
            doubtful = np.array([s.stop is not None or s.sigma >= known for s in best])
            which = np.flatnonzero(doubtful & (wider * half_width <= widest))
            if not len(which):
                break
            others = self.settle(predicted[which], wider * half_width[which])
            for k, other in zip(which, others, strict=True):
                if other.stop is None and (
                    best[k].stop is not None or other.sigma < 0.7 * best[k].sigma
                ):
                    best[k] = other
        return best

    def settle(self, predicted: Frames, half_width: np.ndarray) -> list[Station]:
        """Measure in one slab each, and again from what was found while a section still turns.

        Parameters
        ----------
        half_width : (m,) mm
        """
        found = self._measure_once(predicted, half_width)
        frames, which = predicted, np.arange(len(predicted))
        for _ in range(_MEASUREMENTS - 1):
            seen = Frames.join([found[k].frame for k in which])
            turned = np.einsum("mki,mki->mk", seen.sides, frames.sides).min(axis=1)
            moved = np.linalg.norm(seen.origin - frames.origin, axis=1)
            going = (turned <= np.cos(_REMEASURE_TURN)) | (moved >= self.settings.cloud_pitch)
            going &= [found[k].stop is None for k in which]
            if not going.any():
                break
            frames, which = seen[going], which[going]
            again = self._measure_once(frames, half_width[which])
            for k, station in zip(which, again, strict=True):
                found[k] = station
        return found

    def slab(self, frames: Frames, half_width: np.ndarray) -> SectionPoints:
        """Points within the reach of sections and half a width (m,) along the edge."""
        radius = np.hypot(self.settings.reach, half_width) * 1.05
        # Both trees are gone through together, and what they have in common comes as arrays.
        pairs = cKDTree(frames.origin).sparse_distance_matrix(
            self.cloud.tree, radius.max(), output_type="ndarray"
        )
        index, owner = pairs["j"], pairs["i"]
        points = self.cloud.points.take(index, axis=0)
        offset = points - frames.origin.take(owner, axis=0)
        ahead = np.einsum("ni,ni->n", offset, frames.tangent.take(owner, axis=0))
        # Outside of a bend a narrow slab of points fans out, up to twice its width.
        fanned = _ARC * (1.0 + np.linalg.norm(frames.bend, axis=1) * radius)
        near = np.abs(ahead) <= (half_width * np.minimum(fanned, 2.0)).take(owner)
        near = np.flatnonzero(near & (pairs["v"] <= radius.take(owner)))
        # In an order that does not depend on which sections are measured together.
        near = near[np.argsort(index[near])]
        found = section_points(frames, owner[near], index[near], points.take(near, axis=0))
        return found[np.abs(found.along) <= half_width[found.owner]]

    def spacing(self, frames: Frames) -> np.ndarray:
        """How far apart points lie along each edge, near its section, on the sparser side, (m,) mm.

        It is that side's pitch, or where a scanner's lines run across the edge, the distance from
        one to the next. A single hole in the cloud is neither.
        """
        looked = np.full(len(frames), _LOOKED * self.settings.cloud_pitch)
        points = self.slab(frames, looked)
        points = points[self._plausible(frames, points)]
        found = np.zeros((len(frames), 2))
        for (k, side), _ in np.ndenumerate(found):
            mine = points[(points.owner == k) & (points.side == side)]
            if len(mine.index) > 1:
                found[k, side] = _spacing(mine.along, mine.away)
        return found.max(axis=1)

    def _measure_once(self, frames: Frames, half_width: np.ndarray) -> list[Station]:
        seen = self.look(frames, half_width)
        return [seen.station(k) for k in range(len(frames))]

    def look(self, frames: Frames, half_width: np.ndarray) -> MeasuredSections:
        """Measure in one slab each, once.

        Parameters
        ----------
        half_width : (m,) mm
        """
        settings, sections = self.settings, len(frames)
        points = self.slab(frames, half_width)
        kept = points[self._plausible(frames, points)]
        supplied = np.bincount(points.owner, minlength=sections)
        missing = np.array(
            [Stop.CLOUD_END if count < 12 else Stop.CORNER for count in supplied], dtype=object
        )
        enough = _counts(kept, sections).min(axis=1) >= 6
        if not enough.any():
            return MeasuredSections.unmeasured(frames, missing, settings.reach)
        fits = self._fit(frames, kept, half_width)
        residual = fits.residuals(kept)
        limit = 3.5 * np.maximum(np.sqrt(fits.variance) * settings.reach, settings.noise)
        inliers = np.abs(residual) <= kept.of_their_sides(limit)
        if not np.all(inliers):
            fits = self._fitted_again(frames, kept, inliers, fits, half_width)
            kept = kept[inliers]
        ahead = kept.along > 0.0
        enough &= (
            np.minimum(_counts(kept[ahead], sections), _counts(kept[~ahead], sections))
            .min(axis=1)
            .astype(bool)
        )
        enough &= np.all(fits.count >= 6, axis=1)
        corner = corners(frames, fits)
        lost = ~corner.found | self._hanging(corner, fits, points)
        measured = frames_from_sides(
            corner.point,
            corner.tangent,
            corner.sides,
            frames.bend,
            fits.coefficients[..., 2] / settings.reach,
        )
        sigma = largest_sigma(corner.covariance)
        noise = np.sqrt(fits.variance.min(axis=1)) * settings.reach
        cover, begins, ends = _cover(kept, fits), fits.begins, fits.ends
        lost_in_noise = ~(sigma <= 0.5 * begins.max(axis=1) + 2.0 * settings.cloud_pitch)
        stops = np.full(sections, None, dtype=object)
        stops[noise > _MOST_SCATTER * settings.noise] = Stop.CORNER
        stops[lost_in_noise] = Stop.LOST
        stops[measured.turn < settings.min_angle / 2.0] = Stop.SMOOTH
        reach = np.full(sections, settings.reach)
        seen = MeasuredSections(measured, sigma, noise, begins, ends, cover, stops, reach)
        if np.all(enough & ~lost):
            return seen
        missing[enough] = Stop.LOST
        nowhere = np.flatnonzero(~enough | lost)
        nothing = MeasuredSections.unmeasured(frames[nowhere], missing[nowhere], settings.reach)
        return seen.replaced(nowhere, nothing)

    def _fitted_again(
        self,
        frames: Frames,
        points: SectionPoints,
        inliers: np.ndarray,
        fits: SideFits,
        half_width: np.ndarray,
    ) -> SideFits:
        """The fits, those of sections with outliers without these."""
        rows = np.unique(points.owner[~inliers])
        number = np.full(len(frames), -1)
        number[rows] = np.arange(len(rows))
        theirs = number[points.owner] >= 0
        own, kept = points[theirs], inliers[theirs]
        own = replace(own, owner=number[own.owner])
        removed, left = (
            block_counts(own[part], len(rows), self.settings.reach) for part in (~kept, kept)
        )
        doubtful = removed > 0.25 * (left + removed)
        again = self._fit(frames[rows], own[kept], half_width[rows], doubtful)
        return fits.replaced(rows, again)

    def _hanging(self, corner: Corners, fits: SideFits, points: SectionPoints) -> np.ndarray:
        """Whether an edge point hangs farther in the air than a rounding can take away, (m,).

        Sides that meet farther outside, like the two faces of a thin plate that a fit has bent
        towards each other, have no edge there.
        """
        half = corner.half_angle
        rounded = gap_under_rounding(fits.begins.max(axis=1), half)
        farthest = 1.3 * rounded + _HANGING * self.settings.cloud_pitch
        away = self.cloud.points.take(points.index, axis=0)
        away -= corner.point.take(points.owner, axis=0)
        near = np.einsum("ni,ni->n", away, away) <= np.square(farthest).take(points.owner)
        return np.bincount(points.owner[near], minlength=len(half)) == 0

    def _fit(
        self,
        frames: Frames,
        points: SectionPoints,
        half_width: np.ndarray,
        doubtful: np.ndarray | None = None,
    ) -> SideFits:
        reach = self.settings.reach
        moments = block_moments(points, len(frames), reach)
        moments = without_crowds(moments, reach, half_width, self.settings.cloud_pitch)
        return choose_stretches(
            moments, reach, self.settings.noise, frames.curvature * reach, doubtful=doubtful
        )

    def ending(self, last: Station, stop: Stop) -> Stop:
        """Tell a corner, where other surfaces begin, from the end of the cloud.

        Round the last edge point either nothing lies ahead, or points that belong to neither
        side, or the sides go on and the edge between them was lost.
        """
        if stop is Stop.SMOOTH:
            return stop
        frame, pitch = last.frame, self.settings.cloud_pitch
        begins = min(max(last.begins), 0.5 * self.settings.reach) + 0.5 * pitch
        ball = self.cloud.tree.query_ball_point(frame.origin[0], _ENDING * pitch + begins)
        index = np.asarray(ball, dtype=np.int64)
        points = section_points(frame, np.zeros_like(index), index, self.cloud.points[index])
        points = points[np.abs(points.along) <= _ENDING * pitch]
        clear = points.away > begins
        near = 4.0 * self.settings.noise + 0.05 * pitch + 0.1 * points.away
        expected = 0.5 * frame.curvature[0, points.side] * points.away**2
        foreign = clear & (np.abs(points.height - expected) > near)
        # What lies farther back has been walked along.
        foreign &= points.along > -2.5 * pitch
        ahead = points.along > 1.5 * pitch
        if foreign.sum() >= _FOREIGN:
            return Stop.CORNER
        return stop if np.count_nonzero(ahead & clear) >= _FOREIGN else Stop.CLOUD_END

    def _plausible(self, frame: Frames, points: SectionPoints) -> np.ndarray:
        """Points near enough to the surface that the prediction expects."""
        expected = 0.5 * points.of_their_sides(frame.curvature) * points.away**2
        allowed = 4.0 * self.settings.noise + 0.5 * self.settings.cloud_pitch + 0.15 * points.away
        begins = frame.rolled_over(self.settings.probe_radius)[points.owner]
        return (points.away > begins) & (np.abs(points.height - expected) <= allowed)


def _cover(points: SectionPoints, fits: SideFits) -> np.ndarray:
    """How far each side's fit reaches among its points, the smaller share of the two, (m,).

    A side that is not smooth within the noise, or curls within its length as a rounding does,
    counts for less. What is left out next to the edge may well be a rounding and does not count.
    """
    extent = np.full(fits.count.shape, 1e-12)
    np.maximum.at(extent.reshape(-1), 2 * points.owner + points.side, points.away)
    curl = fits.coefficients[..., 2] * fits.ends / fits.reach
    share = np.minimum(fits.ends / extent, 1.0) / (1.0 + curl**2)
    return np.asarray(np.where(fits.accepted, share, 0.6 * share).min(axis=1))


def _spacing(along: np.ndarray, away: np.ndarray) -> float:
    """How far apart along the edge the points (n,) of one side are, mm."""
    gaps = np.sort(np.diff(np.sort(along)))
    covered = np.cumsum(gaps)
    # Between lines most of the length is in gaps of their spacing, however many points they have.
    line_spacing = gaps[np.searchsorted(covered, 0.5 * covered[-1])]
    # Half of the points tell the width: foreign ones may lie far beyond a side's end.
    width = 2.0 * np.subtract(*np.quantile(away, (0.75, 0.25)))
    pitch = np.sqrt((covered[-1] - gaps[-1]) * width / len(along))
    return float(max(line_spacing, pitch))


def _counts(points: SectionPoints, sections: int) -> np.ndarray:
    """Number of points of each side of each section, (m, 2)."""
    return np.bincount(points.owner * 2 + points.side, minlength=2 * sections).reshape(-1, 2)
