# SPDX-License-Identifier: LGPL-2.1-or-later
"""How exact a probed edge can be: exact contacts on arcs, beside circles and the error model.

Every contact lies on the torus object to within rounding errors, so that what an edge point is
off comes from the method alone: from curves that are no arcs, from planes that lean, from chords.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.optimize import fsolve

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


# ---------------------------------------------------------------- the chord of a bend


@pytest.mark.parametrize(
    ("torus", "edge_pitch"), [(BARE, 1.0), (BARE, 2.0), *PROBED_BENDS], ids=named
)
def test_the_printed_compensation_lies_a_sagitta_inside_of_a_bend(torus, edge_pitch):
    """Schreve 4.5.4.4: the rulings between lines j - 1 and j + 1 are chords, 2ρe long.

    Both lines have to be of one kind for that, and must not change when the edge is known as sharp.
    """
    edge = scanned(
        torus, edge_pitch=edge_pitch, compensation="intersection_printed", safeguards=ALIKE
    )
    assert set(edge.compensation[1:-1]) <= {"intersection_printed", "none"}
    outside, up = off_the_circle(torus, edge.points[1:-1]).T
    sagitta = sagitta_of(torus, edge_pitch)
    if torus is BARE:
        assert sagitta == pytest.approx({1.0: 0.0125, 2.0: 0.05}[edge_pitch], rel=1e-3)
    assert -outside == pytest.approx(sagitta, rel=0.1)
    assert -outside.mean() == pytest.approx(sagitta, rel=0.03)
    assert np.abs(up).max() < 0.05 * sagitta


@pytest.mark.parametrize(
    ("torus", "edge_pitch"), [(BARE, 1.0), (BARE, 2.0), *PROBED_BENDS], ids=named
)
def test_the_default_loses_less_than_a_hundredth_of_it(torus, edge_pitch):
    """Half a dozen lines on each side tell the edge's course; near its ends it is known less."""
    sagitta = sagitta_of(torus, edge_pitch)
    error = errors(torus, edge_pitch=edge_pitch, lines=14.0, compensation="intersection")
    assert error.mean() < 0.01 * sagitta + bias(torus)
    assert error.max() < 0.04 * sagitta + bias(torus)


@pytest.mark.parametrize("torus", [PROBED, ROUNDED, BLUNT], ids=named)
def test_a_printed_edge_point_lies_on_the_chord_between_its_neighbours(torus):
    """However far they are apart, whatever the rounding."""
    edge = scanned(torus, edge_pitch=2.0, compensation="intersection_printed")
    half = 0.5 * (azimuths(edge.points)[2:] - azimuths(edge.points)[:-2])
    chord = torus.edge_radius * (1.0 - np.cos(half))
    outside = off_the_circle(torus, edge.points[1:-1])[:, 0]
    assert -outside == pytest.approx(chord, abs=0.03 * chord.mean() + bias(torus))


# ---------------------------------------------------------------- one compensation beside another


@pytest.mark.parametrize(
    ("torus", "edge_pitch", "pattern"),
    [
        (PROBED, 1.0, "square"),
        (PROBED, 2.0, "square"),
        (ROUNDED, 1.0, "square"),
        (BLUNT, 2.0, "square"),
        (PROBED, 1.0, "zigzag"),
        (ROUNDED, 1.0, "zigzag"),
        (BLUNT, 2.0, "zigzag"),
    ],
    ids=named,
)
def test_the_default_is_no_worse_than_each_line_alone(torus, edge_pitch, pattern):
    """Points of a zigzag lie up to ρe/2 before and behind its plane; the bend is part of ε."""
    values = {"edge_pitch": edge_pitch, "pattern": pattern, "tolerance": 0.01}
    mine = errors(torus, **values)
    alone = errors(torus, **values, compensation="curve")
    assert mine.mean() <= 1.2 * alone.mean()
    assert mine.max() <= 1.2 * alone.max()


