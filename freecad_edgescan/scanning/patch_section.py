# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edge points from all the points of a patch across the edge.

The walk needs one rough edge point after the other; `PatchSection.measure` takes the points of a
slab around the predicted section. Once the walk knows where the edge runs, `finish` measures all
sections together in the bend of the edge itself (see `strip`).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..cloud.point_cloud import PointCloud
from .corner import Corners, corners
from .section import Frames, SectionPoints, Station, frames_from_sides, section_points
from .side_fit import SideFits, block_counts, block_moments, choose_stretches, without_crowds
from .stop import Stop

# A measured section that turns more than this against its prediction is measured once more.
_REMEASURE_TURN = 0.06
_MEASUREMENTS = 3
_MOST_BENT = 0.4  # rad, turn of the edge within half a slab
_MOST_SCATTER = 5.0  # times the noise, of the better side, at which it is no side any more
_ENDING = 6.0  # pitches round the last edge point in which to see why a walk ended
_HANGING = 3.0  # pitches: what an edge point may be off the nearest point besides a rounding
_FOREIGN = 6  # points there that make a surface
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
    """

    reach: float
    edge_pitch: float
    cloud_pitch: float
    noise: float
    probe_radius: float = 0.0
    min_angle: float = 0.26

    @property
    def half_width(self) -> float:
        """Half the width of a slab, along the edge."""
        return max(0.75 * self.edge_pitch, 1.5 * self.cloud_pitch)

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

    def measure(self, predicted: Frames, half_width: float, last: Station) -> Station:
        """Measure one edge point in the slab around a predicted section.

        Where the slab holds too few points to know the edge well, a wider one is tried.
        """
        widest = _MOST_BENT / max(float(np.linalg.norm(predicted.bend)), 1e-12)
        best = self.settle(predicted, min(half_width, max(widest, self.settings.cloud_pitch)))
        for wider in _WIDER:
            known = self.settings.noise + 0.05 * self.settings.cloud_pitch
            if (best.stop is None and best.sigma < known) or wider * half_width > widest:
                break
            other = self.settle(predicted, wider * half_width)
            if other.stop is None and (best.stop is not None or other.sigma < 0.7 * best.sigma):
                best = other
        return best

    def settle(self, predicted: Frames, half_width: float) -> Station:
        """Measure in one slab, and again from what was found while the section still turns."""
        frame = predicted
        for _ in range(_MEASUREMENTS):
            station = self._measure_once(frame, half_width)
            if station.stop is not None:
                return station
            turned = np.einsum("mki,mki->mk", station.frame.sides, frame.sides).min()
            moved = float(np.linalg.norm(station.frame.origin - frame.origin))
            frame = station.frame
            if turned > np.cos(_REMEASURE_TURN) and moved < self.settings.cloud_pitch:
                break
        return station

    def slab(self, frame: Frames, half_width: float) -> SectionPoints:
        """Points within the reach of a section and half a width along the edge."""
        reach = self.settings.reach
        radius = float(np.hypot(reach, half_width)) * 1.05
        index = np.array(
            self.cloud.tree.query_ball_point(frame.origin[0], radius, return_sorted=False),
            dtype=np.int64,
        )
        points = self.cloud.points[index]
        ahead = (points - frame.origin[0]) @ frame.tangent[0]
        # Inside of a bend a narrow slab of points fans out to twice its width.
        near = np.abs(ahead) <= 2.0 * half_width
        index, points = index[near], points[near]
        found = section_points(frame, np.zeros(len(index), dtype=np.int64), index, points)
        return found[np.abs(found.along) <= half_width]

    def _measure_once(self, frame: Frames, half_width: float) -> Station:
        settings = self.settings
        points = self.slab(frame, half_width)
        kept = points[self._plausible(frame, points)]
        missing = Station(frame, stop=Stop.CLOUD_END if len(points.index) < 12 else Stop.CORNER)
        if min(np.bincount(kept.side, minlength=2)) < 6:
            return missing
        fits = self._fit(frame, kept, half_width)
        residual = fits.residuals(kept)
        spread = np.sqrt(fits.variance[0]) * settings.reach
        limit = 3.5 * np.maximum(spread, settings.noise)[kept.side]
        inliers = np.abs(residual) <= limit
        if not np.all(inliers):
            removed = block_counts(kept[~inliers], len(frame), settings.reach)
            kept = kept[inliers]
            left = block_counts(kept, len(frame), settings.reach)
            fits = self._fit(frame, kept, half_width, removed > 0.25 * (left + removed))
        if np.any(fits.count < 6) or not np.all(_reached(kept)):
            return missing
        corner = corners(frame, fits)
        if not corner.found[0] or self._hanging(corner, fits, points):
            return Station(frame, stop=Stop.LOST)
        measured = frames_from_sides(
            corner.point,
            corner.tangent,
            corner.sides,
            frame.bend,
            fits.coefficients[..., 2] / settings.reach,
        )
        sigma = float(np.sqrt(np.linalg.eigvalsh(corner.covariance[0])[-1]))
        noise = float(np.sqrt(np.min(fits.variance[0])) * settings.reach)
        begins = (float(fits.begins[0, 0]), float(fits.begins[0, 1]))
        ends = (float(fits.ends[0, 0]), float(fits.ends[0, 1]))
        stop = None
        if measured.turn[0] < settings.min_angle / 2.0:
            stop = Stop.SMOOTH
        elif not np.isfinite(sigma) or sigma > 0.5 * max(begins) + 2.0 * settings.cloud_pitch:
            stop = Stop.LOST
        elif noise > _MOST_SCATTER * settings.noise:
            stop = Stop.CORNER
        return Station(measured, sigma, noise, begins, _cover(kept, fits), stop, ends=ends)

    def _hanging(self, corner: Corners, fits: SideFits, points: SectionPoints) -> bool:
        """Whether the edge point hangs farther in the air than a rounding can take away.

        A rounding that touches both sides where they begin leaves b (1 − sin θ/2) / cos θ/2 between
        its top and the edge. Sides that meet farther outside, like the two faces of a thin plate
        that a fit has bent towards each other, have no edge there.
        """
        cosine = float(corner.sides[0, 0] @ corner.sides[0, 1])
        half = 0.5 * np.arccos(np.clip(cosine, -1.0, 1.0))
        rounded = float(fits.begins[0].max()) * (1.0 - np.sin(half)) / max(np.cos(half), 1e-3)
        near = np.linalg.norm(self.cloud.points[points.index] - corner.point[0], axis=1).min()
        return bool(near > 1.3 * rounded + _HANGING * self.settings.cloud_pitch)

    def _fit(
        self,
        frame: Frames,
        points: SectionPoints,
        half_width: float,
        doubtful: np.ndarray | None = None,
    ) -> SideFits:
        reach = self.settings.reach
        moments = block_moments(points, len(frame), reach)
        moments = without_crowds(moments, reach, half_width, self.settings.cloud_pitch)
        return choose_stretches(
            moments, reach, self.settings.noise, frame.curvature * reach, doubtful=doubtful
        )

    def ending(self, last: Station, stop: Stop) -> Stop:
        """Tell a corner, where other surfaces begin, from the end of the cloud.

        Round the last edge point either nothing lies ahead, or points that belong to neither
        side, or the sides go on and the edge between them was lost.
        """
        if stop is Stop.SMOOTH:
            return stop
        frame, pitch = last.frame, self.settings.cloud_pitch
        ball = self.cloud.tree.query_ball_point(frame.origin[0], _ENDING * pitch)
        index = np.asarray(ball, dtype=np.int64)
        points = section_points(frame, np.zeros_like(index), index, self.cloud.points[index])
        clear = points.away > min(max(last.begins), 0.5 * self.settings.reach) + 0.5 * pitch
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
        expected = 0.5 * frame.curvature[points.owner, points.side] * points.away**2
        allowed = 4.0 * self.settings.noise + 0.5 * self.settings.cloud_pitch + 0.15 * points.away
        begins = frame.rolled_over(self.settings.probe_radius)[points.owner]
        return (points.away > begins) & (np.abs(points.height - expected) <= allowed)


def _cover(points: SectionPoints, fits: SideFits) -> float:
    """How far each side's fit reaches among its points, the smaller share of the two.

    A side that is not smooth within the noise, or curls within its length as a rounding does,
    counts for less. What is left out next to the edge may well be a rounding and does not count.
    """
    shares = []
    for k in range(2):
        extent = max(points.away[points.side == k].max(), 1e-12)
        curl = fits.coefficients[0, k, 2] * fits.ends[0, k] / fits.reach
        share = min(fits.ends[0, k] / extent, 1.0) / (1.0 + curl**2)
        shares.append(share if fits.accepted[0, k] else 0.6 * share)
    return float(min(shares))


def _reached(points: SectionPoints) -> np.ndarray:
    """Whether each side has points both behind and ahead of the section, (2,)."""
    ahead = np.bincount(points.side[points.along > 0.0], minlength=2)
    behind = np.bincount(points.side[points.along < 0.0], minlength=2)
    return np.minimum(ahead, behind) > 0
