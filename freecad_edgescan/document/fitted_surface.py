# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric fitted surface: a B-spline through the points of a cloud near a base surface.

The name of this module and of `FittedSurfaceProxy` are written into users' files.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import FreeCAD

from ..cloud.progress import Stage
from ..scanning import Progress
from ..surfacing import SurfaceFit, fit_surface
from .bridge import origin_of
from .cloud_cache import cloud_checksum
from .computed_object import MESSAGE, ORIGIN, ComputedProxy, Task
from .declared_properties import Declared
from .fit_numbers import FIT_RESULTS, write_fit_numbers
from .linked_geometry import linked_surface, require_cloud, require_shape
from .native_surface import surface_shape
from .points_near_base import points_near_base

__all__ = ["FittedSurfaceProxy", "make_fitted_surface"]

_PROPERTIES = (
    Declared("LinkGlobal", "Cloud", "Fit", "Cloud or segment the surface is fitted to"),
    Declared("LinkGlobal", "Base", "Fit", "Surface near the points; it gives the fit its rim"),
    Declared(
        "Distance",
        "Distance",
        "Fit",
        "Points of a whole cloud nearer than this to the base surface belong to it; all of a "
        "segment do",
    ),
    Declared("Integer", "PolesU", "Fit", "Control points in u; 0: as many as Tolerance asks for"),
    Declared("Integer", "PolesV", "Fit", "Control points in v; 0: as many as Tolerance asks for"),
    Declared("Integer", "DegreeU", "Fit", "Degree in u"),
    Declared("Integer", "DegreeV", "Fit", "Degree in v"),
    Declared(
        "Distance",
        "Tolerance",
        "Fit",
        "Without numbers of control points: largest distance of a point from the surface at which "
        "no more are added; 0: the points' scatter decides",
    ),
    *FIT_RESULTS,
    MESSAGE,
    ORIGIN,
)


def make_fitted_surface(
    doc: Any,
    cloud: Any,
    base: Any,
    control_points: tuple[int, int] | None = (12, 6),
    degree: tuple[int, int] = (3, 3),
    tolerance: float | None = None,
    distance: float = 3.0,
    name: str = "FittedSurface",
) -> Any:
    """Make a surface that fits a cloud; `doc.recompute()` fits it.

    Parameters
    ----------
    doc : App.Document
    cloud : Points::Feature
    base : object whose Shape is one face near the points
    control_points : in u and v; None: as many as the tolerance, or the points' scatter, asks for
    degree : in u and v
    tolerance : mm, with ``control_points=None``
    distance : mm, from the base surface, within which points of a whole cloud belong to it
    name : of the object

    Returns
    -------
    Part::FeaturePython whose Shape is one B-spline face.

    Raises
    ------
    ValueError: no cloud, or a base without a shape.
    """
    require_cloud(cloud)
    require_shape("base surface", [base])
    obj = doc.addObject("Part::FeaturePython", name)
    FittedSurfaceProxy(obj)
    obj.Cloud, obj.Base, obj.Distance = cloud, base, float(distance)
    obj.PolesU, obj.PolesV = (0, 0) if control_points is None else map(int, control_points)
    obj.DegreeU, obj.DegreeV = map(int, degree)
    obj.Tolerance = float(tolerance or 0.0)
    return obj


class FittedSurfaceProxy(ComputedProxy):
    """What makes the object fit."""

    PROPERTIES = _PROPERTIES

    def depends_on(self, obj: Any) -> Iterable[object]:
        """Cloud, base surface, and the surface's form."""
        yield linked_surface(obj.Base, "base surface")
        yield "" if obj.Cloud is None else cloud_checksum(obj.Cloud)
        yield from (obj.Distance.Value, obj.Tolerance.Value)
        yield from (obj.PolesU, obj.PolesV, obj.DegreeU, obj.DegreeV)

    def task(self, obj: Any) -> Task:
        """What fits the surface."""
        base = linked_surface(obj.Base, "base surface")
        near = points_near_base(obj.Cloud, obj.Distance.Value)
        automatic = obj.PolesU == 0 and obj.PolesV == 0
        control_points = None if automatic else (int(obj.PolesU), int(obj.PolesV))
        degree = int(obj.DegreeU), int(obj.DegreeV)
        tolerance = obj.Tolerance.Value or None

        def fit(progress: Progress | None) -> SurfaceFit:
            return fit_surface(
                near(base, progress and Stage(progress, 0.0, 0.5)),
                base,
                control_points,
                degree,
                tolerance=tolerance,
                progress=progress and Stage(progress, 0.5, 1.0),
            )

        return fit

    def write(self, obj: Any, result: SurfaceFit) -> None:
        """Write surface and numbers."""
        shape = surface_shape(result.surface)
        shape.Placement = obj.Placement
        obj.Shape = shape
        obj.Message = result.message
        write_fit_numbers(obj, result)
        obj.Origin = FreeCAD.Vector(*origin_of(obj.Cloud))
