# SPDX-License-Identifier: LGPL-2.1-or-later
import dataclasses

import numpy as np
import pytest

from freecad_edgescan.scanning import (
    Compensation,
    Pattern,
    ScanError,
    ScanParameters,
    Steering,
    Tangent,
)

LENGTHS = (
    "amplitude",
    "line_pitch",
    "edge_pitch",
    "chord_height",
    "tolerance",
    "prehit_distance",
    "search_distance",
    "cloud_pitch",
)


def test_everything_is_automatic_unless_given():
    assert ScanParameters().given() == {}
    given = ScanParameters(amplitude=4.0, degree=2).given()
    assert given == {"amplitude": 4.0, "degree": 2}


def test_the_names_are_the_published_ones():
    names = {field.name for field in dataclasses.fields(ScanParameters)}
    others = {"degree", "pattern", "tangent", "steering", "compensation", "probe_radius"}
    assert names == set(LENGTHS) | others | {"approach", "safeguards"}


def test_choices_are_taken_as_plain_strings():
    given = ScanParameters(
        pattern="zigzag",
        tangent="planes",
        steering="curvature",
        compensation="intersection_printed",
    )
    assert given.pattern is Pattern.ZIGZAG
    assert given.tangent is Tangent.PLANES
    assert given.steering is Steering.CURVATURE
    assert given.compensation is Compensation.INTERSECTION_PRINTED
    assert ScanParameters(pattern=Pattern.SQUARE).pattern == "square"


@pytest.mark.parametrize("name", LENGTHS)
@pytest.mark.parametrize("value", [0.0, -1.5, float("nan"), float("inf"), "wide"])
def test_a_length_is_a_positive_number(name, value):
    with pytest.raises(ScanError) as refused:
        ScanParameters(**{name: value})
    sentence = str(refused.value)
    assert name.replace("_", " ") in sentence
    assert repr(value) in sentence
    assert "positive length in mm" in sentence


@pytest.mark.parametrize(
    "value",
    [
        -0.5,
        float("nan"),
        float("inf"),
        pytest.param(
            "1 mm",
        ),
    ],
)
def test_a_probe_radius_is_no_negative_and_no_text(value):
    with pytest.raises(ScanError) as refused:
        ScanParameters(probe_radius=value)
    assert repr(value) in str(refused.value)


def test_a_probe_of_no_radius_is_allowed():
    assert ScanParameters(probe_radius=0.0).probe_radius == 0.0


@pytest.mark.parametrize("value", [0, 4, 1.5, "two"])
def test_a_degree_is_1_2_or_3(value):
    with pytest.raises(ScanError, match=r"degree is .*give 1 \(line\)"):
        ScanParameters(degree=value)


@pytest.mark.parametrize(
    ("name", "known"),
    [
        ("pattern", "'square', 'zigzag'"),
        ("tangent", "'interpolation', 'planes', 'polynomials'"),
        ("steering", "'tangent', 'curvature'"),
        ("compensation", "'point', 'curve', 'intersection', 'intersection_printed'"),
    ],
)
def test_an_unknown_choice_is_answered_with_the_known_ones(name, known):
    with pytest.raises(ScanError, match=f"{name} is 'round'; choose one of {known}"):
        ScanParameters(**{name: "round"})


def test_an_approach_is_a_direction_of_any_length():
    assert ScanParameters(approach=(0, 0, -5)).approach == pytest.approx([0, 0, -1])


@pytest.mark.parametrize(
    "value",
    [
        (0, 0, 0),
        (0, 1),
        (0, 0, np.nan),
        pytest.param(
            "down",
        ),
    ],
)
def test_an_approach_without_a_direction_is_refused(value):
    with pytest.raises(ScanError, match="approach is"):
        ScanParameters(approach=value)


def test_equal_parameters_are_equal():
    one, other = (ScanParameters(amplitude=4.0, approach=(0, 0, -1)) for _ in range(2))
    assert one == other
    assert one != ScanParameters(amplitude=4.0, approach=(0, 0, 1))
