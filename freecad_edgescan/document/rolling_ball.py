# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the centre of a ball can be that rolls over a shape.

Over the faces the centres lie on offset surfaces, round convex edges on tubes, round convex
corners on spheres; none of them may be closer than the radius to any place of the shape.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from ..cloud.true_edge import TrueEdge
from .contacts import Contacts
from .nurbs_face import NurbsFace
from .triangle_distance import triangle_distance

__all__ = ["ball_contacts", "without_collisions"]

Array = NDArray[np.float64]

_NEIGHBOURS = 12
_DEPTH = 1e-6  # of the radius; plus the triangles' own error


def ball_contacts(
    shape: Any,
    faces: Sequence[NurbsFace],
    edges: Sequence[TrueEdge],
    density: float,
    radius: float,
    rng: np.random.Generator,
) -> Contacts:
    """Random centres over faces, convex edges and corners, so many per mm², collisions included.

    Parameters
    ----------
    shape : Part.Shape
    faces : one NurbsFace for each of its faces
    edges : its true edges
    density : centres per mm² of the surface they lie on
    radius : of the ball, mm
    rng : source of chance
    """
    parts = [
        Contacts.on_face(face, label, density, radius, rng) for label, face in enumerate(faces)
    ]
    ends = []
    for edge in edges:
        if edge.convex:
            sides = _sides(shape, faces, edge)
            parts.append(_round_edge(edge, sides, density, radius, rng))
            if not edge.closed:
                normals = np.stack([side[1] for side in sides], axis=1)
                labels = [side[0] for side in sides]
                ends += [(edge.points[end], normals[end], labels) for end in (0, -1)]
    parts += _round_corners(ends, density, radius, rng)
    return Contacts.join(parts)


def _sides(shape: Any, faces: Sequence[NurbsFace], edge: TrueEdge) -> list[tuple[int, Array]]:
    """Number and normals (m, 3) of the two faces that meet at an edge."""
    kernel_edge = shape.Edges[int(edge.name.removeprefix("Edge")) - 1]
    numbers = [
        label
        for label, face in enumerate(shape.Faces)
        if any(kernel_edge.isSame(other) for other in face.Edges)
    ]
    return [(label, faces[label].locate(edge.points)[2]) for label in numbers]


def _round_edge(
    edge: TrueEdge,
    sides: list[tuple[int, Array]],
    density: float,
    radius: float,
    rng: np.random.Generator,
) -> Contacts:
    """Centres on the tube round a convex edge, between the two faces' normals."""
    (first_label, first), (second_label, second) = sides
    points = edge.points
    if edge.closed:
        points, first, second = (np.vstack([a, a[:1]]) for a in (points, first, second))
    turn = np.arctan2(
        np.linalg.norm(np.cross(first, second), axis=1), np.einsum("ij,ij->i", first, second)
    )
    length = np.linalg.norm(np.diff(points, axis=0), axis=1)
    widest = 1.5 * radius * turn.max()
    count = rng.poisson(density * widest * length.sum())
    along = np.cumsum(length)
    segment = np.searchsorted(along, rng.random(count) * along[-1], side="right")
    segment = np.minimum(segment, len(length) - 1)
    share = rng.random((count, 1))
    angle_share = rng.random((count, 1))

    def between(values: Array, at: Array) -> Array:
        return values[segment] + at * (values[segment + 1] - values[segment])

    def direction(at: Array) -> Array:
        a, b = between(first, at), between(second, at)
        theta = between(turn[:, None], at)
        mix = np.sin((1.0 - angle_share) * theta) * a + np.sin(angle_share * theta) * b
        return mix / np.linalg.norm(mix, axis=1, keepdims=True)

    normal = direction(share)
    step = points[segment + 1] - points[segment]
    swept = step + radius * (direction(np.ones_like(share)) - direction(np.zeros_like(share)))
    forward = step / length[segment, None]
    stretch = np.einsum("ij,ij->i", swept, forward) / length[segment]
    theta = between(turn[:, None], share)[:, 0]
    kept = rng.random(count) * widest <= radius * theta * np.clip(stretch, 0.0, 1.5)
    centres = between(points, share) + radius * normal
    labels = np.where(angle_share[:, 0] < 0.5, first_label, second_label).astype(np.intp)
    return Contacts(centres[kept], normal[kept], labels[kept])


