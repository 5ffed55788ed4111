# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plane, cylinder, cone, sphere or quadric that points lie on, chosen by evidence.

1. Many shapes through two or three points and their normals are tried; the one with the least
   median distance is near, though up to half of the points may be strays (Schnabel, Wahl and Klein
   2007, Efficient RANSAC for point-cloud shape detection).
2. It is fitted to the points that belong to it, by their true distances.
3. Of the fitted shapes the one with the least sum of squared distances is taken, strays counting
   as what they could at most be, after each unknown is paid for (Bayesian information criterion).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from ..cloud.progress import Progress
from .primitive_shapes import (
    Cone,
    Cylinder,
    FlatPlane,
    Primitive,
    QuadricGraph,
    ShapeKind,
    Sphere,
)

__all__ = ["fitted_primitives", "simplest_primitive"]

Array = NDArray[np.float64]

_TRIES = 400
_JUDGES = 400  # points the tries are judged by
_ROUNDS = 6
_STEPS = 60  # evaluations in a round
_STRAY = 3.0  # of the spread: points farther away belong to something else
_MEDIAN = 1.4826  # standard deviations in a median absolute deviation
_EXACT = 1e-7  # of the size: differences below are rounding
_LARGEST = 1e3  # radius, in sizes of the cloud, that is still told from a plane


def fitted_primitives(
    points: Array,
    normals: Array,
    kinds: tuple[ShapeKind, ...],
    progress: Progress | None = None,
) -> dict[ShapeKind, Primitive]:
    """Shapes of some kinds fitted to points; kinds that cannot be are missing.

    Parameters
    ----------
    points : (n, 3) mm, near the origin
    normals : (n, 3) unit vectors of either sign, nan where unknown
    kinds : of plane, cylinder, cone, sphere and quadric
    progress : told the share that is done; where it answers False, the kinds so far are the result
    """
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    known = np.isfinite(normals[:, 0])
    draws = _draws(points[known], normals[known]) if known.sum() >= 3 else None
    found: dict[ShapeKind, Primitive] = {}
    for number, kind in enumerate(kinds, 1):
        shape = _fit(kind, points, draws, size)
        if shape is not None:
            found[kind] = shape
        if progress and found and not progress.update(number / len(kinds), None):
            break
    return found


def simplest_primitive(
    shapes: dict[ShapeKind, Primitive], points: Array, noise: float
) -> tuple[Primitive, float]:
    """The shape that explains points best for its unknowns, and its spread, mm.

    Parameters
    ----------
    shapes : fitted ones
    points : (n, 3) mm
    noise : mm, standard deviation that the points have anyway
    """
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    distances = {kind: np.abs(shape.distances(points)) for kind, shape in shapes.items()}
    spreads = {kind: _spread(own, size) for kind, own in distances.items()}
    scale = max(min(spreads.values()), 0.5 * noise)
    cost = {
        kind: float(np.sum(np.minimum(own / scale, _STRAY) ** 2))
        + shapes[kind].unknowns * np.log(len(points))
        for kind, own in distances.items()
    }
    best = min(cost, key=lambda kind: cost[kind])
    return shapes[best], spreads[best]


def _spread(distances: Array, size: float) -> float:
    """Standard deviation of the distances that are no strays, mm."""
    start = max(_MEDIAN * float(np.median(distances)), _EXACT * size)
    near = distances[distances <= _STRAY * start]
    return max(float(np.sqrt(np.mean(near**2))), _EXACT * size) if len(near) else start


def _draws(points: Array, normals: Array) -> tuple[Array, Array]:
    """Three points (k, 3, 3) and their normals for each try."""
    rows = np.random.default_rng(0).integers(0, len(points), (_TRIES, 3))
    return points[rows], normals[rows]


