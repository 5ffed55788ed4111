# SPDX-License-Identifier: LGPL-2.1-or-later
"""The points beside a rounded edge, and the steps that bring its sides and its rounding to them."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from .edge_path import EdgePath
from .neighbours import Neighbours
from .normal_equations import PRIOR_SIGMA, crowd_weights
from .patch_section import PatchSettings
from .positive_definite import inverses
from .rounded_rows import CURVATURES_AND_RADIUS, Rounded, Rows, rows_of, solved
from .section import Frames, SectionPoints

__all__ = [
    "COARSE",
    "FAR",
    "FINE",
    "LARGEST",
    "POOLED",
    "WIDEST",
    "Expected",
    "RoundedStrip",
    "moved",
    "stepped",
]

POOLED = 4  # sections on each side that decide together
# Standard deviations beyond which a point is no point, step by step: from a radius that was one of
# a few, from sides that were fitted by themselves, and near the end.
FAR, COARSE, FINE = (20.0, 10.0, 5.0), (5.0, 3.0), (3.0, 3.0)
WIDEST = 0.6  # of a side, that a rounding may take
LARGEST = 0.6  # reaches, of a radius
_SMALLEST = 0.05  # pitches
_MOST_CHANGED = 0.4  # of a radius, and half a pitch, in one step
_LEAST_NOISE = 0.3  # of the usual, in a section that has met less
_NO_NOISE = 1e-6  # reaches
# Pitches of noise: with less, hardly any point of a rounding lies on one of nearly its radius.
_BLURRED = 0.05


@dataclass(frozen=True)
class Expected:
    """What is expected of both sides' coefficients and the radius.

    Attributes
    ----------
    mean : (m, 9)
    precision : (m, 9, 9) inverse of the covariance
    """

    mean: np.ndarray
    precision: np.ndarray

    @staticmethod
    def nothing(sections: int) -> Expected:
        """Hardly anything: sides that are roughly those of the frames."""
        sigma = np.append(np.tile(PRIOR_SIGMA, 2), 1e3)
        return Expected(np.zeros((sections, 9)), np.tile(np.diag(1.0 / sigma**2), (sections, 1, 1)))

    def with_shape(self, mean: np.ndarray, covariance: np.ndarray) -> Expected:
        """With curvatures and radius (m, 3) that are known to a covariance (m, 3, 3)."""
        means, precision = self.mean.copy(), self.precision.copy()
        means[:, CURVATURES_AND_RADIUS] = mean
        rows = CURVATURES_AND_RADIUS
        precision[:, rows[:, None], rows] = inverses(covariance + 1e-8 * np.eye(3))
        return Expected(means, precision)

    def of_change(self, radius: np.ndarray) -> np.ndarray:
        """The same mean with the radius as a change of a model's, (m, 9)."""
        mean = self.mean.copy()
        mean[:, -1] -= radius
        return mean

    def shared(self, covariance: np.ndarray) -> np.ndarray:
        """Part of a fit's covariance (m, 9, 9) that comes from what was expected of the shape."""
        rows, precision = CURVATURES_AND_RADIUS, np.zeros_like(self.precision)
        precision[:, rows[:, None], rows] = self.precision[:, rows[:, None], rows]
        return covariance @ precision @ covariance


