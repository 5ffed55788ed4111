# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a probed scan steps on, with a section that knows an exact edge (Schreve 4.4.2 to 4.4.4)."""

from dataclasses import replace

import numpy as np
import pytest

from freecad_edgescan.scanning import ScanParameters, Stop
from freecad_edgescan.scanning.probe_gait import ProbeGait
from freecad_edgescan.scanning.probe_settings import ProbeSettings
from freecad_edgescan.scanning.safeguards import Safeguards
from freecad_edgescan.scanning.section import Station, frames_from_sides
from freecad_edgescan.scanning.walker import walk

PITCH = 1.5


def settings(coasting=3, literal=False, **values):
    safeguards = replace(Safeguards.none() if literal else Safeguards(), coasting=coasting)
    given = {
        "amplitude": 8.0,
        "line_pitch": 0.1,
        "edge_pitch": PITCH,
        "tolerance": 0.02,
        "degree": 1,
        "approach": (0.0, 0.0, -1.0),
        "prehit_distance": 1.0,
        "search_distance": 5.0,
        "safeguards": safeguards,
        **values,
    }
    return ProbeSettings.from_parameters(ScanParameters(**given), 0.26)


class Straight:
    """Along (2, 3, 6) / 7 from a point off the origin."""

    place, way = np.array([1.0, -4.0, 2.0]), np.array([2.0, 3.0, 6.0]) / 7.0

    def at(self, s):
        """Point, unit tangent and a direction across it at an arc length."""
        across = np.cross(self.way, [0.0, 0.0, 1.0])
        return self.place + s * self.way, self.way, across / np.linalg.norm(across)

    def nearest(self, point):
        return (point - self.place) @ self.way


class Circle:
    """In a plane that leans; s = 0 lies at its first axis."""

    centre = np.array([3.0, 1.0, -2.0])
    first, second = np.array([0.6, 0.8, 0.0]), np.array([0.48, -0.36, 0.8])

    def __init__(self, radius):
        self.radius = radius

    def at(self, s):
        a = s / self.radius
        out = np.cos(a) * self.first + np.sin(a) * self.second
        way = np.cos(a) * self.second - np.sin(a) * self.first
        return self.centre + self.radius * out, way, out

    def nearest(self, point):
        away = point - self.centre
        return self.radius * np.arctan2(away @ self.second, away @ self.first)

    def off(self, point):
        away, axis = point - self.centre, np.cross(self.first, self.second)
        height = away @ axis
        return np.hypot(np.linalg.norm(away - height * axis) - self.radius, height)


class Known:
    """A section that knows the edge, but fails on some of its lines."""

    def __init__(self, edge, fails=()):
        self.edge, self.fails = edge, list(fails)
        self.predicted, self.widths = [], []

    def station(self, s, step=np.nan):
        point, way, across = self.edge.at(s)
        sides = np.array([across, np.cross(way, across)])
        return Station(frames_from_sides(point[None], way[None], sides[None]), step=step)

    def measure(self, predicted, half_width, last):
        self.predicted.append(predicted)
        self.widths += half_width.tolist()
        stop = self.fails.pop(0) if self.fails else None
        if stop is not None:
            return [Station(predicted, stop=stop)]
        return [self.station(self.edge.nearest(predicted.origin[0]))]

    def ending(self, last, stop):
        return stop


def walked(edge, step=PITCH, count=3):
    """Stations of a walk so far, the last one at s = 0."""
    section = Known(edge)
    return [
        section.station(k * step, step if k > 1 - count else np.nan) for k in range(1 - count, 1)
    ]


CIRCLES = pytest.mark.parametrize("radius", [2.0, 8.0, 300.0])
STEERINGS = ["tangent", "curvature"]

# ---------------------------------------------------------------- where the next line goes


@CIRCLES
@pytest.mark.parametrize("step", [0.4, PITCH, 2.5])
def test_steered_by_curvature_the_next_line_lies_on_the_circle_of_the_last_three(radius, step):
    """Schreve 4.4.3: one edge pitch further round it, across its tangent there."""
    edge = Circle(radius)
    section = Known(edge)
    ProbeGait(settings(steering="curvature")).stride(section, walked(edge, step))
    ahead = section.predicted[0]
    point, way, _ = edge.at(PITCH)
    assert ahead.origin[0] == pytest.approx(point, abs=1e-6)
    assert ahead.tangent[0] == pytest.approx(way, abs=1e-6)
    assert np.abs(ahead.sides[0] @ way) == pytest.approx(0.0, abs=1e-6)


def test_uneven_steps_lead_round_the_same_circle():
    edge = Circle(5.0)
    section = Known(edge)
    stations = [section.station(s, 1.0) for s in (-3.1, -0.4, 0.0)]
    ProbeGait(settings(steering="curvature")).stride(section, stations)
    assert section.predicted[0].origin[0] == pytest.approx(edge.at(PITCH)[0], abs=1e-9)


