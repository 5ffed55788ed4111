# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edge points with their sigma, of scanned edges in a document, as a table in a file."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from ..scanning.edge_point_table import COLUMNS, row_of
from .bridge import origin_of
from .linked_geometry import is_cloud

__all__ = ["export_csv"]


def export_csv(objects: Sequence[Any], path: str | PathLike[str]) -> None:
    """Write one row for each edge point: position, sigma, tangent, angle and rounding.

    The columns are those of `edgescan find --csv`; "edge" names the object, and of several edges
    in it the number.

    Parameters
    ----------
    objects : scanned edges, boundaries or networks of a document
    path : of the file. Coordinates are true ones: each object's placement and ``Origin`` count.

    Raises
    ------
    ValueError: nothing to write, or a file that cannot be written.
    """
    objects = list(objects) if isinstance(objects, Sequence) else [objects]
    rows = [row for obj in objects for row in _rows(obj)]
    target = Path(path)
    if not rows and any(is_cloud(obj) for obj in objects):
        raise ValueError(
            "A table holds edge points, and a cloud has none; write its points with "
            "es.write_cloud(es.PointCloud(document.points_of(cloud)), 'cloud.ply')."
        )
    if not rows:
        raise ValueError(
            f"There are no edge points among {len(objects)} objects to write into {target.name}; "
            "choose scanned edges, and recompute the document first."
        )
    try:
        with target.open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(["edge", *COLUMNS])
            writer.writerows(rows)
    except OSError as error:
        raise ValueError(
            f"{target} cannot be written ({error.strerror}). Check the folder."
        ) from error


def _rows(obj: Any) -> list[list[str]]:
    if not hasattr(obj, "Sigma") or not hasattr(obj, "Points"):
        return []
    sigma = np.array(obj.Sigma, dtype=float)
    points = np.array([tuple(obj.Placement.multVec(point)) for point in obj.Points], dtype=float)
    points = points.reshape(-1, 3) + origin_of(obj)
    angles = "PointAngles" if hasattr(obj, "PointAngles") else "Angles"  # of each edge elsewhere
    columns = np.column_stack(
        [
            points,
            sigma,
            _tangents(obj, len(sigma)),
            np.degrees(_values(obj, angles, len(sigma))),
            _values(obj, "FilletRadii", len(sigma)),
            _values(obj, "FilletSigmas", len(sigma)),
        ]
    )
    numbers = getattr(obj, "EdgeNumbers", None)
    names = [f"{obj.Label} {number}" for number in numbers] if numbers else [obj.Label] * len(sigma)
    supported = list(getattr(obj, "Supported", [])) or [True] * len(sigma)
    return [
        [name, *row_of(row, held)]
        for name, row, held in zip(names, columns.tolist(), supported, strict=True)
    ]


def _tangents(obj: Any, count: int) -> np.ndarray:
    """Unit tangents (count, 3), turned as the object is; nan where it has none."""
    turned = [tuple(obj.Placement.Rotation.multVec(own)) for own in getattr(obj, "Tangents", [])]
    return np.array(turned, dtype=float) if len(turned) == count else np.full((count, 3), np.nan)


def _values(obj: Any, name: str, count: int) -> np.ndarray:
    """A list of numbers of an object; nan where it has none."""
    values = np.array(getattr(obj, name, []), dtype=float)
    return values if len(values) == count else np.full(count, np.nan)
