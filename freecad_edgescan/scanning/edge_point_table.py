# SPDX-License-Identifier: LGPL-2.1-or-later
"""The columns of a table of edge points, the same in every file."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from .scanned_edge import ScannedEdge

__all__ = ["COLUMNS", "edge_point_rows", "row_of"]

COLUMNS = (
    *("x_mm", "y_mm", "z_mm", "sigma_mm", "tangent_x", "tangent_y", "tangent_z"),
    *("angle_deg", "fillet_radius_mm", "fillet_sigma_mm", "supported"),
)


def edge_point_rows(edge: ScannedEdge) -> Iterator[list[str]]:
    """One row of words for each edge point: position, sigma, tangent, angle, rounding."""
    for j in range(len(edge)):
        numbers = [*edge.points[j], edge.sigma[j], *edge.tangents[j], np.degrees(edge.angle[j])]
        yield row_of([*numbers, edge.fillet_radius[j], edge.fillet_sigma[j]], edge.supported[j])


def row_of(numbers: Iterable[float], supported: bool) -> list[str]:
    """The words of one row."""
    return [*(f"{value:.6f}" for value in numbers), str(int(supported))]
