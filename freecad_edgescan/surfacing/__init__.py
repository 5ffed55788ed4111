# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces from clouds: fitted, extended, intersected and swept."""

from .base_surface import BaseSurface, base_surface
from .coons import coons_surface
from .cross_section import CrossSection, cross_section
from .deviation import Deviation, deviation
from .extension import Side, extend_surface
from .fit_result import SurfaceFit
from .intersection import SurfaceIntersection, intersect_surfaces
from .primitive_shapes import ShapeKind
from .section_profile import ProfileKind
from .segmentation import segment_cloud
from .surface_fit import fit_surface
from .sweep_kind import SweepKind, sweep_kinds
from .swept_fit import SweptFit, compare_sweep_models, fit_swept_surface
from .swept_surface import Pairing, SweepModel, SweptSurface

__all__ = [
    "BaseSurface",
    "CrossSection",
    "Deviation",
    "Pairing",
    "ProfileKind",
    "ShapeKind",
    "Side",
    "SurfaceFit",
    "SurfaceIntersection",
    "SweepKind",
    "SweepModel",
    "SweptFit",
    "SweptSurface",
    "base_surface",
    "compare_sweep_models",
    "coons_surface",
    "cross_section",
    "deviation",
    "extend_surface",
    "fit_surface",
    "fit_swept_surface",
    "intersect_surfaces",
    "segment_cloud",
    "sweep_kinds",
]
