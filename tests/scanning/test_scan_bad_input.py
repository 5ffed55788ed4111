# SPDX-License-Identifier: LGPL-2.1-or-later
"""What cannot be scanned is refused in a sentence with the value and the way out."""

import re

import numpy as np
import pytest

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.scanning import Gate, ScanError, ScanParameters, Start, scan_edge


@pytest.fixture(scope="module")
def part(wedge):
    return wedge(90.0, width=20.0)


def refusal(cloud, *args, kind=ScanError, **more):
    with pytest.raises(kind) as refused:
        scan_edge(cloud, *args, **more)
    return str(refused.value)


def numbers(sentence):
    return [float(x) for x in re.findall(r"-?\d+\.?\d*(?:e[+-]?\d+)?", sentence)]


def test_every_refusal_of_the_scan_is_a_value_error():
    assert issubclass(ScanError, ValueError)


@pytest.mark.parametrize(
    ("points", "words"),
    [
        (np.random.default_rng(0).random((19, 3)), "19 points.*at least 20"),
        (np.full((50, 3), 2.5), r"All 50 points.*equal \(2.5, 2.5, 2.5\)"),
        (np.outer(np.arange(50.0), [1, 2, 3]), "on one line"),
        (np.random.default_rng(0).random((500, 3)) * [30, 20, 0], "on one plane"),
    ],
    ids=["few", "equal", "line", "plane"],
)
def test_a_cloud_without_a_surface_has_no_edge(points, words):
    assert re.search(words, refusal(PointCloud(points), points[0], kind=ValueError))


@pytest.mark.parametrize("cloud", [None, np.zeros((100, 3)), "part.ply"])
def test_what_is_no_cloud_is_answered_with_how_to_make_one(cloud):
    sentence = refusal(cloud, (0, 0, 0))
    assert type(cloud).__name__ in sentence
    assert "read_cloud" in sentence


@pytest.mark.parametrize(
    "click",
    [
        (np.nan, 0, 0),
        (np.inf, 0, 0),
        (1.0, 2.0),
        [[1, 2, 3]],
        None,
        pytest.param(
            "here",
        ),
    ],
)
def test_a_click_is_three_finite_numbers(part, click):
    sentence = refusal(part.cloud, click)
    assert "click" in sentence
    assert "three" in sentence


def test_a_click_off_the_cloud_says_how_far_and_where_the_cloud_is(part):
    click = part.middle + np.array([100.0, 0.0, 0.0])
    sentence = refusal(part.cloud, click)
    distance = np.linalg.norm(part.cloud.points - click, axis=1).min()
    assert f"{distance:.3g} mm away" in sentence
    low, high = part.cloud.bounds
    for value in (*low, *high):
        assert f"{value:.4g}" in sentence


@pytest.mark.parametrize("aside", [16.0, 18.0])
def test_a_click_on_a_flat_place_says_how_far_the_nearest_edge_is(part, aside):
    sentence = refusal(part.cloud, part.at(0.1, aside))
    assert "smooth" in sentence
    named = float(re.search(r"([\d.]+) mm away", sentence).group(1))
    assert named == pytest.approx(aside, abs=1.5)
    place = numbers(re.search(r"at \((.*)\)", sentence).group(1))
    assert part.distance([place])[0] < 0.2


def test_a_click_on_a_smooth_part_says_how_far_has_been_looked():
    rng = np.random.default_rng(2)
    u, v = rng.uniform(0.2, 1.4, 6000), rng.uniform(0, 2 * np.pi, 6000)
    ball = 30 * np.column_stack([np.cos(u) * np.cos(v), np.cos(u) * np.sin(v), np.sin(u)])
    sentence = refusal(PointCloud(ball), ball[10])
    assert "no edge" in sentence
    assert "smooth" in sentence
    assert "mm" in sentence


def test_the_edge_of_a_sheet_alone_is_no_edge_between_surfaces(wedge):
    """A plane with noise ends somewhere, but no second surface meets it there."""
    rng = np.random.default_rng(4)
    sheet = np.column_stack([rng.uniform(0, 30, (4000, 2)), 0.02 * rng.normal(size=4000)])
    assert "smooth" in refusal(PointCloud(sheet), (15.0, 0.2, 0.0))


def test_an_edge_pitch_below_the_cloud_pitch_is_refused_with_both(part):
    sentence = refusal(part.cloud, part.at(), parameters=ScanParameters(edge_pitch=0.2))
    assert "edge pitch of 0.2 mm" in sentence
    named = float(re.search(r"cloud pitch of ([\d.]+) mm", sentence).group(1))
    assert named == pytest.approx(0.5, rel=0.15)
    assert "at least" in sentence


def test_an_amplitude_without_room_for_two_sides_is_refused_with_the_least_one(part):
    sentence = refusal(part.cloud, part.at(), parameters=ScanParameters(amplitude=1.2))
    assert "amplitude of 1.2 mm" in sentence
    assert float(re.search(r"at least ([\d.]+) mm", sentence).group(1)) > 1.2


@pytest.mark.parametrize("radius", [30.0, 1e6])
def test_a_probe_larger_than_the_part_is_refused(part, radius):
    sentence = refusal(
        part.cloud, part.at(), parameters=ScanParameters(probe_radius=radius, approach=(0, 0, 1))
    )
    assert f"probe radius of {radius:g} mm" in sentence
    assert "unit" in sentence


