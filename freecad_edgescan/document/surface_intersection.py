# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric intersection: all curves in which the surfaces of two objects meet.

OpenCASCADE finds them. The name of this module and of `SurfaceIntersectionProxy` are written into
users' files.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import Part

from ..scanning import Progress
from .bridge import origin_of
from .computed_object import MESSAGE, ORIGIN, ComputedProxy, Task, result
from .computed_shape import write_shape
from .declared_properties import Declared
from .given_numbers import positive_length
from .linked_geometry import face_inputs, linked_faces, require_shape

__all__ = ["SurfaceIntersectionProxy", "make_surface_intersection"]

_PROPERTIES = (
    Declared("LinkGlobal", "First", "Intersection", "A surface or any other shape with faces"),
    Declared("LinkGlobal", "Second", "Intersection", "What meets it"),
    Declared("Distance", "Tolerance", "Intersection", "Of the curves from both surfaces"),
    result("Integer", "CurveCount", "Number of curves"),
    result("Length", "Length", "Length of all curves"),
    MESSAGE,
    ORIGIN,
)


def make_surface_intersection(
    doc: Any, first: Any, second: Any, tolerance: float = 1e-3, name: str = "SurfaceIntersection"
) -> Any:
    """Make the curves in which two objects' surfaces meet; `doc.recompute()` finds them.

    Parameters
    ----------
    doc : App.Document
    first, second : two different objects with faces
    tolerance : mm, of the curves from both surfaces
    name : of the object

    Returns
    -------
    Part::FeaturePython whose Shape is one edge or wire, or a compound of wires, the longest first.

    Raises
    ------
    ValueError: the same object twice, one without a shape, or a tolerance that is not positive.
    """
    require_shape("surface", [first, second])
    if first is second:
        raise ValueError(f"Both surfaces are {first.Label!r}; choose two different objects.")
    tolerance = positive_length("tolerance", tolerance)
    obj = doc.addObject("Part::FeaturePython", name)
    SurfaceIntersectionProxy(obj)
    obj.First, obj.Second, obj.Tolerance = first, second, tolerance
    return obj


class SurfaceIntersectionProxy(ComputedProxy):
    """What makes the object intersect."""

    PROPERTIES = _PROPERTIES
    PLAIN = False

    def depends_on(self, obj: Any) -> Iterable[object]:
        """All faces of both, and the tolerance."""
        for own in (obj.First, obj.Second):
            yield from face_inputs(linked_faces(own, "surface"))
        yield obj.Tolerance.Value

    def task(self, obj: Any) -> Task:
        """What intersects them: the curves as wires, the longest first."""
        first, second = (
            Part.Compound(linked_faces(own, "surface")) for own in (obj.First, obj.Second)
        )
        tolerance = positive_length("tolerance", obj.Tolerance.Value)
        labels = obj.First.Label, obj.Second.Label

        def intersect(_progress: Progress | None) -> list[Any]:
            edges = first.section([second], tolerance).Edges
            if not edges:
                raise ValueError(
                    f"{labels[0]!r} and {labels[1]!r} do not meet; extend one of them, or choose "
                    "others."
                )
            wires = [Part.Wire(chain) for chain in Part.sortEdges(edges)]
            return sorted(wires, key=lambda wire: -float(wire.Length))

        return intersect

    def write(self, obj: Any, result: list[Any]) -> None:
        """Write the curves."""
        wires = result
        shape = wires[0] if len(wires) == 1 else Part.Compound(wires)
        shape = shape.Edges[0] if len(shape.Edges) == 1 else shape
        write_shape(obj, shape, "", origin_of(obj.First))
        obj.CurveCount = len(wires)
        obj.Length = sum(float(wire.Length) for wire in wires)
