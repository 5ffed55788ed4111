# SPDX-License-Identifier: LGPL-2.1-or-later
"""How probed walks end, and how they do not, on extruded parts that change along the edge.

Every contact is exact, so that the walk and nothing else is tested (Schreve 4.4.4, 4.7.3, 4.8).
"""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from freecad_edgescan.scanning import Gate, ScanParameters, Start, Stop, scan_edge
from freecad_edgescan.scanning.safeguards import Safeguards

AMPLITUDE, PITCH = 8.0, 0.5
DEGREES = pytest.mark.parametrize("degree", [1, 2, 3])
both_ways = pytest.mark.parametrize("literal", [False, True], ids=["default", "as printed"])


def scan(machine, fall=0.0, to=12.0, literal=False, **values):
    """Along y from 0 to the gate, beginning on the left side, which falls off at an angle."""
    across = np.array([np.cos(fall), 0.0, np.sin(fall)])
    begin = -0.5 * AMPLITUDE * across
    given = {
        "amplitude": AMPLITUDE,
        "line_pitch": 0.8,
        "edge_pitch": PITCH,
        "tolerance": 0.02,
        "degree": 1,
        "pattern": "square",
        "prehit_distance": 1.0,
        "search_distance": 10.0,
        **values,
    }
    parameters = ScanParameters.literal(**given) if literal else ScanParameters(**given)
    return scan_edge(
        machine,
        at=Start(begin, across, [0.0, 1.0, 0.0]),
        gate=Gate(begin + np.array([0.0, to, 0.0]), across),
        parameters=parameters,
    )


def off_the_edge(edge):
    """Distances from the y axis."""
    return np.hypot(edge.points[:, 0], edge.points[:, 2])


FALL = np.radians(35.0)


def roof(degrees, top=0.0, reach=40.0):
    fall = np.radians(0.5 * (180.0 - degrees))
    foot = np.array([reach * np.cos(fall), top - reach * np.sin(fall)])
    return [foot * [-1.0, 1.0], [0.0, top], foot]


def broken(extruded, low, high=np.inf):
    """A roof of 110° whose ridge is broken off between two places: 5° of turn are left there."""
    sharp, blunt = roof(110.0), roof(175.0, -2.4)
    return extruded((-np.inf, low, sharp), (low, high, blunt), (high, np.inf, sharp))


# ---------------------------------------------------------------- no edge, and too few points


@both_ways
@DEGREES
@pytest.mark.parametrize("end", [4.8, 5.2])
def test_a_walk_ends_where_the_sides_become_one_surface(extruded, end, degree, literal):
    """No edge, in mid-walk (Schreve figure 22); what was found until then is kept."""
    edge = scan(broken(extruded, end), FALL, degree=degree, literal=literal)
    assert edge.stops == (Stop.START, Stop.NO_EDGE)
    assert end - PITCH < edge.points[-1, 1] < end
    assert len(edge) == round(edge.points[-1, 1] / PITCH) + 1
    assert off_the_edge(edge).max() < 1e-6
    assert "found no edge on a scan line" in edge.message
    assert "gate was not passed" in edge.message


def test_a_short_broken_piece_is_passed_over(extruded):
    edge = scan(broken(extruded, 4.8, 5.8), FALL)
    assert edge.stops[1] is Stop.GATE
    steps = np.diff(edge.points[:, 1])
    assert steps.max() == pytest.approx(3.0 * PITCH, abs=1e-6)
    assert np.sort(steps)[-2] == pytest.approx(PITCH, abs=1e-6)
    assert off_the_edge(edge).max() < 1e-6


def test_a_short_broken_piece_ends_the_printed_walk(extruded):
    edge = scan(broken(extruded, 4.8, 5.8), FALL, literal=True)
    assert edge.stops[1] is Stop.NO_EDGE
    assert edge.points[-1, 1] == pytest.approx(4.5, abs=1e-6)


@both_ways
@DEGREES
def test_a_walk_ends_where_a_line_has_too_few_points_on_a_side(extruded, degree, literal):
    """The edge jumps to where the next line starts: one contact lies before it (Schreve 4.7.3)."""
    level, moved = extruded.wedge(110.0), extruded.wedge(110.0, shift=-3.9)
    part = extruded((-np.inf, 4.8, level), (4.8, np.inf, moved))
    edge = scan(part, degree=degree, literal=literal)
    assert edge.stops == (Stop.START, Stop.TOO_FEW_POINTS)
    assert edge.points[-1, 1] == pytest.approx(4.5, abs=1e-6)
    assert off_the_edge(edge).max() < 1e-6
    assert "too few points" in edge.message
    assert "lower the line pitch" in edge.message


