# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric deviation map: a cloud's points in the colours of their distances from a shape.

The name of this module and of `DeviationMapProxy` are written into users' files.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..cloud import compensate_cloud
from ..cloud.progress import Stage
from ..experiments.deviation_picture import draw_deviations
from ..scanning import Progress
from ..surfacing import Deviation
from .bridge import origin_of, points_of
from .cloud_cache import cloud_checksum, point_cloud
from .computed_cloud import ComputedCloudProxy, write_points
from .computed_object import MESSAGE, ORIGIN, Task, result
from .declared_properties import Declared, Role
from .deviation_from_shape import MeasurableShape, write_deviations
from .given_numbers import length_or_zero
from .linked_geometry import face_inputs, linked_faces, require_cloud, require_shape

__all__ = [
    "DeviationMapProxy",
    "deviation_colours",
    "make_deviation_map",
    "save_deviation_map",
]

_BINS = 61
_FULL = 99.5  # percent of the absolute deviations that the colours tell apart

# Blue to white to red, as far apart for those who tell few colours.
_STOPS = np.array([(0.02, 0.19, 0.38), (0.26, 0.58, 0.76), (0.97, 0.97, 0.97)])
_STOPS = np.concatenate([_STOPS, [(0.84, 0.38, 0.30), (0.40, 0.0, 0.12)]])


def _hidden(kind: str, name: str, tooltip: str) -> Declared:
    return Declared(kind, name, "Map", tooltip, Role.HIDDEN_RESULT)


_PROPERTIES = (
    Declared("LinkGlobal", "Cloud", "Deviation", "The cloud whose points are measured"),
    Declared("LinkGlobal", "Surface", "Deviation", "A surface or any other shape with faces"),
    Declared(
        "Distance", "Reach", "Deviation", "Points farther from the shape are left out; 0: none is"
    ),
    Declared(
        "Distance",
        "Limit",
        "Deviation",
        "Deviation of the strongest colours; 0: 99.5 % of all deviations are below",
    ),
    result("Length", "Average", "Mean absolute deviation"),
    result("Length", "Maximum", "Largest absolute deviation"),
    result("Length", "RootMeanSquare", "Root mean square deviation"),
    result("Distance", "Mean", "Mean deviation, signed"),
    result("Integer", "PointCount", "Number of points that were measured"),
    result("Length", "LimitUsed", "Deviation of the strongest colours"),
    _hidden("FloatList", "Deviations", "Of each point, mm, positive on the normal's side"),
    _hidden("ColorList", "Color", "Of each point"),
    _hidden("IntegerList", "Histogram", "Numbers of points in equal steps from -Limit to Limit"),
    MESSAGE,
    ORIGIN,
)


def make_deviation_map(
    doc: Any,
    cloud: Any,
    surface: Any,
    reach: float = 3.0,
    limit: float = 0.0,
    name: str = "DeviationMap",
) -> Any:
    """Make a map of how far a cloud is from a surface; `doc.recompute()` measures it.

    Parameters
    ----------
    doc : App.Document
    cloud : Points::Feature; of centres of a probe the touched points are taken
    surface : object with faces: a fitted surface, or any part
    reach : mm, from the surface; points farther off, or beyond its free rim, are left out;
        0: no point is too far
    limit : mm, deviation of the strongest colours; 0: 99.5 % of all deviations are below
    name : of the object

    Returns
    -------
    Points::FeaturePython with the measured points, their Deviations, and their Color.

    Raises
    ------
    ValueError: no cloud, a surface without a shape or, once it is computed, without a face, or a
        negative reach or limit.
    """
    require_cloud(cloud)
    require_shape("surface", [surface])
    if not surface.Shape.isNull():  # else it may get faces when it is computed
        linked_faces(surface, "surface")
    reach, limit = length_or_zero("reach", reach), length_or_zero("limit", limit)
    obj = doc.addObject("Points::FeaturePython", name)
    DeviationMapProxy(obj)
    obj.Cloud, obj.Surface = cloud, surface
    obj.Reach, obj.Limit = reach, limit
    return obj


