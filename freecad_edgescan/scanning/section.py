# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections across an edge: where to look, what was found there, and who can measure it.

A section stands at an origin on the (predicted) edge, across its tangent. Coordinates follow the
edge's own bend: u is the arc length along the osculating circle of the edge, and the offset
across the edge is taken in the plane that stands on the circle there. In these coordinates the
two surfaces of a swept part do not change with u, so a wide slab of points shares one section.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np

from ..geometry.frames import cross, unit

if TYPE_CHECKING:
    from collections.abc import Sequence

    from .probed_line import ProbedLine
    from .stop import Stop


@dataclass(frozen=True)
class Frames:
    """Sections across an edge, m at a time.

    Attributes
    ----------
    origin : (m, 3) array, mm, points on the edge
    tangent : (m, 3) unit vectors along the edge
    sides : (m, 2, 3) unit vectors across the tangent, along each surface, away from the edge
    normals : (m, 2, 3) unit vectors across tangent and side, out of the smaller wedge
    bend : (m, 3) array, 1/mm, curvature vector of the edge
    curvature : (m, 2) array, 1/mm, of each surface in the section, positive towards its normal
    """

    origin: np.ndarray
    tangent: np.ndarray
    sides: np.ndarray
    normals: np.ndarray
    bend: np.ndarray
    curvature: np.ndarray

    def __len__(self) -> int:
        return len(self.origin)

    def __getitem__(self, index: int | slice | np.ndarray) -> Frames:
        """Return a part of the sections, always as an array of sections."""
        part = slice(index, index + 1 or None) if isinstance(index, int) else index
        return Frames(
            self.origin[part],
            self.tangent[part],
            self.sides[part],
            self.normals[part],
            self.bend[part],
            self.curvature[part],
        )

    def backward(self) -> Frames:
        """The same sections in the other order, walked the other way."""
        there = self[::-1]
        return Frames(
            there.origin, -there.tangent, there.sides, there.normals, there.bend, there.curvature
        )

    def replaced(self, rows: np.ndarray, others: Frames) -> Frames:
        """These sections, and others (k) in some rows: (k,) indices."""
        names = ("origin", "tangent", "sides", "normals", "bend", "curvature")
        arrays = {name: getattr(self, name).copy() for name in names}
        for name, array in arrays.items():
            array[rows] = getattr(others, name)
        return Frames(**arrays)

    @staticmethod
    def join(frames: Sequence[Frames]) -> Frames:
        """Put sections behind each other."""
        names = ("origin", "tangent", "sides", "normals", "bend", "curvature")
        return Frames(*(np.concatenate([getattr(f, name) for f in frames]) for name in names))

    @property
    def turn(self) -> np.ndarray:
        """Angle by which the surface turns at the edge, π − θ, (m,) rad."""
        cosine = np.einsum("mi,mi->m", self.sides[:, 0], self.sides[:, 1])
        return np.pi - np.arccos(np.clip(cosine, -1.0, 1.0))

    def rolled_over(self, radius: float | np.ndarray) -> np.ndarray:
        """How far from the edge a ball (m,) that rolls round it, or rounds it, touches, (m,) mm."""
        return radius * np.tan(0.5 * np.minimum(self.turn, 2.8))


def frames_from_sides(
    origin: np.ndarray,
    tangent: np.ndarray,
    sides: np.ndarray,
    bend: np.ndarray | None = None,
    curvature: np.ndarray | None = None,
) -> Frames:
    """Complete sections: sides made square to the tangent, normals out of the smaller wedge.

    Parameters
    ----------
    origin, tangent : (m, 3) arrays
    sides : (m, 2, 3) array, roughly along the two surfaces, away from the edge
    bend, curvature : see `Frames`; zero when not given
    """
    tangent = unit(tangent)
    sides = unit(sides - np.einsum("mki,mi->mk", sides, tangent)[..., None] * tangent[:, None])
    normals = cross(tangent[:, None], sides)
    outward = -np.einsum("mki,mki->mk", normals, sides[:, ::-1])
    normals = normals * np.where(outward < 0.0, -1.0, 1.0)[..., None]
    bend = np.zeros_like(origin) if bend is None else bend
    curvature = np.zeros(sides.shape[:2]) if curvature is None else curvature
    return Frames(origin, tangent, sides, normals, bend, curvature)


