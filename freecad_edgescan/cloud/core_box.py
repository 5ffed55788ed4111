# SPDX-License-Identifier: LGPL-2.1-or-later
"""The core box of the published case study (Schreve chapter 7), in dimensions of our own.

Two half-pipes are sunk into the split plane z = 0 of a block and bend by a right angle. It is
scanned the way the study's machine did it: lines parallel to y, a pitch apart in the plane, points
at most a pitch apart along each line. Where the pipes cross the lines their walls are dense; where
they run along the lines, neighbouring lines leave gaps of up to 4 mm in the walls. The cloud holds
the centres of the ball. The part goes on beyond the scanned window, so that its outer sides are
not in the cloud.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from .half_pipe import SIDES, HalfPipe
from .simulated_cloud import SimulatedCloud, add_noise
from .true_edge import TrueEdge

__all__ = ["CoreBox"]

Array = NDArray[np.float64]

# x, y, radius of the control points. The y of pipe 1 makes the narrowest land 3.0000 mm wide.
PIPE_1 = (
    *((-60, 147.8349, 19.5), (-10, 147.8349, 19.5), (40, 147.8349, 19.5), (90, 147.8349, 19.5)),
    *((140, 149.8349, 19.3), (190, 151.8349, 18.9), (235, 148.8349, 18.3), (275, 138.8349, 17.7)),
    *((302, 113.8349, 17.3), (315, 79.8349, 17.1), (318, 44.8349, 17.0)),
    *((318, 14.8349, 17.0), (318, -15.1651, 17.0), (318, -45.1651, 17.0)),
)
PIPE_2 = (
    *((-60, 50, 19.5), (-10, 50, 19.5), (40, 50, 19.5), (85, 52, 19.5), (125, 68, 19.2)),
    *((165, 94, 18.8), (204, 111.5, 18.3), (244, 110.5, 17.8), (267.5, 88.5, 17.4)),
    *((273, 56, 17.1), (270, 22, 17.0), (270, -5, 17.0), (270, -30, 17.0), (270, -55, 17.0)),
)
SMALL_PIPE = (
    *((-24, 33, 8.0), (-8, 33, 8.0), (8, 33, 8.0), (20, 33, 7.8), (34, 34, 7.5), (48, 27, 7.2)),
    *((52, 12, 7.0), (52, 0, 7.0), (52, -12, 7.0), (52, -24, 7.0)),
)
LARGEST_ROUNDING = 1.4  # mm; two of them still leave a land between the pipes
EVEN_SHARE = 0.98  # of the pitch: what steps along a line are meant to be
EDGE_STEP = 0.025  # mm, between the samples of a rim: a chord error below 1e-5 mm
ROOM_SAMPLES = 20  # one in so many samples measures the room; between them it is interpolated
END_MARGIN = 8.0  # mm of rim between the window's border and a start or gate
APPROACH = (0.0, 0.0, -1.0)


@dataclass(frozen=True)
class CoreBox:
    """Half-pipes sunk into a plane, scanned along lines by a ball that comes down.

    Parameters
    ----------
    rim_radius : mm, of the rims' rounding, up to 1.4; 0 for sharp rims
    probe_radius : R_p, mm, of the ball; the study's was 2.011 mm in diameter
    size : mm, of the scanned window in x and y, which begins at (0, 0)
    pipes : the half-pipes; each enters the window at x = 0 and leaves it at y = 0

    Raises
    ------
    ValueError: a rim or probe radius outside its range.
    """

    rim_radius: float = 0.0
    probe_radius: float = 1.0055
    size: tuple[float, float] = (350.0, 190.0)
    pipes: tuple[HalfPipe, ...] = (HalfPipe(PIPE_1), HalfPipe(PIPE_2))

    def __post_init__(self) -> None:
        if not 0.0 <= self.rim_radius <= LARGEST_ROUNDING:
            raise ValueError(
                f"The rim radius is {self.rim_radius} mm; give one from 0 to {LARGEST_ROUNDING} "
                "mm, so that the narrowest land keeps a flat part."
            )
        narrowest = min(float(pipe.spine.c[:, 2].min()) for pipe in self.pipes)
        if not 0.0 <= self.probe_radius < narrowest:
            raise ValueError(
                f"The probe radius is {self.probe_radius} mm; give one from 0 to below the "
                f"{narrowest:g} mm of the narrowest pipe."
            )

    @classmethod
    def small(cls, rim_radius: float = 0.0, probe_radius: float = 1.0055) -> CoreBox:
        """A box with one pipe of radius 8 to 7 mm and two rims, for quick tries."""
        return cls(rim_radius, probe_radius, (68.0, 48.0), (HalfPipe(SMALL_PIPE),))

    @property
    def face_names(self) -> tuple[str, ...]:
        """Names of the labels: the plane, the pipes' walls, the ball rolling round the rims."""
        pipes = tuple(f"pipe {k + 1}" for k in range(len(self.pipes)))
        return ("plane", *pipes, *(f"rim {k + 1}" for k in range(2 * len(self.pipes))))

    @cached_property
    def edges(self) -> tuple[TrueEdge, ...]:
        """The sharp rims within the window: left and right of each pipe, in its direction."""
        rims = [self._rim(pipe, side) for pipe in self.pipes for side in SIDES]
        trees = [cKDTree(points) for points, _ in rims]
        edges = []
        for k, (points, tangents) in enumerate(rims):
            few = np.arange(0, len(points), ROOM_SAMPLES)
            others = [tree.query(points[few])[0] for tree in trees[:k] + trees[k + 1 :]]
            edges.append(
                TrueEdge(
                    f"rim {k + 1}",
                    np.column_stack([points, np.zeros(len(points))]),
                    np.column_stack([tangents, np.zeros(len(points))]),
                    np.asarray(np.pi / 2),
                    convex=True,
                    room=np.interp(np.arange(len(points)), few, np.min(others, axis=0)),
                )
            )
        return tuple(edges)

    def cloud(
        self, pitch: float = 0.5, noise: float = 0.05, seed: int | Sequence[int] = 0
    ) -> SimulatedCloud:
        """The ball's centres where it touches the part, line by line.

        Parameters
        ----------
        pitch : float
            Of the lines in x, and the largest distance of two points along a line, mm.
        noise : float
            Level η, mm: each coordinate gets an independent uniform error in [-η, η].
        seed : int or sequence of int
            Anything ``numpy.random.default_rng`` takes.

        Raises
        ------
        ValueError: a pitch that is not positive, or a negative noise.
        """
        if not 0.0 < pitch < min(self.size):
            raise ValueError(
                f"The pitch is {pitch} mm; give a positive number below the box's size."
            )
        points, labels = self._scan_lines(pitch)
        return SimulatedCloud(
            add_noise(points, noise, seed),
            labels,
            self.face_names,
            self.edges,
            self.probe_radius,
            APPROACH,
        )

    def touch(self, places: Array) -> tuple[Array, NDArray[np.intp]]:
        """Height of the ball that comes down over places (n, 2), and the label it touches."""
        height = np.full(len(places), self.probe_radius)
        label = np.zeros(len(places), dtype=np.intp)
        for k, pipe in enumerate(self.pipes):
            touch = pipe.touch(places, self.probe_radius, self.rim_radius)
            names = np.array([0, 1 + k, 1 + len(self.pipes) + 2 * k, 2 + len(self.pipes) + 2 * k])
            touched = touch.part > 0
            height[touched] = touch.height[touched]
            label[touched] = names[touch.part[touched]]
        return height, label

    def starts(self, amplitude: float) -> tuple[tuple[Array, Array, Array], ...]:
        """For each rim where a scan starts: point, direction across and direction along.

        The point lies on the plane, half an amplitude from the rim; across leads to the pipe.
        """
        return tuple(
            self._beside(k, amplitude, END_MARGIN / edge.length)
            for k, edge in enumerate(self.edges)
        )

    def gates(self, amplitude: float) -> tuple[tuple[Array, Array], ...]:
        """For each rim where a scan ends: point and direction across, like those of the starts."""
        return tuple(
            self._beside(k, amplitude, 1 - END_MARGIN / edge.length)[:2]
            for k, edge in enumerate(self.edges)
        )

    def _beside(self, k: int, amplitude: float, share: float) -> tuple[Array, Array, Array]:
        """Point on the plane half an amplitude beside rim k, at a share of its length."""
        if not 0.0 < amplitude < np.inf:
            raise ValueError(f"The amplitude is {amplitude} mm; give a positive number.")
        edge = self.edges[k]
        at = round(share * (len(edge) - 1))
        tangent = edge.tangents[at]
        across = SIDES[k % 2] * np.array([tangent[1], -tangent[0], 0.0])
        point = edge.points[at] - amplitude / 2 * across
        return point + np.array([0.0, 0.0, self.probe_radius]), across, tangent

    def _rim(self, pipe: HalfPipe, side: float) -> tuple[Array, Array]:
        """Evenly spaced points (m, 2) and tangents (m, 2) of a rim within the window."""
        u = pipe.parameters
        fine = np.interp(np.arange(0, len(u) - 1, 0.25), np.arange(len(u)), u)
        points = pipe.rim(fine, side)[0]
        length = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
        first, last = np.flatnonzero((points >= 0.0).all(axis=1))[[0, -1]]
        count = int(np.ceil((length[last] - length[first]) / EDGE_STEP)) + 1
        even = np.linspace(length[first], length[last], count)
        return pipe.rim(np.interp(even, length, fine), side)[:2]

    def _scan_lines(self, pitch: float) -> tuple[Array, NDArray[np.intp]]:
        """Centres and labels, line by line, in even steps of at most a pitch along each line."""
        lines, rows = (int(extent / pitch) + 1 for extent in self.size)
        line = np.repeat(np.arange(lines), rows)
        path = self._refined(line, np.tile(np.arange(rows) * pitch, lines), pitch)
        path = self._refined(*_evened(*path[:3], EVEN_SHARE * pitch), pitch)
        line, y, z, label = path
        return np.column_stack([line * pitch, y, z]), label

    def _refined(
        self, line: NDArray[np.intp], y: Array, pitch: float
    ) -> tuple[NDArray[np.intp], Array, Array, NDArray[np.intp]]:
        """Line, y, height and label of places along the lines, halved until no step is longer."""
        z, label = self.touch(np.column_stack([line * pitch, y]))
        while True:
            step = np.hypot(np.diff(y), np.diff(z))
            wide = np.flatnonzero((step > pitch * (1 + 1e-9)) & (line[1:] == line[:-1]))
            if len(wide) == 0:
                return line, y, z, label
            middle = (y[wide] + y[wide + 1]) / 2
            height, touched = self.touch(np.column_stack([line[wide] * pitch, middle]))
            y = np.insert(y, wide + 1, middle)
            z = np.insert(z, wide + 1, height)
            label = np.insert(label, wide + 1, touched)
            line = np.insert(line, wide + 1, line[wide])


def _evened(
    line: NDArray[np.intp], y: Array, z: Array, step: float
) -> tuple[NDArray[np.intp], Array]:
    """Line and y of places in even steps along each line's path, none longer than a step."""
    length = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(y), np.diff(z)))])
    first = np.flatnonzero(np.diff(line, prepend=-1))
    last = np.append(first[1:], len(line)) - 1
    extent = length[last] - length[first]
    steps = np.ceil(extent / step).astype(np.intp)
    number = np.repeat(np.arange(len(first)), steps + 1)
    rank = np.arange(len(number)) - np.repeat(np.cumsum(steps + 1) - steps - 1, steps + 1)
    target = length[first][number] + rank * (extent / steps)[number]
    return number, np.interp(target, length, y)
