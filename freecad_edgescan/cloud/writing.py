# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writing a cloud to a file that reads back as exactly the same numbers."""

from __future__ import annotations

from os import PathLike
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .ply_format import write_ply
from .point_cloud import PointCloud

__all__ = ["WRITABLE_ENDINGS", "write_cloud"]

WRITABLE_ENDINGS = (".xyz", ".ply")
PIECE = 100_000  # points


def write_cloud(cloud: PointCloud, path: str | PathLike[str]) -> None:
    """Write the points of a cloud as .xyz text or as a binary .ply of doubles.

    Parameters
    ----------
    cloud : whose points are written, mm; the probe radius and the approach are not
    path : of the file, which is replaced if it exists

    Raises
    ------
    ValueError: another ending, or a place that cannot be written to.
    """
    file = Path(path)
    writers = {".xyz": _write_xyz, ".ply": write_ply}
    ending = file.suffix.lower()
    if ending not in writers:
        raise ValueError(
            f"A cloud cannot be written as '{file.name}'. "
            f"End the name in {' or '.join(WRITABLE_ENDINGS)}."
        )
    try:
        writers[ending](cloud.points, file)
    except OSError as error:
        raise ValueError(
            f"{file} cannot be written: {error.strerror or error}. "
            "Check that the folder exists and may be written to."
        ) from error


def _write_xyz(points: NDArray[np.float64], path: Path) -> None:
    with path.open("w", encoding="ascii", newline="\n") as stream:
        for start in range(0, len(points), PIECE):
            values = points[start : start + PIECE].ravel().tolist()
            stream.write("%r %r %r\n" * (len(values) // 3) % tuple(values))