@pytest.mark.parametrize("edge_pitch", [1.0, 2.0])
def test_without_a_probe_the_default_is_as_good_as_each_line_alone(edge_pitch):
    """Nothing has to be taken off: a line alone has the error of its curves and nothing else.

    The mean with its neighbours adds what the course of the edge is known badly by, which is a
    small part of the sagitta.
    """
    mine = errors(BARE, edge_pitch=edge_pitch, lines=14.0)
    alone = errors(BARE, edge_pitch=edge_pitch, lines=14.0, compensation="curve")
    assert mine.mean() <= 1.2 * alone.mean() + 0.01 * sagitta_of(BARE, edge_pitch)


def test_without_a_probe_point_and_curve_have_nothing_to_take_off():
    point, curve = (scanned(BARE, compensation=way) for way in ("point", "curve"))
    assert point.points == pytest.approx(curve.points, abs=1e-9)
    assert set(point.compensation) == {"none"}


@pytest.mark.parametrize(("torus", "edge_pitch"), PROBED_BENDS, ids=named)
@pytest.mark.parametrize("way", WAYS)
def test_every_compensation_keeps_to_its_own_error(way, torus, edge_pitch):
    """The sharp edge is where the circles of the sides, moved by R_p, meet: at (x, -R)."""
    # Each line stands across the edge as it ran before: its tangent was read between two lines
    # (half a step behind), is the mean of this and the last one (one step more), and is used one
    # step ahead. So its plane leans by 2.5 ρe κe against the edge.
    lean = 2.5 * edge_pitch / torus.edge_radius
    # In a leaning plane the surfaces lie R_p / cos δ from the curve of the centres, not R_p: both
    # sides are moved R_p δ²/2 too little, and the edge 1 / sin(θ/2) times that.
    too_little = 0.5 * torus.probe_radius * lean**2 / np.sin(0.5 * torus.angle)
    own = {
        # A normal leaves the leaning plane by R_p sin δ at most. The point at its end, moved back
        # square to the plane instead of along the edge, has gone δ times that aside.
        "point": 2.0 * too_little,
        "curve": too_little,
        # Lines scanned along a tangent that lags lie up to 1 / cos δ farther apart.
        "intersection_printed": sagitta_of(torus, edge_pitch) / np.cos(lean) ** 2,
        # It stands across the edge itself, whose course is known to a small part of the sagitta.
        "intersection": 0.01 * sagitta_of(torus, edge_pitch),
    }[way]
    # What is within the tolerance may lie on the rounding. All lines together see that it does;
    # a line alone does not, and the last of its points, drawn out, counts by about a half.
    let_in = 0.0 if way == "intersection" else 0.5 * tolerance_for(torus)
    lines = 14.0 if way == "intersection" else 10.0
    error = errors(torus, edge_pitch=edge_pitch, lines=lines, compensation=way)
    assert error.mean() < own + bias(torus) + let_in


# ---------------------------------------------------------------- the model of the error


def sections(torus: TorusObject, edge: ScannedEdge) -> list[list[np.ndarray]]:
    """Angles of the kept contacts of both sides of each line, from far away to the edge, rad.

    Each about the centre of the circle it lies on; that it lies there is part of the test.
    """
    circles = torus.faces(1.0)[:2]
    found = []
    for line in edge.scan_lines.lines:
        sides = []
        for section in line.sections:
            contacts = line.contacts[section.contacts[section.kept]]
            rho, z = np.hypot(*contacts[:, :2].T), contacts[:, 2]
            gaps, angles = [], []
            for face in circles:
                along, up = rho - face.major_radius, z - face.centre_height
                gaps.append(np.abs(np.hypot(along, up) - face.section_radius).max())
                angles.append(np.unwrap(np.arctan2(up, along)))
            assert min(gaps) < 1e-3 * circles[0].section_radius
            sides.append((int(np.argmin(gaps)), angles[int(np.argmin(gaps))]))
        found.append([angle for _, angle in sorted(sides, key=lambda side: side[0])])
    return found


