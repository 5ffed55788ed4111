# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sharp edges of a shape as sampled curves: the truth a scan is compared with."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from ..cloud.true_edge import TrueEdge

__all__ = ["smooth_faces", "true_edges"]

Array = NDArray[np.float64]

_CHORD = 1e-6  # of the edge's length
_FEWEST, _MOST = 128, 4096
_ROOM_PLACES = 33


def true_edges(shape: Any, min_angle: float = 0.26) -> list[TrueEdge]:
    """Find the sharp edges of a shape and sample them.

    An edge is sharp where two faces meet and their outward normals turn by at least ``min_angle``
    at half of its samples or more. Seams, edges of one face only and smooth edges are left out.

    Parameters
    ----------
    shape : Part.Shape
        A solid, shell or compound of them, mm.
    min_angle : float
        Least turn between the normals, rad.

    Returns
    -------
    One TrueEdge for each sharp edge, in the order of the shape's edges, named as FreeCAD names
    them (``Edge7``). ``angle`` is the smaller wedge between the two faces (pi less the turn),
    ``convex`` says whether that wedge is material. The chords between samples stay within 1e-6 of
    the edge's length. ``room`` is, at each sample, the distance in the plane across the edge
    to the next place where a sharp edge (another one, or this one further on) passes through
    that plane; infinite where none does. At a vertex itself the edges that meet there do not
    count.

    Raises
    ------
    ValueError: the shape has no faces.
    """
    if not shape.Faces:
        raise ValueError(
            f"The shape is a {shape.ShapeType if not shape.isNull() else 'null shape'} "
            "without faces; give a solid or a shell."
        )
    drafts = []
    faces_of = _faces_of_edges(shape)
    for number, edge in enumerate(shape.Edges, start=1):
        faces = faces_of[number - 1]
        if edge.Degenerated or len(faces) != 2:
            continue
        draft = _sampled(f"Edge{number}", edge, faces)
        if draft is not None and np.median(np.pi - draft["angle"]) >= min_angle:
            drafts.append(draft)
    rooms = _rooms([draft["points"] for draft in drafts], [draft["closed"] for draft in drafts])
    return [TrueEdge(**draft, room=room) for draft, room in zip(drafts, rooms, strict=True)]


def smooth_faces(shape: Any, min_angle: float = 0.26) -> NDArray[np.intp]:
    """Number of the smooth face to which each face of a shape belongs, (faces,).

    Faces that meet in an edge that is not sharp are one.

    Parameters
    ----------
    shape, min_angle : as of `true_edges`
    """
    sharp = {edge.name for edge in true_edges(shape, min_angle)}
    faces = shape.Faces
    pairs = [
        [next(k for k, face in enumerate(faces) if face.isSame(meeting)) for meeting, _ in both]
        for number, both in enumerate(_faces_of_edges(shape), start=1)
        if len(both) == 2 and f"Edge{number}" not in sharp
    ]
    one, other = np.array(pairs, dtype=np.intp).reshape(-1, 2).T
    graph = coo_matrix((np.ones(len(one)), (one, other)), shape=(len(faces), len(faces)))
    return np.asarray(connected_components(graph, directed=False)[1], dtype=np.intp)


def _faces_of_edges(shape: Any) -> list[list[tuple[Any, str]]]:
    """For each edge of the shape the faces it bounds, and its orientation there."""
    rank: dict[int, list[int]] = {}
    edges = shape.Edges
    for index, edge in enumerate(edges):
        rank.setdefault(edge.hashCode(), []).append(index)
    faces_of: list[list[tuple[Any, str]]] = [[] for _ in edges]
    for face in shape.Faces:
        for edge in face.Edges:
            for index in rank.get(edge.hashCode(), ()):
                if edges[index].isSame(edge):
                    faces_of[index].append((face, edge.Orientation))
    return faces_of


