# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pipes of the demonstration: profiles, a sweep, a loft and a fitted sweep, held against the truth.

A sweep moves one profile along one rail; where the pipe narrows it cannot follow. The loft
goes through arc profiles measured at several places between the two rails, and can. The fitted
sweep turns and scales its profiles between both rails, and goes through all points of the cloud.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..cloud.half_pipe import HalfPipe
from ..experiments.true_wall import deviation_from_wall
from .arc_profile import make_arc_profile
from .cloud_section import make_cloud_section
from .cloud_segment import make_cloud_segment
from .deviation_map import make_deviation_map
from .sweeps import make_loft, make_sweep
from .swept_surface import make_swept_surface

__all__ = ["DemoSurface", "make_pipe"]

Array = NDArray[np.float64]

_ENDS = (0.04, 0.96)  # between these shares of the first rail the profiles stand
_GRID = (160, 24)  # places on a surface, along and across
_ROUGH = 1e-2  # mm, tolerance of the surface that cuts the cloud


@dataclass(frozen=True)
class DemoSurface:
    """One row of the demonstration's second table.

    Attributes
    ----------
    name : what it is called
    profiles : how many it goes through
    valid : whether FreeCAD could make it and finds its shape valid
    deviation : (k,) distances of places on it from the true wall, mm; none when it is not valid
    from_cloud : mean and largest deviation of the cloud's points from it, mm, when it was fitted
    """

    name: str
    profiles: int
    valid: bool
    deviation: Array
    from_cloud: tuple[float, float] | None = None


def make_pipe(
    doc: Any, cloud: Any, rails: tuple[Any, Any], truth: HalfPipe, number: int, profiles: int
) -> list[DemoSurface]:
    """Make the profiles, sweep, loft and fitted sweep of one pipe, and measure them.

    Parameters
    ----------
    doc : App.Document
    cloud : Points::Feature
    rails : the two scanned rims
    truth : the exact pipe
    number : of the pipe, for names
    profiles : how many the loft goes through, two or more; the first one is swept

    Raises
    ------
    ValueError: a profile could not be measured.
    """
    arcs = [
        make_arc_profile(doc, cloud, rails, float(share), name=f"Pipe{number}Profile")
        for share in np.linspace(*_ENDS, profiles)
    ]
    sweep = make_sweep(doc, arcs[0], rails[1], name=f"Pipe{number}Sweep")
    loft = make_loft(doc, arcs, name=f"Pipe{number}Loft")
    group = doc.addObject("App::DocumentObjectGroup", f"Pipe{number}Profiles")
    group.addObjects(arcs)
    fitted = _fitted_sweep(doc, cloud, rails, number)
    doc.recompute()
    return [
        _measured(f"pipe {number} sweep", 1, sweep, truth),
        _measured(f"pipe {number} loft", profiles, loft, truth),
        replace(
            _measured(f"pipe {number} fitted", 2, fitted, truth),
            from_cloud=(fitted.Average.Value, fitted.Maximum.Value),
        ),
    ]


def _fitted_sweep(doc: Any, cloud: Any, rails: tuple[Any, Any], number: int) -> Any:
    """The sweep along both rails, fitted to its segment of the cloud, with its deviation map."""
    ends = [
        make_cloud_section(doc, cloud, rails[0], share, rails[1], name=f"Pipe{number}End")
        for share in (0.0, 1.0)
    ]
    base = make_swept_surface(doc, rails, ends, model="rotate", name=f"Pipe{number}Base")
    base.Tolerance = _ROUGH
    segment = make_cloud_segment(doc, cloud, base, name=f"Pipe{number}Points")
    fitted = make_swept_surface(
        doc, rails, ends, segment, model="rotate", name=f"Pipe{number}Fitted"
    )
    make_deviation_map(doc, segment, fitted, name=f"Pipe{number}Deviations")
    return fitted


def _measured(name: str, profiles: int, obj: Any, truth: HalfPipe) -> DemoSurface:
    valid = not obj.Shape.isNull() and obj.Shape.isValid() and bool(obj.Shape.Faces)
    deviation = deviation_from_wall(truth, _places(obj.Shape)) if valid else np.zeros(0)
    return DemoSurface(name, profiles, valid, deviation)


def _places(shape: Any) -> Array:
    """Places (k, 3) on a grid over each face of a shape."""
    places = []
    for face in shape.Faces:
        first_u, last_u, first_v, last_v = face.ParameterRange
        for u in np.linspace(first_u, last_u, _GRID[0]).tolist():
            for v in np.linspace(first_v, last_v, _GRID[1]).tolist():
                place = face.valueAt(u, v)
                places.append((place.x, place.y, place.z))
    return np.array(places)
