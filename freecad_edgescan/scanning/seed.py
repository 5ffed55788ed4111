# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a click near an edge to the first section on it.

Around the click, in growing balls, the normals of the cloud are gathered into the directions most
points share; each pair of directions proposes two sides, whose planes meet in a proposed edge.
A proposal counts only when the patch measurement itself confirms it: two smooth sides, fitted
without their rounding, that meet at an angle near the click.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from ..cloud.point_cloud import PointCloud
from .evened import one_per_cell
from .gait import jumped, predict
from .patch_section import PatchSection, PatchSettings
from .section import Frames, Station, frames_from_sides
from .shared_planes import normals_of, shared_planes

_BALLS = (4.0, 6.0, 9.0, 14.0, 20.0, 30.0)  # radii round the click, in pitches
_NEAR = 6.0  # pitches besides a rounding: a click farther off does not mean this edge
_LARGEST_SIGMA = 0.5  # pitches
_GROWTH = 1.7  # of the reach, from one measurement to the next


@dataclass(frozen=True)
class Seed:
    """The first station of an edge.

    Attributes
    ----------
    station : it
    reach : the one that knows it best, mm
    spacing : of the points along the edge, mm; see `PatchSettings`
    """

    station: Station
    reach: float
    spacing: float


def find_seed(
    cloud: PointCloud,
    at: np.ndarray,
    settings: PatchSettings,
    along: np.ndarray | None = None,
    within: float | None = None,
) -> Seed | None:
    """First station of an edge near a click, or None where no two sides meet.

    Parameters
    ----------
    at : (3,) the click, mm
    settings : its reach is the largest one to use, and a given one is used in any case
    along : (3,) unit vector; only edges within 40° of it count, and it gives the direction
    within : largest distance of the edge from the click, mm; by default a few pitches besides
        what a rounding takes
    """
    found = []
    for ball in _BALLS:
        radius = ball * settings.cloud_pitch
        tried: list[Frames] = []
        for frame in proposals(cloud, at, radius, settings.min_angle):
            if not any(_alike(frame, other) for other in tried):
                tried.append(frame)
        # Whoever gives a start knows that there is an edge.
        shortest, patient = max(radius, 8.0 * settings.cloud_pitch), along is not None
        for seed in _measured_growing(cloud, tried, shortest, settings, patient):
            confirmed = _confirmed(seed, at, settings, along, within)
            if confirmed is not None:
                found.append(confirmed)
    # Small balls also propose tangent planes of a rounding; their edges are poorly known.
    found.sort(key=lambda seed: _doubt(seed.station, at, settings))
    return next((seed for seed in found if _goes_on(cloud, seed, settings)), None)


def nearest_seed(
    cloud: PointCloud, at: np.ndarray, settings: PatchSettings, radius: float
) -> Seed | None:
    """The nearest place round a click where an edge can be found, to tell the user."""
    index = np.array(cloud.tree.query_ball_point(at, radius), dtype=np.int64)
    if len(index) < 30:
        return None
    rng = np.random.default_rng(0)
    sample = rng.choice(index, size=min(len(index), 600), replace=False)
    balls = cloud.tree.query_ball_point(cloud.points[sample], 5.0 * settings.cloud_pitch)
    flatness = np.array([_thickness(cloud.points[ball]) for ball in balls])
    sharp = sample[flatness > 2.0 * settings.noise + 0.15 * settings.cloud_pitch]
    order = np.argsort(np.linalg.norm(cloud.points[sharp] - at, axis=1))
    for candidate in sharp[order[:12]]:
        seed = find_seed(cloud, cloud.points[candidate], settings)
        if seed is not None:
            return seed
    return None


def proposals(cloud: PointCloud, at: np.ndarray, radius: float, min_angle: float) -> list[Frames]:
    """Sections proposed by the pairs of directions that most normals share."""
    index = np.array(cloud.tree.query_ball_point(at, radius), dtype=np.int64)
    if len(index) < 12:
        return []
    points = one_per_cell(cloud.points[index], radius / 8.0)
    normals = normals_of(cloud, points)
    weight = np.exp(-np.square(np.linalg.norm(points - at, axis=1) / (0.6 * radius)))
    planes = shared_planes(points, normals, weight, min_angle)
    frames = []
    for (normal_a, centre_a), (normal_b, centre_b) in combinations(planes, 2):
        tangent = np.cross(normal_a, normal_b)
        size = np.linalg.norm(tangent)
        if size < np.sin(0.5 * min_angle):
            continue
        tangent /= size
        origin = np.linalg.solve(
            np.array([normal_a, normal_b, tangent]),
            np.array([normal_a @ centre_a, normal_b @ centre_b, tangent @ at]),
        )
        if np.linalg.norm(origin - at) > radius:
            continue
        sides = np.array([np.cross(tangent, normal_a), np.cross(tangent, normal_b)])
        for k, centre in enumerate((centre_a, centre_b)):
            sides[k] *= 1.0 if (centre - origin) @ sides[k] >= 0 else -1.0
        frames.append(frames_from_sides(origin[None], tangent[None], sides[None]))
    return frames


