# SPDX-License-Identifier: LGPL-2.1-or-later
"""One line across an edge, scanned on extruded parts by a machine whose every contact is exact.

Schreve 4.2, and 4.7.2 for what goes wrong on the way.
"""

from dataclasses import replace

import numpy as np
import pytest

from freecad_edgescan.scanning import ScanParameters, Stop
from freecad_edgescan.scanning.line_scanner import LineScanner
from freecad_edgescan.scanning.probe_settings import ProbeSettings
from freecad_edgescan.scanning.safeguards import Safeguards
from freecad_edgescan.scanning.scan_plane import ScanPlane

AMPLITUDE, PITCH, PREHIT, SEARCH = 8.0, 0.8, 1.0, 10.0
LEVEL = (1.0, 0.0)
both_ways = pytest.mark.parametrize("literal", [False, True], ids=["default", "as printed"])


def settings(literal=False, **values):
    safeguards = Safeguards.none() if literal else Safeguards()
    names = {name for name in values if hasattr(safeguards, name)}
    safeguards = replace(safeguards, **{name: values.pop(name) for name in names})
    given = {
        "amplitude": AMPLITUDE,
        "line_pitch": PITCH,
        "edge_pitch": 1.0,
        "tolerance": 0.02,
        "degree": 1,
        "approach": (0.0, 0.0, -1.0),
        "prehit_distance": PREHIT,
        "search_distance": SEARCH,
        "safeguards": safeguards,
        **values,
    }
    return ProbeSettings.from_parameters(ScanParameters(**given), 0.26)


def plane(y=0.0, wedge=0.0):
    """Across y, from left to right, the part below."""
    return ScanPlane(
        np.array([0.0, y, 0.0]), np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, -1.0]), wedge
    )


def scanned(machine, begin=-4.3, literal=False, onward=None, first=None, edge_at=None, **values):
    scanner = LineScanner(machine, settings(literal, **values))
    return scanner.scan(plane(), (begin, 0.0), LEVEL, first, onward, edge_at)


def steps(contacts):
    return np.linalg.norm(np.diff(contacts, axis=0), axis=1)


def beyond(contacts):
    """Distance from the edge in the y axis of those behind it, along a falling side."""
    behind = contacts[contacts[:, 2] < -1e-9]
    return np.hypot(behind[:, 0], behind[:, 2])


# ---------------------------------------------------------------- one point after the other


def test_points_lie_one_line_pitch_apart(extruded):
    line = scanned(extruded(extruded.wedge(150.0)))
    before = line.contacts[line.contacts[:, 0] <= 0.0]
    assert line.stop is None
    assert before[0] == pytest.approx([-4.3, 0.0, 0.0], abs=1e-9)
    assert steps(before) == pytest.approx(PITCH, abs=1e-9)
    assert steps(line.contacts[-4:]) == pytest.approx(PITCH, abs=1e-9)
    assert line.contacts[:, 1] == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("degrees", [100.0, 150.0, 200.0])
def test_as_printed_points_lie_no_more_than_one_line_pitch_apart(extruded, degrees):
    """Schreve 4.2.2; also the small gaps that an edge makes are refilled."""
    line = scanned(extruded(extruded.wedge(degrees)), literal=True)
    assert line.stop is None
    assert steps(line.contacts).max() <= PITCH * (1.0 + 1e-9)


def test_as_printed_nothing_is_refilled_where_there_is_no_gap(extruded):
    """On planes every step is one line pitch long, but for those about the edge."""
    for begin in (-4.0, -4.1, -4.3):
        line = scanned(extruded(extruded.wedge(150.0)), begin, literal=True)
        behind = line.contacts[line.contacts[:, 2] < -PITCH]
        assert steps(behind) == pytest.approx(PITCH, abs=1e-9)


def test_each_target_lies_on_the_straight_line_through_the_last_two_contacts(extruded):
    """And is searched for square to that line, from one prehit distance in the air."""
    part = extruded(extruded.wedge(165.0))
    contacts = scanned(part).contacts
    assert len(part.searches) == len(contacts)  # no gaps to refill on so blunt an edge
    for k in range(2, len(contacts)):
        (begin, direction, prehit), last = part.searches[k], contacts[k - 1]
        way = last - contacts[k - 2]
        way /= np.linalg.norm(way)
        assert direction @ way == pytest.approx(0.0, abs=1e-9)
        assert direction[2] < 0.0
        assert prehit == PREHIT
        assert begin + PREHIT * direction == pytest.approx(last + PITCH * way, abs=1e-9)


