# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bounds for the parameters of a probed scan, against table 1 worked out by hand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from freecad_edgescan.experiments.doe_design import EXPERIMENTS, TESTS, trial
from freecad_edgescan.scanning.errors import ScanError
from freecad_edgescan.scanning.guidelines import Guidelines, Limit, check_possible
from freecad_edgescan.scanning.parameters import ScanParameters
from freecad_edgescan.scanning.surroundings import Surroundings

# R = 21, R_p = 1: r = 20 mm. sin φ = 21 · sin 30° / 21 = 1/2, φ = 30°, df = 2 · π/6 · 1 mm.
PIPE = Surroundings(
    section_radius=21.0,
    angle=np.radians(120.0),
    fillet_radius=0.0,
    probe_radius=1.0,
    cloud_pitch=0.2,
    noise_level=0.05,
)
ROUNDING = np.pi / 3.0


def values(guidelines: Guidelines) -> dict[tuple[str, str], list[float]]:
    """Values of the bounds by parameter and limit."""
    found: dict[tuple[str, str], list[float]] = {}
    for bound in guidelines.bounds:
        found.setdefault((bound.parameter, bound.limit.value), []).append(bound.value)
    return found


@pytest.mark.parametrize(
    ("degree", "longest", "best", "largest_pitch", "best_pitch"),
    [(1, 0.2, 0.16, 0.022, 0.003), (2, 1.2, 0.8, 0.133, 0.013)],
)
def test_the_bounds_are_those_of_table_1(
    degree: int, longest: float, best: float, largest_pitch: float, best_pitch: float
) -> None:
    bounds = values(Guidelines.of(PIPE, degree, line_pitch=0.4))
    assert bounds["amplitude", "minimum"] == pytest.approx([3.0 * ROUNDING, 2.4 + ROUNDING])
    assert bounds["amplitude", "maximum"] == pytest.approx([longest * 20.0 + ROUNDING])
    assert bounds["amplitude", "optimum"] == pytest.approx([best * 20.0 + ROUNDING])
    assert bounds["cloud_pitch", "maximum"] == pytest.approx([largest_pitch * 20.0])
    assert bounds["cloud_pitch", "optimum"] == pytest.approx([best_pitch * 20.0])
    assert bounds["line_pitch", "minimum"] == pytest.approx([0.3])
    assert bounds["edge_pitch", "minimum"] == pytest.approx([0.3])
    assert bounds["edge_pitch", "optimum"] == pytest.approx([0.4])
    assert bounds["tolerance", "minimum"] == pytest.approx([0.05 + 0.2 * 0.17364818])


def test_the_least_amplitude_leaves_three_points_on_each_side() -> None:
    """The printed 5.3.4.6.2 does not; with its sign put right s / ρ_L is 3 exactly."""
    around = replace(PIPE, fillet_radius=2.0)
    (bound,) = (b for b in Guidelines.of(around, 2, 0.5).bounds if "5.3.4.6.2" in b.equation)
    assert around.line_section(bound.value) / 0.5 == pytest.approx(3.0)


def test_the_case_study_s_largest_pitch_comes_out() -> None:
    """Appendix F: a pipe of 17 mm radius may be scanned up to 2.261 mm, best at 0.221 mm."""
    around = replace(PIPE, section_radius=17.0, probe_radius=0.0)
    bounds = values(Guidelines.of(around, 2))
    assert bounds["cloud_pitch", "maximum"] == pytest.approx([2.261])
    assert bounds["cloud_pitch", "optimum"] == pytest.approx([0.221])


def test_every_bound_says_where_it_comes_from_and_why() -> None:
    for bound in Guidelines.of(PIPE, 2).bounds:
        assert bound.equation in bound.text()
        assert bound.sentence.endswith(".")
        assert isinstance(bound.limit, Limit)


def test_planes_leave_the_amplitude_open() -> None:
    flat = Guidelines.of(replace(PIPE, section_radius=np.inf), 2, 0.4)
    assert flat.most("amplitude") == np.inf
    assert flat.least("amplitude") == pytest.approx(2.4 + ROUNDING)
    assert not flat.contradictions


def test_contradictory_bounds_are_said_with_their_numbers() -> None:
    rounded = replace(PIPE, fillet_radius=6.0)
    guidelines = Guidelines.of(rounded, 1, 0.4)
    (sentence,) = guidelines.contradictions
    assert f"{guidelines.least('amplitude'):.4g}" in sentence
    assert f"{guidelines.most('amplitude'):.4g}" in sentence
    assert "5.3.4.6.1" in sentence
    assert "5.3.4.6.4" in sentence
    assert guidelines.best("amplitude") == guidelines.least("amplitude")
    assert not Guidelines.of(PIPE, 2, 0.4).contradictions


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("amplitude", 2.0, "below the guideline of 3.142 mm"),
        ("amplitude", 30.0, "above the guideline of 25.05 mm"),
        ("line_pitch", 0.25, "below the guideline of 0.3 mm"),
        ("edge_pitch", 0.25, "below the guideline of 0.3 mm"),
        ("tolerance", 0.08, "below the guideline of 0.08473 mm"),
        ("cloud_pitch", 3.0, "above the guideline of 2.66 mm"),
    ],
)
def test_what_breaks_a_guideline_is_warned_of(name: str, value: float, words: str) -> None:
    keeping = ScanParameters(
        amplitude=16.0, line_pitch=0.4, edge_pitch=0.4, tolerance=0.1, cloud_pitch=0.2
    )
    guidelines = Guidelines.of(PIPE, 2, 0.4)
    assert guidelines.warnings(keeping) == ()
    warnings = guidelines.warnings(replace(keeping, **{name: value}))
    assert any(words in sentence for sentence in warnings)
    assert all(name.replace("_", " ") in sentence for sentence in warnings)


def test_none_of_the_published_experiments_is_refused() -> None:
    for row in (trial(experiment, test) for experiment in EXPERIMENTS for test in TESTS):
        for degree in (1, 2):
            check_possible(
                ScanParameters(
                    amplitude=row.amplitude,
                    line_pitch=row.line_pitch,
                    edge_pitch=row.edge_pitch,
                    cloud_pitch=row.cloud_pitch,
                    degree=degree,
                )
            )


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"amplitude": 6.0, "line_pitch": 1.0, "degree": 2}, "makes 3 points.*more than 3"),
        ({"amplitude": 4.0, "line_pitch": 1.0, "degree": 1}, "makes 2 points.*more than 2"),
        ({"line_pitch": 0.1, "cloud_pitch": 0.2}, "line pitch of 0.1 mm is below.*0.2 mm"),
        ({"edge_pitch": 0.1, "cloud_pitch": 0.2}, "edge pitch of 0.1 mm is below.*0.2 mm"),
    ],
)
def test_the_impossible_is_refused_with_the_numbers(values: dict[str, float], words: str) -> None:
    with pytest.raises(ScanError, match=words):
        check_possible(ScanParameters(**values))  # type: ignore[arg-type]


def test_just_possible_is_possible() -> None:
    check_possible(ScanParameters(amplitude=6.01, line_pitch=1.0, degree=2, cloud_pitch=1.0))
    check_possible(ScanParameters(line_pitch=0.1))
