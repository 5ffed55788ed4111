# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of a wedge of two planes, scanned by a machine whose every contact is known exactly."""

import numpy as np
import pytest

from freecad_edgescan.scanning import (
    Gate,
    ScanError,
    ScanParameters,
    Start,
    Stop,
    scan_edge,
)
from freecad_edgescan.scanning.line_scanner import LineScanner
from freecad_edgescan.scanning.probe_settings import ProbeSettings
from freecad_edgescan.scanning.scan_plane import ScanPlane

BLUNT = np.radians(100.0)


class WedgeMachine:
    """Two half-planes that meet in the y axis, each falling off from it at an angle.

    In the section the sides are s0 = (-cos a, -sin a) and s1 = (cos a, -sin a), with a half of the
    turn π - θ; a negative turn makes an inner edge. A probe of radius r is touched at the distance
    r from the planes and from the edge.
    """

    def __init__(self, angle=BLUNT, reach=30.0, length=(-20.0, 100.0), radius=0.0):
        fall = 0.5 * (np.pi - angle)
        self.sides = np.array([[-np.cos(fall), -np.sin(fall)], [np.cos(fall), -np.sin(fall)]])
        self.normals = np.array([[-np.sin(fall), np.cos(fall)], [np.sin(fall), np.cos(fall)]])
        self.reach, self.length, self.probe_radius = reach, length, radius
        self.approach = np.array([0.0, 0.0, -1.0])
        self.touches, self.moves = [], []
        self.holes = []  # (low, high) along y where nothing is touched

    def _first(self, start, way, low, high):
        """Smallest parameter in (low, high] at which the probe meets the part."""
        p, d = start[[0, 2]], way[[0, 2]]
        found = []
        for side, normal in zip(self.sides, self.normals, strict=True):
            speed = normal @ d
            if abs(speed) > 1e-12:
                t = (self.probe_radius - normal @ p) / speed
                s = side @ (p + t * d)
                if 0.0 <= s <= self.reach:
                    found.append(t)
        if self.probe_radius:
            b, c = p @ d, p @ p - self.probe_radius**2
            root = b * b - (d @ d) * c
            if root > 0.0:
                for t in ((-b - np.sqrt(root)) / (d @ d), (-b + np.sqrt(root)) / (d @ d)):
                    if np.all(self.sides @ (p + t * d) <= 1e-12):
                        found.append(t)
        good = []
        for t in found:
            y = start[1] + t * way[1]
            hole = any(a < y < b for a, b in self.holes)
            if low < t <= high and self.length[0] <= y <= self.length[1] and not hole:
                good.append(t)
        return min(good) if good else None

    def move(self, start, end):
        self.moves.append((start, end))
        way = end - start
        t = self._first(start, way, 1e-9, 1.0)
        return None if t is None else start + t * way

    def touch(self, start, direction, prehit_distance, search_distance):
        self.touches.append(start)
        t = self._first(start, direction, 0.0, prehit_distance + search_distance)
        return None if t is None else start + t * direction


DEFAULTS = {
    "amplitude": 8.0,
    "line_pitch": 0.8,
    "edge_pitch": 1.0,
    "tolerance": 0.02,
    "degree": 1,
    "pattern": "square",
    "probe_radius": 0.0,
    "approach": (0.0, 0.0, -1.0),
    "prehit_distance": 1.0,
    "search_distance": 10.0,
}


def parameters(literal=False, **values):
    values = {**DEFAULTS, **values}
    return ScanParameters.literal(**values) if literal else ScanParameters(**values)


def start(machine, amplitude=8.0, y=0.0):
    """On side 0, half an amplitude from the edge, across it, walking towards growing y."""
    side = np.array([machine.sides[0][0], 0.0, machine.sides[0][1]])
    return Start(0.5 * amplitude * side + [0.0, y, 0.0], -side, [0.0, 1.0, 0.0])


def gate(machine, y, amplitude=8.0):
    begin = start(machine, amplitude, y)
    return Gate(begin.point, begin.across)


def scan(machine, to=30.0, literal=False, **values):
    values.setdefault("probe_radius", machine.probe_radius)
    amplitude = values.get("amplitude", DEFAULTS["amplitude"])
    return scan_edge(
        machine,
        at=start(machine, amplitude),
        gate=gate(machine, to, amplitude),
        parameters=parameters(literal, **values),
    )


