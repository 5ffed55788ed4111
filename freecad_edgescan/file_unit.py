# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clouds whose numbers are not millimetres: the unit a user names, and a hint when it looks so."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from freecad_edgescan.terminal_progress import tell

if TYPE_CHECKING:
    from freecad_edgescan.cloud import PointCloud

__all__ = ["UNITS", "read_in_mm"]

UNITS = ("mm", "m", "inch")
SMALLEST_PART = 1.0  # mm; a scanned part is larger


def read_in_mm(
    file: str,
    unit: str | None = None,
    probe_radius: float = 0.0,
    approach: Sequence[float] | None = None,
) -> PointCloud:
    """Read a cloud, its coordinates brought from their unit (None: not named, mm) to mm.

    The probe radius is mm whatever the unit of the file.
    """
    from freecad_edgescan.cloud import read_cloud

    cloud = read_cloud(file, probe_radius, approach, unit=unit or "mm")
    if unit is None and 0.0 < (across := float(cloud.size.max())) < SMALLEST_PART:
        tell(
            f"{file} is only {across:.3g} mm across; is the file in metres? "
            "If so, give --unit m (or --unit inch)."
        )
    return cloud
