# SPDX-License-Identifier: LGPL-2.1-or-later
from itertools import pairwise

import numpy as np
import pytest

from freecad_edgescan.scanning import Gate, ScanError, ScanParameters, Start
from freecad_edgescan.scanning.edge_gate import LineGate, PointGate

UP = np.array([0.0, 0.0, 1.0])


def test_start_is_touched_as_a_point_a_point_across_and_a_point_along():
    start = Start.from_points((1, 2, 3), (1, 2, 7), (6, 2, 3))
    assert start.point == pytest.approx([1, 2, 3])
    assert start.across == pytest.approx([0, 0, 1])
    assert start.along == pytest.approx([1, 0, 0])


def test_gate_is_touched_as_its_two_ends():
    gate = Gate.from_points((1, 0, 0), (1, 3, 4))
    assert gate.point == pytest.approx([1, 0, 0])
    assert gate.across == pytest.approx([0, 0.6, 0.8])


def test_directions_of_any_length_mean_the_same():
    one, other = Start((0, 0, 0), (1, 0, 0), (0, 1, 0)), Start((0, 0, 0), (9, 0, 0), (0, 0.1, 0))
    assert other.across == pytest.approx(one.across)
    assert other.along == pytest.approx(one.along)


def test_starts_and_gates_keep_no_hold_on_the_callers_arrays():
    point = np.array([1.0, 2.0, 3.0])
    start, gate = Start(point, (1, 0, 0), (0, 1, 0)), Gate(point, (1, 0, 0))
    point[:] = 0.0
    assert start.point == pytest.approx([1, 2, 3])
    assert gate.point == pytest.approx([1, 2, 3])


@pytest.mark.parametrize(
    ("build", "words"),
    [
        (lambda: Start((0, 0, 0), (1, 0, 0), (1, 0.1, 0)), r"nearly the same.*one across"),
        (lambda: Start((0, np.nan, 0), (1, 0, 0), (0, 1, 0)), r"start point is \(0, nan, 0\)"),
        (lambda: Start((0, 1), (1, 0, 0), (0, 1, 0)), r"start point is \(0, 1\).*three"),
        (lambda: Start((0, 0, 0), (0, 0, 0), (0, 1, 0)), "across the edge has no length"),
        (lambda: Start((0, 0, 0), (1, 0, 0), (0, np.inf, 0)), "along the edge is .*inf"),
        (lambda: Start.from_points((1, 1, 1), (1, 1, 1), (2, 1, 1)), "has no length"),
        (lambda: Start.from_points((0, 0, 0), (1, 0, 0), (2, 0, 0)), "nearly the same"),
        (lambda: Gate((0, 0, 0), (0, 0, 0)), "across the gate has no length"),
        (lambda: Gate((0, 0, np.inf), (0, 0, 1)), r"gate point is \(0, 0, inf\)"),
        (lambda: Gate.from_points((1, 2, 3), (1, 2, 3)), "has no length"),
    ],
)
def test_what_makes_no_start_or_gate_is_refused_with_the_value(build, words):
    with pytest.raises(ScanError, match=words):
        build()


def test_something_that_is_no_point_at_all_is_a_scan_error_too():
    with pytest.raises(ScanError, match="start point"):
        Start("here", (1, 0, 0), (0, 1, 0))
    with pytest.raises(ScanError, match="gate point"):
        Gate(None, (1, 0, 0))


def test_a_gate_is_crossed_between_its_ends_however_high_the_walk_runs():
    gate = Gate((10, -2, 0), (0, 1, 0))
    for height in (0.0, 7.0, -7.0):
        share = gate.crossing(np.array([8.0, 0, height]), np.array([12.0, 0, height]), 4.0, UP)
        assert share == pytest.approx(0.5)
    assert gate.crossing(np.array([9.0, 1.9, 0]), np.array([10.5, 1.9, 0]), 4.0, UP) is not None


def test_a_gate_is_not_crossed_beside_it_nor_before_it():
    gate = Gate((10, -2, 0), (0, 1, 0))
    for y in (-2.1, 2.1):
        assert gate.crossing(np.array([8.0, y, 0]), np.array([12.0, y, 0]), 4.0, UP) is None
    assert gate.crossing(np.array([8.0, 0, 0]), np.array([9.9, 0, 0]), 4.0, UP) is None
    assert gate.crossing(np.array([10.1, 0, 0]), np.array([12.0, 0, 0]), 4.0, UP) is None


def test_a_gate_that_slopes_is_as_long_as_its_shadow_along_the_approach():
    """Its second end lies at point + A·across; both ends stand upright along the approach."""
    gate = Gate((10, 0, 0), (0, 0.6, 0.8))
    for y, crossed in ((0.1, True), (5.9, True), (6.1, False), (-0.1, False)):
        share = gate.crossing(np.array([9.0, y, 0]), np.array([11.0, y, 0]), 10.0, UP)
        assert (share is not None) is crossed, y


def test_a_walk_that_ends_exactly_on_the_gate_has_passed_it():
    gate = LineGate(Gate((10, -2, 0), (0, 1, 0)), 4.0, None)
    steps = [np.array([x, 0.0, 0.0]) for x in (8.0, 9.0, 10.0, 11.0)]
    passed = [gate(a, b) for a, b in pairwise(steps)]
    assert any(passed)


def test_without_an_approach_the_gate_stands_upright_on_the_walk():
    gate = LineGate(Gate((10, -2, 0), (0, 1, 0)), 4.0, None)
    assert gate(np.array([9.5, 0, 3.0]), np.array([10.5, 0, 3.0]))
    assert not gate(np.array([9.5, 3, 0.0]), np.array([10.5, 3, 0.0]))


def test_a_point_as_gate_is_passed_when_the_walk_moves_away_from_it():
    gate = PointGate(np.array([10.0, 1.0, 0.0]), reach=5.0)
    steps = np.column_stack([np.arange(0.0, 20.0, 0.8), np.zeros(25), np.zeros(25)])
    passed = [gate(a, b) for a, b in pairwise(steps)]
    assert steps[passed.index(True) + 1, 0] == pytest.approx(10.4)
    assert not any(passed[: passed.index(True)])


def test_unit_vectors_come_back_bit_for_bit():
    random = np.random.default_rng(4)
    for across, aside in random.normal(size=(200, 2, 3)):
        along = np.cross(across, aside)
        once = Start((0, 0, 0), across, along)
        again = Start((0, 0, 0), once.across, once.along)
        assert np.array_equal(once.across, again.across)
        assert np.array_equal(once.along, again.along)
        approach = ScanParameters(approach=across).approach
        assert ScanParameters(approach=approach).approach == approach