def _round_corners(
    ends: list[tuple[Array, Array, list[int]]],
    density: float,
    radius: float,
    rng: np.random.Generator,
) -> list[Contacts]:
    """Centres on the spheres round the ends of convex edges, in all directions."""
    if not ends:
        return []
    places = np.array([end[0] for end in ends])
    reach = 1e-6 * float(np.ptp(places, axis=0).max(initial=1.0))
    groups = cKDTree(places).query_ball_point(places, reach)
    parts = []
    for number, group in enumerate(groups):
        if min(group) != number:
            continue
        normals = np.vstack([ends[member][1] for member in group])
        labels = np.concatenate([ends[member][2] for member in group])
        axis = normals.sum(axis=0)
        axis /= np.linalg.norm(axis) or 1.0
        lowest = max(-1.0, float((normals @ axis).min()) - 0.01)
        count = rng.poisson(density * 2.0 * np.pi * radius**2 * (1.0 - lowest))
        direction = _on_cap(axis, lowest, count, rng)
        nearest = labels[np.argmax(direction @ normals.T, axis=1)].astype(np.intp)
        parts.append(Contacts(places[number] + radius * direction, direction, nearest))
    return parts


def _on_cap(axis: Array, lowest: float, count: int, rng: np.random.Generator) -> Array:
    """Uniformly random directions whose cosine to the axis is at least ``lowest``."""
    height = rng.uniform(lowest, 1.0, count)
    turn = rng.uniform(0.0, 2.0 * np.pi, count)
    across = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    across /= np.linalg.norm(across)
    other = np.cross(axis, across)
    width = np.sqrt(1.0 - height**2)
    return (
        height[:, None] * axis
        + (width * np.cos(turn))[:, None] * across
        + (width * np.sin(turn))[:, None] * other
    )


def without_collisions(
    contacts: Contacts, faces: Sequence[NurbsFace], pitch: float, radius: float
) -> Contacts:
    """Leave out the centres closer than the radius to any place of the shape.

    The triangles round the nearest of many samples are measured exactly, so that only the
    triangles' own error on curved faces remains.
    """
    triangles = np.vstack([face.triangles for face in faces])
    samples, owner = _samples(triangles, pitch)
    tree = cKDTree(samples)
    error = np.repeat([face.chord for face in faces], [len(face.triangles) for face in faces])
    limit = radius * (1.0 - _DEPTH) - 1.5 * error
    kept = np.ones(len(contacts), dtype=bool)
    count = min(_NEIGHBOURS, len(samples))
    for low in range(0, len(contacts), 20_000):
        block = slice(low, low + 20_000)
        centres = contacts.centres[block]
        reach = radius + pitch
        distance, nearest = tree.query(
            centres, k=list(range(1, count + 1)), distance_upper_bound=reach
        )
        row, column = np.nonzero(np.isfinite(distance))
        chosen = owner[nearest[row, column]]
        pairs = np.unique(np.column_stack([row, chosen]), axis=0)
        close = triangle_distance(centres[pairs[:, 0]], triangles[pairs[:, 1]])
        close = close < limit[pairs[:, 1]]
        kept[low + pairs[close, 0]] = False
    return contacts.taken(kept)


def _samples(triangles: Array, pitch: float) -> tuple[Array, NDArray[np.intp]]:
    """Points on the triangles at most about half a pitch apart, and the triangle of each."""
    longest = np.linalg.norm(triangles - np.roll(triangles, 1, axis=1), axis=2).max(axis=1)
    parts = np.maximum(1, np.ceil(longest / (0.5 * pitch))).astype(int)
    points, owner = [], []
    for count in np.unique(parts):
        which = np.flatnonzero(parts == count)
        i, j = np.nonzero(np.add.outer(np.arange(count + 1), np.arange(count + 1)) <= count)
        a, b = i / count, j / count
        share = np.column_stack([1.0 - a - b, a, b])
        points.append(np.einsum("sc,tcd->tsd", share, triangles[which]).reshape(-1, 3))
        owner.append(np.repeat(which, len(share)))
    return np.vstack(points), np.concatenate(owner)
