# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of torus objects scanned by exact contacts, and what they are off."""

from __future__ import annotations

from functools import cache

import numpy as np

from freecad_edgescan.cloud import TorusObject
from freecad_edgescan.scanning import (
    AnalyticCmm,
    Gate,
    ScannedEdge,
    ScanParameters,
    Start,
    Stop,
    scan_edge,
)
from freecad_edgescan.scanning.error_model import largest_deviation, model_error
from freecad_edgescan.scanning.safeguards import Safeguards

ANGLE = np.radians(110.0)
BEGIN = 0.1  # rad, where a scan starts
SIDE = 6.0  # mm, length s of a line section where nothing else is said

# Edges that bend: without a probe, with one, and with a rounding and one.
BARE = TorusObject(50.0, 40.0, ANGLE)
PROBED = TorusObject(50.0, 40.0, ANGLE, 0.0, 1.0)
ROUNDED = TorusObject(20.0, 30.0, ANGLE, 1.0, 1.0)
BLUNT = TorusObject(50.0, 40.0, np.radians(140.0), 0.5, 0.5)
SHARP = TorusObject(50.0, 40.0, np.radians(90.0), 0.0, 1.0)

PROBED_BENDS = [(PROBED, 1.0), (PROBED, 2.0), (SHARP, 2.0)]  # and edge pitch, mm
WAYS = ["point", "curve", "intersection", "intersection_printed"]
ALIKE = Safeguards(sharp_edge=False)  # all lines of an edge are scanned in the same way
POINTS = 10  # of a line section where nothing else is said


def tolerance_for(torus: TorusObject, side: float = SIDE) -> float:
    """It lets in what a quadratic is off from the arc, and little of a rounding, mm."""
    radius = torus.section_radius - torus.probe_radius
    return 1.2 * radius * float(largest_deviation(2, side / radius))


def named(value: object) -> str | None:
    """In the names of the tests."""
    if not isinstance(value, TorusObject):
        return None
    return f"R{value.section_radius:g}_Rf{value.fillet_radius:g}_Rp{value.probe_radius:g}"


@cache
def scanned(
    torus: TorusObject,
    lines: float = 10.0,
    side: float = SIDE,
    points: int = POINTS,
    edge_pitch: float = 1.0,
    tolerance: float | None = None,
    turn: float | None = None,
    **values: object,
) -> ScannedEdge:
    """A square scan with quadratics over some lines (or a turn, rad) by exact contacts."""
    amplitude = 2.0 * side + torus.rounding_length
    turn = lines * edge_pitch / torus.edge_radius if turn is None else turn
    return scan_edge(
        AnalyticCmm(torus),
        at=Start(*torus.start(amplitude, azimuth=BEGIN)),
        gate=Gate(*torus.gate(amplitude, azimuth=BEGIN + turn)),
        parameters=ScanParameters(
            amplitude=amplitude,
            line_pitch=side / points,
            edge_pitch=edge_pitch,
            tolerance=tolerance or tolerance_for(torus, side),
            **{"pattern": "square", "degree": 2, **values},
        ),
        method="probe",
    )


def off_the_circle(torus: TorusObject, points: np.ndarray) -> np.ndarray:
    """Towards the outside and upwards from the edge's circle, (m, 2) mm."""
    x, y, z = points.T
    return np.column_stack([np.hypot(x, y) - torus.edge_radius, z + torus.section_radius])


def azimuths(points: np.ndarray) -> np.ndarray:
    return np.arctan2(points[:, 1], points[:, 0])


def steps(points: np.ndarray) -> np.ndarray:
    return np.linalg.norm(np.diff(points, axis=0), axis=1)


def errors(torus: TorusObject, **values: object) -> np.ndarray:
    """Distances of the inner edge points from the true edge, mm.

    The first and the last one have one neighbour only, and are always compensated as curves.
    """
    edge = scanned(torus, **values)
    assert edge.stops == (Stop.START, Stop.GATE)
    return np.hypot(*off_the_circle(torus, edge.points[1:-1]).T)


def bias(torus: TorusObject, side: float = SIDE) -> float:
    """What quadratics of arcs are off, mm."""
    shape = torus.section_radius, torus.angle, torus.fillet_radius, torus.probe_radius
    return float(model_error(2, side, *shape))


def sagitta_of(torus: TorusObject, edge_pitch: float) -> float:
    """Of the chord from the line before to the line after, mm; κe ρe² / 2 without a probe.

    The edge pitch is that of the walk, along the circle where the probe's centres would meet:
    r = R - R_p from the centres of both sides.
    """
    centres = np.array([[f.major_radius, f.centre_height] for f in torus.faces(1.0)[:2]])
    across = 0.5 * (centres[1] - centres[0])
    upright = np.array([across[1], -across[0]]) / np.hypot(*across)
    radius = torus.section_radius - torus.probe_radius
    height = np.sqrt(radius**2 - across @ across)
    meetings = centres.mean(axis=0) + np.outer([height, -height], upright)
    gaps = np.hypot(*(meetings - [torus.edge_radius, -torus.section_radius]).T)
    walked_radius = meetings[gaps.argmin(), 0]
    return float(torus.edge_radius * (1.0 - np.cos(edge_pitch / walked_radius)))