def test_the_first_target_is_touched_along_the_probe(extruded):
    part = extruded(extruded.wedge(120.0))
    scanned(part)
    begin, direction, _ = part.searches[0]
    assert begin == pytest.approx([-4.3, 0.0, PREHIT])
    assert direction == pytest.approx([0.0, 0.0, -1.0])
    assert len(part.moves) == len(part.searches) - 1  # nobody knows where it stood before


def test_a_contact_that_is_already_there_begins_the_line(extruded):
    """As the end of the last line in a zigzag."""
    part, first = extruded(extruded.wedge(120.0)), np.array([-3.7, 0.0, 0.0])
    line = scanned(part, first=first)
    assert line.contacts[0] == pytest.approx(first)
    assert part.searches[0][0] == pytest.approx([-3.7 + PITCH, 0.0, PREHIT])


@both_ways
@pytest.mark.parametrize("degrees", [95.0, 100.0, 115.0, 130.0])
@pytest.mark.parametrize("begin", [-4.0, -4.3, -4.7])
def test_a_gap_behind_the_edge_is_refilled(extruded, degrees, begin, literal):
    """Schreve 4.2.2: the search beyond the edge meets the falling side far down."""
    part = extruded(extruded.wedge(degrees))
    line = scanned(part, begin, literal)
    assert line.stop is None
    assert part.off(line.contacts) == pytest.approx(0.0, abs=1e-9)
    assert steps(line.contacts).max() < (1.05 if literal else 1.5) * PITCH
    assert (np.diff(line.contacts[:, 0]) > -1e-9).all()  # in the order of travel


@pytest.mark.parametrize("degrees", [95.0, 130.0, 160.0])
def test_the_gap_in_which_the_edge_is_expected_is_narrow(extruded, degrees):
    """Wherever the line starts, the sides' last contacts lie nearer to each other."""
    onward = -np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    gaps = {True: [], False: []}
    for sharp, found in gaps.items():
        for begin in np.arange(-4.7, -4.0, 0.1):
            part = extruded(extruded.wedge(degrees))
            line = scanned(part, begin, onward=onward, edge_at=0.0 if sharp else None)
            assert line.stop is None
            assert part.off(line.contacts) == pytest.approx(0.0, abs=1e-9)
            level = np.abs(line.contacts[:, 2]) < 1e-9
            along = np.where(level, line.contacts[:, 0], np.hypot(*line.contacts[:, ::2].T))
            assert (np.diff(along) > 0.0).all()  # in the order of travel
            found.append(np.diff(along)[np.flatnonzero(along <= 1e-9)[-1]])
    assert np.less_equal(gaps[True], np.array(gaps[False]) + 1e-9).all()
    assert np.mean(gaps[True]) < 0.8 * PITCH < np.mean(gaps[False])


def test_without_refilling_there_is_such_a_gap(extruded):
    line = scanned(extruded(extruded.wedge(95.0)), largest_gap=10.0)
    assert steps(line.contacts).max() > 3.0 * PITCH


# ---------------------------------------------------------------- how long a line is


@both_ways
@pytest.mark.parametrize("pattern", ["square", "zigzag"])
@pytest.mark.parametrize("begin", [-1.7, -4.0, -6.0, -7.5])
@pytest.mark.parametrize("degrees", [110.0, 150.0])
def test_the_part_behind_the_edge_is_half_a_line_long_wherever_the_line_starts(
    extruded, degrees, begin, pattern, literal
):
    """Schreve 4.2.3: A/2, and √(ρe² + A²)/2 in a zigzag; the whole at least one amplitude."""
    edge_pitch = 3.0
    part = extruded(extruded.wedge(degrees))
    line = scanned(part, begin, literal, pattern=pattern, edge_pitch=edge_pitch)
    half = 0.5 * (AMPLITUDE if pattern == "square" else np.hypot(AMPLITUDE, edge_pitch))
    assert line.stop is None

    chord = line.contacts[-1] - line.contacts[0]
    away = np.linalg.norm(np.cross(line.contacts - line.contacts[0], chord), axis=1)
    assert steps(line.contacts[away.argmax() :]).sum() >= half

    whole, behind = steps(line.contacts).sum(), beyond(line.contacts).max()
    assert whole >= AMPLITUDE
    assert behind > half - PITCH  # the edge itself need not be touched
    # and no longer than it must be
    assert min(whole - AMPLITUDE, behind - half) < PITCH


