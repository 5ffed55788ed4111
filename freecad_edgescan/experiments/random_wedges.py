# SPDX-License-Identifier: LGPL-2.1-or-later
"""A search for confident wrong edges: wedges at random, spoilt at random, one click on each.

A scan may refuse, and may know an edge badly; it must not state a small sigma for an edge that is
somewhere else. The measure is the Mahalanobis distance of each edge point: how far off it is across
the edge, in the standard deviations that the scan states.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from ..cloud import PointCloud
from ..geometry import Line
from ..scanning import Progress, ScanError, scan_edge
from ..scanning.corner import across_axes
from .collecting import collect
from .processes import Failure

__all__ = ["SPOILT", "Judged", "RandomWedge", "judge", "make_wedge", "search", "wedge_table"]

# What is done to a cloud, besides noise.
SPOILT = ("nothing", "outliers", "quantised", "duplicates", "gap", "thinned")

# A scan is wrong when more than this share of its points, or one point, or the root mean square
# of all is farther off than so many of its own standard deviations.
_SHARE, _OFF, _FAR_OFF, _RMS = 0.02, 4.0, 7.0, 2.5


@dataclass(frozen=True)
class RandomWedge:
    """Two flat sides that meet in the x axis, turned and moved; lengths in pitches of the cloud.

    Attributes
    ----------
    number : of the wedge; the same one is the same wedge
    pitch : mm
    angle : between the sides, rad
    noise, rounding, width, length : of the cloud, the edge, each flat side and the edge
    spoilt : what was done to the cloud
    """

    number: int
    pitch: float
    angle: float
    noise: float
    rounding: float
    width: float
    length: float
    spoilt: str

    def __str__(self) -> str:
        return (
            f"wedge {self.number}: {np.degrees(self.angle):.0f}°, pitch {self.pitch:.3g} mm, noise "
            f"{self.noise:g}, rounding {self.rounding:.1f}, sides {self.width:.1f}, length "
            f"{self.length:.0f} pitches, {self.spoilt}"
        )


@dataclass(frozen=True)
class Judged:
    """What a scan of one wedge states, held against the truth.

    Attributes
    ----------
    wedge : it
    distances : (m,) Mahalanobis distances; none where the scan refused
    errors : (m,) pitches, distances from the edge
    """

    wedge: RandomWedge
    distances: np.ndarray
    errors: np.ndarray

    @property
    def refused(self) -> bool:
        """Whether the scan found no edge."""
        return len(self.distances) == 0

    @property
    def wrong(self) -> bool:
        """Whether the edge is farther off than the scan states."""
        if self.refused:
            return False
        off, rms = self.distances > _OFF, np.sqrt(np.mean(self.distances**2))
        return bool(off.mean() > _SHARE or self.distances.max() > _FAR_OFF or rms > _RMS)

    @property
    def elsewhere(self) -> bool:
        """Whether most of it is off by more than four standard deviations."""
        return not self.refused and bool(np.median(self.distances) > _OFF)

    def line(self) -> str:
        """One line of text; only of an edge that was found."""
        return (
            f"{self.wedge}: {len(self.distances)} edge points, "
            f"{(self.distances > _OFF).mean():.0%} beyond {_OFF:g}, largest "
            f"{self.distances.max():.1f}, up to {self.errors.max():.2g} pitches off"
        )


def make_wedge(number: int, rounded: bool) -> tuple[RandomWedge, PointCloud, np.ndarray, Line]:
    """A wedge, its cloud, a click near its edge (3,) mm, and the edge.

    Parameters
    ----------
    number : of the wedge
    rounded : whether half of the wedges have a rounding of up to six pitches
    """
    rng = np.random.default_rng([number, 99])
    wedge = RandomWedge(
        number=number,
        pitch=float(10.0 ** rng.uniform(-1.0, 1.0)),
        angle=float(np.radians(rng.uniform(30.0, 165.0))),
        noise=float(rng.choice([0.02, 0.05, 0.1, 0.2, 0.3])),
        rounding=float(rng.choice([0.0, rng.uniform(0.5, 6.0)])) if rounded else 0.0,
        width=float(rng.uniform(6.0, 25.0)),
        length=float(rng.uniform(15.0, 40.0)),
        spoilt=str(rng.choice(SPOILT)),
    )
    points = _spoilt(_points(wedge, rng), wedge, rng)
    click = np.append(rng.uniform(-0.3, 0.3) * wedge.length, [0.0, 0.0]) + rng.normal(size=3)
    turned = Rotation.random(random_state=rng.integers(2**31))
    place = 10.0 * rng.normal(size=3)
    cloud = PointCloud((turned.apply(points) + place) * wedge.pitch)
    edge = Line(place * wedge.pitch, turned.apply([1.0, 0.0, 0.0]))
    return wedge, cloud, (turned.apply(click) + place) * wedge.pitch, edge


def _points(wedge: RandomWedge, rng: np.random.Generator) -> np.ndarray:
    """Noisy points (n, 3) of both sides and the rounding, in pitches, the edge on the x axis."""
    half = 0.5 * wedge.angle
    touching = wedge.rounding / np.tan(half)
    parts = []
    for sign in (1.0, -1.0):
        side = np.array([0.0, sign * np.sin(half), -np.cos(half)])
        out = np.array([0.0, sign * np.cos(half), np.sin(half)])
        x, s = _scattered(rng, wedge.length, wedge.width)
        height = wedge.noise * rng.normal(size=len(x))
        flat = (touching + s)[:, None] * side + height[:, None] * out
        parts.append(flat + x[:, None] * [1.0, 0.0, 0.0])
    if wedge.rounding:
        span = np.pi - wedge.angle
        x, arc = _scattered(rng, wedge.length, wedge.rounding * span)
        turn = arc / wedge.rounding - 0.5 * span
        radius = wedge.rounding + wedge.noise * rng.normal(size=len(x))
        y, z = radius * np.sin(turn), radius * np.cos(turn) - wedge.rounding / np.sin(half)
        parts.append(np.column_stack([x, y, z]))
    return np.vstack(parts) - [0.5 * wedge.length, 0.0, 0.0]


def _scattered(
    rng: np.random.Generator, length: float, width: float
) -> tuple[np.ndarray, np.ndarray]:
    """One point at random in each cell of a grid of about one pitch."""
    n, m = max(round(length), 1), max(round(width), 1)
    i, j = np.indices((n, m)).reshape(2, -1)
    return (i + rng.random(n * m)) * length / n, (j + rng.random(n * m)) * width / m


def _spoilt(points: np.ndarray, wedge: RandomWedge, rng: np.random.Generator) -> np.ndarray:
    if wedge.spoilt == "outliers":  # 5 % of the points, up to ten pitches off
        few = rng.choice(len(points), len(points) // 20, replace=False)
        points[few] += rng.uniform(-10.0, 10.0, (len(few), 3))
    if wedge.spoilt == "quantised":
        points = np.round(points, 1)
    if wedge.spoilt == "duplicates":
        points = np.vstack([points, points[rng.random(len(points)) < 0.5]])
    if wedge.spoilt == "gap":  # across the edge, two to eight pitches wide
        middle, half = rng.uniform(-0.3, 0.3) * wedge.length, rng.uniform(1.0, 4.0)
        points = points[np.abs(points[:, 0] - middle) > half]
    if wedge.spoilt == "thinned":
        points = points[rng.random(len(points)) < 0.5]
    return points


def judge(task: tuple[int, bool]) -> Judged:
    """Scan one wedge, by its number and whether it may be rounded, from one click."""
    wedge, cloud, click, truth = make_wedge(*task)
    try:
        edge = scan_edge(cloud, at=click)
    except ScanError:
        return Judged(wedge, np.zeros(0), np.zeros(0))
    off = truth.residuals(edge.points)
    seen = np.einsum("mai,mi->ma", across_axes(edge.normals), off)
    inverse = np.linalg.inv(edge.covariance)
    distances = np.sqrt(np.einsum("ma,mab,mb->m", seen, inverse, seen))
    return Judged(wedge, distances, np.linalg.norm(off, axis=1) / wedge.pitch)


def search(
    count: int,
    rounded: bool = True,
    first: int = 0,
    jobs: int = 2,
    progress: Progress | None = None,
) -> list[Judged]:
    """Scan wedges at random; those that were scanned so far when `progress` cancels.

    Parameters
    ----------
    count : of the wedges
    rounded : whether half of them have a rounding
    first : number of the first one
    jobs : number of processes
    progress : told the share of wedges done

    Raises
    ------
    RuntimeError: a scan has failed with something else than a refusal, which is always a fault.
    """
    tasks = [(number, rounded) for number in range(first, first + count)]
    found = collect(judge, tasks, jobs, progress, lambda done: f"{len(done)} wedges")
    judged = []
    for number, answer in sorted(found.items(), key=lambda item: item[0]):
        if isinstance(answer, Failure):
            raise RuntimeError(f"wedge {tasks[number][0]}: {answer.text}")
        judged.append(answer)
    return judged


def wedge_table(found: Sequence[Judged]) -> str:
    """Each wedge whose edge is wrong, and a summary of all."""
    scanned = [judged for judged in found if not judged.refused]
    lines = [judged.line() for judged in scanned if judged.wrong]
    if scanned:
        all_of_them = np.concatenate([judged.distances for judged in scanned])
        middle, most = np.percentile(all_of_them, [50, 95])
        lines.append(
            f"Distance of edge points in the standard deviations the scan states: median "
            f"{middle:.2f}, 95 % {most:.2f} (true ones: 1.18, 2.45)."
        )
    wrong, elsewhere = (
        sum(getattr(judged, name) for judged in scanned) for name in ("wrong", "elsewhere")
    )
    lines.append(
        f"{len(found)} wedges: {len(found) - len(scanned)} refused, {wrong} farther off than "
        f"stated, {elsewhere} of these somewhere else."
    )
    return "\n".join(lines)
