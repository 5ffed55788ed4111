# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where two surfaces may meet: pairs of small patches whose bounding boxes overlap.

The divide-and-conquer of Peng 1984 (Schreve 6.5.1): a patch lies in the box of its Bézier points,
so that patches whose boxes are apart do not meet; the others are halved until they are small.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import comb

import numpy as np
from numpy.typing import NDArray

from ..geometry import BSplineSurface

__all__ = ["OverlappingPatches", "overlapping_patches"]

Array = NDArray[np.float64]

_PAIRS = 400_000
_AT_ONCE = 1_000_000  # pairs of boxes


@dataclass(frozen=True, eq=False)
class OverlappingPatches:
    """Parameter ranges (m, 4) u0, u1, v0, v1 of the pairs' patches on either surface."""

    on_a: Array
    on_b: Array


@dataclass(frozen=True, eq=False)
class _Patches:
    """Bézier points (k, p + 1, q + 1, d), homogeneous when rational, and ranges (k, 4)."""

    points: Array
    ranges: Array

    @classmethod
    def of(cls, surface: BSplineSurface) -> _Patches:
        u, v = (np.unique(knots) for knots in surface.knots)
        p, q = surface.degree
        whole = surface.refined(
            *(_missing(k, d) for k, d in zip(surface.knots, (p, q), strict=True))
        )
        poles = whole.poles
        if whole.weights is not None:
            poles = np.concatenate([poles * whole.weights[..., None], whole.weights[..., None]], -1)
        i = p * np.arange(len(u) - 1)[:, None] + np.arange(p + 1)
        j = q * np.arange(len(v) - 1)[:, None] + np.arange(q + 1)
        points = poles[i[:, None, :, None], j[None, :, None, :]]
        ranges = np.empty((len(u) - 1, len(v) - 1, 4))
        ranges[..., 0], ranges[..., 1] = u[:-1, None], u[1:, None]
        ranges[..., 2], ranges[..., 3] = v[:-1], v[1:]
        return cls(points.reshape(-1, *points.shape[2:]), ranges.reshape(-1, 4))

    def boxes(self) -> tuple[Array, Array]:
        """Least and largest coordinates (k, 3)."""
        points = self.points
        if points.shape[-1] == 4:
            points = points[..., :3] / points[..., 3:]
        return points.min(axis=(1, 2)), points.max(axis=(1, 2))

    def halved(self, large: NDArray[np.bool_]) -> tuple[_Patches, NDArray[np.intp]]:
        """The large patches quartered, the others whole, and the successors (k, 4) of each."""
        kept, split = self.points[~large], self.points[large]
        low_u, high_u = _halves(split.shape[1] - 1)
        low_v, high_v = _halves(split.shape[2] - 1)
        middle = (self.ranges[large][:, [0, 2]] + self.ranges[large][:, [1, 3]]) / 2
        points, ranges = [kept], [self.ranges[~large]]
        for first, along_u in enumerate((low_u, high_u)):
            for second, along_v in enumerate((low_v, high_v)):
                points.append(np.einsum("ai,bj,kijd->kabd", along_u, along_v, split))
                quarter = self.ranges[large].copy()
                quarter[:, 1 - first] = middle[:, 0]
                quarter[:, 3 - second] = middle[:, 1]
                ranges.append(quarter)
        place = np.empty((len(large), 4), dtype=np.intp)
        place[~large] = np.arange(len(kept))[:, None]
        place[large] = len(kept) + np.arange(len(split))[:, None] + len(split) * np.arange(4)
        return _Patches(np.concatenate(points), np.concatenate(ranges)), place


def overlapping_patches(
    a: BSplineSurface, b: BSplineSurface, size: float, margin: float
) -> OverlappingPatches:
    """Pairs of patches no larger than a size whose boxes come nearer than a margin, mm.

    Raises
    ------
    ValueError: so many pairs that the surfaces must coincide over an area.
    """
    patches = [_Patches.of(a), _Patches.of(b)]
    one, other = _first_pairs(patches[0], patches[1], margin)
    while True:
        near = _near(patches[0], patches[1], one, other, margin)
        one, other = one[near], other[near]
        if len(one) > _PAIRS:
            raise ValueError(
                f"More than {_PAIRS} pairs of patches of the two surfaces lie close to each other: "
                "they coincide or touch over an area, which has no curve of intersection; move "
                "one of them, or cut the common part off."
            )
        children, valid = [], []
        for which, index in enumerate((one, other)):
            used, index = np.unique(index, return_inverse=True)
            own = _Patches(patches[which].points[used], patches[which].ranges[used])
            low, high = own.boxes()
            large = np.linalg.norm(high - low, axis=1) > size
            patches[which], place = own.halved(large)
            children.append(place[index])
            valid.append(large[index, None] | (np.arange(4) == 0))
        if not any(flags[:, 1:].any() for flags in valid):
            one, other = children[0][:, 0], children[1][:, 0]
            return OverlappingPatches(patches[0].ranges[one], patches[1].ranges[other])
        both = valid[0][:, :, None] & valid[1][:, None, :]
        one = np.broadcast_to(children[0][:, :, None], both.shape)[both]
        other = np.broadcast_to(children[1][:, None, :], both.shape)[both]


def _first_pairs(
    a: _Patches, b: _Patches, margin: float
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """All pairs of whole patches that are near, some rows of them at a time."""
    found = []
    (low_a, high_a), (low_b, high_b) = a.boxes(), b.boxes()
    rows = max(1, _AT_ONCE // len(low_b))
    for start in range(0, len(low_a), rows):
        part = slice(start, start + rows)
        near = (low_a[part, None] <= high_b + margin) & (low_b <= high_a[part, None] + margin)
        one, other = np.nonzero(near.all(axis=2))
        found.append((one + start, other))
    return np.concatenate([one for one, _ in found]), np.concatenate([two for _, two in found])


def _near(
    a: _Patches, b: _Patches, one: NDArray[np.intp], other: NDArray[np.intp], margin: float
) -> NDArray[np.bool_]:
    """Which pairs of boxes come nearer than the margin in every coordinate."""
    (low_a, high_a), (low_b, high_b) = a.boxes(), b.boxes()
    near = np.ones(len(one), dtype=bool)
    for axis in range(3):
        near &= low_a[one, axis] <= high_b[other, axis] + margin
        near &= low_b[other, axis] <= high_a[one, axis] + margin
    return near


def _missing(knots: Array, degree: int) -> Array:
    """Knots to insert so that every inner one counts as often as the degree."""
    inner, counts = np.unique(knots[degree + 1 : -degree - 1], return_counts=True)
    return np.repeat(inner, degree - counts)


def _halves(degree: int) -> tuple[Array, Array]:
    """Matrices from a Bézier curve's points to those of its two halves (de Casteljau)."""
    low = np.array([[comb(i, j) / 2.0**i for j in range(degree + 1)] for i in range(degree + 1)])
    return low, low[::-1, ::-1]