# ---------------------------------------------------------------- collisions


@both_ways
@pytest.mark.parametrize("degrees", [210.0, 255.0, 270.0])
def test_a_collision_on_the_way_becomes_a_contact(extruded, degrees, literal):
    """Towards a wall the machine runs into it (Schreve 4.7.2), and goes on up the wall."""
    part = extruded(extruded.wedge(degrees))
    line = scanned(part, literal=literal)
    assert line.stop is None
    assert part.off(line.contacts) == pytest.approx(0.0, abs=1e-9)
    for collision in part.collisions:
        assert np.linalg.norm(line.contacts - collision, axis=1).min() < 1e-9
    assert len(part.collisions) >= (1 if degrees > 220.0 else 0)
    on_wall = line.contacts[line.contacts[:, 2] > 1e-9]
    assert np.hypot(on_wall[:, 0], on_wall[:, 2]).max() > 0.5 * AMPLITUDE - PITCH
    assert (np.diff(on_wall[:, 2]) > 0.0).all()


@both_ways
def test_a_collision_far_from_the_first_target_ends_the_line(extruded, literal):
    """From behind the edge straight back to the other side: through the ridge."""
    part = extruded(extruded.wedge(110.0))
    scanner = LineScanner(part, settings(literal))
    assert scanner.scan(plane(), (-4.0, 0.0), LEVEL).stop is None
    line = scanner.scan(plane(1.0), (-6.0, 0.0), LEVEL)
    assert line.stop is Stop.COLLISION
    assert line.contacts.shape == (0, 3)
    assert part.collisions


@both_ways
def test_a_collision_near_the_first_target_is_its_contact_but_not_as_printed(extruded, literal):
    part = extruded(extruded.wedge(110.0))
    scanner = LineScanner(part, settings(literal))
    scanner.scan(plane(), (-4.0, 0.0), LEVEL)
    line = scanner.scan(plane(1.0), (-0.5, 2.0), LEVEL)  # inside the part
    assert part.collisions
    if literal:
        assert line.stop is Stop.COLLISION
        assert len(line.contacts) == 0
    else:
        assert line.stop is None
        assert line.contacts[0] == pytest.approx(part.collisions[0], abs=1e-9)
        assert part.off(line.contacts) == pytest.approx(0.0, abs=1e-9)


def test_a_line_far_away_is_reached_high_above_the_part(extruded):
    """One search distance up against the approach, across, and down."""
    part = extruded(extruded.wedge(110.0))
    scanner = LineScanner(part, settings())
    scanner.scan(plane(), (-4.0, 0.0), LEVEL)
    stood, known = scanner.position, len(part.moves)
    line = scanner.scan(plane(50.0), (-4.0, 0.0), LEVEL)
    assert line.stop is None
    assert not part.collisions
    up, across, down = part.moves[known : known + 3]
    assert up[1] == pytest.approx(stood - SEARCH * part.approach)
    assert across[1] == pytest.approx([-4.0, 50.0, SEARCH])
    assert down[1] == pytest.approx([-4.0, 50.0, PREHIT])


# ---------------------------------------------------------------- the same point, or none


def sticky(extruded, times):
    """A machine that answers its sixth contact a few times more."""

    class Sticky(extruded):
        def touch(self, *where):
            contact = super().touch(*where)
            if len(self.searches) == 6:
                self.sixth = contact
            again = 6 < len(self.searches) <= 6 + times
            return self.sixth.copy() if again else contact

    return Sticky(extruded.wedge(110.0))


@pytest.mark.parametrize("times", [1, 2])
def test_a_point_touched_twice_is_passed_over_in_a_longer_step(extruded, times):
    part = sticky(extruded, times)
    line = scanned(part, begin=-6.0)
    assert line.stop is None
    assert part.off(line.contacts) == pytest.approx(0.0, abs=1e-9)
    assert steps(line.contacts).min() > 0.1 * PITCH
    assert steps(line.contacts).max() < 1.5 * PITCH  # what the longer step left out is refilled


