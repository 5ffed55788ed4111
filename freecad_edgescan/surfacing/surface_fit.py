# SPDX-License-Identifier: LGPL-2.1-or-later
"""Least-squares B-spline surface through a segment of a cloud.

Schreve 6.3:

1. Each point gets the parameters of the closest point of a base surface (Ma and Kruth 1995,
   Parameterization of randomly measured points for least squares fitting of B-spline curves and
   surfaces). Points beyond the base surface's rim are left out.
2. Knots are averaged over the parameters (Piegl and Tiller 1997, eqs. 9.68 and 9.69).
3. The surface's poles are solved for; all weights are 1. Over a closed base surface they are those
   of a periodic spline: the surface is closed, too, and as smooth over its seam as anywhere.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..cloud.progress import Stage
from ..geometry import BSplineSurface
from .fit_result import SurfaceFit
from .parameterised import parameterised
from .pole_count import averaged, fit_with_enough_poles
from .surface_through import surface_through

if TYPE_CHECKING:
    from ..scanning import Progress

__all__ = ["fit_surface"]

Array = NDArray[np.float64]


def fit_surface(
    points: ArrayLike,
    base: BSplineSurface,
    control_points: tuple[int, int] | None = (12, 6),
    degree: tuple[int, int] = (3, 3),
    knots: tuple[ArrayLike, ArrayLike] | None = None,
    tolerance: float | None = None,
    corrections: int = 1,
    smoothing: float = 1e-3,
    progress: Progress | None = None,
) -> SurfaceFit:
    """The B-spline surface that fits points best, over the parameters of a base surface.

    Parameters
    ----------
    points : (n, 3) array
        Points of the segment in mm, compensated for the probe.
    base : BSplineSurface
        A surface near the points; it gives them their parameters, and the fit its rim.
    control_points : two int, or None
        Number of poles in u and v. None: as many as the tolerance, or without one the points'
        scatter, asks for.
    degree : two int
        Degrees in u and v.
    knots : two arrays, optional
        Clamped knots over the base surface's parameters, instead of averaged ones; they decide
        the number of control points.
    tolerance : float, optional
        With ``control_points=None``: largest distance of a point from the surface, mm, at which
        no more poles are added.
    corrections : int
        How often the parameters are corrected to the fitted surface.
    smoothing : float
        Weight of the displacement's energy, relative to the points'.
    progress : object with ``update(fraction, so_far) -> bool``, optional
        Told the fit so far; when it answers False that is the result. Before there is one the
        result is a fit to the points that have their parameters by then.

    Returns
    -------
    SurfaceFit

    Raises
    ------
    ValueError: fewer points over the base surface than control points, or arguments that do not
        go together.
    """
    if corrections < 0:
        raise ValueError(f"Parameters cannot be corrected {corrections} times; give 0 or more.")
    if not smoothing > 0.0:
        raise ValueError(
            f"The smoothing is {smoothing}; give a small positive number, which holds control "
            "points that no point of the cloud supports."
        )
    if knots is None and control_points is not None:
        for name, count, p in zip("uv", control_points, degree, strict=True):
            if count < p + 1:
                raise ValueError(
                    f"{count} control points in {name} are too few for degree {p}; give "
                    f"{p + 1} or more."
                )
    if tolerance is not None and (control_points is not None or knots is not None):
        raise ValueError(
            f"A tolerance ({tolerance} mm) chooses the number of control points; give "
            "control_points=None and no knots with it, or leave it out."
        )
    given = parameterised(points, base, progress and Stage(progress, 0.0, 0.4))
    rest = progress and Stage(progress, 0.4, 1.0)
    if knots is not None:
        chosen = _checked(knots, base, degree)
    elif control_points is not None:
        chosen = averaged(given, base, control_points, degree)
    else:
        return fit_with_enough_poles(given, base, degree, tolerance, corrections, smoothing, rest)
    return surface_through(given, base, chosen, degree, corrections, smoothing, rest)


def _checked(
    knots: tuple[ArrayLike, ArrayLike], base: BSplineSurface, degree: tuple[int, int]
) -> tuple[Array, Array]:
    """Given knots as arrays, refused unless they span the base surface's parameters."""
    u, v = (np.asarray(own, dtype=float) for own in knots)
    for name, own, limits in zip("uv", (u, v), base.parameter_range, strict=True):
        if own.size < 2 or (own[0], own[-1]) != limits:
            raise ValueError(
                f"Knots in {name} must run over the base surface's parameters, from {limits[0]:g} "
                f"to {limits[1]:g}; scale them."
            )
    # refuses knots that make no surface
    BSplineSurface(np.zeros((u.size - degree[0] - 1, v.size - degree[1] - 1, 3)), (u, v), degree)
    return u, v
