# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces from clouds: fitted, extended, intersected and swept."""

from .fit_result import SurfaceFit
from .surface_fit import fit_surface

__all__ = ["SurfaceFit", "fit_surface"]
