# SPDX-License-Identifier: LGPL-2.1-or-later
"""What goes wrong on a machine, and what cannot work with one: all is told, nothing is lost."""

import numpy as np
import pytest

from freecad_edgescan.scanning import ScanError, ScanParameters, Start, Stop, scan_edge
from freecad_edgescan.scanning.line_scanner import LineScanner
from freecad_edgescan.scanning.probe_settings import ProbeSettings
from freecad_edgescan.scanning.scan_plane import ScanPlane

from .wedge_machine import BLUNT, WedgeMachine, off_the_edge, parameters, scan, start

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
