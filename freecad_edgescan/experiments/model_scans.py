# SPDX-License-Identifier: LGPL-2.1-or-later
"""Square scans of an exact machine beside the analytical error (Schreve 5.2, appendix C).

Where the contacts happen to fall beside the edge moves the error of a scan; the model, which knows
no single contacts, is its average.
"""

from __future__ import annotations

from itertools import product

import numpy as np

from ..cloud import TorusObject
from ..scanning import AnalyticCmm, Gate, Progress, ScanParameters, Start, Stop, scan_edge
from ..scanning.error_model import model_error
from .collecting import collect
from .doe_curves import Curve, Curves
from .processes import Failure

__all__ = ["PLACES", "POINTS", "SHARES", "compare_with_model", "over_the_model"]

SHARES = (0.2, 0.35, 0.5, 0.65, 0.8)  # s/r
POINTS = (10, 20, 40)  # s/ρ_L
PLACES = tuple(np.arange(0.0, 1.0, 0.125))  # line pitches by which the contacts fall elsewhere
DEGREES = (1, 2)

_BEGIN = 0.1  # rad, where a scan starts
_EDGE_PITCH = 0.1  # mm
# In steps of a tenth of a millimetre a bend could not be told from scatter.
_OBJECT = TorusObject(20.0, 1000.0, np.radians(110.0))
_UNCLEANED = 20.0  # mm, a tolerance that lets every point pass: there is no rounding
# The edge has to show that it is sharp first, and three lines are averaged.
_LEFT_OUT = 8
_LINES = 30

Case = tuple[int, float, float]


def over_the_model(case: Case) -> float:
    """Average error of one scan over that of the model.

    Parameters
    ----------
    case : degree of the curves, s/r and s/ρ_L

    Raises
    ------
    ValueError: the scan has not passed its gate.
    """
    degree, share, points = case
    side = share * _OBJECT.section_radius
    turn = _LINES * _EDGE_PITCH / _OBJECT.edge_radius
    edge = scan_edge(
        AnalyticCmm(_OBJECT),
        at=Start(*_OBJECT.start(2.0 * side, azimuth=_BEGIN)),
        gate=Gate(*_OBJECT.gate(2.0 * side, azimuth=_BEGIN + turn)),
        parameters=ScanParameters(
            amplitude=2.0 * side,
            line_pitch=side / points,
            edge_pitch=_EDGE_PITCH,
            tolerance=_UNCLEANED,
            pattern="square",
            degree=degree,
        ),
        method="probe",
    )
    if edge.stops[1] is not Stop.GATE or len(edge) < 2 * _LEFT_OUT:
        raise ValueError(f"The scan with {points:g} points a side {edge.stops[1].value}.")
    x, y, z = edge.points[_LEFT_OUT:-1].T
    off = np.hypot(np.hypot(x, y) - _OBJECT.edge_radius, z + _OBJECT.section_radius)
    expected = model_error(degree, side, _OBJECT.section_radius, _OBJECT.angle)
    return float(off.mean() / expected)


def compare_with_model(
    seed: int = 0, jobs: int = 2, progress: Progress | None = None
) -> tuple[Curves, ...]:
    """Error of square scans over that of the model, for lines and for quadratics.

    Parameters
    ----------
    seed : takes no part, for there is no noise
    jobs : number of processes
    progress : told the share of scans done
    """
    shape = len(DEGREES), len(SHARES), len(POINTS), len(PLACES)
    cases = [
        (degree, share, points + place)
        for degree, share, points, place in product(DEGREES, SHARES, POINTS, PLACES)
    ]
    ratios = np.full(len(cases), np.nan)
    found = collect(over_the_model, cases, jobs, progress, lambda done: f"{len(done)} scans")
    for number, ratio in found.items():
        if not isinstance(ratio, Failure):
            ratios[number] = ratio
    return tuple(
        _figure(degree, of_degree)
        for degree, of_degree in zip(DEGREES, ratios.reshape(shape), strict=True)
        if np.isfinite(of_degree.mean(axis=2)).any()
    )


def _figure(degree: int, ratios: np.ndarray) -> Curves:
    """Of ratios (shares, points, places), nan where there is none."""
    means = ratios.mean(axis=2)
    curves = tuple(
        Curve.of(f"{points} points", SHARES, means[:, k], measured=True)
        for k, points in enumerate(POINTS)
    )
    notes = [
        f"Means over {len(PLACES)} places of the points beside the edge: {np.nanmin(means):.2f} to "
        f"{np.nanmax(means):.2f}; single scans: {np.nanmin(ratios):.2f} to {np.nanmax(ratios):.2f}."
    ]
    if missing := int(np.isnan(ratios).sum()):
        notes.append(f"{missing} of {ratios.size} scans are missing.")
    return Curves(
        f"Square scans of an exact machine, degree {degree}: error over that of the model",
        "length of a line section over its radius, s/r",
        "error over the analytical one, by points a side",
        curves,
        tuple(notes),
    )