def _sampled(name: str, edge: Any, faces: list[tuple[Any, str]]) -> dict[str, Any] | None:
    """The edge's samples without the room; None when it has no length or no normal."""
    first, last = edge.ParameterRange
    closed = bool(edge.isClosed())
    count = _FEWEST
    while True:
        parameters = np.linspace(first, last, count + 1)
        points = _vectors([edge.valueAt(t) for t in parameters.tolist()])
        length = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
        if length <= 0.0:
            return None
        sag = np.linalg.norm(points[1:-1] - (points[:-2] + points[2:]) / 2.0, axis=1).max() / 4.0
        if sag <= _CHORD * length or count >= _MOST:
            break
        count *= 2
    tangents = _unit(_vectors([edge.tangentAt(t) for t in parameters.tolist()]))
    tangents *= np.sign(np.sum(tangents[:-1] * np.diff(points, axis=0)) or 1.0)
    normals = [_normals(face, edge, points) for face, _ in faces]
    turn = np.arctan2(
        np.linalg.norm(np.cross(normals[0], normals[1]), axis=1), np.einsum("ij,ij->i", *normals)
    )
    inwards = np.cross(normals[0], tangents)
    if faces[0][1] == "Reversed":
        inwards = -inwards
    convex = bool(np.median(np.einsum("ij,ij->i", inwards, normals[1])) < 0.0)
    keep = slice(0, -1) if closed else slice(None)
    return {
        "name": name,
        "points": points[keep],
        "tangents": tangents[keep],
        "angle": (np.pi - turn)[keep],
        "convex": convex,
        "closed": closed,
    }


def _normals(face: Any, edge: Any, points: Array) -> Array:
    """Outward unit normals (n, 3) of the face at points of its surface."""
    import FreeCAD

    surface = face.Surface
    found = []
    for point in points:
        u, v = surface.parameter(FreeCAD.Vector(*point))
        found.append(surface.normal(u, v))
    outward = -1.0 if face.Orientation == "Reversed" else 1.0
    return outward * _unit(_vectors(found))


def _rooms(curves: list[Array], closed: list[bool]) -> list[Array]:
    """Room of each curve's samples among all the curves."""
    plain = [_thinned(curve, loop) for curve, loop in zip(curves, closed, strict=True)]
    starts = np.vstack([line[:-1] for line in plain]) if plain else np.zeros((0, 3))
    ends = np.vstack([line[1:] for line in plain]) if plain else np.zeros((0, 3))
    rooms = []
    for curve, loop in zip(curves, closed, strict=True):
        places = np.unique(np.linspace(0, len(curve) - 1, _ROOM_PLACES).astype(int))
        step = np.roll(curve, -1, axis=0) - np.roll(curve, 1, axis=0)
        if not loop:
            step[[0, -1]] = curve[1] - curve[0], curve[-1] - curve[-2]
        room = _room(curve[places], _unit(step[places]), starts, ends)
        rooms.append(np.interp(np.arange(len(curve)), places, room))
    return rooms


def _room(points: Array, tangents: Array, starts: Array, ends: Array) -> Array:
    """Distance to the nearest crossing of segments with the plane across at each point."""
    before = starts @ tangents.T - np.einsum("ij,ij->i", points, tangents)
    after = ends @ tangents.T - np.einsum("ij,ij->i", points, tangents)
    scale = 1e-9 + 1e-6 * float(np.ptp(np.vstack([starts, ends]), axis=0).max())
    crosses = (before <= scale) & (after >= -scale) | (before >= -scale) & (after <= scale)
    room = np.full(len(points), np.inf)
    segment, place = np.nonzero(crosses)
    low, high = before[segment, place], after[segment, place]
    flat = np.abs(high - low) <= 2.0 * scale
    share = np.clip(-low / np.where(flat, 1.0, high - low), 0.0, 1.0)
    away = ends[segment] - starts[segment]
    offset = points[place] - starts[segment]
    size = np.einsum("ij,ij->i", away, away)
    nearest = np.clip(np.einsum("ij,ij->i", offset, away) / size, 0.0, 1.0)
    share = np.where(flat, nearest, share)
    distance = np.linalg.norm(share[:, None] * away - offset, axis=1)
    other = distance > 1e3 * scale
    np.minimum.at(room, place[other], distance[other])
    return room


def _thinned(curve: Array, loop: bool) -> Array:
    """The fewest samples, evenly chosen, whose chords stay within 1e-3 of the length."""
    line = np.vstack([curve, curve[:1]]) if loop else curve
    length = np.linalg.norm(np.diff(line, axis=0), axis=1).sum()
    count = 1
    while count < len(line) - 1:
        kept = np.unique(np.linspace(0, len(line) - 1, count + 1).astype(int))
        filled = np.column_stack(
            [np.interp(np.arange(len(line)), kept, line[kept, axis]) for axis in range(3)]
        )
        if np.linalg.norm(filled - line, axis=1).max() <= 1e-3 * length:
            return line[kept]
        count *= 2
    return line


def _vectors(vectors: list[Any]) -> Array:
    return np.array([(v.x, v.y, v.z) for v in vectors], dtype=float).reshape(-1, 3)


def _unit(vectors: Array) -> Array:
    size = np.linalg.norm(vectors, axis=1, keepdims=True)
    return vectors / np.where(size > 0.0, size, 1.0)
