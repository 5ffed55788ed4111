# SPDX-License-Identifier: LGPL-2.1-or-later
"""STEP files of edges and of what was built on them."""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike
from pathlib import Path
from typing import Any

import FreeCAD
import Import
import Part

from ..scanning import ScannedEdge
from .bridge import origin_of
from .native_edge import edge_shape
from .passing_document import passing_document

__all__ = ["export_step"]


def export_step(objects: Sequence[Any], path: str | PathLike[str]) -> None:
    """Write a STEP file; edges stay native curves, under their labels.

    Parameters
    ----------
    objects : document objects with a Shape, ScannedEdges, or Part.Shapes
    path : of the file. Coordinates are true ones: an object's placement and ``Origin`` count.

    Raises
    ------
    ValueError: an object without a shape, such as one that could not be computed, or a file that
        cannot be written. Nothing is written then.
    """
    objects = list(objects) if isinstance(objects, Sequence) else [objects]
    named = [(_label(obj, number), _true_shape(obj)) for number, obj in enumerate(objects, start=1)]
    target = Path(path).resolve()
    if not named:
        raise ValueError(f"There is nothing to write into {target.name}; choose objects.")
    empty = [repr(label) for label, shape in named if shape.isNull()]
    if empty:
        raise ValueError(
            f"{target.name} is not written, since {', '.join(empty)} "
            f"{'has' if len(empty) == 1 else 'have'} no shape yet; recompute the document, or "
            "choose without."
        )
    try:
        target.open("ab").close()
    except OSError as error:
        raise ValueError(
            f"{target} cannot be written ({error.strerror}). Check the folder."
        ) from error
    # Shape.exportStep of several edges ends the whole process in FreeCAD 1.0; Import does not.
    with passing_document() as passing:
        features = []
        for label, shape in named:
            feature = passing.addObject("Part::Feature", "Shape")
            feature.Label = label
            feature.Shape = shape
            features.append(feature)
        Import.export(features, str(target))


def _label(obj: Any, number: int) -> str:
    if isinstance(obj, ScannedEdge):
        return f"Edge {number}"
    return str(getattr(obj, "Label", f"Shape {number}"))


def _true_shape(obj: Any) -> Any:
    if isinstance(obj, ScannedEdge):
        return edge_shape(obj)
    if isinstance(obj, Part.Shape):
        return obj
    if not hasattr(obj, "Shape"):
        raise ValueError(f"{getattr(obj, 'Label', obj)!r} has no shape to write.")
    shape = Part.getShape(obj)
    return shape if shape.isNull() else _placed(shape, FreeCAD.Vector(*origin_of(obj)))


def _placed(shape: Any, origin: Any) -> Any:
    """The shape moved for good: readers lose a placement that stands beside a curve."""
    matrix = shape.Placement.toMatrix()
    matrix.move(origin)
    moved = shape.copy()
    moved.Placement = FreeCAD.Placement()
    moved.transformShape(matrix, True)
    return moved
