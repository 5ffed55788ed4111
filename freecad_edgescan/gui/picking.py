# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which point of a cloud a person means who clicks on it: numbers only, no window.

A click is a ray with a radius of some pixels: a cylinder when the camera is orthographic, a cone
when it is in perspective.

1. The ray is halved again and again; a piece survives while some point may lie in its cone.
2. Of the points in the surviving cone the one with the least *distance from the ray + a share of
   its depth* is meant: what lies in front hides what lies behind, and the middle of a slanting
   surface still wins over the nearer rim of the cone.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

__all__ = ["Hit", "ViewRay", "front_hit", "nearest_to_ray"]

Array = NDArray[np.float64]

DEPTH_SHARE = 0.25  # the middle wins on surfaces that slant up to atan(1 / share) = 76 degrees


@dataclass(frozen=True)
class ViewRay:
    """The line of sight under the cursor.

    Parameters
    ----------
    origin : (3,) array, mm, where sight begins
    direction : (3,) unit vector, away from the eye
    radius : pick radius at the origin, mm
    slope : growth of the pick radius for each mm of depth
    """

    origin: Array
    direction: Array
    radius: float
    slope: float = 0.0

    def widened(self, factor: float) -> ViewRay:
        """The same line of sight with a larger pick radius."""
        return ViewRay(self.origin, self.direction, factor * self.radius, factor * self.slope)


@dataclass(frozen=True)
class Hit:
    """A point of a cloud that a click has met: its index, depth and distance from the ray, mm."""

    index: int
    depth: float
    distance: float

    @property
    def score(self) -> float:
        """The less, the more likely it is meant."""
        return self.distance + DEPTH_SHARE * self.depth


def front_hit(hits: list[Hit | None]) -> int | None:
    """Which of several clouds a click means, given what it met in each; None when nothing."""
    met = [number for number, hit in enumerate(hits) if hit is not None]
    return min(met, key=lambda number: _score(hits[number])) if met else None


def nearest_to_ray(tree: cKDTree, ray: ViewRay, least_radius: float = 0.0) -> Hit | None:
    """Find the point of a cloud that a person means by a click.

    Parameters
    ----------
    tree : KD-tree of the cloud's points, mm
    ray : line of sight with its pick radius
    least_radius : mm, pick radius wherever the ray's own is smaller. With one or two cloud
        pitches a click between the points of a magnified cloud still meets one.

    Returns
    -------
    The Hit, or None when no point lies within the pick radius in front of the eye.
    """
    centres, halves = _pieces(tree, ray, least_radius)
    if not len(centres):
        return None
    places = ray.origin + centres[:, None] * ray.direction
    reach = np.hypot(halves, _radius(ray, centres + halves, least_radius))
    found = np.unique(np.concatenate(tree.query_ball_point(places, reach)).astype(np.intp))
    away = np.asarray(tree.data)[found] - ray.origin
    depth = away @ ray.direction
    distance = np.linalg.norm(away - depth[:, None] * ray.direction, axis=1)
    meant = (depth >= 0.0) & (distance <= _radius(ray, depth, least_radius))
    if not meant.any():
        return None
    score = np.where(meant, distance + DEPTH_SHARE * depth, np.inf)
    best = int(np.argmin(score))
    return Hit(int(found[best]), float(depth[best]), float(distance[best]))


def _pieces(tree: cKDTree, ray: ViewRay, least_radius: float) -> tuple[Array, Array]:
    """Centre depths and half lengths of the pieces of the ray that may hold points."""
    low, high = np.asarray(tree.mins), np.asarray(tree.maxes)
    box = np.stack(np.meshgrid(*np.column_stack([low, high])), axis=-1).reshape(-1, 3)
    depths = (box - ray.origin) @ ray.direction
    near, far = max(float(depths.min()), 0.0), float(depths.max())
    if far < 0.0:
        return np.zeros(0), np.zeros(0)
    half = (far - near) / 2.0 or 1e-9
    centres, halves = np.array([near + half]), np.array([half])
    while len(centres):
        radii = _radius(ray, centres + halves, least_radius)
        reach = np.hypot(halves, radii)
        places = ray.origin + centres[:, None] * ray.direction
        met = tree.query(places, distance_upper_bound=float(reach.max()) * (1.0 + 1e-9))[0] <= reach
        centres, halves, radii = centres[met], halves[met], radii[met]
        if np.all(halves <= radii):
            break
        halves = np.repeat(halves / 2.0, 2)
        centres = np.repeat(centres, 2) + halves * np.tile([-1.0, 1.0], len(centres))
    return centres, halves


def _radius(ray: ViewRay, depth: Array, least_radius: float) -> Array:
    return np.maximum(ray.radius + ray.slope * depth, least_radius)


def _score(hit: Hit | None) -> float:
    return np.inf if hit is None else hit.score
