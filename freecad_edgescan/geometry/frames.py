# SPDX-License-Identifier: LGPL-2.1-or-later
"""Directions along a curve given as a polyline: frames that do not twist, and curvature."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "cross",
    "curvature_of_three_points",
    "curvature_of_polyline",
    "orthonormalise",
    "rotate",
    "rotation_minimising_frames",
    "turned_along",
    "unit",
]

Array = NDArray[np.float64]
_NEXT = np.array([1, 2, 0])
_AFTER = np.array([2, 0, 1])


def cross(one: Array, other: Array) -> Array:
    """Cross product of (..., 3) arrays: NumPy's, without its care for other shapes."""
    return one[..., _NEXT] * other[..., _AFTER] - one[..., _AFTER] * other[..., _NEXT]


def unit(vectors: Array) -> Array:
    """Vectors (..., 3) divided by their lengths, which must not be zero."""
    return vectors / np.sqrt(np.einsum("...i,...i->...", vectors, vectors))[..., None]


def rotate(vectors: ArrayLike, axis: ArrayLike, angle: ArrayLike) -> Array:
    """Vectors turned about an axis through the origin (Rodrigues' formula).

    Parameters
    ----------
    vectors : (..., 3) array
        What is turned.
    axis : (..., 3) array
        Unit vectors.
    angle : (...) array
        rad, by the right-hand rule.
    """
    vectors, axis = np.asarray(vectors, dtype=float), np.asarray(axis, dtype=float)
    angle = np.asarray(angle, dtype=float)[..., None]
    along = np.sum(vectors * axis, axis=-1, keepdims=True) * axis
    return along + np.cos(angle) * (vectors - along) + np.sin(angle) * np.cross(axis, vectors)


def turned_along(vectors: Array, before: Array, after: Array) -> Array:
    """Vectors (m, k, 3) turned by the smallest rotation that takes one direction to another.

    Parameters
    ----------
    before, after : (m, 3) unit vectors, not opposite to each other
    """
    axis = cross(before, after)
    cosine = np.einsum("mi,mi->m", before, after)[:, None, None]
    about = np.einsum("mi,mki->mk", axis, vectors)[..., None]
    turned = vectors * cosine + cross(axis[:, None], vectors)
    return np.asarray(turned + axis[:, None] * about / np.maximum(1.0 + cosine, 1e-9))


def orthonormalise(tangents: ArrayLike, vectors: ArrayLike) -> Array:
    """Unit vectors (..., 3): `vectors` without their share along the unit `tangents`.

    Where nothing remains, any perpendicular direction is taken.
    """
    t, v = np.broadcast_arrays(np.asarray(tangents, dtype=float), np.asarray(vectors, dtype=float))
    across = v - np.sum(t * v, axis=-1, keepdims=True) * t
    length = np.linalg.norm(across, axis=-1, keepdims=True)
    spare = np.eye(3)[np.argmin(np.abs(t), axis=-1)]
    spare = spare - np.sum(t * spare, axis=-1, keepdims=True) * t
    lost = length <= 1e-12 * np.linalg.norm(v, axis=-1, keepdims=True)
    across = np.where(lost, spare, across)
    return across / np.linalg.norm(across, axis=-1, keepdims=True)


def rotation_minimising_frames(
    points: ArrayLike, tangents: ArrayLike, start: ArrayLike | None = None
) -> Array:
    """Frames along a curve that turn about its tangent as little as possible.

    Double reflection of Wang, Juettler, Zheng and Liu, Computation of rotation minimizing frames,
    ACM Transactions on Graphics 27 (2008).

    Parameters
    ----------
    points : (m, 3) array
        Points of the curve, mm.
    tangents : (m, 3) array
        Its unit tangents.
    start : (3,) array, optional
        Direction of the first frame's second axis; any, when not given.

    Returns
    -------
    frames (m, 3, 3): rows are tangent, second axis, third axis (right-handed).
    """
    x, t = np.asarray(points, dtype=float), np.asarray(tangents, dtype=float)
    step = np.diff(x, axis=0)
    still = np.sum(step**2, axis=1) == 0.0
    first = _reflections(np.where(still[:, None], t[:-1], step))
    turned = np.einsum("mij,mj->mi", first, t[:-1])
    moves = _reflections(t[1:] - turned) @ first
    second = np.empty_like(x)
    second[0] = orthonormalise(t[0], np.zeros(3) if start is None else start)
    for i, move in enumerate(moves):
        second[i + 1] = move @ second[i]
    second = orthonormalise(t, second)
    return np.stack([t, second, np.cross(t, second)], axis=1)


