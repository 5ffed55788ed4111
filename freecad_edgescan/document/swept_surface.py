# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric swept surface: it follows its rails and profiles, and is fitted to a cloud.

The name of this module and of `SweptSurfaceProxy` are written into users' files.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from ..cloud.progress import Stage
from ..scanning import Progress
from ..surfacing import (
    SweepModel,
    SweptFit,
    SweptSurface,
    compare_sweep_models,
    fit_swept_surface,
    sweep_kinds,
)
from .bridge import origin_of
from .cloud_cache import cloud_checksum
from .computed_object import MESSAGE, ORIGIN, ComputedProxy, Task, result
from .computed_shape import write_shape
from .declared_properties import Declared
from .exact_sweep import exact_shape
from .fit_numbers import FIT_RESULTS, write_fit_numbers
from .given_numbers import length_or_zero, positive_length, whole_number
from .linked_geometry import linked_curve, require_cloud, require_shape
from .native_surface import surface_shape
from .points_near_base import points_near_base

__all__ = ["SweptSurfaceProxy", "make_swept_surface"]

BETTER = "better"
MODELS = (BETTER, *(str(model.value) for model in SweepModel))

_FEWEST_POLES = 4  # a cubic has that many

_PROPERTIES = (
    Declared("LinkListGlobal", "Rails", "Sweep", "One or two curves along which profiles move"),
    Declared(
        "LinkListGlobal", "Profiles", "Sweep", "Curves from the first rail to the second, in order"
    ),
    Declared(
        "Enumeration",
        "Model",
        "Sweep",
        "How a profile changes: blend moves and blends it, rotate turns it with the rails, better "
        "is the one that explains the cloud better (rotate without a cloud)",
        choices=MODELS,
    ),
    Declared("Distance", "LargestGap", "Sweep", "How far a profile may end beside its rail"),
    Declared(
        "Bool",
        "CutRails",
        "Sweep",
        "Whether rails that go on beyond the outer profiles by more than LargestGap end where "
        "these do",
    ),
    Declared(
        "Distance", "Tolerance", "Sweep", "Of the surface from the exact sweep, without a cloud"
    ),
    Declared(
        "Bool",
        "Exact",
        "Sweep",
        "Whether an extrusion or revolution, as Kinds says, is made as a surface of this kind",
    ),
    Declared("LinkGlobal", "Cloud", "Fit", "Cloud or segment the sweep is fitted to, or nothing"),
    Declared(
        "Distance",
        "Distance",
        "Fit",
        "Points of a whole cloud nearer than this to the sweep belong to it; all of a segment do",
    ),
    Declared("Integer", "RailPoles", "Fit", "Control points of each fitted rail"),
    Declared("Integer", "ProfilePoles", "Fit", "Control points of each fitted profile"),
    result("String", "ModelUsed", "The model of the surface"),
    result("StringList", "Kinds", "What the sweep is besides: ruled, extrusion, revolution, pipe"),
    *FIT_RESULTS,
    MESSAGE,
    ORIGIN,
)


def make_swept_surface(
    doc: Any,
    rails: Sequence[Any],
    profiles: Sequence[Any],
    cloud: Any = None,
    model: str = BETTER,
    control_points: tuple[int, int] = (14, 7),
    distance: float = 3.0,
    cut_rails: bool = True,
    name: str = "SweptSurface",
) -> Any:
    """Make a surface swept by profiles along rails; `doc.recompute()` computes it.

    Parameters
    ----------
    doc : App.Document
    rails : one or two objects whose edges form a curve, such as scanned edges
    profiles : objects with a curve from the first rail to the second, in order
    cloud : Points::Feature the sweep is fitted to; None: it goes through rails and profiles
    model : "blend", "rotate", or "better": the one that explains the cloud better
    control_points : of the fitted rails and of the fitted profiles
    distance : mm, from the sweep, within which points of a whole cloud belong to it
    cut_rails : whether rails that go on beyond the outer profiles end where these do
    name : of the object

    Returns
    -------
    Part::FeaturePython whose Shape is one B-spline face.

    Raises
    ------
    ValueError: objects without a shape, no cloud, or an unknown model; nothing is made then.
    """
    rails, profiles = list(rails), list(profiles)
    require_shape("rail", rails)
    require_shape("profile", profiles)
    if cloud is not None:
        require_cloud(cloud)
    if model not in MODELS:
        raise ValueError(f"There is no sweep model {model!r}; choose {', '.join(MODELS)}.")
    distance = positive_length("distance", distance)
    rail_poles, profile_poles = _poles(*control_points)
    obj = doc.addObject("Part::FeaturePython", name)
    SweptSurfaceProxy(obj)
    obj.Rails, obj.Profiles, obj.Cloud = rails, profiles, cloud
    obj.Model = str(model)
    obj.RailPoles, obj.ProfilePoles = rail_poles, profile_poles
    obj.Distance, obj.CutRails = distance, bool(cut_rails)
    return obj


