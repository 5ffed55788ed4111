# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the fit of a surface answers: the surface, and how far the points are from it."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..geometry import BSplineSurface
from .deviation_figures import DeviationFigures

__all__ = ["SurfaceFit", "said_of_outside", "signed_deviation"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class SurfaceFit(DeviationFigures):
    """A surface fitted to points.

    Attributes
    ----------
    surface : BSplineSurface
    deviation : (n,) mm, distance of each point, positive on the side of the surface's normal
    parameters : u (n,) and v (n,) of the closest points
    outside : (n,) bool, points beyond the surface's rim, which the fit left out
    supported : (ku, kv) bool, patches between the surface's knots that hold points enough; in the
        others the surface follows the base surface and its neighbours
    message : what a person should know
    """

    surface: BSplineSurface
    deviation: Array
    parameters: tuple[Array, Array] = field(repr=False)
    outside: NDArray[np.bool_]
    supported: NDArray[np.bool_]
    message: str = ""

    def is_supported(self, u: ArrayLike, v: ArrayLike) -> NDArray[np.bool_]:
        """Whether the cloud supports the surface at parameters u and v, broadcast together."""
        u, v = np.broadcast_arrays(*self.surface.inside(u, v))
        number = self.surface.patches.patch_of(u.ravel(), v.ravel())
        return np.asarray(self.supported.ravel()[number].reshape(u.shape))


def signed_deviation(
    surface: BSplineSurface, points: Array, u: Array, v: Array, distance: Array
) -> Array:
    """Distances with the sign of the side of the normal on which each point lies."""
    away = points - surface.evaluate(u, v)
    side = np.einsum("mi,mi->m", away, surface.normal(u, v))
    return np.where(side < 0.0, -distance, distance)


def said_of_outside(outside: NDArray[np.bool_]) -> str:
    """How many points were left out, for a person."""
    count = int(outside.sum())
    if not count:
        return ""
    return f"{count} of {len(outside)} points lie beyond the rim of the surface and were left out."
