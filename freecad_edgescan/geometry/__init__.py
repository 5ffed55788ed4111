# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pure mathematics: lines, planes, polynomial curves, B-spline curves and surfaces."""

from freecad_edgescan.geometry.bspline_curve import BSplineCurve
from freecad_edgescan.geometry.bspline_surface import BSplineSurface
from freecad_edgescan.geometry.circle import Circle, CircleFit, fit_circle
from freecad_edgescan.geometry.compatible_curves import compatible_curves
from freecad_edgescan.geometry.curve_fit import fit_curve
from freecad_edgescan.geometry.line import Line, LineFit, fit_line
from freecad_edgescan.geometry.plane import Plane, fit_plane
from freecad_edgescan.geometry.polyline import distance_to_polyline
from freecad_edgescan.geometry.primitive_choice import common_plane, simplest_curve

__all__ = [
    "BSplineCurve",
    "BSplineSurface",
    "Circle",
    "CircleFit",
    "Line",
    "LineFit",
    "Plane",
    "common_plane",
    "compatible_curves",
    "distance_to_polyline",
    "fit_circle",
    "fit_curve",
    "fit_line",
    "fit_plane",
    "simplest_curve",
]
