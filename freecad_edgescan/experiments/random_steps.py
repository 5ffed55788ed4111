# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two edges beside each other at random, sharp or rounded, with a narrow land between them.

A rounding beside a land of one to eight pitches looks much like a side, and a land between two wide
faces is easily overlooked. Such places tempt to state a wrong edge.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from ..cloud import PointCloud
from ..geometry import Line

__all__ = ["RandomStep", "StepEdges", "make_step"]

_FLATTEST = np.radians(170.0)  # turn of both edges together, beyond which the faces do not meet


@dataclass(frozen=True)
class RandomStep:
    """Three flat faces along an axis, turned and moved; lengths in pitches of the cloud.

    Attributes
    ----------
    number : of the step; the same one is the same step
    pitch : mm
    turns : of the two edges, rad; a step up and down again has turns of both signs
    roundings : radii of the two edges, 0 where one is sharp
    land, first, last : widths of the flat part between the edges and of the faces beside them
    noise, length : of the cloud, and of the edges
    """

    number: int
    pitch: float
    turns: tuple[float, float]
    roundings: tuple[float, float]
    land: float
    first: float
    last: float
    noise: float
    length: float

    def __str__(self) -> str:
        turns, roundings = (
            " and ".join(f"{value:.{digits}f}" for value in values)
            for values, digits in ((np.degrees(self.turns), 0), (self.roundings, 1))
        )
        return (
            f"step {self.number}: turns of {turns}°, pitch {self.pitch:.3g} mm, noise "
            f"{self.noise:g}, roundings {roundings}, land {self.land:.1f}, length "
            f"{self.length:.0f} pitches"
        )


@dataclass(frozen=True)
class StepEdges:
    """The lines in which the drawn-out faces of a step meet."""

    lines: tuple[Line, ...]

    def residuals(self, points: np.ndarray) -> np.ndarray:
        """Vectors (m, 3) from that line which is the nearest one to most of the points (m, 3)."""
        found = np.array([line.residuals(points) for line in self.lines])
        nearest = np.argmin(np.median(np.linalg.norm(found, axis=2), axis=1))
        return np.asarray(found[nearest])


def make_step(number: int, sample: int = 0) -> tuple[RandomStep, PointCloud, np.ndarray, StepEdges]:
    """A step, its cloud, a click near one of its edges (3,) mm, and the edges.

    Where both edges turn to the same side, the land is a chamfer, and the edge that it has taken
    away counts as one of them.

    Parameters
    ----------
    number : of the step
    sample : of its points; another one is another scan of the same step
    """
    rng = np.random.default_rng([number, 77])
    turns = rng.choice([-1.0, 1.0], 2) * np.radians(rng.uniform(35.0, 120.0, 2))
    if abs(turns.sum()) > _FLATTEST:  # no rib that is open below
        turns[1] *= -1.0
    roundings = [float(rng.choice([0.0, rng.uniform(0.5, 6.0)])) for _ in turns]
    step = RandomStep(
        number=number,
        pitch=float(10.0 ** rng.uniform(-1.0, 1.0)),
        turns=(float(turns[0]), float(turns[1])),
        roundings=(roundings[0], roundings[1]),
        land=float(rng.uniform(1.0, 8.0)),
        first=float(rng.uniform(10.0, 25.0)),
        last=float(rng.uniform(10.0, 25.0)),
        noise=float(rng.choice([0.01, 0.02, 0.05, 0.1, 0.2])),
        length=float(rng.uniform(30.0, 60.0)),
    )
    clicked = int(rng.integers(2))
    if sample:
        rng = np.random.default_rng([number, 77, sample])
    profile, edges, rounded_away = _drawn(step)
    x, section = _scanned(step, profile, rng)
    points = np.column_stack([x, section.real, section.imag])
    place = edges[clicked] + rounded_away[clicked]
    click = np.array([rng.uniform(-0.3, 0.3) * step.length, place.real, place.imag])
    click += 0.7 * rng.normal(size=3)
    turned = Rotation.random(random_state=rng.integers(2**31))
    moved = 10.0 * rng.normal(size=3)
    lines = tuple(
        Line(
            (turned.apply([0.0, edge.real, edge.imag]) + moved) * step.pitch,
            turned.apply([1.0, 0.0, 0.0]),
        )
        for edge in edges
    )
    cloud = PointCloud((turned.apply(points) + moved) * step.pitch)
    return step, cloud, (turned.apply(click) + moved) * step.pitch, StepEdges(lines)


@dataclass(frozen=True)
class _Piece:
    """A piece of the section: where it begins, its direction there, length and curvature.

    Places and directions are complex numbers, lengths pitches.
    """

    start: complex
    direction: complex
    length: float
    curvature: float = 0.0

    def at(self, s: np.ndarray | float) -> tuple[np.ndarray, np.ndarray]:
        """Places and directions at some lengths along it."""
        turned = np.exp(1j * self.curvature * np.asarray(s))
        if self.curvature:
            way = (turned - 1.0) / (1j * self.curvature)
        else:
            way = np.asarray(s, dtype=complex)
        return self.start + self.direction * way, self.direction * turned


def _drawn(step: RandomStep) -> tuple[list[_Piece], list[complex], list[complex]]:
    """Pieces of the section, the edges, and from each of two to where its rounding lies."""
    place, direction = complex(-step.first), 1.0 + 0.0j
    pieces, edges, rounded_away = [], [], []

    def go(length: float, curvature: float = 0.0) -> None:
        nonlocal place, direction
        pieces.append(_Piece(place, direction, length, curvature))
        ends, ways = pieces[-1].at(length)
        place, direction = complex(ends), complex(ways)

    go(step.first)
    for turn, radius, onward in zip(
        step.turns, step.roundings, (step.land, step.last), strict=True
    ):
        half = abs(turn) / 2.0
        edges.append(place + radius * np.tan(half) * direction)
        inward = direction * np.exp(0.5j * turn) * 1j * np.sign(turn)
        rounded_away.append(inward * radius * (1.0 / np.cos(half) - 1.0))
        if radius:
            go(radius * abs(turn), np.sign(turn) / radius)
        else:
            direction *= np.exp(1j * turn)
        go(onward)
    if step.turns[0] * step.turns[1] > 0.0:
        # Where the first face and the last one meet: along the real axis.
        edges.append(edges[1] - direction * (edges[1].imag / direction.imag))
    return pieces, edges, rounded_away


def _scanned(
    step: RandomStep, pieces: list[_Piece], rng: np.random.Generator
) -> tuple[np.ndarray, np.ndarray]:
    """Points along the edges (n,) and in the section (n,), one for each square pitch."""
    along, section = [], []
    for piece in pieces:
        rows, columns = round(step.length), max(round(piece.length), 1)
        i, j = np.indices((rows, columns)).reshape(2, -1)
        wanted = rng.random(len(i)) < piece.length / columns
        i, j = i[wanted], j[wanted]
        x, s = i + rng.random(len(i)), (j + rng.random(len(j))) * piece.length / columns
        place, direction = piece.at(s)
        along.append(x * step.length / rows - 0.5 * step.length)
        section.append(place + step.noise * rng.normal(size=len(s)) * 1j * direction)
    return np.concatenate(along), np.concatenate(section)
