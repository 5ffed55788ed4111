# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric fitted surface: a B-spline through the points of a cloud near a base surface.

The name of this module and of `FittedSurfaceProxy` are written into users' files.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import Any

from ..cloud import compensate_cloud
from ..cloud.progress import Stage
from ..geometry import BSplineSurface
from ..scanning import Progress
from ..surfacing import SurfaceFit, base_surface, fit_surface
from .bridge import origin_of
from .cloud_cache import cloud_checksum, point_cloud
from .computed_object import MESSAGE, ORIGIN, ComputedProxy, Task
from .computed_shape import write_shape
from .declared_properties import Declared
from .fit_numbers import FIT_RESULTS, write_fit_numbers
from .given_numbers import length_or_zero, positive_length, whole_number
from .linked_geometry import linked_curve, linked_surface, require_cloud, require_shape
from .native_surface import surface_shape
from .points_near_base import points_near_base

__all__ = ["FittedSurfaceProxy", "make_fitted_surface"]

_PROPERTIES = (
    Declared("LinkGlobal", "Cloud", "Fit", "Cloud or segment the surface is fitted to"),
    Declared("LinkGlobal", "Base", "Fit", "Surface near the points; it gives the fit its rim"),
    Declared(
        "LinkListGlobal",
        "Edges",
        "Fit",
        "Without a base: four edges round the surface; without these the plane, cylinder, cone, "
        "sphere or quadric that the cloud's points lie on is the base",
    ),
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
    base: Any = None,
    control_points: tuple[int, int] | None = (12, 6),
    degree: tuple[int, int] = (3, 3),
    tolerance: float | None = None,
    distance: float = 3.0,
    edges: Sequence[Any] = (),
    name: str = "FittedSurface",
) -> Any:
    """Make a surface that fits a cloud; `doc.recompute()` fits it.

    Parameters
    ----------
    doc : App.Document
    cloud : Points::Feature
    base : object whose Shape is one face near the points; None: from edges, or from the points
    control_points : in u and v; None: as many as the tolerance, or the points' scatter, asks for
    degree : in u and v
    tolerance : mm, with ``control_points=None``
    distance : mm, from the base surface, within which points of a whole cloud belong to it
    edges : without a base, four objects with a curve, round the surface; none: the base is the
        plane, cylinder, cone, sphere or quadric that the cloud's points lie on
    name : of the object

    Returns
    -------
    Part::FeaturePython whose Shape is one B-spline face.

    Raises
    ------
    ValueError: no cloud, a base or edges without a shape, a base and edges, or not four edges.
    """
    edges = list(edges)
    require_cloud(cloud)
    require_shape("base surface", [] if base is None else [base])
    require_shape("edge", edges)
    if edges and (base is not None or len(edges) != 4):
        raise ValueError(
            f"{len(edges)} edges {'and a base surface ' if base is not None else ''}are given; "
            "give a base surface, or four edges round the surface, or none of both."
        )
    distance = positive_length("distance", distance)
    tolerance = length_or_zero("tolerance", 0.0 if tolerance is None else tolerance)
    poles, degree = _form((0, 0) if control_points is None else control_points, degree)
    obj = doc.addObject("Part::FeaturePython", name)
    FittedSurfaceProxy(obj)
    obj.Cloud, obj.Base, obj.Edges, obj.Distance = cloud, base, edges, distance
    obj.PolesU, obj.PolesV = poles or (0, 0)
    obj.DegreeU, obj.DegreeV = degree
    obj.Tolerance = tolerance
    return obj


class FittedSurfaceProxy(ComputedProxy):
    """What makes the object fit."""

    PROPERTIES = _PROPERTIES

    def depends_on(self, obj: Any) -> Iterable[object]:
        """Cloud, base surface, and the surface's form."""
        yield None if obj.Base is None else linked_surface(obj.Base, "base surface")
        yield from (linked_curve(edge, "edge") for edge in obj.Edges)
        yield cloud_checksum(obj.Cloud)
        yield from (obj.Distance.Value, obj.Tolerance.Value)
        yield from (obj.PolesU, obj.PolesV, obj.DegreeU, obj.DegreeV)

    def task(self, obj: Any) -> Task:
        """What fits the surface."""
        near = points_near_base(obj.Cloud, obj.Distance.Value)
        base_of = self._base(obj)
        control_points, degree = _form((obj.PolesU, obj.PolesV), (obj.DegreeU, obj.DegreeV))
        tolerance = length_or_zero("tolerance", obj.Tolerance.Value) or None

        def fit(progress: Progress | None) -> SurfaceFit:
            base, said = base_of(progress and Stage(progress, 0.0, 0.3))
            result = fit_surface(
                near(base, progress and Stage(progress, 0.3, 0.5)),
                base,
                control_points,
                degree,
                tolerance=tolerance,
                progress=progress and Stage(progress, 0.5, 1.0),
            )
            return replace(result, message=f"{said} {result.message}".strip())

        return fit

    @staticmethod
    def _base(obj: Any) -> Callable[[Progress | None], tuple[BSplineSurface, str]]:
        """What answers the base surface, and what is to be said of it."""
        if obj.Base is not None:
            surface = linked_surface(obj.Base, "base surface")
            return lambda _progress: (surface, "")
        edges = [linked_curve(edge, "edge") for edge in obj.Edges]
        cloud = point_cloud(obj.Cloud)

        def found(progress: Progress | None) -> tuple[BSplineSurface, str]:
            if edges:
                base = base_surface(edges=edges)
            else:
                half = progress and Stage(progress, 0.0, 0.5)
                base = base_surface(compensate_cloud(cloud, half), progress=progress)
            return base.surface, base.message

        return found

    def write(self, obj: Any, result: SurfaceFit) -> None:
        """Write surface and numbers."""
        shape = surface_shape(result.surface)
        write_shape(obj, shape, result.message, origin_of(obj.Cloud))
        write_fit_numbers(obj, result)


def _form(
    control_points: Sequence[Any], degree: Sequence[Any]
) -> tuple[tuple[int, int] | None, tuple[int, int]]:
    """Control points in u and v, None where they are both 0, and the degrees."""
    p, q = (whole_number(f"degree in {u}", own, 1) for u, own in zip("uv", degree, strict=True))
    if all(count == 0 for count in control_points):
        return None, (p, q)
    m, n = (
        whole_number(f"number of control points in {u}", count, own + 1)
        for u, count, own in zip("uv", control_points, (p, q), strict=True)
    )
    return (m, n), (p, q)
