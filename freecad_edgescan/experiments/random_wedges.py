# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wedges at random, and clouds of them, spoilt at random."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from ..cloud import PointCloud
from ..geometry import Line

__all__ = ["SPOILT", "RandomWedge", "make_wedge"]

# What is done to a cloud, besides noise.
SPOILT = ("nothing", "outliers", "quantised", "duplicates", "gap", "thinned")


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


def make_wedge(
    number: int, rounded: bool, sample: int = 0
) -> tuple[RandomWedge, PointCloud, np.ndarray, Line]:
    """A wedge, its cloud, a click near its edge (3,) mm, and the edge.

    Parameters
    ----------
    number : of the wedge
    rounded : whether half of the wedges have a rounding of up to six pitches
    sample : of its points; another one is another scan of the same wedge
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
    if sample:
        rng = np.random.default_rng([number, 99, sample])
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
