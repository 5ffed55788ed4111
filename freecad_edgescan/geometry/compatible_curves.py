# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves brought to one degree and one knot vector, as skinning and sweeping need them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from freecad_edgescan.geometry.bspline_curve import BSplineCurve
from freecad_edgescan.geometry.knot_vectors import merged_knots

__all__ = ["compatible_curves"]


def compatible_curves(
    curves: Sequence[BSplineCurve], limits: tuple[float, float] = (0.0, 1.0)
) -> tuple[BSplineCurve, ...]:
    """The same curves over one knot vector, exactly, so that their poles correspond.

    The highest degree among them and the union of their knots, after each one's parameters are
    scaled to `limits` (Piegl and Tiller, The NURBS Book, 1997, section 10.3). Periodic curves are
    opened at their seam; where one is rational all get weights.

    Raises
    ------
    ValueError: no curve.
    """
    if not curves:
        raise ValueError("There is no curve to make compatible; give one or more.")
    degree = max(curve.degree for curve in curves)
    raised = [curve.elevated(degree).over_range(*limits) for curve in curves]
    knots = merged_knots([curve.knots for curve in raised], degree)
    result = [curve.over_knots(knots) for curve in raised]
    if any(curve.weights is not None for curve in result):
        result = [
            BSplineCurve(
                curve.poles,
                curve.knots,
                degree,
                weights=np.ones(len(curve.poles)) if curve.weights is None else curve.weights,
            )
            for curve in result
        ]
    return tuple(result)
