# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric shell: surfaces trimmed where they meet or where edges run, and sewn together.

OpenCASCADE splits all surfaces along each other and along the edges. A piece belongs to the shell
when it has no free side: another piece that belongs to it, or one of the edges, is there. What
sticks out beyond is dropped. The name of this module and of `TrimmedShellProxy` are written into
users' files.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import Part

from ..geometry import BSplineCurve, BSplineSurface
from ..geometry.place_text import place_text
from .bridge import origin_of
from .computed_object import MESSAGE, ORIGIN, ComputedProxy, Task, result
from .computed_shape import write_shape
from .declared_properties import Declared
from .given_numbers import positive_length
from .linked_geometry import face_inputs, linked_curve, linked_faces, require_shape
from .native_surface import surface_of

__all__ = ["TrimmedShellProxy", "make_trimmed_shell"]

_SAMPLES = 50  # of an edge

_PROPERTIES = (
    Declared("LinkListGlobal", "Surfaces", "Shell", "Surfaces that reach beyond where they meet"),
    Declared("LinkListGlobal", "Edges", "Shell", "Edges at which surfaces end where no other is"),
    Declared(
        "Distance", "Tolerance", "Shell", "Rims and edges nearer to each other than this are one"
    ),
    Declared("Bool", "Solid", "Shell", "Whether a closed shell becomes a solid"),
    result("Bool", "Closed", "Whether the shell has no rim"),
    result("Integer", "FaceCount", "Number of faces"),
    result("Area", "Area", "Of all faces"),
    MESSAGE,
    ORIGIN,
)


def make_trimmed_shell(
    doc: Any,
    surfaces: Sequence[Any],
    edges: Sequence[Any] = (),
    tolerance: float = 0.05,
    solid: bool = False,
    name: str = "TrimmedShell",
) -> Any:
    """Make a shell of surfaces that are trimmed and sewn; `doc.recompute()` computes it.

    Parameters
    ----------
    doc : App.Document
    surfaces : objects with faces that reach beyond where they meet, or to where they do
    edges : objects with a curve, at which surfaces end where no other surface is
    tolerance : mm, within which rims and edges count as one; two fitted surfaces, or a surface and
        a scanned edge, agree no better than their noise
    solid : whether a closed shell becomes a solid
    name : of the object

    Returns
    -------
    Part::FeaturePython whose Shape is a face, a shell, or a solid.

    Raises
    ------
    ValueError: no surface, one without a shape, or a tolerance that is not positive.
    """
    surfaces, edges = list(surfaces), list(edges)
    if not surfaces:
        raise ValueError("There is no surface to trim; choose one or more.")
    require_shape("surface", surfaces)
    require_shape("edge", edges)
    tolerance = positive_length("tolerance", tolerance)
    obj = doc.addObject("Part::FeaturePython", name)
    TrimmedShellProxy(obj)
    obj.Surfaces, obj.Edges = surfaces, edges
    obj.Tolerance, obj.Solid = tolerance, bool(solid)
    return obj


class TrimmedShellProxy(ComputedProxy):
    """What makes the object trim and sew."""

    PROPERTIES = _PROPERTIES
    PLAIN = False

    def depends_on(self, obj: Any) -> Iterable[object]:
        """All faces, all edges, and how they are joined."""
        yield from face_inputs(face for _, face in _labelled_faces(obj.Surfaces))
        yield from (linked_curve(edge, "edge") for edge in obj.Edges)
        yield from (obj.Tolerance.Value, obj.Solid)

    def task(self, obj: Any) -> Task:
        """What trims and sews."""
        labelled = _labelled_faces(obj.Surfaces)
        surfaces = [surface_of(face) for _, face in labelled]
        tolerance = positive_length("tolerance", obj.Tolerance.Value)
        edges = [
            shape
            for item in obj.Edges
            for shape in item.Shape.Edges
            if not _is_where_two_meet(linked_curve(item, "edge"), surfaces, tolerance)
        ]
        return lambda _progress: _sewn(labelled, edges, tolerance, bool(obj.Solid))

    def write(self, obj: Any, result: _Sewn) -> None:
        """Write shape and figures."""
        shape = result.shape
        write_shape(obj, shape, result.message, origin_of(obj.Surfaces[0]))
        obj.Closed, obj.FaceCount = result.closed, len(shape.Faces)
        obj.Area = float(shape.Area)


@dataclass(frozen=True, eq=False)
class _Sewn:
    shape: Any
    closed: bool
    message: str