@dataclass(frozen=True)
class RoundedStrip:
    """The points beside an edge, and what they are compared with; lengths in reaches.

    Attributes
    ----------
    frames, neighbours : m sections
    points : in them, in mm
    place : (n,) of each point along the edge, in pitches of the cloud
    crowd : (n,) weight of each point
    noise : (m, 2) of the two sides
    reach : mm
    pitch : of the cloud
    counted : how often sums over neighbours count each point
    closed : whether the last section leads back to the first
    """

    frames: Frames
    neighbours: Neighbours
    points: SectionPoints
    place: np.ndarray
    crowd: np.ndarray
    noise: np.ndarray
    reach: float
    pitch: float
    counted: float
    closed: bool

    @staticmethod
    def of(
        points: SectionPoints,
        noise: np.ndarray,
        path: EdgePath,
        settings: PatchSettings,
        counted: float,
    ) -> RoundedStrip:
        """The points of a path's sections; noise (m, 2) in mm, the rest as in `fit_rounded`."""
        reach, pitch = settings.reach, settings.cloud_pitch
        least = max(_LEAST_NOISE * float(np.median(noise)), _NO_NOISE * reach)
        return RoundedStrip(
            frames=path.frames,
            neighbours=Neighbours(path, reach),
            points=points,
            place=(path.at[points.owner] + points.along) / pitch,
            crowd=crowd_weights(points, len(path), reach, settings.half_width, pitch),
            noise=np.maximum(noise, least) / reach,
            reach=reach,
            pitch=pitch / reach,
            counted=counted,
            closed=path.closed,
        )

    def rows(self, model: Rounded) -> tuple[Rows, np.ndarray]:
        """The points as measurements, and their residuals (n,) in standard deviations."""
        rows = rows_of(self.frames, model, self.points, self.reach)
        return rows, rows.residual / self._sigma(rows)

    def summed(
        self, model: Rounded, cut: float, seen: tuple[Rows, np.ndarray] | None = None
    ) -> np.ndarray:
        """Rows (m, 12, 12) of each section's own points within so many standard deviations.

        What `rows` says of the model may be given where it is known.
        """
        rows, off = seen or self.rows(model)
        weight = self.crowd * (np.abs(off) < cut) / self._sigma(rows) ** 2
        return rows.summed(self.points, self.reach, weight, np.square(self.noise))

    def pooled(self, summed: np.ndarray, width: int) -> np.ndarray:
        """The same of neighbours, too, each point once."""
        return self.neighbours.pooled_pairs(summed, width) / self.counted

    def misfit(self, off: np.ndarray) -> float:
        """Sum of squares of residuals (n,), each at most that of three standard deviations."""
        return float(np.sum(self.crowd * np.minimum(off**2, 9.0))) / self.counted

    def blurred(self) -> RoundedStrip:
        """The same points with enough noise to search for a radius among a few."""
        least = _BLURRED * self.pitch
        if float(np.median(self.noise)) >= least:
            return self
        return replace(self, noise=np.maximum(self.noise, least))

    def within(self, ends: np.ndarray) -> RoundedStrip:
        """Only the points nearer to the edge than the ends of their sides, (m, 2)."""
        return self._of(self.points.away < self.reach * self.points.of_their_sides(ends))

    def between(self, first: float, last: float) -> RoundedStrip:
        """Only the points between two places along the edge, in pitches."""
        return self._of((self.place >= first) & (self.place <= last))

    def _of(self, part: np.ndarray) -> RoundedStrip:
        return replace(
            self, points=self.points[part], place=self.place[part], crowd=self.crowd[part]
        )

    def _sigma(self, rows: Rows) -> np.ndarray:
        of_both = self.noise.mean(axis=1).take(self.points.owner)
        return np.where(rows.on_arc, of_both, self.points.of_their_sides(self.noise))


def moved(
    strip: RoundedStrip,
    model: Rounded,
    expected: Expected,
    cuts: tuple[float, ...],
    free: bool = True,
) -> tuple[Rounded, np.ndarray]:
    """Steps of Gauss and Newton on pooled sections, and the covariance (m, 9, 9) at the last.

    Parameters
    ----------
    cuts : standard deviations beyond which a point is left out, for each step
    free : whether the radius may change
    """
    precision = expected.precision
    if not free:
        precision = precision.copy()
        precision[:, -1], precision[:, :, -1] = 0.0, 0.0
        precision[:, -1, -1] = 1e14
    for cut in cuts:
        mean = expected.of_change(model.radius)
        if not free:
            mean[:, -1] = 0.0
        unknown, covariance = solved(
            strip.pooled(strip.summed(model, cut), POOLED), mean, precision
        )
        model = stepped(strip, model, unknown)
    return model, covariance


def stepped(strip: RoundedStrip, model: Rounded, unknown: np.ndarray) -> Rounded:
    """The model that unknowns (m, 9) were solved for; its radius changes by bounded steps."""
    most = _MOST_CHANGED * model.radius
    step = np.clip(unknown[:, -1], -most, most + 0.5 * strip.pitch)
    radius = np.clip(model.radius + step, _SMALLEST * strip.pitch, LARGEST)
    return Rounded(unknown[:, :-1].reshape(-1, 2, 4), radius)
