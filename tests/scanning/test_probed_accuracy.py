# SPDX-License-Identifier: LGPL-2.1-or-later
"""How exact a probed edge can be: exact contacts on arcs, beside circles and the error model.

Every contact lies on the torus object to within rounding errors, so that what an edge point is
off comes from the method alone: from curves that are no arcs, from planes that lean, from chords.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import fsolve

from freecad_edgescan.cloud import TorusObject
from freecad_edgescan.scanning import ScannedEdge, Stop

from .exact_torus import (
    ALIKE,
    ANGLE,
    BARE,
    BLUNT,
    PROBED,
    PROBED_BENDS,
    ROUNDED,
    WAYS,
    azimuths,
    bias,
    errors,
    named,
    off_the_circle,
    sagitta_of,
    scanned,
    steps,
    tolerance_for,
)

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
