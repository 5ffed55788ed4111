# SPDX-License-Identifier: LGPL-2.1-or-later
"""What others make of the same cloud: the two ways to an edge that install from PyPI.

Both get help that a user would have to give by hand: the part of the cloud that lies nearer to the
edge than to any other one, and the truth to choose what they answer.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from importlib import import_module
from importlib.util import find_spec

import numpy as np
from numpy.typing import NDArray

from ..cloud import PointCloud, TrueEdge
from ..geometry import fit_plane

__all__ = ["PEERS", "missing_peers", "plane_pair", "variation_labels", "whole_cloud_labels"]

Array = NDArray[np.float64]

_CROP = 60.0  # pitches from the edge, where nothing else is nearer
_TRIES = 300  # of RANSAC, for each plane
_NEAR_PLANE = 3.0  # standard deviations of the noise
_SOUGHT = 6.0  # pitches from the edge, where labels are looked for
_VARIATION = 3.0  # pitches, radius in which the surface variation is taken


def plane_pair(cloud: PointCloud, truth: TrueEdge, noise: float) -> Array:
    """Two RANSAC planes (pyransac3d), fitted again to their points, and where they meet.

    Parameters
    ----------
    cloud : PointCloud
    truth : the edge that is sought; it tells the planes' part of the cloud
    noise : standard deviation of the cloud, mm

    Returns
    -------
    (k, 3) points of the line where the planes meet, beside the samples of the true edge; none when
    there are no two planes.
    """
    ransac = import_module("pyransac3d")
    left, planes = _crop(cloud, truth), []
    near = _NEAR_PLANE * max(noise, 1e-3 * cloud.pitch)
    for _ in range(2):
        if len(left) < 20:
            return np.zeros((0, 3))
        with _same_chance():
            inliers = ransac.Plane().fit(left, thresh=near, maxIteration=_TRIES).inliers
        plane = fit_plane(left[inliers])
        off = np.abs((left - plane.point) @ plane.normal)
        planes.append(fit_plane(left[off < near]))
        left = left[off >= near]
    normals = np.array([plane.normal for plane in planes])
    along = np.cross(*normals)
    if np.linalg.norm(along) < 0.1:
        return np.zeros((0, 3))
    along /= np.linalg.norm(along)
    level = [plane.normal @ plane.point for plane in planes]
    point = np.linalg.solve(np.vstack([normals, along]), [*level, along @ truth.points.mean(0)])
    return np.asarray(point + ((truth.points - point) @ along)[:, None] * along)


def variation_labels(cloud: PointCloud, truth: TrueEdge, noise: float) -> Array:
    """The points of largest surface variation near an edge (jakteristics), one for each pitch.

    Parameters
    ----------
    cloud, truth : as for `plane_pair`
    noise : not used

    Returns
    -------
    (k, 3) points, mm.
    """
    features = import_module("jakteristics").compute_features
    points = _crop(cloud, truth)
    variation = features(
        np.ascontiguousarray(points),
        search_radius=_VARIATION * cloud.pitch,
        feature_names=["surface_variation"],
    )[:, 0]
    # Other edges, and the rims of the crop, are left out by hand.
    sought = truth.distance(points) < _SOUGHT * cloud.pitch
    if not truth.closed:
        for end in truth.points[[0, -1]]:
            sought &= np.linalg.norm(points - end, axis=1) > 2.0 * _SOUGHT * cloud.pitch
    variation[~sought | ~np.isfinite(variation)] = -1.0
    count = min(int(truth.length / cloud.pitch), int(sought.sum()))
    return np.asarray(points[np.argsort(variation)[len(points) - count :]])


def whole_cloud_labels(cloud: PointCloud, edges: Sequence[TrueEdge]) -> Array:
    """The points of largest surface variation in a whole cloud (jakteristics).

    Parameters
    ----------
    edges : the true edges; their length tells how many points to label, one for each pitch

    Returns
    -------
    (k, 3) points, mm.
    """
    features = import_module("jakteristics").compute_features
    variation = features(
        np.array(cloud.points),  # it wants to be able to write into them
        search_radius=_VARIATION * cloud.pitch,
        feature_names=["surface_variation"],
        num_threads=2,
    )[:, 0]
    variation = np.where(np.isfinite(variation), variation, -1.0)
    count = min(int(sum(edge.length for edge in edges) / cloud.pitch), len(cloud))
    return np.asarray(cloud.points[np.argsort(variation)[len(cloud) - count :]])


@contextmanager
def _same_chance() -> Iterator[None]:
    """Seed Python's own random numbers, the only ones pyransac3d takes, and give them back."""
    state = random.getstate()
    random.seed(0)
    try:
        yield
    finally:
        random.setstate(state)


def _crop(cloud: PointCloud, truth: TrueEdge) -> Array:
    """Points (n, 3) nearer to the edge than to others, and not far away."""
    room = np.nanmedian(truth.room) if np.any(np.isfinite(truth.room)) else np.inf
    reach = min(0.5 * float(room), _CROP * cloud.pitch)
    return cloud.points[truth.distance(cloud.points) < reach]


Peer = Callable[[PointCloud, TrueEdge, float], Array]

# By name: what it needs from PyPI, and the function.
PEERS: dict[str, tuple[str, Peer]] = {
    "two RANSAC planes": ("pyransac3d", plane_pair),
    "surface variation": ("jakteristics", variation_labels),
}


def missing_peers() -> list[str]:
    """Packages of the peers that are not installed."""
    return [package for package, _ in PEERS.values() if find_spec(package) is None]
