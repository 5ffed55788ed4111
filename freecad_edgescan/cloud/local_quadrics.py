# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quadrics through small neighbourhoods all over a cloud: local normals, noise and bend.

A quadric serves all points of its neighbourhood, so that there are far fewer of them than points.
Each is the graph h(a, b) over the neighbourhood's own plane.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from .progress import Progress
from .thinning import spaced_rows

__all__ = ["FLAT", "LocalQuadrics", "local_quadrics"]

Array = NDArray[np.float64]

SEED_DISTANCE = 0.45  # of the reach, between the middles of neighbourhoods
SEEN = 1e-8  # least of a quadric's terms, relative to the largest, that the points determine
AT_ONCE = 1_000_000  # points of neighbourhoods worked on together
FLAT = 0.012  # of the pitch: what a quadric may leave over where there is no noise
MISFIT = 1.4  # of the noise: likewise, where there is


@dataclass(frozen=True, eq=False)
class LocalQuadrics:
    """Quadrics h = c0 + c1 a + c2 b + c3 a² + c4 ab + c5 b² in frames of their own.

    Attributes
    ----------
    origins : (k, 3) mm
    axes : (k, 3, 3) rows are the unit vectors of a, b and h
    coefficients : (k, 6) mm, 1, 1/mm
    reach : (k,) mm, how far from the origin the points of the neighbourhood are
    rms : (k,) mm, of what the quadric leaves over, for the degrees of freedom it leaves
    """

    origins: Array
    axes: Array
    coefficients: Array
    reach: Array
    rms: Array

    def at(self, rows: NDArray[np.intp], points: Array) -> tuple[Array, Array]:
        """Heights (m,) of points above the quadrics of some rows, and unit normals (m, 3) there.

        Heights are distances: those along h, times the normal's share in it.
        """
        axes = self.axes[rows]
        local = np.einsum("mij,mj->mi", axes, points - self.origins[rows])
        c = self.coefficients[rows].T
        a, b, h = local.T
        slope_a = c[1] + 2.0 * c[3] * a + c[4] * b
        slope_b = c[2] + c[4] * a + 2.0 * c[5] * b
        lift = h - (c[0] + c[1] * a + c[2] * b + c[3] * a * a + c[4] * a * b + c[5] * b * b)
        upright = 1.0 / np.sqrt(1.0 + slope_a**2 + slope_b**2)
        normal = np.stack([-slope_a * upright, -slope_b * upright, upright], axis=1)
        return lift * upright, np.asarray(np.einsum("mij,mi->mj", axes, normal))

    @property
    def normals(self) -> Array:
        """Unit normals (k, 3) at the origins' feet."""
        c = self.coefficients
        normal = np.stack([-c[:, 1], -c[:, 2], np.ones(len(c))], axis=1)
        normal /= np.linalg.norm(normal, axis=1)[:, None]
        return np.asarray(np.einsum("mij,mi->mj", self.axes, normal))

    def smooth(self, pitch: float, noise: float) -> NDArray[np.bool_]:
        """Which quadrics (k,) the points follow as closely as a cloud's pitch and noise allow."""
        return np.asarray(self.rms <= max(MISFIT * noise, FLAT * pitch))

    def bends(self) -> tuple[Array, Array]:
        """Principal curvatures (k,), lowest and highest, positive where the graph bends upwards."""
        c = self.coefficients
        mean, half = c[:, 3] + c[:, 5], np.hypot(c[:, 3] - c[:, 5], c[:, 4])
        return mean - half, mean + half


def local_quadrics(
    tree: cKDTree,
    reach: float,
    neighbours: int,
    within: NDArray[np.bool_] | None = None,
    progress: Progress | None = None,
) -> LocalQuadrics:
    """Quadrics through the points round seeds that are spread over a cloud.

    Parameters
    ----------
    tree : of the cloud's points
    reach : mm, of a neighbourhood where the cloud is dense
    neighbours : how many points a neighbourhood holds at least; it is wider where they are sparse
    within : (n,) bool, the points among which the seeds are; all of them when not given
    progress : told the share that is done; where it answers False, those so far are the result
    """
    points = np.asarray(tree.data)
    places = points if within is None else points[within]
    seeds = places[spaced_rows(places, SEED_DISTANCE * reach)]
    count = min(neighbours, len(points))
    parts = np.array_split(seeds, max(1, len(seeds) * count // AT_ONCE + 1))
    pieces: list[tuple[Array, ...]] = []
    for part in parts:
        pieces.append(_fitted(points, tree, part, count))
        if progress and not progress.update(len(pieces) / len(parts), None):
            break
    return LocalQuadrics(*(np.concatenate(values) for values in zip(*pieces, strict=True)))


def _fitted(points: Array, tree: cKDTree, seeds: Array, count: int) -> tuple[Array, ...]:
    distance, rows = tree.query(seeds, k=count, workers=-1)
    offsets = points[rows] - seeds[:, None]
    centre = offsets.mean(axis=1)
    offsets -= centre[:, None]
    scale = distance[:, -1]
    unit = np.where(scale > 0.0, scale, 1.0)
    offsets /= unit[:, None, None]
    _, vectors = np.linalg.eigh(offsets.transpose(0, 2, 1) @ offsets)
    axes = vectors.transpose(0, 2, 1)[:, ::-1]
    a, b, h = (offsets @ axes.transpose(0, 2, 1)).transpose(2, 0, 1)
    terms = np.stack([np.ones_like(a), a, b, a * a, a * b, b * b], axis=2)
    normal_matrix = terms.transpose(0, 2, 1) @ terms
    values, directions = np.linalg.eigh(normal_matrix)
    seen = values > SEEN * values[:, -1:]
    inverse = np.divide(1.0, values, out=np.zeros_like(values), where=seen)
    right = directions.transpose(0, 2, 1) @ (terms.transpose(0, 2, 1) @ h[:, :, None])
    solved = (directions @ (inverse[:, :, None] * right))[:, :, 0]
    left_over = h - (terms @ solved[:, :, None])[:, :, 0]
    freedom = np.maximum(count - seen.sum(axis=1), 1)
    rms = np.sqrt((left_over**2).sum(axis=1) / freedom) * unit
    coefficients = solved * unit[:, None] ** np.array([1.0, 0, 0, -1, -1, -1])
    return seeds + centre, axes, coefficients, scale, rms
