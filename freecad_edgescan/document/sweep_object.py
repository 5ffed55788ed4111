# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric sweep: a Part::FeaturePython that follows its profile and its rail.

Its properties have the names that FreeCAD's own Part::Sweep gives them. The name of this module and
of `SweepProxy` are written into users' files.
"""

from __future__ import annotations

from typing import Any

import Part

from .computed_object import MESSAGE
from .declared_properties import Declared, Role, declare
from .refusal import RefusalError
from .sweep_shape import sweep_shape

__all__ = ["SweepProxy"]

_PROPERTIES = (
    Declared("LinkList", "Sections", "Sweep", "The profile that is moved: one object"),
    Declared("LinkSub", "Spine", "Sweep", "The rail: an object and the names of its edges"),
    Declared("Bool", "Solid", "Sweep", "Whether a closed profile gives a solid"),
    Declared("String", "Frames", "Sweep", "How the profile is kept from turning", Role.RESULT),
    MESSAGE,
)


class SweepProxy:
    """What makes the object sweep. It keeps no state: everything lives in properties."""

    def __init__(self, obj: Any) -> None:
        obj.Proxy = self
        declare(obj, _PROPERTIES)

    def execute(self, obj: Any) -> None:
        """Sweep again; a sweep that fails leaves the shape made before."""
        refused = _sweep(obj)
        if refused is not None:
            raise RefusalError(refused)

    def onDocumentRestored(self, obj: Any) -> None:
        """Bring an object of an older file up to date."""
        declare(obj, _PROPERTIES)

    def dumps(self) -> None:
        """Nothing to write into the file."""
        return None

    def loads(self, state: object) -> None:
        """Nothing to read from the file."""

    # FreeCAD before 0.21.2 asks for these instead.
    __getstate__ = dumps
    __setstate__ = loads


def _sweep(obj: Any) -> str | None:
    """Sweep; the sentence that says why it cannot be."""
    try:
        shape, planar = sweep_shape(_profile_of(obj), _rail_of(obj), bool(obj.Solid))
    except ValueError as error:
        obj.Message = str(error)
        return str(error)
    shape.Placement = obj.Placement
    obj.Shape = shape
    obj.Frames = "at a fixed angle to the plane of the rail" if planar else "turning least"
    kind = "A solid" if shape.ShapeType == "Solid" else "A surface"
    faces = len(shape.Faces)
    obj.Message = f"{kind} of {faces} face{'' if faces == 1 else 's'}, {shape.Area:.4g} mm²."
    return None


def _profile_of(obj: Any) -> Any:
    if len(obj.Sections) != 1:
        raise ValueError(f"A sweep has one profile, not {len(obj.Sections)}.")
    (profile,) = obj.Sections
    edges = profile.Shape.Edges
    if not edges:
        raise ValueError(f"The profile {profile.Label!r} has no edge; recompute or draw it.")
    return _wire(edges, f"profile {profile.Label!r}")


def _rail_of(obj: Any) -> Any:
    if obj.Spine is None:
        raise ValueError("The sweep has no rail.")
    rail, names = obj.Spine
    edges = [rail.Shape.getElement(name) for name in names if name] or rail.Shape.Edges
    if not edges:
        raise ValueError(f"The rail {rail.Label!r} has no edge; recompute the document.")
    return _wire(edges, f"rail {rail.Label!r}")


def _wire(edges: list[Any], what: str) -> Any:
    chains = Part.sortEdges(edges)
    if len(chains) != 1:
        raise ValueError(
            f"The edges of the {what} form {len(chains)} wires; a sweep needs one. Select those "
            "that follow each other, and make a wire of them first."
        )
    return Part.Wire(chains[0])
