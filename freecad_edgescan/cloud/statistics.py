# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pitch and noise of a cloud, estimated from small neighbourhoods of its points.

1. *Pitch*: the k nearest points of a place fill a disc of the surface, folded or not, so the
   density is k over the disc's area. At the rim of the cloud, where they lie to one side, they
   fill only part of a disc; there their second moments C tell the area, 4 pi sqrt(det C).
2. *Two pitches*: probes strewn over that disc are joined to their nearest points. For rows a
   apart with points b apart the offsets have the second moments a²/12 and b²/12, for points
   strewn at random they are alike in all directions.
3. *Noise*: residuals of a quadric through each neighbourhood, divided by the degrees of freedom
   it leaves, so that neither curvature nor the fit itself changes the figure. It is measured in
   the half of the neighbourhoods that bends least, away from edges; how a fit bends and what it
   leaves over are independent, so the choice does not change the figure either.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree
from scipy.special import gammaincinv

__all__ = ["estimate_largest_gap", "estimate_local_pitch", "estimate_pitch_and_noise"]

Array = NDArray[np.float64]

SEEDS = 2000  # neighbourhoods looked at
PITCH_NEIGHBOURS = 48
NOISE_NEIGHBOURS = 32
PROBES = 96  # strewn over one neighbourhood to see how its points are spaced
WITHIN_GAP = 0.999  # of the probes
QUADRIC_TERMS = 6
LOPSIDED = 0.15  # of the radius: how far the centre of a filled disc may lie off its place


def estimate_pitch_and_noise(tree: cKDTree) -> tuple[float, float]:
    """1 / sqrt(points per mm² of surface), the median over neighbourhoods, and the noise, mm.

    The pitch is nan for a cloud of which all points are equal. The noise is the standard deviation
    of the points along the surface normal, 0 where there are too few to tell noise from shape.
    """
    offsets = _neighbourhoods(tree, _seeds(tree), PITCH_NEIGHBOURS)
    local, centres = _in_local_axes(offsets)
    pitch = _pitch(offsets, local, centres)
    measurable = pitch[pitch > 0]
    return float(np.median(measurable)) if len(measurable) else float("nan"), _noise(local)


def estimate_local_pitch(tree: cKDTree, places: Array) -> Array:
    """Two principal pitches round each place, (m, 2), larger first, mm."""
    pieces = np.split(places, range(SEEDS, len(places), SEEDS))
    return np.concatenate([_two_pitches(tree, piece) for piece in pieces])


def estimate_largest_gap(tree: cKDTree, places: Array) -> float:
    """Distance to the nearest point that all but a few places on the surface keep, mm."""
    offsets = _neighbourhoods(tree, places, PITCH_NEIGHBOURS)
    gaps = _gaps(_in_local_axes(offsets)[0][:, :, :2])
    return float(np.quantile(np.hypot(gaps[..., 0], gaps[..., 1]), WITHIN_GAP))


def _two_pitches(tree: cKDTree, places: Array) -> Array:
    offsets = _neighbourhoods(tree, places, PITCH_NEIGHBOURS)
    local, centres = _in_local_axes(offsets)
    gaps = _gaps(local[:, :, :2])
    moments = np.linalg.eigvalsh(gaps.transpose(0, 2, 1) @ gaps)
    with np.errstate(divide="ignore", invalid="ignore"):
        stretch = (moments[:, 1] / moments[:, 0]) ** 0.25
    pitch = _pitch(offsets, local, centres)
    return np.stack([pitch * stretch, pitch / stretch], axis=1)


def _gaps(flat: Array) -> Array:
    """Offsets of probes strewn over each neighbourhood from its nearest point, (m, PROBES, 2)."""
    radius = np.sqrt((flat**2).sum(axis=2).max(axis=1))
    probes = 0.6 * radius[:, None, None] * _disc(PROBES)
    squares = (flat**2).sum(axis=2)[:, None, :] - 2 * probes @ flat.transpose(0, 2, 1)
    nearest = np.take_along_axis(flat, squares.argmin(axis=2)[:, :, None], axis=1)
    return np.asarray(probes - nearest)


