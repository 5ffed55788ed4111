# SPDX-License-Identifier: LGPL-2.1-or-later
"""Between our B-spline curves and FreeCAD's: the same poles, weights and knots."""

from __future__ import annotations

from typing import Any

import FreeCAD
import numpy as np
import Part
from numpy.typing import ArrayLike

from ..geometry import BSplineCurve

__all__ = ["curve_of", "curve_shape", "native_curve", "vector"]


def native_curve(curve: BSplineCurve) -> Any:
    """The Part.BSplineCurve with the same poles, weights and knots."""
    knots, multiplicities = curve.distinct_knots_and_multiplicities()
    native = Part.BSplineCurve()
    weights = np.ones(len(curve.poles)) if curve.weights is None else curve.weights
    native.buildFromPolesMultsKnots(
        [vector(pole) for pole in curve.poles],
        [int(count) for count in multiplicities],
        [float(knot) for knot in knots],
        bool(curve.periodic),
        int(curve.degree),
        [float(weight) for weight in weights],
    )
    return native


def curve_shape(curve: BSplineCurve) -> Any:
    """The native B-spline edge with the same poles, weights and knots."""
    return native_curve(curve).toShape()


def curve_of(shape: Any, what: str = "curve") -> BSplineCurve:
    """The exact B-spline of a shape's edges, clamped, in the direction in which they run.

    Parameters
    ----------
    shape : Part.Shape whose edges follow each other, such as an edge, a wire or a sketch; lines,
        arcs and other conics become the B-splines that they are
    what : what to call it in a sentence

    Returns
    -------
    BSplineCurve in mm, where the shape stands. Over a single edge the parameters are the edge's
    own; over several they are lengths along the chain, and the curve bends as sharply as it does.

    Raises
    ------
    ValueError: no edge, or edges that form more than one chain.
    """
    edges = [] if shape.isNull() else shape.Edges
    if not edges:
        raise ValueError(f"The {what} has no edge; recompute the document, or choose another one.")
    if len(edges) == 1:
        return _curve_of_edge(edges[0])
    chains = Part.sortEdges(edges)
    if len(chains) != 1:
        raise ValueError(
            f"The {len(edges)} edges of the {what} form {len(chains)} separate chains; choose "
            "edges that follow each other."
        )
    return _joined([_curve_of_edge(edge) for edge in chains[0]])


def vector(values: ArrayLike) -> Any:
    """The FreeCAD.Vector of three numbers."""
    return FreeCAD.Vector(*np.asarray(values, dtype=float).tolist())


def _curve_of_edge(edge: Any) -> BSplineCurve:
    (converted,) = edge.toNurbs().Edges
    native = converted.Curve
    first, last = converted.ParameterRange
    low, high = native.FirstParameter, native.LastParameter
    slack = 1e-9 * (high - low)
    if native.isPeriodic() or first > low + slack or last < high - slack:
        native = native.copy()
        native.segment(first, last)
    weights = np.array(native.getWeights())
    curve = BSplineCurve.from_distinct_knots(
        np.array([tuple(pole) for pole in native.getPoles()]),
        native.getKnots(),
        native.getMultiplicities(),
        int(native.Degree),
        weights=None if np.all(weights == weights[0]) else weights,
    )
    return curve.reversed() if converted.Orientation == "Reversed" else curve


def _joined(curves: list[BSplineCurve]) -> BSplineCurve:
    """Curves that follow each other as one, with a knot as high as the degree at each joint."""
    degree = max(curve.degree for curve in curves)
    rational = any(curve.weights is not None for curve in curves)
    poles: list[np.ndarray] = []
    weights: list[np.ndarray] = []
    knots = [np.zeros(1)]
    at, weight = 0.0, 1.0
    for curve in curves:
        until = at + curve.length()
        raised = curve.elevated(degree).over_range(at, until)
        own = np.ones(len(raised.poles)) if raised.weights is None else raised.weights
        own = own * (weight / own[0])
        begin = 1 if poles else 0
        poles.append(raised.poles[begin:])
        weights.append(own[begin:])
        knots.append(raised.knots[1:-1] if begin == 0 else raised.knots[degree + 1 : -1])
        at, weight = until, own[-1]
    return BSplineCurve(
        np.concatenate(poles),
        np.concatenate([*knots, [at]]),
        degree,
        weights=np.concatenate(weights) if rational else None,
    )
