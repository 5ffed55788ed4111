# SPDX-License-Identifier: LGPL-2.1-or-later
"""The B-spline surface with given knots that agrees with another shape at Greville's abscissae."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import BSpline
from scipy.linalg import solve

from freecad_edgescan.geometry.bspline_surface import BSplineSurface
from freecad_edgescan.geometry.knot_vectors import greville

__all__ = ["interpolated_surface"]

Array = NDArray[np.float64]


def interpolated_surface(
    shape: Callable[[Array, Array], Array], knots: tuple[Array, Array], degree: tuple[int, int]
) -> BSplineSurface:
    """The polynomial surface through a shape's points, as many as it has poles.

    Parameters
    ----------
    shape : takes parameters u (nu, 1) and v (1, nv), answers points (nu, nv, 3) in mm
    knots, degree : of the surface, clamped
    """
    at_u, at_v = (greville(k, p) for k, p in zip(knots, degree, strict=True))
    points = shape(at_u[:, None], at_v[None, :])
    rows, columns = (
        BSpline.design_matrix(at, k, p).toarray()
        for at, k, p in zip((at_u, at_v), knots, degree, strict=True)
    )
    poles = solve(rows, points.reshape(len(at_u), -1)).reshape(points.shape)
    poles = solve(columns, poles.transpose(1, 0, 2).reshape(len(at_v), -1))
    poles = poles.reshape(len(at_v), len(at_u), 3).transpose(1, 0, 2)
    return BSplineSurface(poles, knots, degree)
