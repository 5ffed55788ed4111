# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which side of a cloud the air is on, from the approach or from rims the probe rolled over.

What is known in some places is passed on to their neighbours, whose normals are nearly the same.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from .local_quadrics import LocalQuadrics

__all__ = ["air_signs"]

Array = NDArray[np.float64]

_FACING = 0.35  # cosine between normal and approach above which the approach tells the side
_NEIGHBOURS = 10
_ALIKE = 3  # power of the normals' cosine with which a neighbour counts
_LEAST_VOTES = (2.0, 1.0, 0.5, 0.2)
_AS_THE_BALL = (0.8, 1.25)  # of the probe's own curvature: a rim it rolled over
_STRAIGHT = 0.3  # of that bend, the most there is along the rim
_FEWEST_RIMS = 8
_PIECES = 50  # of a cloud that is not in one
_UNKNOWN = 2
_AGREE = 0.9


def air_signs(
    quadrics: LocalQuadrics, good: NDArray[np.bool_], probe_radius: float, approach: Array | None
) -> NDArray[np.int8]:
    """Signs (k,) that turn the quadrics' normals into the air; 0 where that cannot be told.

    Parameters
    ----------
    quadrics : of a cloud of ball centres
    good : (k,) bool, those that the points follow
    probe_radius : mm
    approach : (3,) unit vector, or None

    Raises
    ------
    ValueError: no approach, and no rim that tells the side.
    """
    signs = np.zeros(len(quadrics.origins), dtype=np.int8)
    if approach is not None:
        facing = -(quadrics.normals @ approach)
        told = np.abs(facing) > _FACING
        signs[told] = np.sign(facing[told])
        return _passed_on(quadrics, good, signs)
    rims = np.where(good, _rims(quadrics, probe_radius), 0)
    told = agreeing = 0
    for _ in range(_PIECES):
        if signs.all():
            break
        # a piece of the cloud, the same way round everywhere; then which way that is
        piece = np.zeros_like(signs)
        piece[np.flatnonzero(signs == 0)[0]] = 1
        piece = np.where(signs == 0, _passed_on(quadrics, good, piece), 0).astype(np.int8)
        votes = piece * rims
        count, tally = np.count_nonzero(votes), int(votes.sum(dtype=np.intp))
        told, agreeing = told + count, agreeing + (count + abs(tally)) // 2
        sure = count >= _FEWEST_RIMS and abs(tally) >= (2 * _AGREE - 1) * count
        signs[piece != 0] = (piece * np.sign(tally))[piece != 0] if sure else _UNKNOWN
    signs[signs == _UNKNOWN] = 0
    if not signs.any():
        raise ValueError(
            f"On which side of the cloud the air is cannot be told: {told} places look like a rim "
            f"that the ball of {probe_radius:g} mm rolled over, and {agreeing} of them agree. Give "
            "the direction the probe came along, as in PointCloud(points, probe_radius, "
            "approach=(0, 0, -1))."
        )
    return signs


def _rims(quadrics: LocalQuadrics, probe_radius: float) -> NDArray[np.int8]:
    """Signs (k,) of the air's side where the cloud bends as the ball does and hardly across it."""
    low, high = quadrics.bends()
    down = np.abs(low) > np.abs(high)
    strongest, weakest = np.where(down, low, high), np.where(down, high, low)
    turn = np.abs(strongest) * probe_radius
    told = (turn > _AS_THE_BALL[0]) & (turn < _AS_THE_BALL[1])
    told &= np.abs(weakest) < _STRAIGHT * np.abs(strongest)
    # the rim is where the graph bends to; the air is on the other side
    return np.where(told, -np.sign(strongest), 0).astype(np.int8)


def _passed_on(
    quadrics: LocalQuadrics, good: NDArray[np.bool_], signs: NDArray[np.int8]
) -> NDArray[np.int8]:
    """Signs also of those whose neighbours know theirs."""
    result = signs.copy()
    open_ = np.flatnonzero(result == 0)
    if not len(open_) or len(open_) == len(result):
        return result
    count = min(_NEIGHBOURS, len(result))
    tree = cKDTree(quadrics.origins, balanced_tree=False)
    near = tree.query(quadrics.origins[open_], k=range(1, count + 1), workers=-1)[1]
    normals = quadrics.normals
    cosine = np.einsum("mki,mi->mk", normals[near], normals[open_])
    weight = cosine**_ALIKE * np.where(good[near], 1.0, 0.3)
    level = 0
    while len(open_) and level < len(_LEAST_VOTES):
        votes = (weight * result[near]).sum(axis=1)
        sure = np.abs(votes) >= _LEAST_VOTES[level]
        if not sure.any():
            level += 1
            continue
        result[open_[sure]] = np.sign(votes[sure])
        open_, near, weight = open_[~sure], near[~sure], weight[~sure]
        level = 0
    return result
