# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading a cloud from a file: by its content where that is plain, else by its ending."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing
from os import PathLike
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .blocks import ROWS, Blocks
from .growing_points import GrowingPoints
from .pcd_format import looks_like_pcd, pcd_blocks
from .ply_format import ply_blocks
from .ply_header import PLY_MAGIC
from .point_cloud import PointCloud
from .progress import Progress
from .region import Reach, Region
from .text_format import looks_like_text_cloud, text_blocks

__all__ = ["READABLE_ENDINGS", "TEXT_ENDINGS", "UNITS", "cloud_blocks", "read_cloud"]

Array = NDArray[np.float64]
Reader = Callable[[Path, int], Blocks]

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
    wanted = None if region is None else Region.of(region)
    try:
        points = _read(file, UNITS[unit], wanted, progress)
    except OSError as error:
        raise ValueError(
            f"{file} cannot be read: {error.strerror or error}. Check the path and the permissions."
        ) from error
    cloud = PointCloud(points, probe_radius, approach)
    if progress is not None:
        progress.update(1.0, cloud)
    return cloud


def cloud_blocks(file: Path, rows: int = ROWS) -> Blocks:
    """Points of a file of any readable kind in blocks of so many, in the file's own unit.

    Raises
    ------
    ValueError: as for ``read_cloud``.
    """
    return _reader(file)(file, rows)


def _read(file: Path, scale: float, wanted: Region | None, progress: Progress | None) -> Array:
    """The wanted points of a file, (n, 3) read-only, mm."""
    kept, reach = GrowingPoints(), Reach()
    read = found = 0
    with closing(cloud_blocks(file)) as blocks:
        for points, share in blocks:
            read += len(points)
            points *= scale
            if wanted is not None:
                reach.widen(points)
                points = points[wanted.holds(points)]
                found += int(np.count_nonzero(np.isfinite(points).all(axis=1)))
            kept.append(points)
            if progress is not None and not progress.update(min(share, 0.99), points):
                break
    if not read:
        raise ValueError(f"{file.name} holds no points. Check how the file was written.")
    if wanted is not None and not found:
        raise wanted.is_empty_of(file.name, reach.bounds)
    return kept.taken()


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
        return ply_blocks
    if looks_like_pcd(head):
        return pcd_blocks
    ending = file.suffix.lower()
    if ending in TEXT_ENDINGS or looks_like_text_cloud(file):
        return text_blocks
    if ending == ".ply":
        return ply_blocks
    if ending == ".pcd":
        return pcd_blocks
    raise ValueError(
        f"{file.name} is not a cloud this can read: its ending is '{file.suffix or 'missing'}' and "
        f"its content is no table of points. Readable are {', '.join(READABLE_ENDINGS)}; inside "
        "FreeCAD, freecad_edgescan.document also reads e57, stl, obj and other meshes."
    )