def _labelled_faces(items: Sequence[Any]) -> list[tuple[str, Any]]:
    """All faces with the labels of their objects."""
    if not items:
        raise ValueError("There is no surface to trim; choose one, or undo its deletion.")
    return [(str(item.Label), face) for item in items for face in linked_faces(item, "surface")]


def _is_where_two_meet(
    edge: BSplineCurve, surfaces: list[BSplineSurface], tolerance: float
) -> bool:
    """Whether an edge runs where surfaces meet anyway: their intersection stands for it."""
    points = edge.sample(_SAMPLES)
    near = [surface.closest(points)[2] <= tolerance for surface in surfaces]
    return bool(np.all(np.sum(near, axis=0) >= 2)) if near else False


def _sewn(
    labelled: list[tuple[str, Any]], edges: list[Any], tolerance: float, solid: bool
) -> _Sewn:
    faces = [face for _, face in labelled]
    pieces, of_edges = _split(faces, edges, tolerance)
    kept, sides = _without_free_sides(pieces, of_edges)
    if not kept:
        raise ValueError(
            f"The {len(faces)} surfaces close nowhere: every piece of them has a free side. Extend "
            "them until they cross, add the edges at which they end, or give a larger tolerance "
            f"than {tolerance:g} mm."
        )
    _refuse_three(kept, sides)
    lost = [
        label
        for number, (label, _) in enumerate(labelled)
        if all(number != source for source, _ in kept)
    ]
    shape = _one_shape([face for _, face in kept])
    closed = shape.ShapeType == "Shell" and bool(shape.isClosed())
    said = [f"{label!r} bounds no part of the shell and was left out." for label in lost]
    if closed:
        filled = Part.Solid(shape)
        shape = filled if solid else shape
        if filled.Volume < 0.0:  # its normals point inwards
            shape.reverse()
    elif solid:
        said.append("The shell is open, so that it makes no solid.")
    return _Sewn(shape, closed, " ".join(said))


def _one_shape(faces: list[Any]) -> Any:
    """The face, or the shell of several; sewing turns their sides the same way."""
    if len(faces) == 1:
        return faces[0]
    sewn = Part.Compound(faces)
    sewn.sewShape()
    return sewn.Shells[0] if len(sewn.Shells) == 1 and len(sewn.Faces) == len(faces) else sewn


Piece = tuple[int, Any]


def _split(faces: list[Any], edges: list[Any], tolerance: float) -> tuple[list[Piece], set[int]]:
    """Pieces with the numbers of their surfaces, and hashes of the pieces of the edges."""
    tools = [*faces, *edges]
    if len(tools) == 1:
        return [(0, faces[0])], set()
    try:
        _, parts = tools[0].generalFuse(tools[1:], tolerance)
    except (Part.OCCError, RuntimeError) as error:
        raise ValueError(
            f"OpenCASCADE cannot split these surfaces along each other ({error}); choose another "
            f"tolerance than {tolerance:g} mm."
        ) from None
    pieces: dict[int, Piece] = {}
    for number, made in enumerate(parts[: len(faces)]):
        for shape in made:
            for face in shape.Faces:
                pieces.setdefault(int(face.hashCode()), (number, face))
    on_edges = {
        int(edge.hashCode())
        for made in parts[len(faces) :]
        for shape in made
        for edge in shape.Edges
    }
    return list(pieces.values()), on_edges


def _without_free_sides(
    pieces: list[Piece], on_edges: set[int]
) -> tuple[list[Piece], Counter[int]]:
    """Pieces that are left when those with a free side are dropped again and again."""
    sides = [_sides(face) for _, face in pieces]
    kept = list(range(len(pieces)))
    while True:
        count = Counter(name for number in kept for name in sides[number])
        still = [
            number
            for number in kept
            if all(count[name] > 1 or name in on_edges for name in sides[number])
        ]
        if still == kept:
            return [pieces[number] for number in kept], count
        kept = still


def _sides(face: Any) -> list[int]:
    """Hashes of the edges round a face; its own seam is none."""
    return [
        int(edge.hashCode()) for edge in face.Edges if not (edge.Degenerated or edge.isSeam(face))
    ]


def _refuse_three(kept: list[Piece], count: Counter[int]) -> None:
    for _, face in kept:
        for edge in face.Edges:
            if count[int(edge.hashCode())] > 2:
                place = place_text(edge.valueAt(edge.FirstParameter))
                raise ValueError(
                    f"More than two faces meet along an edge at ({place}), so that inside and "
                    "outside cannot be told; leave out the surface that divides the part."
                )
