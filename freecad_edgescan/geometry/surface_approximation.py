# SPDX-License-Identifier: LGPL-2.1-or-later
"""Any smooth shape over a rectangle of parameters as a B-spline surface within a tolerance."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from freecad_edgescan.geometry.bspline_surface import BSplineSurface
from freecad_edgescan.geometry.surface_interpolation import interpolated_surface

__all__ = ["approximated_surface"]

Array = NDArray[np.float64]

_BETWEEN = np.array([0.11, 0.31, 0.5, 0.69, 0.89])  # shares of a span at which it is checked
_MOST = 400  # spans in one direction


def approximated_surface(
    shape: Callable[[Array, Array], Array],
    knots: tuple[Array, Array],
    degree: tuple[int, int],
    tolerance: float,
) -> BSplineSurface:
    """The interpolating surface whose spans are halved until it keeps the tolerance.

    A shape that is a spline over the given knots is returned exactly. Points of equal parameters
    are compared, so that the surface also has the shape's parameters.

    Parameters
    ----------
    shape : takes parameters u (nu, 1) and v (1, nv), answers points (nu, nv, 3) in mm
    knots, degree : clamped knots to begin with; those where the shape has kinks must be among them
    tolerance : mm

    Raises
    ------
    ValueError: a tolerance that is not positive, or that more than 400 spans do not keep.
    """
    if not 0.0 < tolerance < np.inf:
        raise ValueError(f"The tolerance is {tolerance} mm; give a positive length.")
    while True:
        surface = interpolated_surface(shape, knots, degree)
        breaks = [np.unique(own) for own in knots]
        u, v = ((own[:-1, None] + np.diff(own)[:, None] * _BETWEEN).ravel() for own in breaks)
        miss = np.linalg.norm(
            surface.evaluate(u[:, None], v) - shape(u[:, None], v[None, :]), axis=2
        )
        if miss.max() <= tolerance:
            return surface
        knots = _halved(knots, breaks, miss, tolerance)
        if max(len(own) for own in knots) > _MOST + 2 * max(degree):
            raise ValueError(
                f"A surface of {_MOST} spans is still {miss.max():.3g} mm off, above the tolerance "
                f"of {tolerance:g} mm; the shape has kinks, or take a larger tolerance."
            )


def _halved(
    knots: tuple[Array, Array], breaks: list[Array], miss: Array, tolerance: float
) -> tuple[Array, Array]:
    """Knots with those spans halved that miss, in the direction in which the miss varies more."""
    blocks = miss.reshape(len(breaks[0]) - 1, len(_BETWEEN), len(breaks[1]) - 1, len(_BETWEEN))
    worst = blocks.max(axis=(1, 3))
    # Along a direction in which the spline is good enough the miss of a patch is nearly constant.
    vary_u = np.ptp(blocks, axis=1).max(axis=2)
    vary_v = np.ptp(blocks, axis=3).max(axis=1)
    wrong = worst > tolerance
    chosen = (
        (wrong & (vary_u >= 0.3 * vary_v)).any(axis=1),
        (wrong & (vary_v >= 0.3 * vary_u)).any(axis=0),
    )
    u, v = (
        np.sort(np.append(own, ((at[:-1] + at[1:]) / 2)[which]))
        for own, at, which in zip(knots, breaks, chosen, strict=True)
    )
    return u, v