def _fit(
    kind: ShapeKind, points: Array, draws: tuple[Array, Array] | None, size: float
) -> Primitive | None:
    if kind is ShapeKind.QUADRIC:
        return _quadric(points, size)
    tried: list[Primitive] = []
    if kind is ShapeKind.PLANE:
        tried.append(_plane(points))
    if draws is not None:
        tried.extend(_TRIED[kind](*draws, size))
    if kind is ShapeKind.SPHERE:
        tried += _algebraic_sphere(points, size)
    if not tried:
        return None
    judges = points[:: max(1, len(points) // _JUDGES)]
    misfit = [float(np.median(np.abs(shape.distances(judges)))) for shape in tried]
    shape = tried[int(np.argmin(misfit))]
    for _ in range(_ROUNDS):
        off = np.abs(shape.distances(points))
        near = points[off <= _STRAY * _spread(off, size)]
        if len(near) <= shape.unknowns:
            return None
        better = _REFINED[kind](shape, near, size)
        change = float(np.abs(better.distances(points) - shape.distances(points)).max())
        shape = better
        if change < _EXACT * size:
            break
    return shape if np.isfinite(shape.distances(points)).all() else None


def _plane(points: Array) -> FlatPlane:
    centre = points.mean(axis=0)
    away = points - centre
    return FlatPlane(centre, np.linalg.eigh(away.T @ away)[1][:, 0])


def _planes(points: Array, normals: Array, size: float) -> list[Primitive]:
    across = np.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0])
    length = np.linalg.norm(across, axis=1)
    good = length > 1e-6 * size**2
    return [
        FlatPlane(point, normal / far)
        for point, normal, far in zip(points[good, 0], across[good], length[good], strict=True)
    ]


def _spheres(points: Array, normals: Array, size: float) -> list[Primitive]:
    """Through two points, with the centre where their normals come nearest to each other."""
    found: list[Primitive] = []
    centre = _between_lines(points[:, 0], normals[:, 0], points[:, 1], normals[:, 1])
    radius = np.linalg.norm(points[:, 0] - centre, axis=1)
    for middle, own in zip(centre, radius, strict=True):
        if 0.0 < own < _LARGEST * size:
            found.append(Sphere(middle, float(own)))
    return found


def _algebraic_sphere(points: Array, size: float) -> list[Primitive]:
    centre = points.mean(axis=0)
    x = points - centre
    rows = np.column_stack([2.0 * x, np.ones(len(x))])
    solved = np.linalg.lstsq(rows, (x**2).sum(axis=1), rcond=None)[0]
    square = solved[3] + solved[:3] @ solved[:3]
    if not 0.0 < square < (_LARGEST * size) ** 2:
        return []
    return [Sphere(centre + solved[:3], float(np.sqrt(square)))]


def _cylinders(points: Array, normals: Array, size: float) -> list[Cylinder]:
    """Square to two normals, round where they cross."""
    axis = np.cross(normals[:, 0], normals[:, 1])
    sine = np.linalg.norm(axis, axis=1)
    good = sine > 0.02
    axis = axis[good] / sine[good, None]
    p, n = points[good], normals[good]
    centre = _between_lines(p[:, 0], n[:, 0], p[:, 1], n[:, 1])
    away = p[:, 0] - centre
    ring = np.linalg.norm(away - np.sum(away * axis, axis=1)[:, None] * axis, axis=1)
    return [
        Cylinder(middle, way, float(own))
        for middle, way, own in zip(centre, axis, ring, strict=True)
        if 0.0 < own < _LARGEST * size
    ]


def _cones(points: Array, normals: Array, size: float) -> list[Primitive]:
    """With the apex where three tangent planes meet, and cylinders, for those that hardly taper."""
    found: list[Primitive] = [
        Cone(shape.point, shape.axis, shape.radius, 0.0)
        for shape in _cylinders(points, normals, size)
    ]
    usable = np.abs(np.linalg.det(normals)) > 1e-3
    p, n = points[usable], normals[usable]
    if not len(p):
        return found
    apex = np.linalg.solve(n, np.sum(n * p, axis=2)[..., None])[..., 0]
    arms = p - apex[:, None]
    length = np.linalg.norm(arms, axis=2, keepdims=True)
    arms = arms / np.where(length > 0.0, length, 1.0)
    axis = np.cross(arms[:, 1] - arms[:, 0], arms[:, 2] - arms[:, 0])
    norm = np.linalg.norm(axis, axis=1)
    for k in np.flatnonzero(norm > 1e-9):
        way = axis[k] / norm[k]
        cosine = float(np.mean(arms[k] @ way))
        if cosine < 0.0:
            way, cosine = -way, -cosine
        slope = float(np.arccos(np.clip(cosine, 0.0, 1.0)))
        if 0.005 < slope < 1.5:
            ahead = float(np.mean((p[k] - apex[k]) @ way))
            found.append(Cone(apex[k] + ahead * way, way, ahead * float(np.tan(slope)), slope))
    return found


def _between_lines(p: Array, a: Array, q: Array, b: Array) -> Array:
    """Middles (k, 3) of the shortest ways between lines through p and q along a and b."""
    w, cosine = p - q, np.sum(a * b, axis=1)
    sine = np.maximum(1.0 - cosine**2, 1e-12)
    d, e = np.sum(a * w, axis=1), np.sum(b * w, axis=1)
    s, t = (cosine * e - d) / sine, (e - cosine * d) / sine
    return np.asarray((p + s[:, None] * a + q + t[:, None] * b) / 2.0)


