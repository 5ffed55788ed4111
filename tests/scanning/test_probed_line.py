# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines across an edge, split, cleaned and intersected, against wedges and roundings known exactly.

Schreve 4.3, and 4.7.3 where the points run out.
"""

from dataclasses import dataclass

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from freecad_edgescan.scanning import ScanParameters, Stop
from freecad_edgescan.scanning.probe_settings import ProbeSettings
from freecad_edgescan.scanning.probed_line import (
    farthest_from_chord,
    measure_line,
    without_rounding,
)
from freecad_edgescan.scanning.safeguards import Safeguards

ANGLES = [np.radians(a) for a in (35.0, 90.0, 120.0, 165.0)]
DEGREES = [1, 2, 3]


def settings(degree=1, tolerance=0.02, literal=False, safeguards=None):
    values = ScanParameters(
        amplitude=10.0,
        line_pitch=0.5,
        edge_pitch=1.0,
        tolerance=tolerance,
        degree=degree,
        approach=(0.0, 0.0, -1.0),
        prehit_distance=1.0,
        search_distance=5.0,
        safeguards=Safeguards.none() if literal else safeguards,
    )
    return ProbeSettings.from_parameters(values, 0.26)


# ---------------------------------------------------------------- where a line is split


def arc_from_edge(first, radius, length, pitch):
    """Points (n, 2) along a circle from the origin, which is left in a direction that turns up."""
    turn = first + np.arange(1, round(length / pitch) + 1) * pitch / radius
    return radius * np.stack([np.sin(turn) - np.sin(first), np.cos(first) - np.cos(turn)], axis=1)


def chord_distance(points):
    """Distances from the straight line through the ends, by dropping perpendiculars."""
    chord = (points[-1] - points[0]) / np.linalg.norm(points[-1] - points[0])
    offset = points - points[0]
    return np.linalg.norm(offset - np.outer(offset @ chord, chord), axis=1)


@pytest.mark.parametrize("turn", [0.0, 1.0, 2.5, 4.0])
def test_a_line_is_split_at_the_point_farthest_from_its_chord(turn):
    rng = np.random.default_rng(3)
    x = np.linspace(-4.0, 5.0, 25)
    points = np.stack([x, -0.6 * np.abs(x - 0.7)], axis=1) + 0.02 * rng.normal(size=(25, 2))
    points = points @ [[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]]
    assert farthest_from_chord(points) == chord_distance(points).argmax()


@pytest.mark.parametrize("mirrored", [False, True], ids=["wedge below", "wedge above"])
@pytest.mark.parametrize("backward", [False, True], ids=["to the right", "to the left"])
@pytest.mark.parametrize("both", [False, True], ids=["one side curved", "both sides curved"])
def test_a_belly_farther_from_the_chord_than_the_edge_is_not_taken_for_it(mirrored, backward, both):
    """Concave sides, as of the torus object: only the edge stands out of the smaller wedge."""
    curved = arc_from_edge(-0.25 * np.pi, 5.0, 7.0, 0.25)
    other = curved if both else np.arange(1, 13)[:, None] * [0.25, -0.05]
    points = np.vstack([curved[::-1] * [-1.0, 1.0], [[0.0, 0.0]], other])
    edge = len(curved)
    wedge = -1.0
    if mirrored:
        points, wedge = points * [1.0, -1.0], 1.0
    if backward:
        points, edge = points[::-1], len(points) - 1 - edge
    assert chord_distance(points).argmax() != edge
    assert farthest_from_chord(points) == chord_distance(points).argmax()
    assert farthest_from_chord(points, wedge) == edge


# ---------------------------------------------------------------- a whole line


@dataclass(frozen=True)
class Wedge:
    """Two half-planes that meet in a straight edge, somewhere in space."""

    angle: float
    seed: int = 1

    @property
    def frame(self):
        """Tangent, direction across from side 0 to side 1, direction into the smaller wedge."""
        return Rotation.random(random_state=self.seed).as_matrix()

    @property
    def edge(self):
        return np.array([3.0, -20.0, 8.0]) * self.seed

    @property
    def sides(self):
        half = 0.5 * self.angle
        across, inward = np.array([-np.sin(half), np.sin(half)]), np.full(2, np.cos(half))
        return across[:, None] * self.frame[1] + inward[:, None] * self.frame[2]

    def contacts(self, away, along=0.0):
        """Points (n, 3), |away| from the edge: on side 0 where that is negative."""
        away = np.asarray(away)
        on = self.sides[(away > 0.0).astype(int)]
        return (
            self.edge
            + np.abs(away)[:, None] * on
            + np.broadcast_to(along, away.shape)[:, None] * self.frame[0]
        )

    def in_section(self, xy):
        """Points (n, 3) at coordinates across and out of the smaller wedge."""
        return self.edge + xy @ np.array([self.frame[1], -self.frame[2]])

    def measure(self, contacts, starts_on=0, beside=0.3, narrow=False, **values):
        tangent, across, inward = self.frame
        way = across if starts_on == 0 else -across
        origin = self.edge + beside * across + 0.2 * tangent  # where the edge was predicted
        return measure_line(
            contacts, origin, tangent, way, starts_on, settings(**values), inward, narrow
        )

    def off(self, point):
        """Distance of a point from the edge."""
        return np.linalg.norm(np.cross(point - self.edge, self.frame[0]))


BOTH_SIDES = np.arange(-4.9, 5.0, 0.5)  # none on the edge itself


@pytest.mark.parametrize("literal", [False, True])
@pytest.mark.parametrize("degree", DEGREES)
@pytest.mark.parametrize("angle", ANGLES)
def test_plane_sides_meet_in_the_edge(angle, degree, literal):
    wedge = Wedge(angle)
    line = wedge.measure(wedge.contacts(BOTH_SIDES), degree=degree, literal=literal)
    assert line.edge_point == pytest.approx(wedge.edge, abs=1e-8)
    assert line.rough_sides == pytest.approx(wedge.sides, abs=1e-8)
    split = np.setdiff1d(np.arange(20), np.concatenate([s.contacts for s in line.sections]))
    # The farthest point from the chord is given up (Schreve 4.3.2).
    assert len(split) == 1
    assert abs(BOTH_SIDES[split[0]]) == np.abs(BOTH_SIDES).min()
    assert all(section.kept.all() for section in line.sections)


@pytest.mark.parametrize("beside", [0.1, 0.3])
@pytest.mark.parametrize("angle", ANGLES)
def test_on_an_edge_known_to_be_sharp_the_farthest_point_stays_on_its_side(angle, beside):
    wedge, away = Wedge(angle), np.arange(-4.9, 5.0, 0.5) + beside
    line = wedge.measure(wedge.contacts(away), degree=2, narrow=True)
    for k, section in enumerate(line.sections):
        assert sorted(section.contacts) == sorted(np.flatnonzero(np.sign(away) == 2 * k - 1))
        gap = np.hypot(*(line.sections[0].points[-1] - line.sections[1].points[-1]))
        steps = np.abs(away[section.contacts])
        assert line.length(k) == pytest.approx(steps[0] - steps[-1] + 0.5 * gap, abs=1e-9)


@pytest.mark.parametrize("curved", [False, True], ids=["flat sides", "curved sides"])
def test_the_farthest_point_of_a_sharp_edge_lies_on_a_side(curved):
    wedge = Wedge(np.radians(100.0))
    contacts = wedge.contacts(BOTH_SIDES)
    if curved:
        side = arc_from_edge(wedge.angle / 2 - np.pi / 2, 12.0, 5.0, 0.5)
        contacts = wedge.in_section(np.vstack([side[::-1] * [-1.0, 1.0], [[0.0, 0.0]], side]))
    for narrow in (False, True):
        line = wedge.measure(contacts, degree=2, tolerance=1.0, narrow=narrow)
        assert line.split_off < (0.01 if curved else 1e-6)
        left_out = len(contacts) - sum(len(section.contacts) for section in line.sections)
        assert left_out == (0 if narrow else 1)


@pytest.mark.parametrize("narrow", [False, True])
@pytest.mark.parametrize("radius", [0.3, 1.2])
def test_a_farthest_point_on_a_rounding_is_given_up_even_within_the_tolerance(radius, narrow):
    wedge = Wedge(np.radians(100.0))
    contacts, away = filleted(wedge, radius)
    line = wedge.measure(contacts, degree=2, tolerance=1.0, narrow=narrow)
    # How far the top of a circle in the wedge stands off the sides drawn out, in line pitches.
    assert line.split_off > 0.3 * radius * (1.0 - np.sin(0.5 * wedge.angle)) / 0.5
    farthest = np.abs(away).argmin()
    assert all(farthest not in section.contacts for section in line.sections)
    assert len(line.contacts) == len(contacts)


@pytest.mark.parametrize("starts_on", [0, 1])
def test_sections_keep_their_surface_whichever_way_the_line_runs(starts_on):
    wedge = Wedge(np.radians(110.0))
    contacts = wedge.contacts(BOTH_SIDES)
    contacts = contacts[::-1] if starts_on else contacts
    line = wedge.measure(contacts, starts_on)
    assert line.ends_on == 1 - starts_on
    for section, side in zip(line.sections, wedge.sides, strict=True):
        away = (contacts[section.contacts] - wedge.edge) @ side
        assert (away > 0.0).all()
        assert (np.diff(away) < 0.0).all()  # from far away towards the edge
    assert line.edge_point == pytest.approx(wedge.edge, abs=1e-9)
    assert line.rough_sides == pytest.approx(wedge.sides, abs=1e-9)


@pytest.mark.parametrize("literal", [False, True])
def test_a_rounding_is_cleaned_away_and_the_sides_meet_where_they_would_without_it(literal):
    wedge, radius = Wedge(np.radians(100.0)), 1.2
    contacts, away = filleted(wedge, radius)
    line = wedge.measure(contacts, tolerance=1e-4, literal=literal)
    assert line.edge_point == pytest.approx(wedge.edge, abs=1e-3)
    begin = radius / np.tan(0.5 * wedge.angle)
    for section in line.sections:
        kept = np.abs(away[section.contacts][section.kept])
        assert kept.min() > 0.9 * begin
        assert kept.max() == pytest.approx(np.abs(away[section.contacts]).max())


def test_curves_of_higher_degree_follow_curved_sides_to_the_edge():
    wedge = Wedge(np.radians(100.0))
    side = arc_from_edge(wedge.angle / 2 - np.pi / 2, 12.0, 5.0, 0.5)
    xy = np.vstack([side[::-1] * [-1.0, 1.0], [[0.0, 0.0]], side])
    off = [
        wedge.off(wedge.measure(wedge.in_section(xy), degree=degree, tolerance=1.0).edge_point)
        for degree in DEGREES
    ]
    assert off[0] > 0.1
    assert off[1] < 0.1 * off[0]
    assert off[2] < 0.3 * off[1]


def test_curved_sides_give_up_points_far_from_the_edge_and_the_printed_algorithm_near_ones():
    """A line holds the tolerance over a part of a bent side only."""
    wedge = Wedge(np.radians(100.0))
    side = arc_from_edge(wedge.angle / 2 - np.pi / 2, 12.0, 5.0, 0.5)
    contacts = wedge.in_section(np.vstack([side[::-1] * [-1.0, 1.0], [[0.0, 0.0]], side]))
    line, printed = (wedge.measure(contacts, literal=literal) for literal in (False, True))
    for section, other in zip(line.sections, printed.sections, strict=True):
        assert section.kept[-1] and not section.kept[0]
        assert other.kept[0] and not other.kept[-1]
        assert np.abs(section.residuals()).max() <= 0.02 + 1e-5
    assert wedge.off(line.edge_point) < 0.3 * wedge.off(printed.edge_point)


# ---------------------------------------------------------------- lines that do not stay in a plane


def test_a_line_that_drifts_along_the_edge_is_moved_back_along_the_tangent():
    """Of a discrete cloud: each contact lies on its surface, but somewhere beside the plane."""
    wedge, rng = Wedge(np.radians(80.0)), np.random.default_rng(11)
    drift = rng.uniform(-0.8, 0.8, len(BOTH_SIDES)) + 0.05 * BOTH_SIDES**2
    line = wedge.measure(wedge.contacts(BOTH_SIDES, drift))
    assert line.ruling == pytest.approx(wedge.frame[0], abs=1e-12)
    assert wedge.off(line.edge_point) < 1e-9
    assert line.rough_sides == pytest.approx(wedge.sides, abs=1e-9)


@pytest.mark.parametrize("slopes", [(0.0, 0.0), (0.25, -0.25), (0.2, 0.6)])
def test_an_edge_point_lies_where_a_straight_drift_passes_the_edge(slopes):
    """As of zigzag lines, which have a kink where they pass a sharp edge."""
    wedge = Wedge(np.radians(80.0))
    drift = 0.7 + np.where(BOTH_SIDES < 0.0, slopes[0], slopes[1]) * np.abs(BOTH_SIDES)
    line = wedge.measure(wedge.contacts(BOTH_SIDES, drift))
    assert line.edge_point == pytest.approx(wedge.edge + 0.7 * wedge.frame[0], abs=1e-6)
    # Also away from the edge the line is known to run where it was scanned.
    for section in line.sections:
        assert line.place(section.points) == pytest.approx(
            wedge.contacts(BOTH_SIDES, drift)[section.contacts], abs=1e-6
        )


def test_the_printed_algorithm_moves_points_square_to_the_plane_that_fits_them_best():
    """Schreve eq. 4.3.1.1; where the line drifts, the edge point leaves the edge."""
    wedge, rng = Wedge(np.radians(80.0)), np.random.default_rng(11)
    drift = rng.uniform(-0.8, 0.8, len(BOTH_SIDES)) + 0.05 * BOTH_SIDES**2
    contacts = wedge.contacts(BOTH_SIDES, drift)
    line = wedge.measure(contacts, literal=True, tolerance=10.0)

    covariance = np.cov(contacts.T, bias=True) * len(contacts)
    least = np.linalg.eigvalsh(covariance)[0]
    out_of_plane = (contacts - line.origin) @ np.cross(*line.axes)
    assert (out_of_plane**2).sum() == pytest.approx(least, rel=1e-9)

    middle = contacts.mean(axis=0)
    normal = np.linalg.eigh(covariance)[1][:, 0]
    flat = contacts - np.outer((contacts - middle) @ normal, normal)
    split = np.linalg.norm(np.cross(flat - flat[0], flat[-1] - flat[0]), axis=1).argmax()
    feet, ways = [], []
    for part in (flat[:split], flat[split + 1 :]):
        feet.append(part.mean(axis=0))
        ways.append(np.linalg.svd(part - feet[-1])[2][0])
    steps = np.linalg.lstsq(np.array([ways[0], -ways[1]]).T, feet[1] - feet[0], rcond=None)[0]
    assert line.edge_point == pytest.approx(feet[0] + steps[0] * ways[0], abs=1e-9)
    assert wedge.off(line.edge_point) > 0.02


# ---------------------------------------------------------------- when the points run out


@pytest.mark.parametrize("literal", [False, True])
@pytest.mark.parametrize("count", [2, 3, 4, 5])
@pytest.mark.parametrize("degree", DEGREES)
def test_the_degree_is_reduced_on_a_side_with_too_few_points(degree, count, literal):
    """Schreve 4.7.3; the other side keeps its degree."""
    wedge = Wedge(np.radians(100.0))
    away = np.append(np.arange(-0.5 * count, 0.0, 0.5), np.arange(0.0, 5.0, 0.5))
    line = wedge.measure(wedge.contacts(away), degree=degree, literal=literal)
    first, second = line.sections
    assert (len(first.contacts), len(second.contacts)) == (count, 9)
    assert first.curve.degree == min(degree, count - 1)
    assert second.curve.degree == degree
    assert line.edge_point == pytest.approx(wedge.edge, abs=1e-8)


@pytest.mark.parametrize("degree", DEGREES)
@pytest.mark.parametrize(
    "away",
    [[-0.5, 0.0, 0.5, 1.0, 1.5, 2.0], [-2.0, -1.5, -1.0, -0.5, 0.0, 0.5], [-1.0, -0.5, 0.0, 0.5]],
    ids=["one point before the edge", "one point behind it", "four points in all"],
)
def test_a_line_with_one_point_on_a_side_has_too_few(away, degree):
    wedge = Wedge(np.radians(100.0))
    contacts = wedge.contacts(np.array(away))
    for literal in (False, True):
        found = wedge.measure(contacts, degree=degree, literal=literal)
        assert found is Stop.TOO_FEW_POINTS


def test_parallel_sides_have_no_edge():
    """A step: its two treads do not meet."""
    wedge = Wedge(np.radians(90.0))
    x = np.array([-3.0, -2.5, -2.0, -1.5, -1.0, -0.5, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0])
    contacts = wedge.in_section(np.stack([x, np.where(x < 0.0, 0.6, -0.6)], axis=1))
    assert wedge.measure(contacts, literal=True, tolerance=1e-3) is Stop.NO_EDGE


# ---------------------------------------------------------------- without the rounding


def filleted(wedge, radius, pitch=0.3, half_length=6.0):
    """Contacts (n, 3) over a wedge with a rounding, and their distances from the edge."""
    half = 0.5 * wedge.angle
    begin, arc = radius / np.tan(half), radius * (0.5 * np.pi - half)
    s = np.arange(-half_length, half_length + 0.5 * pitch, pitch) + 0.07
    turn, beyond = np.clip(s, -arc, arc) / radius, np.abs(s) - arc
    x = np.where(beyond > 0.0, np.sign(s) * (begin + beyond) * np.sin(half), radius * np.sin(turn))
    below = np.where(
        beyond > 0.0, (begin + beyond) * np.cos(half), radius / np.sin(half) - radius * np.cos(turn)
    )
    return wedge.in_section(np.stack([x, -below], axis=1)), np.sign(s) * np.hypot(x, below)


@pytest.mark.parametrize("degree", DEGREES)
@pytest.mark.parametrize("angle", ANGLES[1:3])
def test_without_its_rounding_a_line_shows_the_exact_edge(angle, degree):
    wedge, radius = Wedge(angle), 1.5
    contacts, away = filleted(wedge, radius)
    values = {"degree": degree, "tolerance": 0.1}
    line = wedge.measure(contacts, **values)
    begin = radius / np.tan(0.5 * angle)
    left = without_rounding(line, wedge.edge, [1.0001 * begin] * 2, settings(**values))
    for section in left.sections:
        from_edge = np.abs(away[section.contacts])
        assert (section.kept == (from_edge > begin)).all()
    assert wedge.off(left.edge_point) < 1e-8
    assert left.rough_sides == pytest.approx(wedge.sides, abs=1e-8)
    assert wedge.off(line.edge_point) > 100.0 * wedge.off(left.edge_point)


def test_a_side_on_which_no_rounding_begins_stays_as_it_was():
    wedge = Wedge(np.radians(100.0))
    contacts, _ = filleted(wedge, 1.5)
    values = {"degree": 2, "tolerance": 0.1}
    line = wedge.measure(contacts, **values)
    left = without_rounding(line, wedge.edge, [0.0, 1.6], settings(**values))
    assert left.sections[0] is line.sections[0]
    assert left.sections[1].kept.sum() < line.sections[1].kept.sum()
    assert without_rounding(line, wedge.edge, [0.0, 0.0], settings(**values)).edge_point == (
        pytest.approx(line.edge_point, abs=1e-12)
    )


@pytest.mark.parametrize("begin", [4.8, 100.0], ids=["too few for the degree", "nothing left"])
def test_a_line_of_which_too_little_would_be_left_stays_as_it_was(begin):
    wedge = Wedge(np.radians(100.0))
    contacts, _ = filleted(wedge, 0.5)
    values = {"degree": 3, "tolerance": 0.1}
    line = wedge.measure(contacts, **values)
    assert without_rounding(line, wedge.edge, [begin, 1.0], settings(**values)) is line
