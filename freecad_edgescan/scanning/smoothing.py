# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edge points smoothed along the edge with their known covariance.

An edge runs on smoothly; what its points scatter about a short parabola is noise. Each edge point
becomes the value at its own section of a weighted least-squares parabola (of a line where the whole
edge is one) through its neighbours. How many of these are asked is decided at each section: the
parabola over a longer stretch is taken as long as its points lie on it and it agrees with all those
over shorter ones (Lepski, Theory of Probability and its Applications 35, 1991), so that a real
change of the edge stays.

The points are not independent: their slabs overlap, each side's as far as it has asked neighbours
for points, and they share what is known about the sides' curvature. Both are known, and with them
the covariance of any weighted mean.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .corner import Corners, across_axes, root_2x2
from .edge_points import Measured
from .pooling import shared_between
from .positive_definite import inverses

_FARTHEST = 16.0  # pitches of the cloud, that a neighbour may be away
_MOST_TURNED = 0.8  # rad, that the edge may bend up to there
_MOST = 12  # neighbours on each side at most
_LENGTHS = (0.3, 0.5, 0.75, 1.0)  # of the longest stretch, that are tried
_AGREE = 9.2  # squared Mahalanobis distance beyond which two estimates differ (99 %)
_ASTRAY = 16.0  # the same, of a point from what its neighbours say of it
_MOST_MISFIT = 2.0  # variances, of the points about a parabola whose word is taken
_EACH_WAY = 2  # neighbours on each side, at least, who say it
# So many such points in a row are a mistake: stretches of the sides are decided for four sections
# at a time. More of them are the edge.
_FEW = 4


@dataclass(frozen=True)
class Smoothed:
    """Edge points of m sections.

    Attributes
    ----------
    point : (m, 3) array, mm
    covariance : (m, 2, 2) mm², in the axes of `across_axes` of the frames
    independent : number of independent errors in all of them, 1 or more
    """

    point: np.ndarray
    covariance: np.ndarray
    independent: float


def smoothed(
    measured: Measured,
    edge: Corners,
    cloud_pitch: float,
    closed: bool,
    straight: bool,
    ending: tuple[bool, bool] = (True, True),
) -> Smoothed:
    """Smooth edge points along the edge.

    Parameters
    ----------
    measured : the sections
    edge : their edge points
    cloud_pitch : mm
    closed : whether the last one leads back to the first
    straight : whether all of them are known to lie on one straight line
    ending : whether the edge ends there, at its start and end, rather than having been left
    """
    slabs = _independent_slabs(measured)
    raw = Smoothed(edge.point, edge.covariance, max(1.0, float(slabs.sum())))
    near = _Neighbours.around(measured, edge, _FARTHEST * cloud_pitch, closed, straight)
    if near is None:
        return raw
    degree = 1 if straight else 2
    trusted = near.inside & ~_astray(near, degree, ending, closed)
    values, covariances = [np.zeros_like(near.off[:, 0])], [edge.covariance]
    means, shares = [near.mean(near.own())], [np.ones(len(edge.point))]
    taken = np.zeros(len(edge.point), dtype=np.int64)
    alone = ~trusted[:, near.reach]  # what such a section says itself is no evidence
    good = [~alone]
    for share in _LENGTHS:
        width = max(round(share * near.reach), degree + 1)
        asked = trusted & near.within(width)
        weight, found = near.parabola(asked, degree)
        mean = near.mean(weight)
        value, covariance = mean.value, mean.covariance
        # Where the edge bends otherwise from here on it is no parabola, however close that comes.
        agrees = found & (near.misfit(asked, degree) < _MOST_MISFIT)
        for before, other, known in zip(values, means, good, strict=True):
            # One section in a hundred is farther off by chance alone; that is no change.
            limit = _ASTRAY if other is means[0] else _AGREE
            agrees &= (_distance(value - before, mean.difference(other)) <= limit) | ~known
        better = agrees & _smaller(covariance, np.array(covariances)[taken, np.arange(len(taken))])
        better |= agrees & alone & (taken == 0)
        values.append(value)
        covariances.append(covariance)
        means.append(mean)
        shares.append(weight[:, near.reach])
        good.append(agrees)
        taken[better] = len(values) - 1
    rows = np.arange(len(taken))
    shift = np.array(values)[taken, rows]
    axes = across_axes(measured.frames.normals)
    # Each point's own share in what it is: summed, the degrees of freedom of the smoothed edge.
    own = np.clip(np.array(shares)[taken, rows], 0.0, slabs)
    return Smoothed(
        edge.point + np.einsum("ma,mai->mi", shift, axes),
        np.array(covariances)[taken, rows],
        max(1.0, float(own.sum())),
    )