def edge_of_arcs(torus: TorusObject, angles: list[np.ndarray], degree: int) -> np.ndarray:
    """Where curves through points of the two circles meet, moved by R_p; from the edge, (2,) mm."""
    curves = []
    for face, angle in zip(torus.faces(1.0)[:2], angles, strict=True):
        out = np.column_stack([np.cos(angle), np.sin(angle)])
        centre = np.array([face.major_radius, face.centre_height])
        points = centre + face.section_radius * out
        if degree == 1:  # the line of least squares across itself
            middle = points.mean(axis=0)
            way = np.linalg.svd(points - middle)[2][0]
            way = way if way @ (points[-1] - points[0]) > 0.0 else -way
            parts = np.array([way, middle])
            begin = float((points[-1] - middle) @ way)
        else:  # by the share of the chord length
            u = np.append(0.0, np.cumsum(steps(points)))
            parts = np.linalg.lstsq(np.vander(u / u[-1], degree + 1), points, rcond=None)[0]
            begin = 1.0
        curves.append((parts, centre, begin))

    def moved(number: int, u: float) -> np.ndarray:
        parts, centre, _ = curves[number]
        way = np.array([np.polyval(np.polyder(parts[:, k]), u) for k in range(2)])
        point = np.array([np.polyval(parts[:, k], u) for k in range(2)])
        normal = np.array([-way[1], way[0]]) / np.hypot(*way)
        # From the air, where the circle's centre is, into the material.
        normal = normal if normal @ (point - centre) > 0.0 else -normal
        return point + torus.probe_radius * normal

    def gap(u: np.ndarray) -> np.ndarray:
        return moved(0, u[0]) - moved(1, u[1])

    met, _, state, _ = fsolve(gap, [curves[0][2], curves[1][2]], full_output=True)
    assert state == 1
    return moved(0, met[0]) - [torus.edge_radius, -torus.section_radius]


MODELLED = TorusObject(20.0, 100.0, ANGLE)


@pytest.mark.parametrize("share", [0.2, 0.5, 0.8])
@pytest.mark.parametrize(
    ("degree", "fillet", "probe"), [(1, 0.0, 0.0), (2, 0.0, 0.0), (2, 0.0, 0.5), (2, 0.5, 0.5)]
)
def test_edge_points_are_off_as_curves_through_the_same_points_of_arcs_are(
    degree, fillet, probe, share
):
    """A dozen points cover not quite s of the arc; how much, the points themselves tell.

    Where lines get closer to the edge and their error halves, the edge has a step that is taken
    for a bend; that is left out here.
    """
    torus = TorusObject(20.0, 100.0, ANGLE, fillet, probe)
    side = share * (20.0 - probe)
    # Straight lines through few points of such long arcs jump too far to be followed.
    points = 40 if (degree, share) == (1, 0.8) else 12
    whole = 20.0  # mm: nothing is cleaned away from a sharp edge
    edge = scanned(
        torus,
        side=side,
        points=points,
        edge_pitch=0.1,
        degree=degree,
        tolerance=whole if degree == 1 else None,
        safeguards=ALIKE,
    )
    assert edge.stops[1] is Stop.GATE
    each = np.array([edge_of_arcs(torus, angles, degree) for angles in sections(torus, edge)])
    expected = (each[:-2] + each[1:-1] + each[2:]) / 3.0  # the default takes three lines
    found = off_the_circle(torus, edge.points[1:-1])
    size = np.hypot(*expected.T)
    # Over a millimetre a bend is hardly told from scatter, and taken to be smaller than it is; that
    # moves the edge by some 30 nm.
    unknown = 3.5e-5
    assert np.hypot(*found.T) == pytest.approx(size, rel=0.1, abs=unknown)
    assert np.hypot(*(found - expected).T).max() < max(0.1 * size.max(), unknown)


