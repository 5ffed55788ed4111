# SPDX-License-Identifier: LGPL-2.1-or-later
"""One door to base surfaces: from four edges, from rails and profiles, or from points alone.

A base surface is near the part: it gives the points of a cloud their parameters (Schreve 6.3) and
tells which of them belong to it (6.7).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..cloud import PointCloud
from ..cloud.local_normals import local_normals
from ..cloud.progress import Progress, Stage
from ..geometry import BSplineCurve, BSplineSurface
from ..geometry.plain_number import plain
from ..scanning import ScannedEdge
from .coons import coons_surface
from .deviation import points_of
from .primitive_search import fitted_primitives, simplest_primitive
from .primitive_shapes import Primitive, ShapeKind
from .swept_surface import SweepModel, SweptSurface

__all__ = ["BaseSurface", "base_surface", "curve_of"]

Array = NDArray[np.float64]

_SHAPES = (
    ShapeKind.PLANE,
    ShapeKind.SPHERE,
    ShapeKind.CYLINDER,
    ShapeKind.CONE,
    ShapeKind.QUADRIC,
)
_FEWEST = 20
_SAMPLE = 4000  # points the shape is found by
_STRAY = 4.0  # of the spread


@dataclass(frozen=True, eq=False)
class BaseSurface:
    """A base surface and where it comes from.

    Attributes
    ----------
    surface : BSplineSurface
    kind : plane, cylinder, cone, sphere or quadric (from points), edges or sweep
    message : what it is, and what was done to the curves it was made of
    shape : the plane, cylinder, cone, sphere or quadric itself, or None
    sweep : the sweep it is the B-spline of, or None
    """

    surface: BSplineSurface
    kind: ShapeKind
    message: str = ""
    shape: Primitive | None = None
    sweep: SweptSurface | None = None


def base_surface(
    points: PointCloud | ArrayLike | None = None,
    *,
    edges: Sequence[BSplineCurve | ScannedEdge] | None = None,
    rails: Sequence[BSplineCurve | ScannedEdge] | None = None,
    profiles: Sequence[BSplineCurve | ScannedEdge] | None = None,
    kind: ShapeKind | str | None = None,
    model: SweepModel | str = SweepModel.ROTATE,
    largest_gap: float = 1.0,
    tolerance: float = 1e-2,
    progress: Progress | None = None,
) -> BaseSurface:
    """A surface near the part, from exactly one of points, four edges, or rails and profiles.

    Parameters
    ----------
    points : PointCloud or (n, 3) array, mm
        A segment of a cloud, compensated. A plane, cylinder, cone, sphere or quadric (a graph of
        degree 2) is chosen by evidence and laid over the part the points cover. Up to a third of
        them may be strays.
    edges : four curves or scanned edges round a patch, in any order
    rails, profiles : as for `SweptSurface`
    kind : "plane", "cylinder", "cone", "sphere" or "quadric", optional
        With points: this one, whatever the evidence says.
    model : "rotate" or "blend"
        With rails.
    largest_gap : float
        How far, mm, edges or profiles may miss each other or the rails.
    tolerance : float
        mm, of the B-spline against edges and sweep.
    progress : object with ``update(fraction, so_far) -> bool``, optional
        With points: told the share that is done; when it answers False the best of the shapes
        tried so far is the result.

    Returns
    -------
    BaseSurface

    Raises
    ------
    ValueError: not exactly one of the three ways; too few points; curves that do not meet, with
        the gaps between them.
    """
    swept = rails is not None or profiles is not None
    given = [points is not None, edges is not None, swept]
    if sum(given) != 1:
        raise ValueError(
            f"A base surface is made from points, from edges, or from rails and profiles, not from "
            f"{sum(given)} of these ways; give exactly one."
        )
    if kind is not None and points is None:
        raise ValueError(f"A kind ({kind!r}) is chosen for points only; leave it out.")
    if points is not None:
        return _from_points(points_of(points), kind, progress)
    if edges is not None:
        surface, said = coons_surface([curve_of(edge) for edge in edges], largest_gap, tolerance)
        return BaseSurface(surface, ShapeKind.EDGES, said)
    if rails is None or profiles is None:
        raise ValueError(
            f"A sweep needs rails and profiles; the {'rails' if rails is None else 'profiles'} "
            "are missing."
        )
    sweep = SweptSurface(
        tuple(curve_of(rail) for rail in rails),
        tuple(curve_of(profile) for profile in profiles),
        SweepModel(model) if model in list(SweepModel) else model,  # type: ignore[arg-type]
        largest_gap=largest_gap,
    )
    return BaseSurface(sweep.to_bspline(tolerance), ShapeKind.SWEEP, sweep.message, sweep=sweep)


def curve_of(edge: BSplineCurve | ScannedEdge) -> BSplineCurve:
    """The curve of a scanned edge, or the curve itself."""
    return edge.curve() if isinstance(edge, ScannedEdge) else edge


def _from_points(
    points: Array, kind: ShapeKind | str | None, progress: Progress | None
) -> BaseSurface:
    if kind is not None and kind not in list(_SHAPES):
        listed = ", ".join(_SHAPES)
        raise ValueError(f"There is no base surface of the kind {kind!r}; choose one of {listed}.")
    if len(points) < _FEWEST:
        raise ValueError(
            f"{len(points)} points are too few to tell what they lie on; give {_FEWEST} or more."
        )
    origin = points.mean(axis=0)
    cloud = PointCloud(points - origin)
    extents = cloud.principal_extents
    if extents[1] <= 1e-6 * extents[0]:
        raise ValueError(
            f"All {len(points)} points lie on one line, {plain(extents[0], 4)} mm long; no surface "
            "is determined. Take a larger segment."
        )
    some = _sample(len(points))
    normals = local_normals(cloud, some, Stage(progress, 0.0, 0.3))
    kinds = _SHAPES if kind is None else (ShapeKind(kind),)
    shapes = fitted_primitives(cloud.points[some], normals, kinds, Stage(progress, 0.3, 1.0))
    if not shapes:
        raise ValueError(
            f"No {kind or 'surface'} can be fitted to the {len(points)} points; choose another "
            "kind, or a smoother segment."
        )
    shape, spread = simplest_primitive(shapes, cloud.points[some], cloud.noise)
    off = np.abs(shape.distances(cloud.points))
    near = off <= _STRAY * spread
    surface = shape.surface(cloud.points[near])
    placed = BSplineSurface(surface.poles + origin, surface.knots, surface.degree, surface.weights)
    strays = int(np.count_nonzero(~near))
    message = (
        f"{shape.said()} holds {len(points) - strays} of {len(points)} points with a spread of "
        f"{plain(spread, 3)} mm."
    )
    return BaseSurface(placed, shape.kind, message, shape.moved(origin))


def _sample(count: int) -> NDArray[np.bool_]:
    """Some of the points, by chance: among evenly spread ones sparse strays would be more."""
    some = np.zeros(count, dtype=bool)
    some[np.random.default_rng(0).permutation(count)[:_SAMPLE]] = True
    return some