# ---------------------------------------------------------------- zigzags that drift


def drifting(extruded, drift):
    """A machine whose contacts lie ahead of the search line on one side, behind it on the other.

    The part is extruded along y, so that they lie on it all the same.
    """

    class Drifting(extruded):
        def touch(self, *where):
            contact = super().touch(*where)
            if contact is not None:
                contact[1] += drift * np.sign(contact[0])
            return contact

    return Drifting(extruded.wedge(110.0))


DRIFTS = pytest.mark.parametrize("drift", [-0.5, -0.3, 0.1, 0.3, 0.5])
ZIGZAG = {"pattern": "zigzag", "edge_pitch": 1.0, "to": 14.0}


def advances(edge):
    """How far each line gets along the edge from its first contact to its last."""
    lines = edge.scan_lines.lines
    return np.array([line.contacts[-1, 1] - line.contacts[0, 1] for line in lines])


@DRIFTS
@pytest.mark.parametrize("degree", [1, 2])
def test_lines_of_a_drifting_zigzag_keep_spanning_the_edge(extruded, drift, degree):
    """Each is off by what its own two ends drift, and it does not add up (Schreve figure 14)."""
    edge = scan(drifting(extruded, drift), degree=degree, **ZIGZAG)
    assert edge.stops[1] is Stop.GATE
    assert off_the_edge(edge).max() < 1e-6
    assert np.abs(advances(edge)[1:] - 1.0).max() < 2.0 * abs(drift) + 0.15
    for line in edge.scan_lines.lines:
        begin, end = line.contacts[0], line.contacts[-1]
        assert begin[0] * end[0] < 0.0
        for contact in (begin, end):
            away = np.hypot(contact[0], contact[2])
            assert 0.5 * AMPLITUDE - 0.8 < away < 0.5 * AMPLITUDE + 1.6


@DRIFTS
def test_turning_points_lie_half_an_edge_pitch_ahead_but_for_their_own_drift(extruded, drift):
    edge = scan(drifting(extruded, drift), **ZIGZAG)
    lines = edge.scan_lines.lines
    early = 0.5 * 0.8 / AMPLITUDE  # edge pitches, for half a line pitch that a line may be short of
    for before, after in pairwise(lines[2:]):
        middle = 0.5 * (before.edge_point[1] + after.edge_point[1])
        assert before.contacts[-1, 1] == pytest.approx(middle, abs=abs(drift) + 0.15 + early)
        assert after.contacts[0, 1] == pytest.approx(middle, abs=abs(drift) + 0.25)


@pytest.mark.parametrize("drift", [-0.5, -0.3, 0.3, 0.5])
def test_without_restoring_it_the_zigzag_degenerates(extruded, drift):
    """Its lines swing farther than their own ends drift: to and fro by turns."""
    safeguards = replace(Safeguards(), restore=False)
    edge = scan(drifting(extruded, drift), safeguards=safeguards, **ZIGZAG)
    restored = scan(drifting(extruded, drift), **ZIGZAG)
    swing, repaired = (np.ptp(advances(each)[1:]) for each in (edge, restored))
    assert swing > 4.0 * abs(drift) + 0.5
    # A line of a sharp edge may end half a line pitch early, too, where less is gained.
    assert repaired < 4.0 * abs(drift) + 0.1 + 2.0 * 0.5 * 0.8 / AMPLITUDE


@pytest.mark.parametrize("drift", [-0.5, 0.5])
def test_the_printed_zigzag_ends_when_it_degenerates(extruded, drift):
    """Quickly, where the drift is as large as the edge pitch."""
    part, short = drifting(extruded, drift), {**ZIGZAG, "edge_pitch": 0.5}
    assert scan(part, literal=True, **short).stops[1] is Stop.TOO_FEW_POINTS
    assert scan(part, **short).stops[1] is Stop.GATE


@both_ways
def test_a_zigzag_that_does_not_drift_stays_as_it_is(extruded, literal):
    edge = scan(drifting(extruded, 0.0), literal=literal, **ZIGZAG)
    assert edge.stops[1] is Stop.GATE
    assert off_the_edge(edge).max() < 1e-6
    assert np.abs(advances(edge)[1:]).max() < 2.0
