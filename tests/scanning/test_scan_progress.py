# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest

from freecad_edgescan.scanning import Gate, ScanParameters, Start, Stop, scan_edge

PITCH = 0.5


class Listener:
    """Hears of a scan, and cancels it after some updates."""

    def __init__(self, patience=10**9):
        self.patience, self.new, self.whole, self.fractions = patience, [], [], []

    def update(self, fraction, so_far):
        self.fractions.append(fraction)
        self.new.append(so_far.new_points)
        self.whole.append(so_far.points)
        return len(self.new) < self.patience


@pytest.fixture(scope="module")
def long_wedge(wedge):
    return wedge(90.0, PITCH, length=120.0, width=8.0)


def start_and_gate(part, low, high):
    return (
        Start(part.at(low, 4.0), -part.sides[0], part.along),
        Gate(part.at(high, 4.0), -part.sides[0]),
    )


def test_new_points_add_up_to_the_edge_so_far(long_wedge):
    part, heard = long_wedge, Listener()
    start, gate = start_and_gate(part, -0.4, 0.4)
    edge = scan_edge(part.cloud, start, gate, ScanParameters(amplitude=8.0), progress=heard)
    assert len(heard.new) >= 3
    for k in range(len(heard.new)):
        assert np.array_equal(np.vstack(heard.new[: k + 1]), heard.whole[k])
    last = heard.whole[-1]
    assert part.distance(last).max() < 0.15
    place = part.place_along(last)
    assert (np.diff(place) > 0).all()
    assert place[-1] < part.place_along(edge.points[-1:])[0] + PITCH


def test_fractions_are_shares_or_unknown(long_wedge):
    heard = Listener()
    scan_edge(long_wedge.cloud, long_wedge.at(), progress=heard)
    for fraction in heard.fractions:
        assert np.isnan(fraction) or 0.0 <= fraction <= 1.0


def test_who_listens_changes_nothing(long_wedge):
    one = scan_edge(long_wedge.cloud, long_wedge.at())
    other = scan_edge(long_wedge.cloud, long_wedge.at(), progress=Listener())
    assert np.array_equal(one.points, other.points)
    assert one.stops == other.stops


def test_what_was_found_before_cancelling_is_kept(long_wedge):
    part, heard = long_wedge, Listener(patience=2)
    start, gate = start_and_gate(part, -0.4, 0.4)
    edge = scan_edge(part.cloud, start, gate, ScanParameters(amplitude=8.0), progress=heard)
    assert edge.stops == (Stop.START, Stop.CANCELLED)
    assert "cancelled" in edge.message
    assert len(edge) >= 5
    assert part.distance(edge.points).max() < 0.15
    assert part.place_along(edge.points).max() < part.place_along(heard.whole[-1]).max() + PITCH
    assert part.place_along(edge.points).max() < 0.3 * part.length


def test_a_click_can_be_cancelled_on_either_way(long_wedge):
    part, every = long_wedge, Listener()
    scan_edge(part.cloud, part.at(), progress=every)
    for patience in range(1, len(every.new)):
        edge = scan_edge(part.cloud, part.at(), progress=Listener(patience))
        assert Stop.CANCELLED in edge.stops
        assert len(edge) >= 3
        assert part.distance(edge.points).max() < 0.15


def test_the_scan_lines_so_far_lie_across_the_edge_on_both_sides(long_wedge):
    class Last(Listener):
        def update(self, fraction, so_far):
            self.lines, self.sigma = so_far.scan_lines, so_far.sigma
            return super().update(fraction, so_far)

    part, heard = long_wedge, Last()
    scan_edge(part.cloud, part.at(), progress=heard)
    assert len(heard.lines) == len(heard.sigma) == len(heard.whole[-1])
    for line in heard.lines:
        away = line[[0, -1]] - part.middle
        assert np.ptp(part.place_along(line)) < 2 * PITCH
        assert np.abs(np.sort(np.abs(away @ part.outward.T), axis=1)[:, 0]).max() < 0.3