@dataclass(frozen=True)
class SectionPoints:
    """Cloud points in the coordinates of their sections.

    Attributes
    ----------
    index : (n,) index of the point in the cloud
    owner : (n,) index of the section
    along : (n,) u, mm, arc length along the edge
    side : (n,) 0 or 1, which of the two surfaces it may belong to
    away : (n,) s, mm, along that side, away from the edge
    height : (n,) mm, along that side's normal
    """

    index: np.ndarray
    owner: np.ndarray
    along: np.ndarray
    side: np.ndarray
    away: np.ndarray
    height: np.ndarray

    def __getitem__(self, part: np.ndarray) -> SectionPoints:
        """Return some of the points: (n,) bool, or their numbers."""
        rows = np.flatnonzero(part) if part.dtype == bool else part
        return SectionPoints(
            self.index.take(rows),
            self.owner.take(rows),
            self.along.take(rows),
            self.side.take(rows),
            self.away.take(rows),
            self.height.take(rows),
        )

    def of_their_sides(self, values: np.ndarray) -> np.ndarray:
        """Values (m, 2, …) of the sections' sides at each point, (n, …): those of its own side."""
        flat = values.reshape(-1, *values.shape[2:])
        return flat.take(2 * self.owner + self.side, axis=0)


def unrolled(
    frames: Frames, owner: np.ndarray, points: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Take points along the edge's bend into the planes of the sections that own them.

    Parameters
    ----------
    owner : (n,) section of each point
    points : (n, 3) array, mm

    Returns
    -------
    along : (n,) mm, arc length along the edge from the section
    offset : (n, 3) mm, from the section's origin; its part along the tangent is left in
    before_centre : (n,) bool, False beyond the edge's centre of curvature, where the sections
        cross each other
    """
    bend = np.linalg.norm(frames.bend, axis=1)
    inward = (frames.bend / np.maximum(bend, 1e-300)[:, None]).take(owner, axis=0)
    offset = points - frames.origin.take(owner, axis=0)
    ahead = np.einsum("ni,ni->n", offset, frames.tangent.take(owner, axis=0))
    kappa = bend.take(owner)
    within = np.einsum("ni,ni->n", offset, inward)
    to_centre = 1.0 - kappa * within
    distance = np.hypot(to_centre, kappa * ahead)
    # Offset across the edge after unrolling it: (1 − distance)/κ, written so that κ → 0 is exact.
    flat = (2.0 * within - kappa * (within**2 + ahead**2)) / (1.0 + distance)
    offset = offset + (flat - within)[:, None] * inward
    with np.errstate(invalid="ignore", divide="ignore"):
        along = np.where(kappa > 1e-9, np.arctan2(kappa * ahead, to_centre) / kappa, ahead)
    return along, offset, to_centre > 0.2


def section_points(
    frames: Frames, owner: np.ndarray, index: np.ndarray, points: np.ndarray
) -> SectionPoints:
    """Coordinates of points in the sections that own them.

    Points beyond the edge's centre of curvature, where the sections cross each other, are left
    out.

    Parameters
    ----------
    owner : (n,) section of each point
    index : (n,) index of each point in the cloud
    points : (n, 3) array, mm
    """
    along, offset, before_centre = unrolled(frames, owner, points)
    away = np.einsum("nki,ni->nk", frames.sides.take(owner, axis=0), offset)
    side = (away[:, 1] > away[:, 0]).astype(np.int64)
    normal = frames.normals.reshape(-1, 3).take(2 * owner + side, axis=0)
    height = np.einsum("ni,ni->n", normal, offset)
    result = SectionPoints(index, owner, along, side, np.maximum(*away.T), height)
    return result if before_centre.all() else result[before_centre]


@dataclass(frozen=True)
class Station:
    """One edge point of the walk, before the whole edge is measured together.

    Attributes
    ----------
    frame : one section that stands on the edge point
    sigma : standard deviation of the edge point, mm
    noise : noise met on the two sides, mm
    begins, ends : (2,) distance from the edge where each side's support begins and ends, mm
    cover : how much of the two sides' points the fits explain, 0 … 1
    stop : why no edge point could be measured here; None when there is one
    step : length of the step that led here, mm; nan at the first station
    surprise : how far it is beside where the step was to lead, beyond what noise explains, in
        steps, or half the angle by which its sides are turned otherwise, rad, if that is more
    line : what a probe touched here, when one did
    """

    frame: Frames
    sigma: float = np.nan
    noise: float = np.nan
    begins: tuple[float, float] = (np.nan, np.nan)
    cover: float = 1.0
    stop: Stop | None = None
    step: float = np.nan
    surprise: float = np.nan
    line: ProbedLine | None = None
    ends: tuple[float, float] = (np.nan, np.nan)


class Section(Protocol):
    """How the edge points of a walk are obtained."""

    def measure(self, predicted: Frames, half_width: np.ndarray, last: Station) -> list[Station]:
        """Measure an edge point near each predicted section; a failure is a station with a stop.

        Parameters
        ----------
        predicted : m sections; only one where a machine touches the part
        half_width : (m,) mm to both sides of them along the edge, to take points from
        last : the station before
        """
        ...

    def ending(self, last: Station, stop: Stop) -> Stop:
        """Tell why a walk that stopped after the last station came to its end."""
        ...