def _independent_slabs(measured: Measured) -> np.ndarray:
    """Of each section's points, the share that no neighbour has as well, (m,)."""
    if len(measured.at) < 2:
        return np.ones(len(measured.at))
    spacing = float(np.median(np.diff(measured.at)))
    return np.minimum(1.0, spacing / (2.0 * measured.half_length.mean(axis=1)))


@dataclass(frozen=True)
class _Neighbours:
    """What the neighbours of m sections say, k of them round each section.

    Attributes
    ----------
    reach : number of neighbours on each side; k = 2 reach + 1
    inside : (m, k) whether there is one
    along : (m, k) how far it is along the edge, in units of the farthest
    off : (m, k, 2) how far its point is beside the section's own, mm
    precision : (m, k) inverse variance of its own scatter, 1/mm²
    parts : of the neighbours' covariance: of the scatter of each side's points, and of what is
        shared. The correlations (m, k, k) and the roots (m, 2, k, 1 or 2), mm
    """

    reach: int
    inside: np.ndarray
    along: np.ndarray
    off: np.ndarray
    precision: np.ndarray
    parts: list[tuple[np.ndarray, np.ndarray]]

    @staticmethod
    def around(
        measured: Measured, edge: Corners, farthest: float, closed: bool, straight: bool
    ) -> _Neighbours | None:
        """Gather the neighbours; None where there are too few."""
        count, at = len(edge.point), measured.at
        spacing = float(np.median(np.diff(at))) if count > 1 else 0.0
        if spacing <= 0.0:
            return None
        reach = int(min(_MOST, farthest / spacing, (count - 1) // 2))
        if reach < 2:
            return None
        step = np.arange(-reach, reach + 1)
        which = np.arange(count)[:, None] + step
        inside = np.full(which.shape, True) if closed else (which >= 0) & (which < count)
        which = which % count if closed else np.clip(which, 0, count - 1)
        away = edge.point[which] - edge.point[:, None]
        axes = across_axes(measured.frames.normals)
        along = np.einsum("mi,mki->mk", measured.frames.tangent, away)
        # A straight edge's own bend is noise of the walk, and a line could not absorb it.
        bend = np.einsum("mai,mi->ma", axes, measured.frames.bend)
        bend = np.zeros_like(bend) if straight else bend
        turned = np.linalg.norm(bend, axis=1)[:, None] * np.abs(along)
        inside &= (np.abs(along) <= farthest) & (turned < _MOST_TURNED)
        # What the bend of the edge explains; a parabola alone is no circle.
        turned = np.minimum(turned, _MOST_TURNED)
        explained = along**2 / (1.0 + np.sqrt(1.0 - turned**2))
        scatter = np.sum(np.square(edge.scatter), axis=(1, 2))
        parts = [
            (
                _overlap(along, measured.half_length[which, side]),
                np.swapaxes(edge.scatter[which, :, side : side + 1], 1, 2).copy(),
            )
            for side in range(2)
        ]
        shared = shared_between(count, closed, 2 * reach, measured.summed_over)
        earlier = which[:, np.minimum(np.arange(len(step))[:, None], np.arange(len(step)))]
        alike = shared[earlier, np.abs(step[:, None] - step)]
        parts.append((alike, np.swapaxes(root_2x2(edge.shared)[which], 1, 2).copy()))
        return _Neighbours(
            reach,
            inside,
            along / farthest,
            np.einsum("mai,mki->mka", axes, away) - explained[..., None] * bend[:, None],
            1.0 / np.maximum(scatter[which], 1e-12 * float(scatter.max(initial=1e-12))),
            parts,
        )

    def within(self, width: int) -> np.ndarray:
        """Which neighbours are at most so many sections away, (k,) bool."""
        return np.abs(np.arange(-self.reach, self.reach + 1)) <= width

    def own(self) -> np.ndarray:
        """Weights (m, k) of the section itself."""
        weight = np.zeros(self.along.shape)
        weight[:, self.reach] = 1.0
        return weight

    def parabola(self, used: np.ndarray, degree: int) -> tuple[np.ndarray, np.ndarray]:
        """Weights (m, k) that give a least-squares polynomial's value, and where there is one."""
        power = self.along[..., None] ** np.arange(degree + 1)
        weighted = power * (self.precision * used)[..., None]
        normal = np.einsum("mki,mkj->mij", weighted, power)
        found = used.sum(axis=1) >= degree + 2
        size = np.sqrt(np.maximum(np.einsum("mii->mi", normal), 1e-300))
        scaled = normal / size[:, :, None] / size[:, None]
        eigenvalues = np.linalg.eigvalsh(scaled)
        found &= eigenvalues[:, 0] > 1e-8 * eigenvalues[:, -1]
        scaled = np.where(found[:, None, None], scaled, np.eye(degree + 1))
        first = inverses(scaled)[:, 0] / size[:, :1] / size
        return np.where(found[:, None], np.einsum("mki,mi->mk", weighted, first), 0.0), found

    def misfit(self, used: np.ndarray, degree: int) -> np.ndarray:
        """Mean square of the neighbours' distances from the polynomial, in variances, (m,)."""
        power = self.along[..., None] ** np.arange(degree + 1)
        root = np.sqrt(self.precision * used)[..., None]
        # What lies in the space of the polynomials is explained by the best of them.
        space, off = np.linalg.qr(power * root)[0], self.off * root
        left = np.sum(np.square(off - space @ (np.swapaxes(space, 1, 2) @ off)), axis=(1, 2))
        return left / np.maximum(used.sum(axis=1) - degree - 1, 1)

    def mean(self, weight: np.ndarray) -> _Mean:
        """Weighted mean of the neighbours."""
        parts = []
        for alike, root in self.parts:
            moved = weight[:, None, :, None] * root
            parts.append((moved, alike[:, None] @ moved))
        return _Mean.of(np.einsum("mk,mka->ma", weight, self.off), parts)


@dataclass(frozen=True)
class _Mean:
    """A weighted mean of each section's neighbours.

    Attributes
    ----------
    value : (m, 2) mm
    parts : of each part of the covariance two (m, 2, k, 1 or 2) arrays, mm: the neighbours' roots
        times their weights, and what of these each neighbour has in common with all of them
    covariance : (m, 2, 2) mm²
    """

    value: np.ndarray
    parts: list[tuple[np.ndarray, np.ndarray]]
    covariance: np.ndarray

    @staticmethod
    def of(value: np.ndarray, parts: list[tuple[np.ndarray, np.ndarray]]) -> _Mean:
        """The mean with its covariance."""
        return _Mean(value, parts, _common(parts, parts))

    def difference(self, other: _Mean) -> np.ndarray:
        """Covariance (m, 2, 2) of the difference of two means, mm²."""
        common = _common(self.parts, other.parts)
        return self.covariance + other.covariance - common - np.swapaxes(common, -1, -2)


def _common(
    one: list[tuple[np.ndarray, np.ndarray]], other: list[tuple[np.ndarray, np.ndarray]]
) -> np.ndarray:
    """Covariance (m, 2, 2) of two weighted means, mm²."""
    flat = (len(one[0][0]), 2, -1)
    return np.asarray(
        sum(
            moved.reshape(flat) @ np.swapaxes(seen.reshape(flat), -1, -2)
            for (moved, _), (_, seen) in zip(one, other, strict=True)
        )
    )


def _astray(near: _Neighbours, degree: int, ending: tuple[bool, bool], closed: bool) -> np.ndarray:
    """Which neighbours (m, k) are among few points that the others say are somewhere else."""
    # What is mistaken together is not asked about itself.
    others = near.inside & ~near.within(min(_FEW, near.reach // 3))
    weight, found = near.parabola(others, degree)
    # What its neighbours say of a section's point, whose own place is zero.
    said = near.mean(weight)
    far = found & (_distance(said.value, said.difference(near.mean(near.own()))) > _ASTRAY)
    # What is drawn out beyond those it was fitted to says little. It is asked only where the edge
    # ends, and the next surface may have got in.
    for ends, beside in zip(
        ending, (others[:, : near.reach], others[:, -near.reach :]), strict=True
    ):
        far &= ends | (beside.sum(axis=1) >= _EACH_WAY)
    # Where the edge is no parabola, as where a line becomes an arc, its neighbours say nothing.
    far &= near.misfit(others, degree) < _MOST_MISFIT
    single = far.copy()
    for run in _runs(far, closed):
        if len(run) > _FEW:
            single[run] = False
    count = len(far)
    which = (np.arange(count)[:, None] + np.arange(-near.reach, near.reach + 1)) % count
    return single[which]


def _overlap(along: np.ndarray, half: np.ndarray) -> np.ndarray:
    """Shares (m, k, k) of their points that slabs at places (m, k) have in common.

    Sections of a window are numbered in their order, also over the seam of a closed edge.
    """
    low, high = along - half, along + half
    common = np.minimum(high[:, :, None], high[:, None])
    common -= np.maximum(low[:, :, None], low[:, None])
    overlap = np.clip(common / np.sqrt(4.0 * half[:, :, None] * half[:, None]), 0.0, 1.0)
    overlap[:, np.arange(half.shape[1]), np.arange(half.shape[1])] = 1.0
    return overlap


def _runs(chosen: np.ndarray, closed: bool) -> list[np.ndarray]:
    """Places of the runs of neighbouring True values, over the seam where it is closed."""
    order = np.arange(len(chosen))
    if closed:
        order = np.roll(order, -int(np.argmin(chosen)))  # no run goes over a False value
    edges = np.flatnonzero(np.diff(np.concatenate([[0], chosen[order].astype(np.int8), [0]])))
    return [order[begin:end] for begin, end in edges.reshape(-1, 2).tolist()]


def _distance(gap: np.ndarray, covariance: np.ndarray) -> np.ndarray:
    """Squared Mahalanobis distance, (m,)."""
    a, b, d = covariance[:, 0, 0], covariance[:, 0, 1], covariance[:, 1, 1]
    # Of next to no points the covariance is beyond all bounds, and nan no distance that is small.
    with np.errstate(over="ignore", invalid="ignore"):
        # Estimates that share nearly everything differ along one direction only.
        determinant = np.maximum(a * d - b * b, 1e-12 * np.square(a + d) + 1e-300)
        square = d * gap[:, 0] ** 2 - 2.0 * b * gap[:, 0] * gap[:, 1] + a * gap[:, 1] ** 2
        return np.asarray(np.maximum(square, 0.0) / determinant)


def _smaller(covariance: np.ndarray, other: np.ndarray) -> np.ndarray:
    return np.trace(covariance, axis1=-2, axis2=-1) < np.trace(other, axis1=-2, axis2=-1)
