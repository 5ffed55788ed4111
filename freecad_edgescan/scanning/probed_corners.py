# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edge points of all probed lines together, with what is known about each.

The default way of taking the probe radius off. It keeps the idea of the intersection curves
(Schreve 4.5.4): the edge is sought in the plane across it, from the curves of a line and of its
two neighbours. But every line is carried into that plane along the smooth course and bend of the
edge itself, not along chords between two lines, so that nothing is lost in a bend, the line's
own curve takes part, and its normals need no neighbours.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..geometry.frames import turned_along
from ..geometry.polynomial_curve import OffsetCurve, fit_polynomial, meeting_parameters
from .corner import across_axes
from .line_section import LineSection
from .probe_settings import ProbeSettings
from .probed_line import ProbedLine, measure_line, without_rounding
from .probed_rounding import rounding_begins
from .section import Frames, frames_from_sides, unrolled
from .stop import Stop

__all__ = ["ProbedCorners", "carried_lines", "corners_of_lines"]

_FEWEST_LINES = 8  # that can agree where a rounding begins


@dataclass(frozen=True)
class ProbedCorners:
    """What each line by itself, or with its neighbours, knows of the edge.

    Attributes
    ----------
    shift : (m, 2) mm, of the edge point from the frame's origin, in the axes across the edge
    sides : (m, 2, 3) unit vectors along the two surfaces at the edge, away from it
    scatter : (m, 2, 2) mm², covariance by noise, in the axes across the edge
    systematic : (m, 2, 2) mm², what all lines have in common and no mean makes smaller
    found : (m,) whether the two curves meet
    """

    shift: np.ndarray
    sides: np.ndarray
    scatter: np.ndarray
    systematic: np.ndarray
    found: np.ndarray

    @property
    def covariance(self) -> np.ndarray:
        """All that is not known about each edge point, (m, 2, 2) mm²."""
        return self.scatter + self.systematic

    def points(self, frames: Frames) -> np.ndarray:
        """Edge points (m, 3) mm, of the sections they were measured in."""
        return np.asarray(frames.origin + self._shifts(frames))

    def with_neighbours(self, frames: Frames) -> ProbedCorners:
        """Each edge point as the weighted mean of its own and its two neighbours'.

        What a neighbour knows is turned along the edge first, for each section has axes of its
        own. The first and the last one stay alone.
        """
        weight = 1.0 / np.maximum(np.trace(self.scatter, axis1=1, axis2=2), 1e-18)
        weight = np.where(self.found, weight, 0.0)
        shares = np.stack([np.roll(weight, 1), weight, np.roll(weight, -1)])
        shares[::2, [0, -1]] = 0.0
        total = shares.sum(axis=0)
        shares = np.divide(shares, total, out=np.zeros_like(shares), where=total > 0.0)
        axes = across_axes(frames.normals)
        mine = np.concatenate([self._shifts(frames)[:, None], self.sides, axes], axis=1)
        mean = np.zeros_like(mine[:, :3])
        scatter, systematic = np.zeros_like(self.scatter), np.zeros_like(self.scatter)
        for share, places in zip(shares, (1, 0, -1), strict=True):
            there = np.roll(mine, places, axis=0)
            here = turned_along(there, np.roll(frames.tangent, places, axis=0), frames.tangent)
            mean += share[:, None, None] * here[:, :3]
            turn = np.einsum("mai,mbi->mab", axes, here[:, 3:])
            both = np.stack([self.scatter, self.systematic])
            turned = np.einsum("mab,kmbc,mdc->kmad", turn, np.roll(both, places, axis=1), turn)
            scatter += (share**2)[:, None, None] * turned[0]
            systematic += share[:, None, None] * turned[1]
        sides = mean[:, 1:] / np.maximum(np.linalg.norm(mean[:, 1:], axis=-1, keepdims=True), 1e-9)
        found = total > 0.0
        return ProbedCorners(
            np.einsum("mai,mi->ma", axes, mean[:, 0]),
            np.where(found[:, None, None], sides, self.sides),
            scatter,
            systematic,
            found,
        )

    def _shifts(self, frames: Frames) -> np.ndarray:
        return np.einsum("ma,mai->mi", self.shift, across_axes(frames.normals))


def carried_lines(
    lines: Sequence[ProbedLine], frames: Frames, settings: ProbeSettings
) -> list[ProbedLine]:
    """Lines whose contacts were carried along the edge's bend into the planes across the edge.

    One that shows another edge point then, because it is split or cleaned elsewhere, stays as it
    was.
    """
    apart = settings.edge_pitch + settings.tolerance
    carried: list[ProbedLine] = []
    for j, line in enumerate(lines):
        owner = np.zeros(len(line.contacts), dtype=np.int64)
        origin, tangent = frames.origin[j], frames.tangent[j]
        contacts = origin + unrolled(frames[j], owner, line.contacts)[1]
        starts_on = 1 - line.ends_on
        across = line.rough_sides[line.ends_on] - line.rough_sides[starts_on]
        wedge = line.rough_sides.sum(axis=0)
        again = measure_line(
            contacts, origin, tangent, across, starts_on, settings, wedge, line.narrow
        )
        if isinstance(again, Stop) or np.linalg.norm(again.edge_point - line.edge_point) > apart:
            again = line
        carried.append(replace(again, sharpness=line.sharpness))
    agreed = settings.safeguards.agreed_cleaning and settings.degree > 1
    if not agreed or len(lines) < _FEWEST_LINES:
        return carried
    begins = [_begin(carried, frames, k, settings.tolerance) for k in range(2)]
    return [
        without_rounding(line, frames.origin[j], begins, settings) for j, line in enumerate(carried)
    ]