@pytest.mark.parametrize("degree", [1, 2])
def test_no_line_over_a_rounding_is_taken_for_one_over_a_sharp_edge(degree):
    torus = TorusObject(20.0, 100.0, ANGLE, 0.5, 0.5)
    edge = scanned(torus, lines=20.0, side=6.0, points=8, degree=degree, tolerance=20.0)
    assert not any(line.sharpness.known for line in edge.scan_lines.lines)


# ---------------------------------------------------------------- steps in a bend


def chord_heights(points: np.ndarray) -> np.ndarray:
    """Distance of each inner point from the line through its neighbours (Schreve 4.4.4.1), mm."""
    chord = points[2:] - points[:-2]
    twice = np.linalg.norm(np.cross(points[1:-1] - points[:-2], chord), axis=1)
    return twice / np.linalg.norm(chord, axis=1)


@pytest.mark.parametrize("steering", ["tangent", "curvature"])
@pytest.mark.parametrize("height", [0.01, 0.05])
def test_the_chord_between_two_edge_points_has_the_height_asked_for(height, steering):
    """Steps √(8xh) = 2.8 and 6.3 mm hold it exactly; both lie between the limits of the pitch."""
    torus = TorusObject(50.0, 100.0, ANGLE)
    turn = 22.0 * np.sqrt(8.0 * height / torus.edge_radius)
    edge = scanned(
        torus, turn=turn, edge_pitch=4.0, side=5.0, chord_height=height, steering=steering
    )
    assert edge.stops[1] is Stop.GATE
    over_two_steps = chord_heights(edge.points)[9:-1]  # the pitch has settled
    assert len(over_two_steps) >= 8
    assert over_two_steps / 4.0 == pytest.approx(height, rel=0.06)


def test_the_edge_pitch_grows_to_three_times_its_start_and_no_further():
    """A height of 0.5 mm would be held by steps of 20 mm."""
    torus = TorusObject(50.0, 100.0, ANGLE)
    edge = scanned(torus, turn=0.9, edge_pitch=2.0, side=5.0, chord_height=0.5)
    assert edge.stops[1] is Stop.GATE
    assert steps(edge.points)[3:] == pytest.approx(6.0, rel=0.02)
    assert chord_heights(edge.points)[4:] == pytest.approx(6.0**2 / 200.0, rel=0.05)


@pytest.mark.parametrize("pattern", ["square", "zigzag"])
@pytest.mark.parametrize("radius", [15.0, 40.0])
def test_steering_by_curvature_follows_a_bend_to_its_gate(radius, pattern):
    """Each line is laid on the circle of the last points: steps are chords of the edge pitch."""
    torus = TorusObject(50.0, radius, ANGLE)
    turn = min(np.pi - 0.2, 40.0 / radius)
    edge = scanned(
        torus,
        turn=turn,
        edge_pitch=2.0,
        side=4.0,
        tolerance=0.02,
        steering="curvature",
        pattern=pattern,
    )
    assert edge.stops[1] is Stop.GATE
    sagitta = 2.0**2 / (2.0 * radius)
    assert np.hypot(*off_the_circle(torus, edge.points).T).max() < 0.05 * sagitta
    chord = 2.0 * radius * np.sin(1.0 / radius)
    allowed = 0.01 if pattern == "square" else 0.04
    assert steps(edge.points)[4:] == pytest.approx(chord, rel=allowed)
    assert azimuths(edge.points)[-1] >= BEGIN + turn


def test_steering_by_curvature_reaches_a_gate_in_steps_of_a_fifth_of_the_radius():
    """A tangent, which lags behind, would lead half a step and more aside there."""
    torus = TorusObject(20.0, 10.0, ANGLE)
    edge = scanned(
        torus, turn=np.pi - 0.2, edge_pitch=2.0, side=4.0, tolerance=0.03, steering="curvature"
    )
    assert edge.stops[1] is Stop.GATE
    assert np.hypot(*off_the_circle(torus, edge.points).T).max() < 0.05 * 2.0**2 / 20.0