def off_the_edge(edge):
    return np.hypot(edge.points[:, 0], edge.points[:, 2])


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


# ---------------------------------------------------------------- what goes wrong on the way


def test_leaving_the_part_keeps_what_was_found():
    edge = scan(WedgeMachine(length=(-20.0, 12.0)))
    assert edge.stops == (Stop.START, Stop.OFF_OBJECT)
    assert 10.0 < edge.points[-1, 1] <= 12.0
    assert "left the object" in edge.message
    assert "gate was not passed" in edge.message


def test_a_small_hole_across_the_edge_is_passed_over_and_a_large_one_is_not():
    machine = WedgeMachine()
    machine.holes = [(9.2, 11.3)]
    edge = scan(machine)
    assert edge.stops[1] is Stop.GATE
    assert np.diff(edge.points[:, 1]).max() > 2.0
    assert off_the_edge(edge).max() < 1e-6
    machine.holes = [(9.2, 15.3)]
    edge = scan(machine)
    assert edge.stops[1] is Stop.OFF_OBJECT
    assert edge.points[-1, 1] < 9.3
    assert len(edge) > 8


def test_the_algorithm_as_printed_stops_at_the_first_hole():
    machine = WedgeMachine()
    machine.holes = [(9.2, 11.3)]
    edge = scan(machine, literal=True)
    assert edge.stops[1] is Stop.OFF_OBJECT
    assert edge.points[-1, 1] < 9.3


def test_the_result_survives_a_machine_that_fails_in_the_middle():
    class Failing(WedgeMachine):
        def touch(self, *where):
            if len(self.touches) > 150:
                raise OSError("the controller does not answer")
            return super().touch(*where)

    edge = scan(Failing())
    assert edge.stops[1] is Stop.CMM_FAILED
    assert len(edge) >= 3
    assert off_the_edge(edge).max() < 1e-6
    assert "the controller does not answer" in edge.message


def test_a_machine_that_fails_at_once_is_told_with_its_words():
    class Failing(WedgeMachine):
        def touch(self, *where):
            raise OSError("the controller does not answer")

    with pytest.raises(ScanError, match="controller does not answer"):
        scan(Failing())


def test_an_obstacle_before_the_first_point_of_a_line_is_a_collision():
    class Walled(WedgeMachine):
        def move(self, start, end):
            if end[1] > 10.4 and np.linalg.norm(end - start) > 0.0:
                return np.array([30.0, end[1], 30.0])
            return None

    edge = scan(Walled())
    assert edge.stops[1] is Stop.COLLISION
    assert edge.points[-1, 1] < 11.0


def test_the_same_point_twice_is_stepped_over_and_stops_the_printed_algorithm():
    class Sticky(WedgeMachine):
        """Answers a contact a second time, now and then."""

        last, next = np.zeros(3), 60

        def touch(self, *where):
            contact = super().touch(*where)
            near = contact is not None and np.linalg.norm(contact - self.last) < 0.9
            if near and len(self.touches) > self.next:
                contact, self.next = self.last, len(self.touches) + 40
            self.last = self.last if contact is None else contact
            return contact

    edge = scan(Sticky())
    assert edge.stops[1] is Stop.GATE
    assert off_the_edge(edge).max() < 1e-6
    printed = scan(Sticky(), literal=True)
    assert printed.stops[1] is Stop.REPEATED_POINT
    assert "raise the line pitch" in printed.message


def test_a_plane_without_an_edge_is_told():
    with pytest.raises(ScanError, match=r"no edge|left the object"):
        scan(WedgeMachine(np.pi - 1e-6))


def test_a_collision_on_the_line_is_measured():
    """Towards an upright wall the machine runs into it before it could touch it from above."""
    machine = WedgeMachine(np.radians(255.0))
    scanner = LineScanner(machine, ProbeSettings.from_parameters(parameters(), 0.26))
    begin = start(machine)
    inward = np.array([-begin.across[2], 0.0, begin.across[0]])
    inward = inward if inward[2] < 0 else -inward
    plane = ScanPlane(begin.point, begin.across, inward)
    line = scanner.scan(plane, (0.0, 0.0), (1.0, 0.0))
    assert line.stop is None
    heights = machine.normals @ line.contacts[:, [0, 2]].T
    assert np.abs(heights).min(axis=0) == pytest.approx(0.0, abs=1e-9)
    assert (machine.sides[1] @ line.contacts[-1][[0, 2]]) > 2.0