def test_a_probe_radius_as_large_as_a_given_side_is_refused(part):
    asked = ScanParameters(amplitude=8.0, probe_radius=4.0, approach=(0, 0, 1))
    sentence = refusal(part.cloud, part.at(), parameters=asked)
    assert "probe radius of 4 mm" in sentence
    assert "amplitude 8 mm" in sentence


def test_an_unknown_method_is_answered_with_the_known_one(part):
    sentence = refusal(part.cloud, part.at(), method="magic")
    assert "'magic'" in sentence
    assert "'patch'" in sentence


def test_a_gate_behind_the_start_is_refused_with_how_far(part):
    start = Start(part.at(0.1, 5.0), -part.sides[0], part.along)
    gate = Gate(part.at(-0.2, 5.0), -part.sides[0])
    sentence = refusal(part.cloud, start, gate, ScanParameters(amplitude=10.0))
    assert "12 mm behind" in sentence
    assert "move the gate" in sentence


def test_a_point_as_gate_behind_the_start_is_refused_too(part):
    start = Start(part.at(0.1, 5.0), -part.sides[0], part.along)
    sentence = refusal(part.cloud, start, part.at(-0.05), ScanParameters(amplitude=10.0))
    assert "behind" in sentence


@pytest.mark.parametrize("gate", [(1, 2), (np.nan, 0, 0)])
def test_a_gate_is_a_gate_or_three_finite_numbers(part, gate):
    sentence = refusal(part.cloud, part.at(), gate)
    assert "gate is" in sentence
    assert "three finite" in sentence


def test_a_start_far_from_the_cloud_is_refused_with_the_distance(part):
    start = Start(part.middle + 200.0, (1, 0, 0), (0, 1, 0))
    assert "mm away from the nearest point" in refusal(part.cloud, start)


def test_a_start_whose_direction_fits_no_edge_is_refused(part):
    """It asks for an edge across the one there is."""
    start = Start(part.at(0.0, 5.0), part.along, part.sides[0])
    assert "no edge" in refusal(part.cloud, start, parameters=ScanParameters(amplitude=10.0))


@pytest.mark.parametrize("least", [0.0, -0.3, np.nan, 4.0])
def test_a_least_angle_is_one_between_surfaces(part, least):
    assert "angle" in refusal(part.cloud, part.at(), min_angle=least)


def test_parameters_that_have_no_effect_are_named(part):
    asked = ScanParameters(
        line_pitch=0.5,
        tolerance=0.1,
        degree=2,
        pattern="square",
        tangent="planes",
        steering="tangent",
        compensation="point",
        prehit_distance=1.0,
        search_distance=5.0,
    )
    message = scan_edge(part.cloud, part.at(), parameters=asked).message
    for name in asked.given():
        assert name.replace("_", " ") in message
    used = ScanParameters(amplitude=8.0, edge_pitch=1.5, chord_height=0.1)
    message = scan_edge(part.cloud, part.at(), parameters=used).message
    for name in used.given():
        assert name.replace("_", " ") not in message


def test_a_cloud_pitch_has_no_effect_and_is_named(part):
    asked = ScanParameters(cloud_pitch=0.7)
    assert "cloud pitch" in scan_edge(part.cloud, part.at(), parameters=asked).message


@pytest.mark.parametrize("pitches", [12, 20, 28])
def test_a_click_on_a_flat_side_does_not_mean_an_edge_farther_off(wedge, pitches):
    part = wedge(90.0, width=20.0)
    sentence = refusal(part.cloud, part.at(0.0, 0.5 * pitches))
    assert "nearest edge" in sentence
    assert f"{0.5 * pitches:.2g}" in sentence


def test_a_surface_that_is_there_twice_is_said():
    """Two scans of one part that do not match, a millimetre apart."""
    rng = np.random.default_rng(0)
    count = 4800
    along, away = rng.uniform(0, 60, (2, count)), rng.uniform(-20, 0, (2, count))
    zero = np.zeros(count)
    once = np.vstack(
        [np.column_stack([along[0], away[0], zero]), np.column_stack([along[1], zero, away[1]])]
    )
    twice = np.vstack([once, once - [0, 1, 1]]) + rng.normal(0, 0.05, (4 * count, 3))
    assert "there twice" in scan_edge(PointCloud(twice), (30, 0, 0)).message
    assert "there twice" not in scan_edge(PointCloud(twice[: 2 * count]), (30, 0, 0)).message


@pytest.mark.parametrize(
    ("at", "ends"),
    [((11.0, 16.0, 0.0), True), ((16.0, 0.3, 0.0), True), ((26.0, 26.0, 0.0), False)],
    ids=["hole", "rim", "middle"],
)
def test_at_the_border_of_the_cloud_a_missing_side_is_named(at, ends):
    """A plane with a hole in it, without the wall of the hole."""
    rng = np.random.default_rng(3)
    x, y = 0.4 * (np.indices((80, 80)).reshape(2, -1) + rng.uniform(0.15, 0.85, (2, 6400)))
    plane = np.column_stack([x, y, rng.normal(scale=0.02, size=len(x))])
    said = refusal(PointCloud(plane[np.hypot(x - 16.0, y - 16.0) > 5.0]), at=at)
    assert "is smooth for" in said
    assert ("an edge needs both of its sides in the cloud" in said) == ends
