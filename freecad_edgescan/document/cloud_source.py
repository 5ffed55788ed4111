# SPDX-License-Identifier: LGPL-2.1-or-later
"""The numbers in a cloud's file: read by our own readers, else by FreeCAD's.

A window reads a file beside the screen first, to say what is in it, and then runs the line that
makes the cloud. Within `already_read` that line finds the numbers instead of reading them again.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import FreeCAD
import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..cloud import READABLE_ENDINGS, PointCloud, read_cloud
from ..cloud.region import cropped
from .bridge import points_of
from .passing_document import passing_document

__all__ = ["already_read", "needs_freecad", "read_source"]

Array = NDArray[np.float64]

_read_before: dict[Path, PointCloud] = {}


def read_source(path: Path, progress: Any = None, region: ArrayLike | None = None) -> PointCloud:
    """Read a cloud's file, its numbers as they are; of a region only the points in it.

    Raises
    ------
    ValueError: a file that is missing, of an unknown kind, damaged or without points, also in the
        region.
    """
    known = _read_before.get(path.resolve())
    if known is not None:
        return known if region is None else cropped(known, region)
    reader = _READERS.get(path.suffix.lower())
    if reader is None:
        return read_cloud(path, region=region, progress=progress)
    if not path.is_file():
        raise ValueError(f"{path} cannot be read: there is no such file. Check the path.")
    try:
        points = reader(path)
    except (RuntimeError, OSError, FreeCAD.Base.FreeCADError) as error:
        raise ValueError(
            f"{path} cannot be read as {path.suffix[1:]} ({error}). "
            "Check the file, or convert it to .ply."
        ) from error
    if len(points) == 0:
        raise ValueError(f"{path.name} holds no points. Check how the file was written.")
    return PointCloud(points) if region is None else cropped(PointCloud(points), region)


def needs_freecad(path: Path) -> bool:
    """Whether a file is read by FreeCAD, which works in the main thread only."""
    return path.suffix.lower() in _READERS


@contextmanager
def already_read(clouds: Mapping[Path, PointCloud]) -> Iterator[None]:
    """Meanwhile these files are not read again."""
    _read_before.update({path.resolve(): cloud for path, cloud in clouds.items()})
    try:
        yield
    finally:
        _read_before.clear()


def _read_by_points(path: Path) -> Array:
    """All points of what FreeCAD's Points module makes of a file, read in a passing document."""
    import Points

    with passing_document() as passing:
        Points.insert(str(path), passing.Name)
        parts = [points_of(obj) for obj in passing.findObjects("Points::Feature")]
    return np.vstack([np.zeros((0, 3)), *parts])


def _read_by_mesh(path: Path) -> Array:
    """The vertices of a mesh file."""
    import Mesh

    vertices, _ = Mesh.Mesh(str(path)).Topology
    return np.array([tuple(vertex) for vertex in vertices], dtype=float).reshape(-1, 3)


_READERS: dict[str, Callable[[Path], Array]] = {
    ending: reader
    for ending, reader in (
        (".e57", _read_by_points),
        (".stl", _read_by_mesh),
        (".obj", _read_by_mesh),
    )
    if ending not in READABLE_ENDINGS
}
