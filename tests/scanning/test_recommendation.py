# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recommendations for an edge, on objects whose truth is known."""

from __future__ import annotations

import numpy as np
import pytest

import freecad_edgescan as es
from freecad_edgescan.scanning import Recommendation
from freecad_edgescan.scanning.guidelines import Guidelines
from freecad_edgescan.scanning.surroundings import Surroundings

TORUS = es.TorusObject(30.0, 60.0, np.radians(110.0), fillet_radius=1.0, probe_radius=1.0)
EDGE = (0.0, 60.0, -30.0)
NOISE = 0.02


@pytest.fixture(scope="module")
def torus() -> es.PointCloud:
    return TORUS.cloud(0.4, 24.0, NOISE, seed=3)


@pytest.fixture(scope="module")
def found(torus: es.PointCloud) -> Recommendation:
    return es.recommend_parameters(torus, EDGE)


def roof(noise: float = 0.02, angle: float = np.radians(100.0)) -> es.PointCloud:
    """Two planes on a regular grid that meet in the x axis."""
    along, away = np.meshgrid(np.arange(-15.0, 15.0, 0.3), np.arange(0.15, 12.0, 0.3))
    rng = np.random.default_rng(2)
    sides = []
    for sign in (1.0, -1.0):
        way = np.array([0.0, sign * np.sin(0.5 * angle), -np.cos(0.5 * angle)])
        normal = np.array([0.0, sign * np.cos(0.5 * angle), np.sin(0.5 * angle)])
        height = noise * rng.standard_normal(along.size)
        flat = np.outer(along.ravel(), (1.0, 0.0, 0.0)) + np.outer(away.ravel(), way)
        sides.append(flat + np.outer(height, normal))
    return es.PointCloud(np.vstack(sides), approach=(0.0, 0.0, -1.0))


def test_the_measured_quantities_are_near_the_truth(found: Recommendation) -> None:
    assert found.section_radius == pytest.approx(30.0, rel=0.03)
    assert found.angle == pytest.approx(TORUS.angle, abs=np.radians(0.5))
    assert found.fillet_radius == pytest.approx(1.0, abs=0.2)
    assert found.cloud_pitch == pytest.approx(0.4, rel=0.25)
    assert found.noise_level == pytest.approx(NOISE, rel=0.1)


def test_the_scan_uses_what_is_recommended(torus: es.PointCloud, found: Recommendation) -> None:
    edge = es.scan_edge(torus, EDGE, gate=(-20.0, 56.57, -30.0), method="probe")
    assert edge.parameters == found.parameters
    assert edge.reasons == found.reasons


@pytest.mark.parametrize("method", ["probe", "patch"])
def test_the_error_to_expect_comes_true(torus: es.PointCloud, method: str) -> None:
    found = es.recommend_parameters(torus, EDGE, method=method)
    gate = (-40.0, np.sqrt(2000.0), -30.0)
    edge = es.scan_edge(torus, EDGE, gate=gate, parameters=found.parameters, method=method)
    x, y, z = edge.points.T
    error = np.sqrt(np.mean((np.hypot(x, y) - 60.0) ** 2 + (z + 30.0) ** 2))
    assert found.expected_error == pytest.approx(np.hypot(found.model_bias, found.noise_error))
    assert 0.3 * found.expected_error < error < 2.0 * found.expected_error


def test_two_planes() -> None:
    found = es.recommend_parameters(roof(), (0.0, 0.0, 0.0))
    assert abs(found.section_radius) > 200.0
    assert found.angle == pytest.approx(np.radians(100.0), abs=np.radians(1.0))
    assert found.fillet_radius == 0.0
    assert found.noise_level == pytest.approx(0.02 * np.sqrt(3.0), rel=0.15)
    assert found.parameters.degree == 1
    assert not found.contradictions


def test_the_error_to_expect_is_the_error_there_is() -> None:
    """Also where it comes from touching the outermost of some points, as on planes."""
    cloud = roof()
    expected = es.recommend_parameters(cloud, (0.0, 0.0, 0.0)).expected_error
    edge = es.scan_edge(cloud, (0.0, 0.0, 0.0), method="probe")
    found = np.sqrt(np.mean(np.sum(edge.points[:, 1:] ** 2, axis=1)))
    assert 0.5 < found / expected < 2.0


def test_the_bounds_are_the_guidelines_of_what_was_measured(found: Recommendation) -> None:
    around = Surroundings(
        found.section_radius, found.angle, found.fillet_radius, 1.0, found.cloud_pitch, 0.0
    )
    expected = Guidelines.of(around, 2, found.parameters.line_pitch)
    amplitudes = [b.value for b in expected.bounds if b.parameter == "amplitude"]
    assert [b.value for b in found.bounds if b.parameter == "amplitude"] == amplitudes


def test_given_values_that_break_a_guideline_are_kept_and_warned_of(torus: es.PointCloud) -> None:
    given = es.ScanParameters(amplitude=6.0, tolerance=0.01)
    found = es.recommend_parameters(torus, EDGE, given)
    assert (found.parameters.amplitude, found.parameters.tolerance) == (6.0, 0.01)
    assert any("amplitude of 6 mm is below" in sentence for sentence in found.warnings)
    assert any("tolerance of 0.01 mm is below" in sentence for sentence in found.warnings)


def test_contradictory_guidelines_are_reported(torus: es.PointCloud) -> None:
    found = es.recommend_parameters(torus, EDGE, es.ScanParameters(degree=1, line_pitch=1.5))
    assert any("amplitude should be at least" in sentence for sentence in found.contradictions)
    assert found.contradictions[0] in found.text()


def test_patches_are_recommended_what_they_take(torus: es.PointCloud) -> None:
    found = es.recommend_parameters(torus, EDGE, method="patch")
    edge = es.scan_edge(torus, EDGE, gate=(-20.0, 56.57, -30.0))
    assert edge.parameters == found.parameters
    assert edge.reasons == found.reasons
    assert found.model_bias == 0.0


def test_the_text_tells_every_value_its_reason_and_the_error(found: Recommendation) -> None:
    text = found.text()
    for name, value in found.parameters.given().items():
        assert name.replace("_", " ") in text
        if isinstance(value, float):
            assert f"{value:.4g}" in text
    for reason in found.reasons.values():
        assert reason in text
    assert all(bound.equation in text for bound in found.bounds)
    assert f"Error to expect: {found.expected_error:.2g} mm" in text


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"at": EDGE, "method": "magic"}, "'magic'.*'patch' or 'probe'"),
        ({"at": EDGE, "min_angle": 4.0}, "between 0 and pi"),
        ({"at": (0.0, 60.0, 100.0)}, "away from the nearest point"),
        ({"at": EDGE, "parameters": es.ScanParameters(line_pitch=0.01)}, "below the cloud pitch"),
    ],
)
def test_bad_input_is_said(torus: es.PointCloud, arguments: dict, words: str) -> None:
    with pytest.raises(es.ScanError, match=words):
        es.recommend_parameters(torus, **arguments)


def test_a_machine_has_nothing_to_measure() -> None:
    with pytest.raises(es.ScanError, match="PointCloud"):
        es.recommend_parameters(object(), EDGE)  # type: ignore[arg-type]