class SweptSurfaceProxy(ComputedProxy):
    """What makes the object sweep and fit."""

    PROPERTIES = _PROPERTIES

    def __init__(self, obj: Any) -> None:
        super().__init__(obj)
        obj.LargestGap, obj.Tolerance, obj.Distance = 1.0, 1e-3, 3.0
        obj.RailPoles, obj.ProfilePoles = 14, 7

    def depends_on(self, obj: Any) -> Iterable[object]:
        """Rails, profiles and cloud, and how they are swept and fitted."""
        yield from (linked_curve(rail, "rail") for rail in obj.Rails)
        yield from (linked_curve(profile, "profile") for profile in obj.Profiles)
        yield from (len(obj.Rails), obj.Model, obj.LargestGap.Value, obj.CutRails, obj.Exact)
        if obj.Cloud is None:
            yield obj.Tolerance.Value
        else:
            yield cloud_checksum(obj.Cloud)
            yield from (obj.Distance.Value, obj.RailPoles, obj.ProfilePoles)

    def task(self, obj: Any) -> Task:
        """What sweeps, and fits when there is a cloud."""
        rails = tuple(linked_curve(rail, "rail") for rail in obj.Rails)
        profiles = tuple(linked_curve(profile, "profile") for profile in obj.Profiles)
        both = obj.Model == BETTER
        model = SweepModel.ROTATE if both else SweepModel(obj.Model)
        gap = length_or_zero("largest gap", obj.LargestGap.Value)
        cut = bool(obj.CutRails)
        if obj.Cloud is None:
            positive_length("tolerance", obj.Tolerance.Value)
        near = None if obj.Cloud is None else points_near_base(obj.Cloud, obj.Distance.Value)
        poles = _poles(obj.RailPoles, obj.ProfilePoles)

        def sweep(progress: Progress | None) -> SweptFit | SweptSurface:
            base = SweptSurface(rails, profiles, model, largest_gap=gap, cut_rails=cut)
            if near is None:
                return base
            points = near(base.to_bspline(1e-2), progress and Stage(progress, 0.0, 0.5))
            rest = progress and Stage(progress, 0.5, 1.0)
            if both and len(base.profiles) == 2 and len(base.rails) == 2:
                return next(iter(compare_sweep_models(points, base, poles, rest).values()))
            return fit_swept_surface(points, base, poles, rest)

        return sweep

    def write(self, obj: Any, result: SweptFit | SweptSurface) -> None:
        """Write surface and numbers, and what the sweep is besides."""
        if isinstance(result, SweptFit):
            sweep, surface = result.sweep, result.surface
            write_fit_numbers(obj, result)
            tolerance = max(3.0 * result.rms, 1e-3)
        else:
            sweep, surface = result, result.to_bspline(obj.Tolerance.Value)
            write_fit_numbers(obj, None)
            tolerance = max(obj.Tolerance.Value, 1e-3)
        kinds = () if sweep is None else sweep_kinds(sweep, tolerance)
        exact = exact_shape(sweep, kinds) if obj.Exact and sweep is not None else None
        shape = surface_shape(surface) if exact is None else exact
        missing = obj.Exact and exact is None
        said = "The sweep is neither an extrusion nor a revolution." if missing else ""
        obj.Kinds = [str(kind.value) for kind in kinds]
        if sweep is not None:
            obj.ModelUsed = str(sweep.model.value)
        origins = [origin_of(own) for own in (*obj.Rails, *([obj.Cloud] if obj.Cloud else []))]
        origin = next((own for own in origins if np.any(own)), np.zeros(3))
        write_shape(obj, shape, f"{result.message} {said}".strip(), origin)


def _poles(rail: Any, profile: Any) -> tuple[int, int]:
    """Control points of each fitted rail and of each fitted profile."""
    return (
        whole_number("number of control points of a rail", rail, _FEWEST_POLES),
        whole_number("number of control points of a profile", profile, _FEWEST_POLES),
    )
