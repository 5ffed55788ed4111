# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faces of a mitred sweep, sewn to a shell, and filled where it is closed."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np
import Part

from ..geometry import BSplineCurve, BSplineSurface
from ..surfacing.mitred_sweep import mitred_sweep
from .native_curve import curve_of, curve_shape
from .native_surface import surface_shape

__all__ = ["sewn_sweep", "smooth_curves"]

_KNOTS = 24  # along the rail, of one face
_SEWN = 1e-5  # mm, between faces whose rims have the same poles


def sewn_sweep(profile: Any, rail: Any, solid: bool) -> Any:
    """Sweep a profile along a rail, with a mitre in each of its corners.

    Parameters
    ----------
    profile, rail : Part.Wire
    solid : whether it is filled; the profile must be closed then

    Returns
    -------
    Part.Shell or Part.Solid.

    Raises
    ------
    ValueError: a corner too sharp, no room for the profile, or one that lies along the rail.
    """
    swept = mitred_sweep(smooth_curves(profile), smooth_curves(rail), bool(rail.isClosed()))
    faces = [
        surface_shape(part) for row in swept.surfaces for whole in row for part in _parts(whole)
    ]
    if solid and not swept.closed:
        faces += [_cap(curves) for curves in (swept.first, swept.last)]
    sewn = Part.Compound(faces)
    sewn.sewShape(_SEWN)
    # Sewing makes no shell of a single face.
    shells = sewn.Shells if len(faces) > 1 else [Part.Shell(faces)]
    if len(shells) != 1 or len(shells[0].Faces) != len(faces) or not shells[0].isValid():
        raise ValueError(
            "The swept surface has no width somewhere or crosses itself. Let the profile stand "
            "across the rail, or sweep along a shorter piece."
        )
    if not solid:
        return shells[0]
    filled = Part.Solid(shells[0])
    return filled if filled.Volume > 0.0 else filled.reversed()


def smooth_curves(wire: Any) -> list[BSplineCurve]:
    """The exact curves of a Part.Wire's edges, in its direction, smooth each."""
    return [span for edge in wire.OrderedEdges for span in _spans(curve_of(edge))]


def _spans(curve: BSplineCurve) -> list[BSplineCurve]:
    """A curve in pieces without a knot as high as its degree, where it may have a corner.

    A circle has such knots too, and OpenCASCADE integrates over them as if they were not there: the
    volume of a tube in one piece comes out wrong by some per cent.
    """
    knots, multiplicities = curve.distinct_knots_and_multiplicities()
    cuts = knots[(multiplicities >= curve.degree) | np.isin(knots, curve.parameter_range)]
    return [curve.restricted(float(low), float(high)) for low, high in pairwise(cuts)]


def _parts(surface: BSplineSurface) -> list[BSplineSurface]:
    """A surface in pieces of so few knots along the rail that OpenCASCADE's integrals are right.

    Those over a hundred knots give volumes that are wrong by some per cent.
    """
    knots = np.unique(surface.knots[1])
    parts, rest = [], surface
    for at in knots[_KNOTS : -_KNOTS // 2 : _KNOTS].tolist():
        part, rest = rest.split(1, at)
        parts.append(part)
    return [*parts, rest]


def _cap(curves: Sequence[BSplineCurve]) -> Any:
    try:
        return Part.Face(Part.Wire([curve_shape(curve) for curve in curves]))
    except Part.OCCError:
        raise ValueError(
            "Only a profile in a plane gives a solid; flatten it, or set Solid to false."
        ) from None
