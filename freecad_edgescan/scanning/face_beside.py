# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which of the two faces beside an edge a place is on.

The faces of the cloud are those that neighbouring points without a crease between them form
(`network.regions`); the place is on one of them, and that one must lie beside the edge.
"""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from ..cloud.point_cloud import PointCloud
from .network.regions import regions_between
from .scanned_edge import ScannedEdge
from .shared_planes import normals_of

__all__ = ["side_of"]

# Pitches from the edge, besides a rounding: no farther, because a wall of few pitches is no face of
# its own, and its halves belong to the faces at both of its ends.
_BEGINS, _BESIDE = 0.7, 2.5
_LEVEL = 0.75  # pitches, and standard deviations of the noise, from the plane of a side
_LEAST = 0.5  # of the points beside the edge, that are on its face
_FLAT = 0.03  # rad, and half a pitch, by which a place in the plane of a side may be off it
_ALIKE = np.cos(np.radians(15.0))


def side_of(cloud: PointCloud, edge: ScannedEdge, place: np.ndarray) -> int | None:
    """Number of the side whose face a place (3,) on the cloud is on; None: it is on neither.

    Where the cloud does not tell, it is the side towards which the place lies.
    """
    j = int(np.linalg.norm(edge.points - place, axis=1).argmin())
    offset = place - edge.points[j]
    towards = int((edge.sides[j] @ offset).argmax())
    if _is_level(cloud, edge.normals[j, towards], offset, place):
        return towards
    nearest = int(cloud.tree.query(place)[1])
    face = next((r.mask for r in regions_between(cloud, [edge]) if r.mask[nearest]), None)
    if face is None:
        return towards
    shares = _shares(cloud, edge, face)
    for side in (towards, 1 - towards):
        if not shares[side] < _LEAST:  # nan: there are no points to tell by
            return side
    return None


def _is_level(cloud: PointCloud, normal: np.ndarray, offset: np.ndarray, place: np.ndarray) -> bool:
    """Whether a place is in the plane of a side, as on a face that gaps and grooves divide."""
    off = _FLAT * float(np.linalg.norm(offset)) + 0.5 * cloud.pitch + 3.0 * cloud.noise
    alike = abs(float(normals_of(cloud, place[None])[0] @ normal))
    return bool(abs(offset @ normal) < off and alike > _ALIKE)


def _shares(cloud: PointCloud, edge: ScannedEdge, face: np.ndarray) -> list[float]:
    """Of the points beside an edge on each of its sides, the share on a face (n,) bool."""
    rounded = 2.0 * max(float(np.median(edge.overhang)) - cloud.pitch, 0.0)
    nearest = cKDTree(edge.points)
    reach = _BESIDE * cloud.pitch + 2.0 * rounded
    away, owner = nearest.query(cloud.points, distance_upper_bound=reach)
    near = np.flatnonzero(np.isfinite(away))
    owner, offset = owner[near], cloud.points[near] - edge.points[owner[near]]
    level = _LEVEL * cloud.pitch + 3.0 * cloud.noise
    shares = []
    for side in range(2):
        ahead = np.einsum("ni,ni->n", offset, edge.sides[owner, side])
        off = np.abs(np.einsum("ni,ni->n", offset, edge.normals[owner, side]))
        beside = near[(ahead > _BEGINS * cloud.pitch + rounded) & (off < level)]
        shares.append(float(face[beside].mean()) if len(beside) else float("nan"))
    return shares
