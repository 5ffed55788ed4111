# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edge points with their sigma, of scanned edges in a document, as a table in a file."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from .bridge import origin_of

__all__ = ["export_csv"]

_HEADER = (
    *("edge", "x_mm", "y_mm", "z_mm", "sigma_mm", "angle_deg"),
    *("fillet_radius_mm", "fillet_sigma_mm", "supported"),
)


def export_csv(objects: Sequence[Any], path: str | PathLike[str]) -> None:
    """Write one row for each edge point: position, sigma, and what else is known.

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
    if not rows:
        raise ValueError(
            f"There are no edge points among {len(objects)} objects to write into {target.name}; "
            "choose scanned edges, and recompute the document first."
        )
    try:
        with target.open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(_HEADER)
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
    columns = np.column_stack(
        [
            points,
            sigma,
            np.degrees(_values(obj, "Angles", len(sigma))),
            _values(obj, "FilletRadii", len(sigma)),
            _values(obj, "FilletSigmas", len(sigma)),
        ]
    )
    numbers = getattr(obj, "EdgeNumbers", None)
    names = [f"{obj.Label} {number}" for number in numbers] if numbers else [obj.Label] * len(sigma)
    supported = list(getattr(obj, "Supported", [])) or [True] * len(sigma)
    return [
        [name, *(f"{value:.6f}" for value in row), str(int(held))]
        for name, row, held in zip(names, columns.tolist(), supported, strict=True)
    ]


def _values(obj: Any, name: str, count: int) -> np.ndarray:
    """A list of numbers of an object; nan where it has none."""
    values = np.array(getattr(obj, name, []), dtype=float)
    return values if len(values) == count else np.full(count, np.nan)