class DeviationMapProxy(ComputedCloudProxy):
    """What makes the object measure."""

    PROPERTIES = _PROPERTIES

    def depends_on(self, obj: Any) -> Iterable[object]:
        """Cloud, all faces of the surface, reach and limit."""
        yield cloud_checksum(obj.Cloud)
        yield from face_inputs(linked_faces(obj.Surface, "surface"))
        yield from (obj.Reach.Value, obj.Limit.Value)

    def task(self, obj: Any) -> Task:
        """What measures the points: those within reach, and their deviations."""
        cloud, shape = point_cloud(obj.Cloud), MeasurableShape(obj.Surface.Shape)
        reach = length_or_zero("reach", obj.Reach.Value) or np.inf
        length_or_zero("limit", obj.Limit.Value)
        labels = obj.Cloud.Label, obj.Surface.Label

        def measure(progress: Progress | None) -> Measured:
            points = cloud.points
            if cloud.probe_radius > 0.0:
                points = compensate_cloud(cloud, progress and Stage(progress, 0.0, 0.5)).points
            found = shape.deviation(points, progress and Stage(progress, 0.5, 1.0))
            kept = ~found.outside & (np.abs(found.deviation) <= reach)
            if not kept.any():
                raise ValueError(
                    f"No point of the cloud {labels[0]!r} lies within {reach:g} mm of "
                    f"{labels[1]!r}; choose another one, or a larger reach."
                )
            measured = points[: len(kept)][kept]
            return Measured(measured, found.deviation[kept], len(points) - len(measured))

        return measure

    def write(self, obj: Any, result: Measured) -> None:
        """Write points, colours and figures."""
        values = result.deviation
        limit = obj.Limit.Value or float(np.percentile(np.abs(values), _FULL)) or 1e-3
        left = result.left_out
        message = f"{left} points beyond the rim or the reach were left out." if left else ""
        write_points(obj, result.points, message, origin_of(obj.Cloud))
        obj.Deviations = values.tolist()
        counts, _ = np.histogram(np.clip(values, -limit, limit), _BINS, (-limit, limit))
        obj.Histogram = counts.tolist()
        obj.Average, obj.Maximum = float(np.abs(values).mean()), float(np.abs(values).max())
        obj.RootMeanSquare = float(np.sqrt(np.mean(values**2)))
        obj.Mean, obj.LimitUsed = float(values.mean()), limit
        obj.Color = [tuple(row) for row in deviation_colours(values, limit).tolist()]


@dataclass(frozen=True, eq=False)
class Measured:
    """Points (n, 3), their deviations (n,), mm, and how many points were left out."""

    points: NDArray[np.float64]
    deviation: NDArray[np.float64]
    left_out: int


def save_deviation_map(
    obj: Any, path: str | PathLike[str], view: ArrayLike = (0.0, 0.0, 1.0)
) -> None:
    """Write a map's deviations as a table (.csv), or as a picture with histogram.

    Parameters
    ----------
    obj : a deviation map that was measured
    path : of the file; .csv, or .png, .svg or .pdf
    view : (3,) direction from the part towards the viewer of the picture

    Raises
    ------
    ValueError: no deviation map, nothing measured yet, or no such kind of file.
    """
    if type(getattr(obj, "Proxy", None)).__name__ != "DeviationMapProxy":
        raise ValueError(f"{getattr(obj, 'Label', obj)!r} is no deviation map; choose one.")
    values = np.array(obj.Deviations)
    if not len(values):
        raise ValueError(f"{obj.Label!r} holds no deviations yet; recompute the document first.")
    points, file = points_of(obj), Path(path)
    if file.suffix.lower() == ".csv":
        nowhere = np.zeros(len(values))
        inside = np.zeros(len(values), dtype=bool)
        write_deviations(points, Deviation(values, inside, (nowhere, nowhere)), file)
    elif file.suffix.lower() in (".png", ".svg", ".pdf"):
        panels = {str(obj.Label): (points, values)}
        draw_deviations(panels, file, view, obj.LimitUsed.Value)
    else:
        raise ValueError(
            f"{file.name} is neither a table nor a picture; write a .csv, .png, .svg or .pdf file."
        )


def deviation_colours(deviation: ArrayLike, limit: float) -> NDArray[np.float64]:
    """Colours (n, 3), red, green and blue from 0 to 1, of deviations (n,), mm.

    White is none; blue is negative and red positive, dark from the limit, mm, on.
    """
    share = np.clip(np.asarray(deviation, dtype=float) / limit, -1.0, 1.0)
    at = np.linspace(-1.0, 1.0, len(_STOPS))
    return np.column_stack([np.interp(share, at, own) for own in _STOPS.T])
