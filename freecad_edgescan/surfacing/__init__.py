# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces from clouds: fitted, extended, intersected and swept."""

from .extension import Side, extend_surface
from .fit_result import SurfaceFit
from .intersection import SurfaceIntersection, intersect_surfaces
from .surface_fit import fit_surface

__all__ = [
    "Side",
    "SurfaceFit",
    "SurfaceIntersection",
    "extend_surface",
    "fit_surface",
    "intersect_surfaces",
]
