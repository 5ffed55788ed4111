# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many sections measured at once: each as `PatchSection` measures one, with all its evidence."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

from ...cloud.point_cloud import PointCloud
from ..corner import corners
from ..patch_section import PatchSettings
from ..section import Frames, SectionPoints, Station, frames_from_sides, section_points
from ..side_fit import SideFits, block_counts, block_moments, choose_stretches, without_crowds

__all__ = ["Sections", "measure_sections"]

_AT_ONCE = 256  # sections measured together
_THREADS = min(4, os.cpu_count() or 1)
_FEWEST = 6  # points of a side
_MOST_SCATTER = 5.0  # times the noise, of the better side, at which it is no side any more
_HANGING = 3.0  # pitches: what an edge point may be off the nearest point besides a rounding


@dataclass(frozen=True)
class Sections:
    """Measured sections, m of them; what could not be measured is not found.

    Attributes
    ----------
    frames : (m) sections that stand on the edge points
    sigma : (m,) mm, standard deviation of the edge point
    noise : (m,) mm, met on the better side
    begins : (m, 2) mm, where each side's support begins
    cover : (m,) how much of the two sides' points the fits explain, 0 … 1
    found : (m,) whether two sides meet there
    reach : (m,) mm, that they were measured with
    """

    frames: Frames
    sigma: np.ndarray
    noise: np.ndarray
    begins: np.ndarray
    cover: np.ndarray
    found: np.ndarray
    reach: np.ndarray

    def __len__(self) -> int:
        return len(self.sigma)

    def __getitem__(self, part: np.ndarray) -> Sections:
        """Return some of them."""
        return Sections(
            self.frames[part],
            self.sigma[part],
            self.noise[part],
            self.begins[part],
            self.cover[part],
            self.found[part],
            self.reach[part],
        )

    @staticmethod
    def join(parts: list[Sections]) -> Sections:
        """Put sections behind each other."""
        names = ("sigma", "noise", "begins", "cover", "found", "reach")
        return Sections(
            Frames.join([part.frames for part in parts]),
            *(np.concatenate([getattr(part, name) for part in parts]) for name in names),
        )

    def replaced(self, rows: np.ndarray, others: Sections) -> Sections:
        """These sections, with others instead of some rows."""
        frames = {
            name: _replaced(getattr(self.frames, name), rows, getattr(others.frames, name))
            for name in ("origin", "tangent", "sides", "normals", "bend", "curvature")
        }
        arrays = {
            name: _replaced(getattr(self, name), rows, getattr(others, name))
            for name in ("sigma", "noise", "begins", "cover", "found", "reach")
        }
        return Sections(Frames(**frames), **arrays)

    @property
    def doubt(self) -> np.ndarray:
        """How badly an edge is known, and how little of its sides it explains, (m,) mm."""
        return self.sigma / np.maximum(self.cover, 1e-3) ** 2

    def station(self, number: int) -> Station:
        """One of them as a station of a walk."""
        first, second = self.begins[number]
        return Station(
            self.frames[number],
            float(self.sigma[number]),
            float(self.noise[number]),
            (float(first), float(second)),
            float(self.cover[number]),
        )


def measure_sections(
    cloud: PointCloud, predicted: Frames, settings: PatchSettings, times: int = 1
) -> Sections:
    """Measure sections near predicted ones.

    Parameters
    ----------
    predicted : m sections
    settings : of all of them
    times : how often they are measured, each time from where they were found
    """
    frames, alive = predicted, np.arange(len(predicted))
    result = _nothing(predicted, settings.reach)
    for _ in range(times):
        measured = _measured(cloud, frames, settings)
        result = result.replaced(alive, measured)
        alive = alive[measured.found]
        frames = measured.frames[measured.found]
    return result


