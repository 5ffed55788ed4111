# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clouds as FreeCAD objects: plain Points features, so that files open without this add-on."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from os import PathLike
from pathlib import Path
from typing import Any

import FreeCAD
import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..cloud import READABLE_ENDINGS, PointCloud, read_cloud
from .bridge import kernel_from_array, points_of
from .passing_document import passing_document

__all__ = ["make_cloud"]

Array = NDArray[np.float64]

PROPERTIES = (
    (
        # Not a Length, which turns a negative value into 0 without a word.
        "App::PropertyDistance",
        "ProbeRadius",
        "Radius of the ball whose centres the cloud holds; 0: the points lie on the surface",
        False,
    ),
    (
        "App::PropertyVector",
        "Approach",
        "Direction the probe came along; the air lies against it. (0, 0, 0): not known",
        False,
    ),
    ("App::PropertyFile", "SourceFile", "File the cloud was read from", True),
    (
        "App::PropertyVector",
        "Origin",
        "Add this to the document's coordinates to get those of the file; a cloud far from the "
        "origin would lose its precision otherwise",
        True,
    ),
    (
        "App::PropertyInteger",
        "DroppedRows",
        "Points of the source that were left out because they hold nan or inf",
        True,
    ),
)


def make_cloud(
    doc: Any,
    source: str | PathLike[str] | PointCloud | ArrayLike,
    probe_radius: float | None = None,
    approach: ArrayLike | None = None,
    name: str = "Cloud",
) -> Any:
    """Put a cloud into a document.

    Parameters
    ----------
    doc : App.Document
    source : path of a file (.xyz .txt .asc .csv .ply .pcd .e57 .stl .obj), a PointCloud, or an
        (n, 3) array, mm
    probe_radius : mm; None: that of the PointCloud, else 0
    approach : (3,) direction the probe came along; None: that of the PointCloud, else unknown
    name : of the object; the file's name becomes its label

    Returns
    -------
    A plain Points::Feature with the properties ProbeRadius, Approach, SourceFile, Origin and
    DroppedRows. The document's coordinates are those of the source less Origin, which is zero
    unless the cloud lies far away for its size.

    Raises
    ------
    ValueError: a source that cannot be read or holds no points; nothing is made then.
    """
    if doc is None:
        raise ValueError("There is no document for the cloud; make one with FreeCAD.newDocument().")
    path = Path(source) if isinstance(source, str | PathLike) else None
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message=".*were left out")  # said below, in plain words
        if path is not None:
            numbers = _read(path)
        else:
            numbers = source if isinstance(source, PointCloud) else PointCloud(np.asarray(source))
    if probe_radius is None:
        probe_radius = numbers.probe_radius
    if approach is None:
        approach = numbers.approach
    checked = PointCloud(numbers.points[:1], probe_radius, approach)
    obj = doc.addObject("Points::Feature", name)
    if path is not None:
        obj.Label = path.stem
    obj.Points = kernel_from_array(numbers.points - numbers.origin_hint)
    for kind, title, tooltip, read_only in PROPERTIES:
        obj.addProperty(kind, title, "Cloud", tooltip, 1 if read_only else 0)
    obj.ProbeRadius = checked.probe_radius
    if checked.approach is not None:
        obj.Approach = FreeCAD.Vector(*checked.approach)
    obj.SourceFile = "" if path is None else str(path.resolve())
    obj.Origin = FreeCAD.Vector(*numbers.origin_hint)
    obj.DroppedRows = numbers.dropped
    if numbers.dropped:
        FreeCAD.Console.PrintWarning(
            f"{obj.Label}: {numbers.dropped} of {numbers.dropped + len(numbers)} points were left "
            "out, because they hold nan or inf.\n"
        )
    return obj


def _read(path: Path) -> PointCloud:
    """Read by our own readers, else by FreeCAD's."""
    reader = _READERS.get(path.suffix.lower())
    if reader is None:
        return read_cloud(path)
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
    return PointCloud(points)


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
