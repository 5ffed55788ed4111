# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading a cloud from a file: by its content where that is plain, else by its ending."""

from __future__ import annotations

from collections.abc import Callable
from os import PathLike
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .pcd_format import looks_like_pcd, read_pcd
from .ply_format import read_ply
from .ply_header import PLY_MAGIC
from .point_cloud import PointCloud
from .progress import Progress
from .text_format import looks_like_text_cloud, read_text

__all__ = ["READABLE_ENDINGS", "TEXT_ENDINGS", "UNITS", "read_cloud"]

Array = NDArray[np.float64]
Reader = Callable[[Path, "Progress | None"], Array]

TEXT_ENDINGS = (".xyz", ".txt", ".asc", ".csv")
UNITS = {"mm": 1.0, "m": 1000.0, "inch": 25.4}  # mm
READABLE_ENDINGS = (*TEXT_ENDINGS, ".ply", ".pcd")


def read_cloud(
    path: str | PathLike[str],
    probe_radius: float = 0.0,
    approach: ArrayLike | None = None,
    region: ArrayLike | None = None,
    progress: Progress | None = None,
    unit: str = "mm",
) -> PointCloud:
    """Read a cloud from a .xyz, .txt, .asc, .csv, .ply or .pcd file.

    Parameters
    ----------
    path : of the file; its content decides over its ending
    probe_radius : mm; above 0 the points are the centres of a probing ball of this radius
    approach : (3,) direction the probe came along
    region : ((xmin, ymin, zmin), (xmax, ymax, zmax)), mm: only points in this box are kept
    progress : told the share read and the newest points, at last the cloud; where it answers
        False, the points read so far are the cloud
    unit : "mm", "m" or "inch", of the numbers in the file; all else is mm

    Returns
    -------
    PointCloud. Rows that hold nan or inf are left out, counted in ``dropped``, with a warning.

    Raises
    ------
    ValueError: a file that is missing, empty, damaged or of another format, text where numbers
        should be (with the line number), an unknown unit, or a region without points.
    """
    file = Path(path)
    if unit not in UNITS:
        raise ValueError(f"The unit {unit!r} is not known. Give one of {', '.join(UNITS)}.")
    box = _box(region)
    try:
        points = _reader(file)(file, progress)
    except OSError as error:
        raise ValueError(
            f"{file} cannot be read: {error.strerror or error}. Check the path and the permissions."
        ) from error
    if len(points) == 0:
        raise ValueError(f"{file.name} holds no points. Check how the file was written.")
    if unit != "mm":
        points = points * UNITS[unit]
    if box is not None:
        points = _within(points, box, file.name)
    cloud = PointCloud(points, probe_radius, approach)
    if progress is not None:
        progress.update(1.0, cloud)
    return cloud


def _reader(file: Path) -> Reader:
    if not file.exists():
        raise ValueError(f"There is no file {file}. Check the path.")
    if file.is_dir():
        raise ValueError(f"{file} is a folder. Give the path of one cloud file in it.")
    with file.open("rb") as stream:
        head = stream.read(4096)
    if not head.strip():
        raise ValueError(f"{file.name} is empty. Export the cloud again.")
    if head.startswith((PLY_MAGIC + b"\n", PLY_MAGIC + b"\r")):
        return read_ply
    if looks_like_pcd(head):
        return read_pcd
    ending = file.suffix.lower()
    if ending in TEXT_ENDINGS or looks_like_text_cloud(file):
        return read_text
    if ending == ".ply":
        return read_ply
    if ending == ".pcd":
        return read_pcd
    raise ValueError(
        f"{file.name} is not a cloud this can read: its ending is '{file.suffix or 'missing'}' and "
        f"its content is no table of points. Readable are {', '.join(READABLE_ENDINGS)}; inside "
        "FreeCAD, freecad_edgescan.document also reads e57, stl, obj and other meshes."
    )


def _box(region: ArrayLike | None) -> Array | None:
    if region is None:
        return None
    try:
        box = np.asarray(region, dtype=np.float64)
    except (TypeError, ValueError):
        box = np.empty(0)
    if box.shape != (2, 3) or not np.all(box[0] <= box[1]):
        raise ValueError(
            f"The region {region!r} is no box. Give its lowest and highest corner, "
            "((xmin, ymin, zmin), (xmax, ymax, zmax)) in mm."
        )
    return box


def _within(points: Array, box: Array, name: str) -> Array:
    """Points in the box, and the rows that are no points, which the cloud counts."""
    inside = ~((points < box[0]) | (points > box[1])).any(axis=1)
    if not np.isfinite(points[inside]).all(axis=1).any():
        finite = points[np.isfinite(points).all(axis=1)]
        reach = ""
        if len(finite):
            lowest, highest = (
                ", ".join(f"{value:.6g}" for value in corner)
                for corner in (finite.min(axis=0), finite.max(axis=0))
            )
            reach = f", which reaches from ({lowest}) to ({highest})"
        raise ValueError(
            f"No point of {name}{reach}, lies in the region {box.tolist()}. "
            "Take a region that overlaps the cloud."
        )
    return np.asarray(points[inside])