def _measured(cloud: PointCloud, frames: Frames, settings: PatchSettings) -> Sections:
    if not len(frames):
        return _nothing(frames, settings.reach)
    # Neighbours lie in one piece, so that the tree's pages are met once.
    pieces = [
        frames[rows] for rows in np.array_split(np.arange(len(frames)), -(-len(frames) // _AT_ONCE))
    ]
    if len(pieces) == 1:
        return _measured_at_once(cloud, frames, settings)
    with ThreadPoolExecutor(_THREADS) as pool:  # NumPy lets go of the interpreter's lock
        return Sections.join(
            list(pool.map(lambda piece: _measured_at_once(cloud, piece, settings), pieces))
        )


def _nothing(frames: Frames, reach: float) -> Sections:
    count = len(frames)
    return Sections(
        frames,
        np.full(count, np.nan),
        np.full(count, np.nan),
        np.full((count, 2), np.nan),
        np.zeros(count),
        np.zeros(count, dtype=bool),
        np.full(count, reach),
    )


def _replaced(values: np.ndarray, rows: np.ndarray, others: np.ndarray) -> np.ndarray:
    values = values.copy()
    values[rows] = others
    return values


def _measured_at_once(cloud: PointCloud, frames: Frames, settings: PatchSettings) -> Sections:
    reach = settings.reach
    points = _slabs(cloud, frames, settings)
    kept = points[_plausible(frames, points, settings)]
    fits = _fit(frames, kept, settings)
    residual = fits.residuals(kept)
    spread = np.sqrt(fits.variance) * reach
    limit = 3.5 * np.maximum(spread, settings.noise)[kept.owner, kept.side]
    inliers = np.abs(residual) <= limit
    if not np.all(inliers):
        fits = _fitted_again(frames, kept, inliers, fits, settings)
        kept = kept[inliers]
    corner = corners(frames, fits)
    found = np.all(fits.count >= _FEWEST, axis=1) & _reached(kept, len(frames)) & corner.found
    measured = frames_from_sides(
        np.where(found[:, None], corner.point, frames.origin),
        np.where(found[:, None], corner.tangent, frames.tangent),
        np.where(found[:, None, None], corner.sides, frames.sides),
        frames.bend,
        fits.coefficients[..., 2] / reach,
    )
    with np.errstate(invalid="ignore"):
        sigma = np.sqrt(np.linalg.eigvalsh(np.nan_to_num(corner.covariance, nan=1e9))[:, -1])
    noise = np.sqrt(np.min(fits.variance, axis=1)) * reach
    begins = fits.begins
    found &= measured.turn >= 0.5 * settings.min_angle
    found &= sigma <= 0.5 * begins.max(axis=1) + 2.0 * settings.cloud_pitch
    found &= noise <= _MOST_SCATTER * settings.noise
    rows = np.flatnonzero(found)
    found[rows] = ~_hanging(cloud, measured[rows], begins[rows], settings.cloud_pitch)
    return Sections(
        measured, sigma, noise, begins, _cover(kept, fits), found, np.full(len(frames), reach)
    )


def _slabs(cloud: PointCloud, frames: Frames, settings: PatchSettings) -> SectionPoints:
    """Points within the reach of each section and half a width along the edge."""
    half_width = settings.half_width
    radius = float(np.hypot(settings.reach, half_width)) * 1.05
    balls = cloud.tree.query_ball_point(frames.origin, radius, return_sorted=False)
    sizes = np.array([len(ball) for ball in balls])
    owner = np.repeat(np.arange(len(frames)), sizes)
    index = np.fromiter((row for ball in balls for row in ball), np.int64, int(sizes.sum()))
    points = cloud.points[index]
    ahead = np.einsum("ni,ni->n", points - frames.origin[owner], frames.tangent[owner])
    near = np.abs(ahead) <= half_width
    return section_points(frames, owner[near], index[near], points[near])


def _plausible(frames: Frames, points: SectionPoints, settings: PatchSettings) -> np.ndarray:
    """Points near enough to the surface that the prediction expects."""
    expected = 0.5 * frames.curvature[points.owner, points.side] * points.away**2
    allowed = 4.0 * settings.noise + 0.5 * settings.cloud_pitch + 0.15 * points.away
    begins = frames.rolled_over(settings.probe_radius)[points.owner]
    return (points.away > begins) & (np.abs(points.height - expected) <= allowed)


def _fit(
    frames: Frames,
    points: SectionPoints,
    settings: PatchSettings,
    doubtful: np.ndarray | None = None,
) -> SideFits:
    reach = settings.reach
    moments = block_moments(points, len(frames), reach)
    moments = without_crowds(moments, reach, settings.half_width, settings.cloud_pitch)
    return choose_stretches(
        moments, reach, settings.noise, frames.curvature * reach, doubtful=doubtful
    )


def _fitted_again(
    frames: Frames,
    points: SectionPoints,
    inliers: np.ndarray,
    fits: SideFits,
    settings: PatchSettings,
) -> SideFits:
    """The fits, those of sections with outliers without these."""
    rows = np.unique(points.owner[~inliers])
    number = np.full(len(frames), -1)
    number[rows] = np.arange(len(rows))
    theirs = number[points.owner] >= 0
    own = points[theirs]
    own = replace(own, owner=number[own.owner])
    kept = inliers[theirs]
    removed, left = (block_counts(own[part], len(rows), settings.reach) for part in (~kept, kept))
    again = _fit(frames[rows], own[kept], settings, removed > 0.25 * (left + removed))
    arrays: dict[str, Any] = {
        each.name: _replaced(getattr(fits, each.name), rows, getattr(again, each.name))
        for each in fields(fits)
        if each.name != "reach"
    }
    return replace(fits, **arrays)


def _reached(points: SectionPoints, sections: int) -> np.ndarray:
    """Whether each side of each section has points both behind and ahead, (m,)."""
    bins = 2 * points.owner + points.side
    ahead, behind = (
        np.bincount(bins[part], minlength=2 * sections).reshape(sections, 2)
        for part in (points.along > 0.0, points.along < 0.0)
    )
    return np.all(np.minimum(ahead, behind) > 0, axis=1)


def _hanging(cloud: PointCloud, frames: Frames, begins: np.ndarray, pitch: float) -> np.ndarray:
    """Which edge points hang farther in the air than a rounding can take away; see PatchSection."""
    if not len(frames):
        return np.zeros(0, dtype=bool)
    cosine = np.einsum("mi,mi->m", frames.sides[:, 0], frames.sides[:, 1])
    half = 0.5 * np.arccos(np.clip(cosine, -1.0, 1.0))
    rounded = begins.max(axis=1) * (1.0 - np.sin(half)) / np.maximum(np.cos(half), 1e-3)
    return cloud.tree.query(frames.origin)[0] > 1.3 * rounded + _HANGING * pitch


def _cover(points: SectionPoints, fits: SideFits) -> np.ndarray:
    """How far each side's fit reaches among its points, the smaller share of the two, (m,)."""
    extent = np.zeros(fits.count.shape)
    np.maximum.at(extent, (points.owner, points.side), points.away)
    curl = fits.coefficients[..., 2] * fits.ends / fits.reach
    share = np.minimum(fits.ends / np.maximum(extent, 1e-12), 1.0) / (1.0 + curl**2)
    return np.asarray(np.where(fits.accepted, share, 0.6 * share).min(axis=1))