def _confirmed(
    seed: Seed,
    at: np.ndarray,
    settings: PatchSettings,
    along: np.ndarray | None,
    within: float | None,
) -> Seed | None:
    """A measured seed that is an edge near the click, turned along; None where it is not."""
    station, found = seed.station, seed.station.frame
    if found.turn[0] < settings.min_angle or station.sigma > _LARGEST_SIGMA * settings.cloud_pitch:
        return None
    if _gap(station, at) > (within or _NEAR * settings.cloud_pitch + max(station.begins)):
        return None
    if along is not None:
        if abs(float(found.tangent[0] @ along)) < np.cos(np.radians(40.0)):
            return None
        if float(found.tangent[0] @ along) < 0:
            station = replace(station, frame=found.backward())
    return replace(seed, station=station)


def _measured_growing(
    cloud: PointCloud,
    proposed: Sequence[Frames],
    reach: float,
    settings: PatchSettings,
    patient: bool,
) -> list[Seed]:
    """Measure proposed sections with growing reach, each time knowing the shape better.

    Of each at which there is an edge, the best known one is kept. A short look at a wide rounding
    sees no edge at all; a patient one goes on from there.
    """
    frames, best = dict(enumerate(proposed)), dict[int, Seed]()
    while frames:
        reach = min(reach, settings.reach)
        section = PatchSection(cloud, settings.with_reach(reach))
        together = Frames.join(list(frames.values()))
        spacing = section.spacing(together)
        measured = section.settle(together, np.maximum(settings.half_width, spacing))
        for k, station, apart in zip(list(frames), measured, spacing, strict=True):
            if station.stop is None:
                if k not in best or station.sigma < 1.1 * best[k].station.sigma:
                    best[k] = Seed(station, reach, float(apart))
                frames[k] = station.frame
            elif k not in best and not patient:
                del frames[k]
        if reach >= settings.reach:
            break
        reach *= _GROWTH
    return [best[k] for k in sorted(best)]


def _doubt(station: Station, at: np.ndarray, settings: PatchSettings) -> float:
    """How badly an edge is known, how little of its sides it explains, how far it lies.

    A click on a rounding lies away from the sharp edge by as much as the rounding takes, and a
    rounding takes away from both sides.
    """
    excess = max(_gap(station, at) - 0.8 * min(station.begins), 0.0)
    return station.sigma * (1.0 + excess / settings.cloud_pitch) / station.cover**2


def _goes_on(cloud: PointCloud, seed: Seed, settings: PatchSettings) -> bool:
    """Whether the edge can be followed for a step, one way or the other."""
    settings = replace(settings, reach=seed.reach, spacing=seed.spacing)
    section = PatchSection(cloud, settings)
    frame, pitch = seed.station.frame, settings.edge_pitch
    both_ways = predict(Frames.join([frame, frame.backward()]), pitch)
    ahead = section.settle(both_ways, np.full(2, settings.half_width))
    return any(
        not (measured.stop or jumped(seed.station, both_ways[k], measured, pitch))
        for k, measured in enumerate(ahead)
    )


def _gap(station: Station, at: np.ndarray) -> float:
    """Distance of the click from the edge's tangent line, mm."""
    offset = at - station.frame.origin[0]
    return float(np.linalg.norm(np.cross(offset, station.frame.tangent[0])))


def _alike(one: Frames, other: Frames) -> bool:
    """Whether two proposals would lead to the same measurement."""
    same = np.einsum("ki,ki->k", one.sides[0], other.sides[0])
    crossed = np.einsum("ki,ki->k", one.sides[0], other.sides[0, ::-1])
    return bool(max(same.min(), crossed.min()) > np.cos(0.1))


def _thickness(points: np.ndarray) -> float:
    """Standard deviation of points about their plane, mm."""
    if len(points) < 6:
        return 0.0
    spread = points - points.mean(axis=0)
    return float(np.sqrt(max(np.linalg.eigvalsh(spread.T @ spread)[0], 0.0) / len(points)))
