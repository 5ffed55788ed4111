# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves, surfaces and clouds of the objects that a parametric object is linked to."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from ..geometry import BSplineCurve, BSplineSurface
from .native_curve import curve_of
from .native_surface import surface_of

__all__ = [
    "face_inputs",
    "is_cloud",
    "linked_curve",
    "linked_faces",
    "linked_surface",
    "require_cloud",
    "require_shape",
]


def linked_curve(obj: Any, what: str) -> BSplineCurve:
    """The curve of a linked object's edges; `what` is its part, such as "rail".

    Raises
    ------
    ValueError: nothing is linked, or what is no single curve.
    """
    if obj is None:
        raise ValueError(f"The {what} is missing; choose one, or undo its deletion.")
    return curve_of(obj.Shape, f"{what} {obj.Label!r}")


def linked_surface(obj: Any, what: str) -> BSplineSurface:
    """The surface of a linked object's only face; `what` is its part, such as "base surface".

    Raises
    ------
    ValueError: nothing is linked, or not one face.
    """
    if obj is None:
        raise ValueError(f"The {what} is missing; choose one, or undo its deletion.")
    return surface_of(obj.Shape, f"{what} {obj.Label!r}")


def linked_faces(obj: Any, what: str) -> list[Any]:
    """All faces of a linked object, one at least; `what` is its part, such as "surface".

    Raises
    ------
    ValueError: nothing is linked, or what has no face.
    """
    if obj is None:
        raise ValueError(f"The {what} is missing; choose one, or undo its deletion.")
    faces = [] if obj.Shape.isNull() else list(obj.Shape.Faces)
    if not faces:
        raise ValueError(
            f"The {what} {obj.Label!r} has no face; recompute the document, or choose another."
        )
    return faces


def face_inputs(faces: Iterable[Any]) -> Iterator[object]:
    """What depends on faces depends on: their surfaces, and where these end."""
    for face in faces:
        yield surface_of(face)
        yield from (round(value, 6) for value in (*face.ParameterRange, face.Length))


def require_shape(what: str, items: Sequence[Any]) -> None:
    """Refuse objects without a shape.

    Raises
    ------
    ValueError
    """
    for item in items:
        if not hasattr(item, "Shape"):
            raise ValueError(
                f"The {what} {getattr(item, 'Label', item)!r} has no shape; choose a scanned edge, "
                "a sketch or another object with a shape."
            )


def is_cloud(item: Any) -> bool:
    """Whether this is a cloud of a document."""
    return bool(getattr(item, "isDerivedFrom", lambda _: False)("Points::Feature"))


def require_cloud(item: Any) -> None:
    """Refuse what is no cloud of a document.

    Raises
    ------
    ValueError
    """
    if not is_cloud(item):
        raise ValueError(
            f"{getattr(item, 'Label', item)!r} is not a point cloud of the document; "
            "make one with make_cloud(doc, source)."
        )