@CIRCLES
def test_steered_by_the_tangent_the_next_line_lies_straight_ahead(radius):
    """Schreve eq. 4.4.2.1; in a bend it lies outside."""
    edge = Circle(radius)
    section = Known(edge)
    ProbeGait(settings(steering="tangent")).stride(section, walked(edge))
    point, way, _ = edge.at(0.0)
    assert section.predicted[0].origin[0] == pytest.approx(point + PITCH * way, abs=1e-12)
    assert section.predicted[0].tangent[0] == pytest.approx(way, abs=1e-12)
    outside = np.hypot(radius, PITCH) - radius
    assert edge.off(section.predicted[0].origin[0]) == pytest.approx(outside)


@pytest.mark.parametrize("count", [1, 2, 3, 5])
@pytest.mark.parametrize("steering", STEERINGS)
def test_on_a_straight_edge_both_lead_straight_ahead(steering, count):
    edge = Straight()
    section = Known(edge)
    ProbeGait(settings(steering=steering)).stride(section, walked(edge, count=count))
    assert section.predicted[0].origin[0] == pytest.approx(edge.at(PITCH)[0], abs=1e-9)
    assert section.predicted[0].tangent[0] == pytest.approx(edge.way, abs=1e-9)


@pytest.mark.parametrize("count", [1, 2])
def test_two_edge_points_have_no_circle_and_the_tangent_is_followed(count):
    edge = Circle(6.0)
    section = Known(edge)
    ProbeGait(settings(steering="curvature")).stride(section, walked(edge, count=count))
    point, way, _ = edge.at(0.0)
    assert section.predicted[0].origin[0] == pytest.approx(point + PITCH * way, abs=1e-12)


def test_a_prediction_keeps_the_sides_square_to_the_tangent():
    edge = Circle(4.0)
    section, stations = Known(edge), walked(edge)
    ProbeGait(settings(steering="curvature")).stride(section, stations)
    ahead, last = section.predicted[0], stations[-1].frame
    assert np.einsum("mki,mi->mk", ahead.sides, ahead.tangent) == pytest.approx(0.0, abs=1e-12)
    assert ahead.sides[0, 1] == pytest.approx(last.sides[0, 1], abs=1e-9)  # the circle's axis


@pytest.mark.parametrize("steering", STEERINGS)
def test_a_walk_goes_once_round_a_circle_and_is_closed(steering):
    edge = Circle(8.0)
    section = Known(edge)
    found = walk(section, section.station(0.0), ProbeGait(settings(steering=steering)))
    assert found.stop is Stop.CLOSED
    assert len(found.stations) == pytest.approx(2.0 * np.pi * 8.0 / PITCH, abs=2.0)
    off = [edge.off(predicted.origin[0]) for predicted in section.predicted[3:]]
    outside = np.hypot(8.0, PITCH) - 8.0
    assert off == pytest.approx(np.full(len(off), 0.0 if steering == "curvature" else outside))


# ---------------------------------------------------------------- how far away it lies


def chord_height(radius, step):
    """Of the arc over the chord between two points on a circle."""
    return radius * (1.0 - np.cos(0.5 * step / radius))


@pytest.mark.parametrize("steering", STEERINGS)
@pytest.mark.parametrize(
    ("wanted", "ratio"),
    [(0.01, 0.5), (0.25, 0.5), (0.49, 0.7), (1.0, 1.0), (3.24, 1.8), (9.0, 3.0), (50.0, 3.0)],
)
def test_the_pitch_changes_by_half_to_threefold_to_have_the_chord_height(wanted, ratio, steering):
    """Schreve 4.4.4; `wanted` is in heights of the chord between the last two edge points."""
    edge, step = Circle(6.0), 0.5
    section = Known(edge)
    gait = ProbeGait(settings(steering=steering, chord_height=wanted * chord_height(6.0, step)))
    (station,) = gait.stride(section, walked(edge, step))
    assert station.step == pytest.approx(ratio * step, rel=2e-3)
    ahead = section.predicted[0].origin[0] - edge.at(0.0)[0]
    way = edge.at(0.0)[1]
    turn = station.step / 6.0
    exact = 6.0 * np.sin(turn) if steering == "curvature" else station.step
    assert ahead @ way == pytest.approx(exact)


@pytest.mark.parametrize(("wanted", "ratio"), [(0.3, 0.5), (0.7, 0.7), (1.8, 1.8), (9.0, 3.0)])
def test_as_printed_the_height_over_two_steps_is_the_ratio_itself(wanted, ratio):
    """Schreve eq. 4.4.4.1."""
    edge, step = Circle(6.0), 0.5
    height = wanted * chord_height(6.0, 2.0 * step)
    gait = ProbeGait(settings(literal=True, chord_height=height))
    assert gait.stride(Known(edge), walked(edge, step))[0].step == pytest.approx(ratio * step)


def test_without_a_chord_height_the_pitch_stays_as_it_was_given():
    for edge in (Straight(), Circle(2.0)):
        assert ProbeGait(settings()).stride(Known(edge), walked(edge, 0.7))[0].step == PITCH


def test_the_first_steps_have_the_pitch_that_was_given():
    """Three edge points make a chord height; on a straight edge it then lets the pitch grow."""
    edge = Straight()
    section = Known(edge)
    gait = ProbeGait(settings(chord_height=0.01))
    stations = [section.station(0.0)]
    for _ in range(4):
        stations += gait.stride(section, stations)
    assert [station.step for station in stations[1:3]] == pytest.approx([PITCH, PITCH])
    assert stations[3].step == pytest.approx(3.0 * PITCH)