# ---------------------------------------------------------------- what cannot work


def test_a_machine_needs_a_start():
    with pytest.raises(ScanError, match="Start"):
        scan_edge(WedgeMachine(), at=(0.0, 0.0, 0.0), parameters=parameters())


def test_a_machine_has_no_cloud_pitch():
    machine = WedgeMachine()
    with pytest.raises(ScanError, match=r"cloud pitch of 0\.3 mm"):
        scan_edge(machine, at=start(machine), parameters=parameters(cloud_pitch=0.3))


def test_a_machine_has_no_patches():
    machine = WedgeMachine()
    with pytest.raises(ScanError, match="probe"):
        scan_edge(machine, at=start(machine), parameters=parameters(), method="patch")


def test_a_start_in_the_air_is_told():
    machine = WedgeMachine()
    begin = Start(np.array([-200.0, 0.0, 0.0]), [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])
    with pytest.raises(ScanError, match="left the object"):
        scan_edge(machine, at=begin, parameters=parameters())


@pytest.mark.parametrize("degree", [0, 4, 1.5, "two"])
def test_a_degree_that_does_not_exist_is_refused(degree):
    with pytest.raises(ScanError, match="degree"):
        ScanParameters(degree=degree)


def test_a_scan_that_is_cancelled_at_once_keeps_its_first_point():
    class Impatient:
        def update(self, fraction, so_far):
            return False

    class Fragile(WedgeMachine):
        def touch(self, start, *rest):
            if start[1] > 0.4:
                raise ConnectionError("the controller is off")
            return super().touch(start, *rest)

    machine = Fragile()
    for progress, stop in ((None, Stop.CMM_FAILED), (Impatient(), Stop.CANCELLED)):
        edge = scan_edge(machine, start(machine), None, parameters(), progress=progress)
        assert edge.stops[1] is stop
        assert len(edge) == 1
        assert off_the_edge(edge).max() < 1e-6


@pytest.mark.parametrize("answer", [(np.nan, 0.0, 0.0), "here", (1.0, 2.0)])
@pytest.mark.parametrize("movement", ["move", "touch"])
def test_a_machine_that_answers_nonsense_has_failed(answer, movement):
    class Confused(WedgeMachine):
        def move(self, start, end):
            return answer if movement == "move" and start[1] > 10 else super().move(start, end)

        def touch(self, start, *rest):
            return answer if movement == "touch" and start[1] > 10 else super().touch(start, *rest)

    edge = scan(Confused())
    assert edge.stops[1] is Stop.CMM_FAILED
    assert "instead of three finite numbers" in edge.message
    assert len(edge) > 5
    assert off_the_edge(edge).max() < 1e-6


def test_a_machine_that_fails_while_it_moves_keeps_the_result():
    class Tired(WedgeMachine):
        def move(self, start, end):
            if start[1] > 10:
                raise TimeoutError("no answer from axis Z")
            return super().move(start, end)

    edge = scan(Tired())
    assert edge.stops[1] is Stop.CMM_FAILED
    assert "no answer from axis Z" in edge.message
    assert off_the_edge(edge).max() < 1e-6


def test_a_first_line_along_the_probe_is_refused():
    machine = WedgeMachine()
    with pytest.raises(ScanError, match="is that of the probe"):
        scan_edge(machine, Start((0, 0, 3), (0, 0, -1), (0, 1, 0)), None, parameters())


def test_a_collision_is_measured_again():
    """What stops a travelling probe is not as exact as a touch."""

    class Rough(WedgeMachine):
        collisions = 0

        def move(self, start, end):
            met = super().move(start, end)
            if met is not None:
                self.collisions += 1
                met = met - 0.05 * (end - start) / np.linalg.norm(end - start)
            return met

    machine = Rough(2.0 * np.pi - BLUNT)  # a groove, whose far wall is in the way
    edge = scan(machine, prehit_distance=0.3, amplitude=8.0)
    assert machine.collisions > 10
    assert edge.stops[1] is Stop.GATE
    assert off_the_edge(edge).max() < 1e-6


def test_what_a_machine_wants_is_named():
    class Blind:
        probe_radius = 0.0
        approach = (0.0, 0.0, -1.0)

        def move(self, start, end):
            return None

    with pytest.raises(ScanError, match="Blind, which has no touch"):
        scan_edge(Blind(), start(WedgeMachine()), parameters=parameters())