@pytest.mark.parametrize(("literal", "times"), [(True, 1), (False, 100)])
def test_the_same_point_again_ends_the_line_and_keeps_what_was_touched(extruded, literal, times):
    """As printed at once (Schreve 4.7.2), otherwise when longer steps do not help."""
    line = scanned(sticky(extruded, times), -6.0, literal)
    assert line.stop is Stop.REPEATED_POINT
    assert line.contacts[:, 0] == pytest.approx(-6.0 + PITCH * np.arange(6), abs=1e-9)


@both_ways
def test_a_first_target_in_the_air_is_off_the_object(extruded, literal):
    line = scanned(extruded(extruded.wedge(110.0, reach=3.0)), literal=literal)
    assert line.stop is Stop.OFF_OBJECT
    assert line.contacts.shape == (0, 3)


@both_ways
def test_a_part_that_ends_is_left_and_its_contacts_are_kept(extruded, literal):
    """The side behind the edge is shorter than half a line."""
    part = extruded([[-40.0, 0.0], [0.0, 0.0], [1.5, -1.5]])
    line = scanned(part, literal=literal)
    assert line.stop is Stop.OFF_OBJECT
    assert len(line.contacts) >= 6
    assert 0.0 < beyond(line.contacts).max() <= np.hypot(1.5, 1.5)


@both_ways
def test_the_edge_of_a_sheet_is_where_the_part_ends(extruded, literal):
    """Nothing lies behind it, neither straight below nor round the edge."""
    part = extruded([[-40.0, 0.0], [0.1, 0.0]])
    line = scanned(part, literal=literal)
    assert line.stop is Stop.OFF_OBJECT
    assert line.contacts[:, 0] == pytest.approx(-4.3 + PITCH * np.arange(6), abs=1e-9)


# ---------------------------------------------------------------- round a sharp edge


@pytest.mark.parametrize("degrees", [45.0, 60.0, 80.0])
def test_as_printed_a_search_in_the_air_is_tried_once_more_half_way_back(extruded, degrees):
    """Between the last contact and where the search ended (Schreve figure 4.20)."""
    part = extruded(extruded.wedge(degrees))
    line = scanned(part, literal=True)
    missed, (begin, way, prehit) = part.searches[6:8]
    assert missed[0] == pytest.approx([0.5, 0.0, PREHIT])
    last, ended = np.array([-0.3, 0.0, 0.0]), np.array([0.5, 0.0, -SEARCH])
    assert begin + prehit * way == pytest.approx(0.5 * (last + ended), abs=1e-9)
    assert way @ (ended - last) == pytest.approx(0.0, abs=1e-9)
    assert way[0] < 0.0  # towards the part
    assert line.stop is None
    assert part.off(line.contacts) == pytest.approx(0.0, abs=1e-9)
    assert beyond(line.contacts).max() > 0.5 * AMPLITUDE - PITCH


def test_as_printed_a_second_search_in_the_air_ends_the_line(extruded):
    part = extruded([[-40.0, 0.0], [0.1, 0.0]])
    line = scanned(part, literal=True)
    assert len(part.searches) == len(line.contacts) + 2


@pytest.mark.parametrize("known", [False, True], ids=["side unknown", "side known"])
@pytest.mark.parametrize("begin", [-4.0, -4.3, -4.7])
@pytest.mark.parametrize("degrees", [45.0, 60.0, 80.0])
def test_the_probe_is_led_round_a_sharp_edge_in_small_turns(extruded, degrees, begin, known):
    turn = np.radians(180.0 - degrees)
    onward = (np.cos(turn), np.sin(turn)) if known else None
    part = extruded(extruded.wedge(degrees))
    line = scanned(part, begin, onward=onward)
    assert line.stop is None
    assert part.off(line.contacts) == pytest.approx(0.0, abs=1e-9)
    behind = beyond(line.contacts)
    assert (np.diff(behind) > 0.0).all()
    assert behind.max() > 0.5 * AMPLITUDE - PITCH
    assert behind.min() < 2.0 * PITCH
    assert steps(line.contacts).max() < 2.0 * PITCH


def test_where_the_surface_behind_the_edge_is_level_there_is_nothing_to_feel_round_for(extruded):
    """The part has ended: no search beyond the one that found nothing."""
    part = extruded([[-40.0, 0.0], [0.1, 0.0]])
    line = scanned(part, onward=(1.0, 0.0))
    assert line.stop is Stop.OFF_OBJECT
    assert len(part.searches) == len(line.contacts) + 1
