# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clouds as FreeCAD objects: plain Points features, so that files open without this add-on."""

from __future__ import annotations

import warnings
from os import PathLike
from pathlib import Path
from typing import Any

import FreeCAD
import numpy as np
from numpy.typing import ArrayLike

from ..cloud import PointCloud
from ..cloud.reading import UNITS
from ..cloud.region import Region, cropped
from .bridge import kernel_from_array
from .cloud_source import read_source
from .declared_properties import Declared, Role, declare

__all__ = ["make_cloud"]

_PROPERTIES = (
    # Not a Length, which turns a negative value into 0 without a word.
    Declared(
        "Distance",
        "ProbeRadius",
        "Cloud",
        "Radius of the ball whose centres the cloud holds; 0: the points lie on the surface",
    ),
    Declared(
        "Vector",
        "Approach",
        "Cloud",
        "Direction the probe came along; the air lies against it. (0, 0, 0): not known",
    ),
    Declared("File", "SourceFile", "Cloud", "File the cloud was read from", Role.RESULT),
    Declared(
        "Vector",
        "Origin",
        "Cloud",
        "Add this to the document's coordinates to get those of the file; a cloud far from the "
        "origin would lose its precision otherwise",
        Role.RESULT,
    ),
    Declared(
        "Integer",
        "DroppedRows",
        "Cloud",
        "Points of the source that were left out because they hold nan or inf",
        Role.RESULT,
    ),
)


def make_cloud(
    doc: Any,
    source: str | PathLike[str] | PointCloud | ArrayLike,
    probe_radius: float | None = None,
    approach: ArrayLike | None = None,
    name: str = "Cloud",
    unit: str = "mm",
    near_origin: bool = True,
    region: ArrayLike | None = None,
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
    unit : "mm", "m" or "inch", of the numbers in the source
    near_origin : move a cloud that lies far away for its size near the origin. A document keeps
        points as float32, which far away would be no longer exact.
    region : ((xmin, ymin, zmin), (xmax, ymax, zmax)), mm: only points in this box are put there.
        Of a file nothing else is kept in memory, however large it is.

    Returns
    -------
    A plain Points::Feature with the properties ProbeRadius, Approach, SourceFile, Origin and
    DroppedRows. The document's coordinates are those of the source less Origin, which is zero
    unless the cloud was moved.

    Raises
    ------
    ValueError: a source that cannot be read or holds no points, an unknown unit, or a region
        without points; nothing is made then.
    """
    if doc is None:
        raise ValueError("There is no document for the cloud; make one with FreeCAD.newDocument().")
    if unit not in UNITS:
        raise ValueError(f"The unit {unit!r} is not known. Give one of {', '.join(UNITS)}.")
    path = Path(source) if isinstance(source, str | PathLike) else None
    if region is not None:  # in the source's unit, as its numbers are
        box = Region.of(region)
        region = (box.lowest / UNITS[unit], box.highest / UNITS[unit])
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message=".*were left out")  # said below, in plain words
        if path is not None:
            numbers = read_source(path, region=region)
        else:
            numbers = source if isinstance(source, PointCloud) else PointCloud(np.asarray(source))
            numbers = numbers if region is None else cropped(numbers, region)
    if probe_radius is None:
        probe_radius = numbers.probe_radius
    if approach is None:
        approach = numbers.approach
    checked = PointCloud(numbers.points[:1], probe_radius, approach)
    origin = np.round(UNITS[unit] * numbers.origin_hint) if near_origin else np.zeros(3)
    obj = doc.addObject("Points::Feature", name)
    if path is not None:
        obj.Label = path.stem
    obj.Points = kernel_from_array(numbers.points, UNITS[unit], origin)
    declare(obj, _PROPERTIES)
    obj.ProbeRadius = checked.probe_radius
    if checked.approach is not None:
        obj.Approach = FreeCAD.Vector(*checked.approach)
    obj.SourceFile = "" if path is None else str(path.resolve())
    obj.Origin = FreeCAD.Vector(*origin)
    obj.DroppedRows = numbers.dropped
    if numbers.dropped:
        FreeCAD.Console.PrintWarning(
            f"{obj.Label}: {numbers.dropped} of {numbers.dropped + len(numbers)} points were left "
            "out, because they hold nan or inf.\n"
        )
    return obj
