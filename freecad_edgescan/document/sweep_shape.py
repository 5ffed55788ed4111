# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shape that a profile leaves on its way along a rail.

Most rails bound a plane face. There the profile keeps its angle to that plane, which is exact.
FreeCAD's own sweep knows only frames that follow the rail's curvature; where a nearly straight rail
bends the other way these turn over within a millimetre, and the surface shoots out or is folded.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import Part
from numpy.typing import NDArray
from scipy.spatial import cKDTree

__all__ = ["require_within_reach", "sweep_shape"]

Array = NDArray[np.float64]

_SAMPLES = 400  # along the rail
_ON_A_FACE = (200, 9)  # places of a face that are looked at
_SMOOTH = 1e-3  # rad, of a turn from edge to edge
_MITRED = 1  # OpenCASCADE's "right corner"; its usual way flattens the profile past each corner
_ROOM = 1.05  # share of the profile's reach that no part of the surface may leave


def sweep_shape(profile: Any, rail: Any, solid: bool = False) -> tuple[Any, bool]:
    """Sweep a profile along a rail.

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
    ValueError: OpenCASCADE cannot do it, or what it made leaves the profile's reach.
    """
    plane = rail.findPlane()
    maker = Part.BRepOffsetAPI.MakePipeShell(rail)
    if plane is not None:
        maker.setBiNormalMode(plane.Axis)
    else:
        maker.setFrenetMode(False)
    if sharpest_turn(rail) > _SMOOTH:
        maker.setTransitionMode(_MITRED)
    maker.add(profile)
    try:
        maker.build()
        surface = maker.shape()
    except (Part.OCCError, RuntimeError) as error:
        raise ValueError(
            f"OpenCASCADE cannot sweep this profile along this rail ({error}). Sweep along a "
            "shorter piece, or loft through several profiles."
        ) from None
    if surface.isNull() or not surface.Faces:
        raise ValueError("The sweep has no face; let the profile stand across the rail.")
    if not surface.isValid():
        raise ValueError(
            "The swept surface has no width somewhere or crosses itself. Let the profile stand "
            "across the rail, or sweep along a shorter piece."
        )
    require_within_reach(surface, profile, rail)
    if solid and not maker.makeSolid():
        raise ValueError("Only a closed profile gives a solid; close it, or set Solid to false.")
    return maker.shape(), plane is not None


def require_within_reach(surface: Any, profile: Any, rail: Any) -> None:
    """Refuse a surface that leaves its rail by more than the profile does.

    OpenCASCADE finds surfaces valid that shoot out by metres.

    Parameters
    ----------
    surface : Part.Shape, the sweep of the profile along the rail
    profile, rail : Part.Wire

    Raises
    ------
    ValueError: some place of the surface is farther from the rail than any of the profile.
    """
    _, nearest, _ = profile.distToShape(rail)
    foot = np.array(nearest[0][1])
    edge = np.concatenate([_samples(part) for part in profile.Edges])
    # In a corner the profile is cut at half the turn, and reaches farther there.
    reach = np.linalg.norm(edge - foot, axis=1).max() / np.cos(0.5 * sharpest_turn(rail))
    way = np.concatenate([_samples(part) for part in rail.Edges])
    step = np.linalg.norm(np.diff(way, axis=0), axis=1).max(initial=0.0)
    away = cKDTree(way).query(_places(surface))[0].max()
    if away > _ROOM * reach + step:
        raise ValueError(
            f"The swept surface leaves the rail by {away:.3g} mm, the profile only by {reach:.3g}: "
            "its frames turn over. Sweep along a shorter piece, or loft through several profiles."
        )


def sharpest_turn(rail: Any) -> float:
    """The largest turn from one edge of a Part.Wire to the next, rad."""
    ends = [_directions(edge) for edge in rail.OrderedEdges]
    pairs = list(pairwise(ends)) + ([(ends[-1], ends[0])] if rail.isClosed() else [])
    return max((float(before[1].getAngle(after[0])) for before, after in pairs), default=0.0)


def _directions(edge: Any) -> tuple[Any, Any]:
    """Of an edge at its start and its end, along the wire it is in."""
    first, last = (edge.tangentAt(parameter) for parameter in edge.ParameterRange)
    return (first, last) if edge.Orientation == "Forward" else (-last, -first)


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