def _noise(local: Array) -> float:
    nearest = np.argsort((local[:, :, :2] ** 2).sum(axis=2), axis=1)[:, :NOISE_NEIGHBOURS]
    local = np.take_along_axis(local, nearest[:, :, None], axis=1)
    freedom = local.shape[1] - QUADRIC_TERMS
    if freedom < 4:
        return 0.0
    variance, bend = _quadric(local)
    flat = variance[bend <= np.median(bend)]
    # of chi-square, whose own module takes as long to load as all others together
    median = 2.0 * gammaincinv(0.5 * freedom, 0.5)
    typical = np.median(flat) * freedom / median
    return float(np.sqrt(flat[flat <= 2.5 * typical].mean()))


def _seeds(tree: cKDTree) -> Array:
    """Points of the cloud to look round, (m, 3), the same ones every time."""
    points = np.asarray(tree.data)
    if len(points) <= SEEDS:
        return points
    chosen = np.random.default_rng(0).choice(len(points), SEEDS, replace=False)
    return points[np.sort(chosen)]


def _neighbourhoods(tree: cKDTree, places: Array, neighbours: int) -> Array:
    """Offsets from each place to its nearest points, (m, k, 3), nearest first, mm."""
    _, indices = tree.query(places, k=range(1, min(neighbours, tree.n) + 1))
    return np.asarray(tree.data)[indices] - places[:, None, :]


def _in_local_axes(offsets: Array) -> tuple[Array, Array]:
    """The neighbourhoods about their centres in principal axes, the normal last; the centres."""
    centres = offsets.mean(axis=1, keepdims=True)
    centred = offsets - centres
    _, axes = np.linalg.eigh(centred.transpose(0, 2, 1) @ centred)
    axes = axes[:, :, ::-1]
    return np.asarray(centred @ axes), np.asarray((centres @ axes)[:, 0])


def _pitch(offsets: Array, local: Array, centres: Array) -> Array:
    """Square root of the area per point in each neighbourhood, (m,), mm."""
    count = offsets.shape[1]
    square = (offsets[:, -1] ** 2).sum(axis=1)
    disc = np.pi * square / max(count - 1.5, 1.0)
    moments = (local[:, :, :2] ** 2).sum(axis=1) / max(count - 1, 1)
    part = 4 * np.pi * np.sqrt(moments.prod(axis=1)) / count
    lopsided = (centres[:, :2] ** 2).sum(axis=1) > LOPSIDED**2 * square
    return np.asarray(np.sqrt(np.where(lopsided, part, disc)))


def _disc(count: int) -> Array:
    """Evenly strewn places in the unit disc, (count, 2): a sunflower."""
    i = np.arange(count) + 0.5
    angle = np.pi * (1 + np.sqrt(5)) * i
    return np.sqrt(i / count)[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)


def _quadric(local: Array) -> tuple[Array, Array]:
    """A quadric h(u, v) through each neighbourhood: residual variance, mm², and bend, mm."""
    scale = np.sqrt((local**2).sum(axis=2).max(axis=1))[:, None, None]
    scaled = np.divide(local, scale, out=np.zeros_like(local), where=scale > 0)
    u, v, h = scaled[:, :, 0], scaled[:, :, 1], scaled[:, :, 2]
    terms = np.stack([np.ones_like(u), u, v, u * u, u * v, v * v], axis=2)
    values, vectors = np.linalg.eigh(terms.transpose(0, 2, 1) @ terms)
    seen = values > 1e-10 * values[:, -1:]
    inverse = np.divide(1.0, values, out=np.zeros_like(values), where=seen)
    projected = vectors.transpose(0, 2, 1) @ (terms.transpose(0, 2, 1) @ h[:, :, None])
    coefficients = vectors @ (inverse[:, :, None] * projected)
    residuals = h - (terms @ coefficients)[:, :, 0]
    freedom = np.maximum(local.shape[1] - seen.sum(axis=1), 1)
    size = scale[:, 0, 0]
    variance = (residuals**2).sum(axis=1) / freedom * size**2
    bend = np.sqrt(coefficients[:, 3:, 0] ** 2 @ np.array([1.0, 0.5, 1.0])) * size
    return np.asarray(variance), np.asarray(bend)
