# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves, surfaces and clouds of the objects that a parametric object is linked to."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from ..geometry import BSplineCurve, BSplineSurface
from .native_curve import curve_of
from .native_surface import surface_of

__all__ = ["linked_curve", "linked_surface", "require_cloud", "require_shape", "shape_inputs"]


def linked_curve(obj: Any, what: str) -> BSplineCurve:
    """The curve of a linked object's edges; `what` is its part, such as "rail".

    Raises
    ------
    ValueError: it is no single curve.
    """
    return curve_of(obj.Shape, f"{what} {obj.Label!r}")


def linked_surface(obj: Any, what: str) -> BSplineSurface:
    """The surface of a linked object's only face; `what` is its part, such as "base surface".

    Raises
    ------
    ValueError: nothing is linked, or not one face.
    """
    if obj is None:
        raise ValueError(f"There is no {what}; choose one, or undo its deletion.")
    return surface_of(obj.Shape, f"{what} {obj.Label!r}")


def shape_inputs(shape: Any) -> Iterator[object]:
    """What depends on all faces of a shape depends on: their surfaces, and where these end."""
    for face in [] if shape.isNull() else shape.Faces:
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


def require_cloud(item: Any) -> None:
    """Refuse what is no cloud of a document.

    Raises
    ------
    ValueError
    """
    if not getattr(item, "isDerivedFrom", lambda _: False)("Points::Feature"):
        raise ValueError(
            f"{getattr(item, 'Label', item)!r} is not a point cloud of the document; "
            "make one with make_cloud(doc, source)."
        )
