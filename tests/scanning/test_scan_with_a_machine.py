# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of a wedge of two planes, scanned by a machine whose every contact is known exactly."""

import numpy as np
import pytest

from freecad_edgescan.scanning import Stop

from .wedge_machine import WedgeMachine, off_the_edge, scan

ANGLES = [np.radians(a) for a in (60.0, 100.0, 150.0)]


@pytest.mark.parametrize("literal", [False, True])
@pytest.mark.parametrize("pattern", ["square", "zigzag"])
@pytest.mark.parametrize("degree", [1, 2, 3])
def test_an_edge_between_planes_is_found_exactly(pattern, degree, literal):
    edge = scan(WedgeMachine(), pattern=pattern, degree=degree, literal=literal)
    assert edge.stops == (Stop.START, Stop.GATE)
    assert off_the_edge(edge).max() < 1e-6
    if not (literal and pattern == "zigzag"):  # as printed, its planes lean
        assert np.diff(edge.points[:, 1]) == pytest.approx(1.0, abs=0.02)
    assert edge.points[-1, 1] == pytest.approx(30.5, abs=0.6)
    assert edge.method == "probe"
    assert np.degrees(edge.angle) == pytest.approx(100.0, abs=1e-3)
    assert edge.convex is True


@pytest.mark.parametrize("angle", ANGLES)
@pytest.mark.parametrize("compensation", ["point", "curve", "intersection", "intersection_printed"])
def test_every_compensation_takes_the_probe_radius_off(compensation, angle):
    """The probe's centre runs round the edge; the rounding is cleaned away, the planes are not."""
    edge = scan(
        WedgeMachine(angle, radius=0.5),
        compensation=compensation,
        amplitude=14.0,
        tolerance=1e-3,
        line_pitch=0.5,
    )
    assert edge.stops[1] is Stop.GATE
    assert off_the_edge(edge).max() < 0.02
    inner = compensation if compensation != "intersection" else "intersection"
    assert set(edge.compensation[1:-1]) == {inner}
    assert list(edge.compensation[[0, -1]]) == ["curve", "curve"]


@pytest.mark.parametrize("angle", ANGLES[1:])
def test_an_inner_edge_is_found_too(angle):
    """In a groove the ball touches both walls at once: its centre stays off the edge."""
    machine = WedgeMachine(2.0 * np.pi - angle, radius=0.5)
    edge = scan(machine, amplitude=10.0, line_pitch=0.5)
    assert edge.stops[1] is Stop.GATE
    assert off_the_edge(edge).max() < 0.02
    assert edge.convex is False


def test_the_machine_is_led_as_the_parameters_say():
    machine = WedgeMachine()
    edge = scan(machine, to=10.0)
    # Each search begins one prehit distance in the air above its plane.
    first = np.array(machine.touches[0])
    assert machine.normals[0] @ first[[0, 2]] == pytest.approx(1.0, abs=0.7)
    for k in range(len(edge)):
        line = edge.scan_lines.lines[k]
        steps = np.linalg.norm(np.diff(line.contacts, axis=0), axis=1)
        assert steps.max() < 1.5 * 0.8 + 1e-9  # gaps across the edge are refilled
        # A gap of more than 1.5 line pitches is halved, and its halves lie above three quarters.
        far_from_the_edge = np.append(steps[1:3], steps[-2:])
        assert np.all(far_from_the_edge > 0.75 * 0.8)
        assert np.all(far_from_the_edge < 1.01 * 0.8)
        short = 0.5 * 0.8 if line.narrow else 0.0
        assert 8.0 - short <= steps.sum() < 8.0 + 3 * 0.8


def test_a_zigzag_turns_half_an_edge_pitch_ahead():
    edge = scan(WedgeMachine(), pattern="zigzag", edge_pitch=2.0)
    for before, after in zip(edge.scan_lines.lines[3:-1], edge.scan_lines.lines[4:], strict=True):
        turn = before.contacts[-1]
        assert after.contacts[0] == pytest.approx(turn, abs=1.0)
        here, there = before.edge_point[1], after.edge_point[1]
        assert turn[1] == pytest.approx(0.5 * (here + there), abs=0.3)


def test_the_edge_pitch_follows_the_chord_height():
    """A straight edge has no chord height at all: the pitch grows to three times its start."""
    edge = scan(WedgeMachine(), to=60.0, chord_height=0.01)
    steps = np.diff(edge.points[:, 1])
    assert steps[0] == pytest.approx(1.0, abs=0.05)
    assert steps[-1] == pytest.approx(3.0, abs=0.1)


def test_curvature_steering_follows_a_straight_edge_as_well():
    edge = scan(WedgeMachine(), steering="curvature")
    assert edge.stops[1] is Stop.GATE
    assert off_the_edge(edge).max() < 1e-6


@pytest.mark.parametrize("tangent", ["interpolation", "planes", "polynomials"])
def test_every_tangent_is_that_of_the_edge(tangent):
    edge = scan(WedgeMachine(), tangent=tangent, edge_pitch=2.0)
    assert edge.tangents @ [0, 1, 0] == pytest.approx(1.0, abs=1e-9)