def _refined_plane(shape: Primitive, near: Array, size: float) -> Primitive:
    return _plane(near)


def _refined_sphere(shape: Primitive, near: Array, size: float) -> Primitive:
    assert isinstance(shape, Sphere)
    start = shape
    # offset and bend where the points are stay well-conditioned when the radius is large
    middle = near.mean(axis=0)
    way = middle - start.centre
    way /= np.linalg.norm(way) or 1.0

    def moved(x: Array) -> Sphere:
        radius = start.radius * float(np.exp(x[3]))
        return Sphere(start.centre + size * x[:3] + way * (start.radius - radius), radius)

    return moved(
        least_squares(
            lambda x: moved(x).distances(near), np.zeros(4), method="lm", max_nfev=_STEPS
        ).x
    )


def _refined_cone(shape: Primitive, near: Array, size: float) -> Primitive:
    assert isinstance(shape, Cone)
    middle = near.mean(axis=0)
    point = shape.point + ((middle - shape.point) @ shape.axis) * shape.axis
    height = float((point - shape.point) @ shape.axis)
    radius = shape.radius + height * np.tan(shape.slope)
    frame = _across(shape.axis)
    out = middle - point
    out /= np.linalg.norm(out) or 1.0

    def moved(x: Array) -> Cone:
        axis = Rotation.from_rotvec(x[:2] @ frame).apply(shape.axis)
        grown = radius * float(np.exp(x[4]))
        place = point + size * x[2:4] @ frame + out * (radius - grown)
        if isinstance(shape, Cylinder):
            return Cylinder(place, axis, grown)
        return Cone(place, axis, grown, float(np.clip(shape.slope + x[5], -1.55, 1.55)))

    start = np.zeros(shape.unknowns)
    return moved(
        least_squares(lambda x: moved(x).distances(near), start, method="lm", max_nfev=_STEPS).x
    )


def _across(axis: Array) -> Array:
    """Two unit vectors (2, 3) square to an axis."""
    first = np.cross(axis, np.eye(3)[int(np.argmin(np.abs(axis)))])
    first /= np.linalg.norm(first)
    return np.stack([first, np.cross(axis, first)])


def _quadric(points: Array, size: float) -> QuadricGraph | None:
    """The graph over the plane that suits it best; a quadric over one plane is none over others."""
    start = _plane(points)
    across = _across(start.normal)
    near = np.ones(len(points), dtype=bool)
    tilt = np.zeros(2)
    shape = None
    for _ in range(_ROUNDS):
        if near.sum() <= QuadricGraph.unknowns:
            return None

        def moved(x: Array, some: Array = points[near]) -> QuadricGraph:
            turn = Rotation.from_rotvec(x @ across).as_matrix()
            frame = np.concatenate([across, start.normal[None]]) @ turn.T
            return _graph(some, start.point, frame, size)

        def misfit(x: Array, some: Array = points[near]) -> Array:
            return moved(x).distances(some)

        tilt = least_squares(misfit, tilt, method="lm", max_nfev=_STEPS).x
        shape = moved(tilt)
        off = np.abs(shape.distances(points))
        kept = off <= _STRAY * _spread(off, size)
        if np.array_equal(kept, near):
            break
        near = kept
    return shape


def _graph(points: Array, origin: Array, frame: Array, size: float) -> QuadricGraph:
    a, b, h = ((points - origin) @ frame.T).T / (size or 1.0)
    terms = np.stack([np.ones_like(a), a, b, a * a, a * b, b * b], axis=1)
    solved = np.linalg.lstsq(terms, h, rcond=None)[0]
    return QuadricGraph(origin, frame, solved * (size or 1.0) ** np.array([1.0, 0, 0, -1, -1, -1]))


_TRIED: dict[ShapeKind, Callable[[Array, Array, float], Sequence[Primitive]]] = {
    ShapeKind.PLANE: _planes,
    ShapeKind.SPHERE: _spheres,
    ShapeKind.CYLINDER: _cylinders,
    ShapeKind.CONE: _cones,
}
_REFINED: dict[ShapeKind, Callable[[Primitive, Array, float], Primitive]] = {
    ShapeKind.PLANE: _refined_plane,
    ShapeKind.SPHERE: _refined_sphere,
    ShapeKind.CYLINDER: _refined_cone,
    ShapeKind.CONE: _refined_cone,
}
