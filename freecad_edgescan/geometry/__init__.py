# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pure mathematics: lines, planes, polynomial and B-spline curves."""

from freecad_edgescan.geometry.bspline_curve import BSplineCurve
from freecad_edgescan.geometry.circle import Circle, CircleFit, fit_circle
from freecad_edgescan.geometry.line import Line, LineFit, fit_line
from freecad_edgescan.geometry.polyline import distance_to_polyline

__all__ = [
    "BSplineCurve",
    "Circle",
    "CircleFit",
    "Line",
    "LineFit",
    "distance_to_polyline",
    "fit_circle",
    "fit_line",
]
