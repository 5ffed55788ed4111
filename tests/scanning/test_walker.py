# SPDX-License-Identifier: LGPL-2.1-or-later
"""The walker on edges that are curves in a formula, measured by a section that knows them."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from freecad_edgescan.scanning.edge_gate import PointGate
from freecad_edgescan.scanning.gait import AdaptiveGait, predict
from freecad_edgescan.scanning.section import Station, frames_from_sides
from freecad_edgescan.scanning.stop import Stop
from freecad_edgescan.scanning.trace import trace_both_ways, trace_one_way
from freecad_edgescan.scanning.walker import walk

PITCH = 1.0


def straight(t):
    return np.array([t, 0.0, 0.0]), np.array([1.0, 0.0, 0.0])


def circle(t, radius=8.0):
    a = t / radius
    return radius * np.array([np.cos(a), np.sin(a), 0.0]), np.array([-np.sin(a), np.cos(a), 0.0])


def helix(t, radius=10.0, rise=0.3):
    size = np.hypot(1.0, rise)
    a = t / radius / size
    return (
        np.array([radius * np.cos(a), radius * np.sin(a), rise * t / size]),
        np.array([-np.sin(a), np.cos(a), rise]) / size,
    )


def right_angle(t):
    """Along x to x = 20, then along y."""
    if t < 20.0:
        return straight(t)
    return np.array([20.0, t - 20.0, 0.0]), np.array([0.0, 1.0, 0.0])


class KnownEdge:
    """A section that measures a curve (point, tangent) = curve(arc length) with some noise."""

    def __init__(self, curve, low=-np.inf, high=np.inf, noise=0.0):
        self.curve, self.low, self.high, self.noise = curve, low, high, noise
        self.rng, self.at = np.random.default_rng(9), 0.0
        self.widths, self.batches = [], []

    def station(self, t, towards=None):
        point, tangent = self.curve(t)
        if towards is not None and tangent @ towards < 0:
            tangent = -tangent
        upright = np.array([0.0, 0.0, 1.0])
        aside = np.cross(upright, self.curve(t)[1])
        aside /= np.linalg.norm(aside)
        sides = np.array([aside, np.cross(aside, self.curve(t)[1])])
        blur = self.noise * self.rng.normal(size=2) @ sides
        frame = frames_from_sides((point + blur)[None], tangent[None], sides[None])
        return Station(frame, max(self.noise, 1e-4), self.noise, (0.0, 0.0))

    def nearest(self, place):
        return minimize_scalar(
            lambda t: np.sum((self.curve(t)[0] - place) ** 2),
            bounds=(self.at - 4 * PITCH, self.at + 4 * PITCH),
            method="bounded",
            options={"xatol": 1e-9},
        ).x

    def measure(self, predicted, half_width, last):
        self.batches.append(len(predicted))
        return [
            self.measure_one(predicted[k], width) for k, width in enumerate(half_width.tolist())
        ]

    def measure_one(self, predicted, half_width):
        self.widths.append(half_width)
        if self.curve is straight:
            self.at = predicted.origin[0, 0]
        t = self.nearest(predicted.origin[0])
        if not self.low < t < self.high:
            return Station(predicted, stop=Stop.CLOUD_END)
        self.at = t
        return self.station(t, predicted.tangent[0])

    def ending(self, last, stop):
        return stop


def walked(edge, longest=PITCH, **more):
    return walk(edge, edge.station(0.0), gait(longest), **more)


def gait(longest=PITCH):
    return AdaptiveGait(PITCH, 0.75 * PITCH, longest)


def places(stations):
    return np.array([s.frame.origin[0] for s in stations])


def test_predictions_run_on_along_the_osculating_circle():
    point, tangent = circle(0.0, 50.0)
    frame = frames_from_sides(
        point[None],
        tangent[None],
        np.array([[[1.0, 0, 0], [0, 0, 1.0]]]),
        np.array([[-1 / 50.0, 0.0, 0.0]]),
    )
    steps = np.array([2.0, 4.0, 30.0])
    ahead = predict(frame, steps)
    for k, step in enumerate(steps):
        point, tangent = circle(step, 50.0)
        assert ahead.origin[k] == pytest.approx(point, abs=1e-12)
        assert ahead.tangent[k] == pytest.approx(tangent, abs=1e-12)
        assert ahead.bend[k] == pytest.approx(-point / 50.0**2, abs=1e-12)
        # What stood across the edge on the cylinder's axis still does.
        assert ahead.sides[k, 1] == pytest.approx([0, 0, 1], abs=1e-12)
        assert ahead.sides[k, 0] == pytest.approx(point / 50.0, abs=1e-12)


def test_several_sections_are_measured_at_once_where_the_edge_runs_as_expected():
    edge = KnownEdge(straight, -1.0, 60.0)
    found = walked(edge)
    assert found.stop is Stop.CLOUD_END
    # The first ones by themselves, until the walk knows how the edge runs.
    assert edge.batches[:3] == [1, 1, 1]
    assert edge.batches.count(6) > 5
    assert len(edge.batches) < 0.5 * len(found.stations)


def test_of_sections_measured_at_once_those_behind_a_surprise_are_looked_for_again():
    """Farther ahead than two sections this one sees an edge that is none, 0.1 mm aside."""

    class Misled(KnownEdge):
        def measure(self, predicted, half_width, last):
            stations = super().measure(predicted, half_width, last)
            for k in range(2, len(stations)):
                frame = stations[k].frame
                aside = frame.origin + 0.1 * frame.sides[:, 0]
                stations[k] = replace(stations[k], frame=replace(frame, origin=aside))
            return stations

    edge = Misled(straight, -1.0, 60.0)
    found = walked(edge)
    assert max(edge.batches) > 2
    assert found.stop is Stop.CLOUD_END
    assert np.abs(places(found.stations)[:, 1]).max() < 1e-3
    assert places(found.stations)[-1, 0] > 60.0 - PITCH


def test_turned_round_a_section_keeps_its_sides_and_normals():
    frame = KnownEdge(circle).station(3.0).frame
    back = frame.backward()
    assert back.tangent == pytest.approx(-frame.tangent)
    assert back.sides == pytest.approx(frame.sides)
    assert back.normals == pytest.approx(frame.normals)
    assert back.bend == pytest.approx(frame.bend)


@pytest.mark.parametrize(("curve", "length"), [(straight, 60.0), (helix, 90.0)])
@pytest.mark.parametrize("noise", [0.0, 0.03])
def test_an_edge_is_walked_to_its_end(curve, length, noise):
    edge = KnownEdge(curve, -1.0, length, noise)
    found = walked(edge)
    assert found.stop is Stop.CLOUD_END
    assert edge.at > length - PITCH
    steps = np.linalg.norm(np.diff(places(found.stations), axis=0), axis=1)
    assert np.median(steps) == pytest.approx(PITCH, rel=0.05)


def test_the_walk_learns_the_bend_of_the_edge():
    found = walked(KnownEdge(circle, high=45.0))
    bend = found.stations[-3].frame
    inward = -bend.origin[0] / np.linalg.norm(bend.origin[0])
    assert bend.bend[0] == pytest.approx(inward / 8.0, abs=0.02)


def test_a_circle_is_closed_when_the_walk_comes_back_to_its_start():
    found = walked(KnownEdge(circle, noise=0.01))
    assert found.stop is Stop.CLOSED
    whole = 2 * np.pi * 8.0
    assert len(found.stations) == pytest.approx(whole / PITCH, abs=2)
    gap = np.linalg.norm(places(found.stations)[-1] - circle(0.0)[0])
    assert gap < 1.3 * PITCH


def test_a_walk_led_on_from_known_stations_is_closed_where_those_begin():
    edge = KnownEdge(circle, noise=0.01)
    first = edge.station(0.0)
    known = [first, *walk(edge, first, gait(), limit=15).stations]
    found = walk(edge, known[-1], gait(), behind=known[:-1])
    assert found.stop is Stop.CLOSED
    assert len(known) + len(found.stations) == pytest.approx(2 * np.pi * 8.0 / PITCH, abs=2)
    gap = np.linalg.norm(places(found.stations)[-1] - circle(0.0)[0])
    assert gap < 1.3 * PITCH


def test_from_two_stations_on_one_place_the_walk_goes_on():
    edge = KnownEdge(straight, -1.0, 20.0)
    found = walk(edge, replace(edge.station(0.0), step=0.0), gait())
    assert found.stop is Stop.CLOUD_END
    assert edge.at > 20.0 - PITCH


def test_a_helix_that_passes_above_its_start_is_not_closed():
    found = walked(KnownEdge(helix, high=150.0))
    assert found.stop is Stop.CLOUD_END


def test_an_edge_that_turns_sharply_ends_in_a_corner():
    edge = KnownEdge(right_angle)
    found = walked(edge)
    assert found.stop is Stop.CORNER
    last = places(found.stations)[-1]
    assert last == pytest.approx([20.0, 0.0, 0.0], abs=PITCH)


def test_longer_steps_are_taken_where_the_edge_runs_as_predicted():
    found = walked(KnownEdge(straight, -1.0, 100.0), longest=3 * PITCH)
    steps = np.diff(places(found.stations)[:, 0])
    assert steps[5:15] == pytest.approx(np.full(10, 3 * PITCH), rel=0.01)


def test_steps_grow_short_before_the_walk_gives_up():
    edge = KnownEdge(straight, -1.0, 30.0)
    found = walked(edge, longest=2 * PITCH)
    assert places(found.stations)[-1, 0] > 30.0 - 0.5 * PITCH
    assert min(edge.widths) < max(edge.widths)


def test_a_walk_ends_at_the_largest_number_of_edge_points():
    found = walked(KnownEdge(straight), limit=25)
    assert found.stop is Stop.LIMIT
    assert len(found.stations) == 25


def test_a_walk_that_has_arrived_ends_at_its_gate():
    gate = PointGate(np.array([15.2, 1.0, 0.0]), 3.0)
    found = walked(KnownEdge(straight), arrived=gate)
    assert found.stop is Stop.GATE
    assert 15.2 < places(found.stations)[-1, 0] < 15.2 + 2 * PITCH


class Listener:
    def __init__(self, patience=10**9):
        self.patience, self.heard, self.whole = patience, [], []

    def update(self, fraction, so_far):
        assert np.isnan(fraction) or 0.0 <= fraction <= 1.0
        self.heard.append(so_far.new_points)
        self.whole.append(so_far.points)
        return len(self.heard) < self.patience


def test_what_was_found_before_cancelling_is_kept():
    listener = Listener(patience=3)
    found = walked(KnownEdge(straight), progress=listener)
    assert found.stop is Stop.CANCELLED
    assert len(found.stations) >= 10
    assert places(found.stations)[-1] == pytest.approx(listener.whole[-1][-1])


def test_new_points_add_up_to_the_points_so_far():
    listener = Listener()
    walked(KnownEdge(straight, -1.0, 77.0), progress=listener)
    assert len(listener.heard) > 5
    for k in range(len(listener.heard)):
        assert np.array_equal(np.vstack(listener.heard[: k + 1]), listener.whole[k])


def test_both_ways_are_one_edge_in_walking_order():
    edge = KnownEdge(straight, -30.0, 40.0)
    trace = trace_both_ways(edge, edge.station(0.0), gait())
    assert trace.stops == (Stop.CLOUD_END, Stop.CLOUD_END)
    x = places(trace.stations)[:, 0]
    assert (np.diff(x) > 0).all()
    assert x[0] < -29.0 and x[-1] > 39.0
    for station in trace.stations:
        assert station.frame.tangent[0] == pytest.approx([1, 0, 0])


def test_where_only_the_second_way_leads_round_the_edge_is_closed_and_nothing_is_there_twice():
    class OnceEnded(KnownEdge):
        """A circle on whose first way something is taken for an end."""

        def measure_one(self, predicted, half_width):
            if np.linalg.norm(self.curve(self.at)[0] - predicted.origin[0]) > 3.0 * PITCH:
                self.at = 0.0  # the second way
            return super().measure_one(predicted, half_width)

    edge = OnceEnded(circle, high=12.0)
    trace = trace_both_ways(edge, edge.station(0.0), gait())
    assert trace.stops == (Stop.CLOSED, Stop.CLOSED)
    assert trace.closed
    turned = np.unwrap(np.arctan2(*places(trace.stations)[:, 1::-1].T))
    assert (np.diff(turned) > 0.0).all()
    assert turned[-1] - turned[0] == pytest.approx(2.0 * np.pi, abs=2.0 * PITCH / 8.0)


def test_points_found_both_ways_are_each_told_once():
    listener = Listener()
    edge = KnownEdge(straight, -45.0, 55.0)
    trace_both_ways(edge, edge.station(0.0), gait(), progress=listener)
    told = np.sort(np.vstack(listener.heard)[:, 0])
    steps = np.diff(told)
    assert steps.max() < PITCH + 0.01
    assert steps.min() > 0.2 * PITCH
    assert told.min() < -43.0
    assert told.max() > 53.0


def test_points_so_far_are_in_walking_order():
    listener = Listener()
    edge = KnownEdge(straight, -45.0, 55.0)
    trace_both_ways(edge, edge.station(0.0), gait(), progress=listener)
    steps = np.linalg.norm(np.diff(listener.whole[-1], axis=0), axis=1)
    assert steps.max() < 1.5 * PITCH


def test_one_way_begins_at_the_start():
    trace = trace_one_way(
        KnownEdge(straight, -50.0, 20.0), KnownEdge(straight).station(0.0), gait()
    )
    assert trace.stops == (Stop.START, Stop.CLOUD_END)
    assert places(trace.stations)[0] == pytest.approx([0, 0, 0])
    assert places(trace.stations)[:, 0].min() >= 0.0


def test_a_cancelled_scan_both_ways_does_not_begin_the_other_way():
    edge = KnownEdge(straight)
    trace = trace_both_ways(edge, edge.station(0.0), gait(), progress=Listener(patience=1))
    assert trace.stops[1] is Stop.CANCELLED
    assert places(trace.stations)[:, 0].min() >= 0.0