def test_the_pitch_grows_to_three_times_what_was_given_and_no_further():
    edge = Straight()
    gait = ProbeGait(settings(chord_height=0.01))
    assert gait.longest_step == pytest.approx(3.0 * PITCH)
    assert gait.stride(Known(edge), walked(edge, 2.5 * PITCH))[0].step == pytest.approx(3.0 * PITCH)
    assert ProbeGait(settings()).longest_step == pytest.approx(PITCH)


@pytest.mark.parametrize(("step", "shrunk"), [(1.5, 0.75), (0.9, 0.6), (0.6, 0.6)])
def test_the_pitch_never_shrinks_below_one_and_a_half_cloud_pitches(step, shrunk):
    edge = Circle(1.0)
    gait = ProbeGait(settings(chord_height=1e-4, cloud_pitch=0.4))
    assert gait.stride(Known(edge), walked(edge, step))[0].step == pytest.approx(shrunk)


def test_without_a_cloud_the_pitch_never_shrinks_below_the_line_pitch():
    edge = Circle(1.0)
    gait = ProbeGait(settings(chord_height=1e-6, line_pitch=0.4))
    assert gait.stride(Known(edge), walked(edge, 0.6))[0].step == pytest.approx(0.4)


@pytest.mark.parametrize("literal", [False, True])
def test_on_a_circle_the_pitch_settles_where_the_chord_has_its_height(literal):
    """As printed, the ratio is that of a height, not of a pitch (Schreve 4.4.4): it swings on."""
    edge = Circle(10.0)
    section = Known(edge)
    height = chord_height(10.0, 4.0 if literal else 2.0)
    gait = ProbeGait(settings(literal=literal, steering="curvature", chord_height=height))
    stations = [section.station(0.0)]
    for _ in range(60):
        stations += gait.stride(section, stations)
    steps = np.array([station.step for station in stations[-24:]])
    assert np.exp(np.log(steps).mean()) == pytest.approx(2.0, rel=0.05)
    assert (np.ptp(steps) > 0.5) == literal


def test_points_are_taken_from_half_a_step_to_both_sides():
    section = Known(Straight())
    ProbeGait(settings()).stride(section, walked(section.edge))
    assert section.widths == pytest.approx([0.5 * PITCH])


# ---------------------------------------------------------------- bad lines


REASONS = [Stop.NO_EDGE, Stop.TOO_FEW_POINTS, Stop.OFF_OBJECT, Stop.REPEATED_POINT]


@pytest.mark.parametrize("bad", [1, 2, 3])
def test_bad_lines_are_passed_over_as_far_as_coasting_goes(bad):
    section = Known(Straight(), REASONS[:bad])
    (station,) = ProbeGait(settings()).stride(section, walked(section.edge))
    assert station.stop is None
    assert station.step == pytest.approx((bad + 1) * PITCH)
    assert station.frame.origin[0] == pytest.approx(section.edge.at(station.step)[0])
    tried = [section.edge.nearest(predicted.origin[0]) for predicted in section.predicted]
    assert tried == pytest.approx(PITCH * np.arange(1, bad + 2))


@pytest.mark.parametrize("coasting", [0, 1, 3])
def test_one_bad_line_more_ends_the_walk_where_it_was_and_for_the_first_reason(coasting):
    section = Known(Straight(), REASONS)
    stations = walked(section.edge)
    (station,) = ProbeGait(settings(coasting)).stride(section, stations)
    assert station.stop is REASONS[0]
    assert len(section.predicted) == coasting + 1
    assert np.array_equal(station.frame.origin, stations[-1].frame.origin)


def test_bad_lines_are_passed_over_round_a_circle():
    section = Known(Circle(8.0), REASONS[:2])
    (station,) = ProbeGait(settings(steering="curvature")).stride(section, walked(section.edge))
    assert section.edge.nearest(station.frame.origin[0]) == pytest.approx(3.0 * PITCH)
    assert section.edge.off(section.predicted[-1].origin[0]) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("reason", [Stop.CMM_FAILED, Stop.CANCELLED])
@pytest.mark.parametrize("before", [0, 1, 2])
def test_a_machine_that_failed_is_not_asked_again(reason, before):
    """Its failure is the reason, whatever was passed over before."""
    section = Known(Straight(), [*REASONS[:before], reason])
    (station,) = ProbeGait(settings()).stride(section, walked(section.edge))
    assert station.stop is reason
    assert len(section.predicted) == before + 1


def test_a_walk_over_a_gap_goes_on_with_the_pitch_it_was_given():
    section = Known(Straight(), [None, None, *REASONS[:2]])
    found = walk(section, section.station(0.0), ProbeGait(settings()), limit=6)
    places = [section.edge.nearest(station.frame.origin[0]) for station in found.stations]
    assert np.array(places) / PITCH == pytest.approx([1.0, 2.0, 5.0, 6.0, 7.0, 8.0])