def _begin(lines: Sequence[ProbedLine], frames: Frames, k: int, tolerance: float) -> float:
    """Where the rounding of surface k begins, mm from the edge."""
    sides = []
    for j, line in enumerate(lines):
        axes = np.array([frames.sides[j, k], frames.normals[j, k]]) @ line.axes.T
        middle = (frames.origin[j] - line.origin) @ line.axes.T
        sides.append((line.sections[k].points - middle) @ axes.T)
    return rounding_begins(sides, tolerance)


def corners_of_lines(
    lines: Sequence[ProbedLine], frames: Frames, distance: float, selection: float = 0.0
) -> ProbedCorners:
    """Intersect the curves of each line, offset by the probe radius.

    Parameters
    ----------
    lines : m lines, in the planes of their frames
    frames : (m) sections of the smooth course of the edge
    distance : mm, from the probe's centres to the surfaces, positive into the smaller wedge
    selection : how far too early contacts lie, in standard deviations (`PointCloudCmm.selection`)
    """
    axes = across_axes(frames.normals)
    count = len(lines)
    shift, found = np.zeros((count, 2)), np.zeros(count, dtype=bool)
    sides, meeting = frames.sides.copy(), np.ones((count, 2))
    for j, line in enumerate(lines):
        curves = [
            OffsetCurve(section.curve, distance * line.wedge_side(k))
            for k, section in enumerate(line.sections)
        ]
        met = meeting_parameters(curves[0], curves[1])
        if met is None:
            continue
        point = line.origin + curves[0].at(met[0]) @ line.axes
        shift[j] = axes[j] @ (point - frames.origin[j])
        ways = np.array([-c.derivative(u) for c, u in zip(curves, met, strict=True)])
        sides[j], meeting[j], found[j] = ways @ line.axes, met, True
    standing = frames_from_sides(frames.origin, frames.tangent, sides)
    gradient = np.einsum("mki,mai->mka", standing.normals, axes)
    inverse = np.linalg.pinv(gradient)
    scatter, systematic = (
        np.einsum("mak,mk,mbk->mab", inverse, variance, inverse)
        for variance in _variances(lines, meeting, found, selection)
    )
    return ProbedCorners(shift, standing.sides, scatter, systematic, found)


def _variances(
    lines: Sequence[ProbedLine], meeting: np.ndarray, found: np.ndarray, selection: float
) -> tuple[np.ndarray, np.ndarray]:
    """Variance of each surface's position at the edge by noise and by system, (m, 2) mm² each.

    The noise is what all lines together scatter about their curves, and each curve knows the
    edge by its leverage there. What a curve of one degree more would say, on the average of all
    lines, is the error of the model; noise does not let it be seen on a single line. Contacts
    that are selected lie too early as a whole.
    """
    by_noise, by_system = np.zeros((2, len(lines), 2))
    for k in range(2):
        leverage, scatter, freedom = np.ones(len(lines)), 0.0, 0
        errors, spread = [], []
        for j, line in enumerate(lines):
            section, u = line.sections[k], meeting[j, k]
            residual = section.residuals()
            scatter += float(residual @ residual)
            freedom += len(residual) - section.curve.degree - 1
            leverage[j] = section.curve.leverage(u)
            if found[j]:
                more = _one_degree_more(section, u)
                if more is not None:
                    errors.append(more[0])
                    spread.append(more[1])
        noise = scatter / max(freedom, 1)
        model = 0.0
        if errors:
            by_chance = noise * float(np.mean(spread)) / len(spread)
            model = max(float(np.mean(errors)) ** 2 - by_chance, 0.0)
        by_noise[:, k] = noise * leverage
        by_system[:, k] = model + selection**2 * noise
    return by_noise, by_system


def _one_degree_more(section: LineSection, u: float) -> tuple[float, float] | None:
    """How far a curve of one degree more lies across this one at u, and its leverage there."""
    points, degree = section.points[section.kept], section.curve.degree + 1
    if len(points) < degree + 2:
        return None
    more = fit_polynomial(points, degree)[0]
    way = section.curve.derivative(u)
    off = more.at(u) - section.curve.at(u)
    across = (way[0] * off[1] - way[1] * off[0]) / float(np.hypot(*way))
    return float(across), more.leverage(u)