def _reflections(normals: Array) -> Array:
    """Matrices (m, 3, 3) that mirror at the planes with these normals."""
    square = np.sum(normals**2, axis=1)
    square = np.where(square > 0.0, square, np.inf)
    return np.eye(3) - 2.0 * normals[:, :, None] * normals[:, None, :] / square[:, None, None]


def curvature_of_three_points(before: ArrayLike, at: ArrayLike, after: ArrayLike) -> Array:
    """Curvature vectors (..., 3) at the middle ones of three points, 1/mm.

    They point to the centre of the circle through the three; zero where the three are on a line.
    """
    at = np.asarray(at, dtype=float)
    a, b = np.asarray(before, dtype=float) - at, np.asarray(after, dtype=float) - at
    aa, bb = (np.sum(v * v, axis=-1, keepdims=True) for v in (a, b))
    normal = np.cross(a, b)
    square = np.sum(normal**2, axis=-1, keepdims=True)
    flat = square <= 1e-24 * aa * bb
    to_centre = np.cross(aa * b - bb * a, normal) / np.where(flat, 1.0, 2.0 * square)
    radius_square = np.sum(to_centre**2, axis=-1, keepdims=True)
    return np.where(flat, 0.0, to_centre / np.where(flat, 1.0, radius_square))


def curvature_of_polyline(
    points: ArrayLike, reach: int = 3, closed: bool = False
) -> tuple[Array, Array]:
    """Unit tangents and curvature vectors from parabolas through each point's neighbours.

    Parameters
    ----------
    points : (m, 3) array
        In order, mm, m >= 3.
    reach : int
        Number of neighbours on each side; at an open end the window is shifted inwards.
    closed : bool
        Whether the last point is followed by the first.

    Returns
    -------
    tangents (m, 3) and curvature vectors (m, 3), 1/mm, perpendicular to the tangents.

    Raises
    ------
    ValueError: fewer than three points.
    """
    x = np.asarray(points, dtype=float)
    m = len(x)
    if m < 3:
        raise ValueError(f"Curvature needs at least 3 points, not {m}.")
    reach = max(1, min(reach, (m - 1) // 2))
    window = np.arange(m)[:, None] + np.arange(-reach, reach + 1)
    if not closed:
        window += np.clip(-window[:, :1], 0, None) - np.clip(window[:, -1:] - m + 1, 0, None)
    step = np.linalg.norm(np.roll(x, -1, axis=0) - x, axis=1)
    round_trip = step.sum() if closed else 0.0
    length = np.append(0.0, np.cumsum(step[:-1]))
    turn, place = np.divmod(window, m)
    s = length[place] + turn * round_trip - length[:, None]
    unit = np.maximum(np.abs(s).max(axis=1), np.finfo(float).tiny)[:, None]
    basis = (s / unit)[..., None] ** np.arange(3)
    coefficients = np.linalg.pinv(basis, rcond=1e-9) @ x[place]
    first, second = coefficients[:, 1] / unit, 2.0 * coefficients[:, 2] / unit**2
    square = np.sum(first**2, axis=1, keepdims=True)
    square = np.where(square > 0.0, square, np.inf)
    bend = (second - np.sum(first * second, axis=1, keepdims=True) / square * first) / square
    return first / np.sqrt(square), bend
