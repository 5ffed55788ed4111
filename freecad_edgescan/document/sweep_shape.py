# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shape that a profile leaves on its way along a rail.

Most rails bound a plane face. There the profile keeps its angle to that plane, which is exact.
FreeCAD's own sweep knows only frames that follow the rail's curvature; where a nearly straight rail
bends the other way these turn over within a millimetre, and the surface shoots out or is folded.

OpenCASCADE's pipes are taken along smooth rails, where they are right, since they keep cylinders
and planes as such. Its mitres are not: a profile a thousandth of a radian off square, or corners
some hundredths of a mm out of one plane, make them invalid, or 6 % too large and valid. So what
has corners, or is beyond it, is swept by our own construction.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import Part
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from .sewn_sweep import sewn_sweep, smooth_curves

__all__ = ["is_within_reach", "sweep_shape"]

Array = NDArray[np.float64]

_SAMPLES = 400  # along the rail
_ON_A_FACE = (200, 9)  # places of a face that are looked at
_SMOOTH = 1e-3  # rad, of a turn from edge to edge
_ROOM = 1.05  # share of the profile's reach that no part of the surface may leave


def sweep_shape(profile: Any, rail: Any, solid: bool = False) -> tuple[Any, bool]:
    """Sweep a profile along a rail, with a mitre in each of its corners.

    Parameters
    ----------
    profile, rail : Part.Wire
    solid : whether a closed profile gives a solid

    Returns
    -------
    The Part.Shape, and whether the profile keeps its angle to the plane of the rail. If not, the
    rail lies in no plane, or is a straight line, and the frames turn as little as they can.

    Raises
    ------
    ValueError: the rail turns too sharply, or the profile has no room beside it, lies along it or
        is open and gives no solid.
    """
    if solid and not profile.isClosed():
        raise ValueError("Only a closed profile gives a solid; close it, or set Solid to false.")
    plane = rail.findPlane()
    smooth = sharpest_turn(rail) <= _SMOOTH
    shape = _pipe(profile, rail, plane, solid) if smooth else None
    return shape or sewn_sweep(profile, rail, solid), plane is not None


def _pipe(profile: Any, rail: Any, plane: Any, solid: bool) -> Any | None:
    """OpenCASCADE's pipe along a smooth rail, or None where it fails."""
    maker = Part.BRepOffsetAPI.MakePipeShell(rail)
    if plane is not None:
        maker.setBiNormalMode(plane.Axis)
    else:
        maker.setFrenetMode(False)
    maker.add(profile)
    try:
        maker.build()
        surface = maker.shape()
    except (Part.OCCError, RuntimeError):
        return None
    if surface.isNull() or not surface.Faces or not surface.isValid():
        return None
    if not is_within_reach(surface, profile, rail) or (solid and not maker.makeSolid()):
        return None
    return maker.shape()


def is_within_reach(surface: Any, profile: Any, rail: Any) -> bool:
    """Whether a surface leaves its rail no farther than the profile does.

    OpenCASCADE finds surfaces valid that shoot out by metres.

    Parameters
    ----------
    surface : Part.Shape, the sweep of the profile along the rail
    profile, rail : Part.Wire
    """
    _, nearest, _ = profile.distToShape(rail)
    foot = np.array(nearest[0][1])
    edge = np.concatenate([_samples(part) for part in profile.Edges])
    reach = np.linalg.norm(edge - foot, axis=1).max()
    way = np.concatenate([_samples(part) for part in rail.Edges])
    step = np.linalg.norm(np.diff(way, axis=0), axis=1).max(initial=0.0)
    away = cKDTree(way).query(_places(surface))[0].max()
    return bool(away <= _ROOM * reach + step)


def sharpest_turn(rail: Any) -> float:
    """The largest turn of a Part.Wire in a corner, between its edges or within one, rad."""
    ends = [curve.tangent(np.array(curve.parameter_range)) for curve in smooth_curves(rail)]
    pairs = list(pairwise(ends)) + ([(ends[-1], ends[0])] if rail.isClosed() else [])
    turns = [np.linalg.norm(after[0] - before[1]) for before, after in pairs]
    return float(2.0 * np.arcsin(0.5 * np.minimum(turns, 2.0)).max(initial=0.0))


def _samples(edge: Any) -> Array:
    return np.array([tuple(place) for place in edge.discretize(_SAMPLES)])


def _places(surface: Any) -> Array:
    """Places (k, 3) on a grid over each face."""
    places = []
    for face in surface.Faces:
        first_u, last_u, first_v, last_v = face.ParameterRange
        # Either of the two parameters may run along the rail.
        for many, few in (_ON_A_FACE, _ON_A_FACE[::-1]):
            for u in np.linspace(first_u, last_u, many).tolist():
                for v in np.linspace(first_v, last_v, few).tolist():
                    places.append(tuple(face.valueAt(u, v)))
    return np.array(places)
