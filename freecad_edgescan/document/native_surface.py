# SPDX-License-Identifier: LGPL-2.1-or-later
"""Between our B-spline surfaces and FreeCAD's: the same poles, weights and knots."""

from __future__ import annotations

from typing import Any

import numpy as np
import Part

from ..geometry import BSplineSurface
from .native_curve import vector

__all__ = ["as_nurbs", "native_surface", "surface_of", "surface_shape"]


def native_surface(surface: BSplineSurface) -> Any:
    """The Part.BSplineSurface with the same poles, weights and knots."""
    (u, count_u), (v, count_v) = surface.distinct_knots_and_multiplicities()
    weights = np.ones(surface.poles.shape[:2]) if surface.weights is None else surface.weights
    native = Part.BSplineSurface()
    native.buildFromPolesMultsKnots(
        [[vector(pole) for pole in row] for row in surface.poles],
        count_u.tolist(),
        count_v.tolist(),
        u.tolist(),
        v.tolist(),
        False,
        False,
        *surface.degree,
        weights.tolist(),
    )
    return native


def surface_shape(surface: BSplineSurface) -> Any:
    """The native face over the whole of a surface."""
    return native_surface(surface).toShape()


def as_nurbs(face: Any) -> Any:
    """The face over the B-spline that its surface is.

    Without the triangles that the window gave it: with them FreeCAD 1.0 makes a face whose surface
    it does not know.
    """
    (converted,) = face.copy(True, False).toNurbs().Faces
    return converted


def surface_of(shape: Any, what: str = "surface") -> BSplineSurface:
    """The exact B-spline surface of a shape's only face.

    Parameters
    ----------
    shape : Part.Shape with one face; planes, cylinders and other elementary surfaces become the
        B-splines that they are
    what : what to call it in a sentence

    Returns
    -------
    BSplineSurface in mm, where the face stands, over the range of the face's parameters: what was
    cut off within that range is there again. Its normal is that of the face.

    Raises
    ------
    ValueError: no face, or several.
    """
    faces = [] if shape.isNull() else shape.Faces
    if len(faces) != 1:
        raise ValueError(
            f"The {what} has {len(faces)} faces and must have one; "
            + ("choose one of them." if faces else "recompute the document, or choose another.")
        )
    converted = as_nurbs(faces[0])
    native = converted.Surface
    wanted, whole = np.array(converted.ParameterRange), np.array(native.bounds())
    slack = 1e-9 * np.repeat(whole[1::2] - whole[::2], 2)
    if native.isUPeriodic() or native.isVPeriodic() or np.any(np.abs(wanted - whole) > slack):
        native = native.copy()
        native.segment(*np.where(np.abs(wanted - whole) > slack, wanted, whole).tolist())
    weights = np.array(native.getWeights())
    surface = BSplineSurface.from_distinct_knots(
        np.array([[tuple(pole) for pole in row] for row in native.getPoles()]),
        (native.getUKnots(), native.getVKnots()),
        (native.getUMultiplicities(), native.getVMultiplicities()),
        (int(native.UDegree), int(native.VDegree)),
        None if np.all(weights == weights.flat[0]) else weights,
    )
    return surface.reversed(0) if converted.Orientation == "Reversed" else surface
