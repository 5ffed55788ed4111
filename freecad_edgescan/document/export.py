# SPDX-License-Identifier: LGPL-2.1-or-later
"""STEP files of edges and of what was built on them."""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike
from pathlib import Path
from typing import Any

import FreeCAD
import Part

from ..scanning import ScannedEdge
from .bridge import origin_of
from .native_edge import edge_shape

__all__ = ["export_step"]


def export_step(objects: Sequence[Any], path: str | PathLike[str]) -> None:
    """Write a STEP file; edges stay native curves.

    Parameters
    ----------
    objects : document objects with a Shape, ScannedEdges, or Part.Shapes
    path : of the file. Coordinates are true ones: an object's placement and ``Origin`` count.

    Raises
    ------
    ValueError: nothing to write, or a file that cannot be written.
    """
    objects = list(objects) if isinstance(objects, Sequence) else [objects]
    shapes = [shape for shape in map(_true_shape, objects) if not shape.isNull()]
    if not shapes:
        raise ValueError(
            f"There is no shape among {len(objects)} objects to write into {Path(path).name}; "
            "recompute the document first, or choose objects with a shape."
        )
    target = Path(path)
    if not target.parent.is_dir():
        raise ValueError(f"{target} cannot be written: there is no folder {target.parent}.")
    whole = shapes[0] if len(shapes) == 1 else Part.makeCompound(shapes)
    try:
        whole.exportStep(str(target))
    except (RuntimeError, OSError, FreeCAD.Base.FreeCADError) as error:
        raise ValueError(f"{target} cannot be written ({error}). Check the folder.") from error


def _true_shape(obj: Any) -> Any:
    if isinstance(obj, ScannedEdge):
        return edge_shape(obj)
    if isinstance(obj, Part.Shape):
        return obj
    if not hasattr(obj, "Shape"):
        raise ValueError(f"{getattr(obj, 'Label', obj)!r} has no shape to write.")
    shape = Part.getShape(obj)
    origin = origin_of(obj)
    return shape.translated(FreeCAD.Vector(*origin)) if origin.any() else shape
