# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a probed scan takes for the values nobody gave."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from freecad_edgescan.cloud import PointCloud, TorusObject
from freecad_edgescan.scanning import ScanError, ScanParameters, Start, scan_edge
from freecad_edgescan.scanning import recommended as rules
from freecad_edgescan.scanning.automatic import MIN_ANGLE
from freecad_edgescan.scanning.edge_site import measure_site
from freecad_edgescan.scanning.recommended import choose_probe_parameters, complete_for_cmm

TORUS = TorusObject(30.0, 60.0, np.radians(110.0), fillet_radius=1.0, probe_radius=1.0)
PITCH, NOISE = 0.4, 0.02
GIVEN = ScanParameters(
    amplitude=12.0, line_pitch=0.7, edge_pitch=0.9, tolerance=0.1, degree=2, cloud_pitch=0.4
)


@pytest.fixture(scope="module")
def cloud() -> PointCloud:
    return TORUS.cloud(PITCH, 24.0, NOISE, seed=3)


def on_edge(azimuth: float) -> np.ndarray:
    return np.array([60.0 * np.cos(azimuth), 60.0 * np.sin(azimuth), -30.0])


def click(cloud: PointCloud, given: ScanParameters | None = None) -> tuple[Any, Any, Any]:
    return choose_probe_parameters(cloud, on_edge(1.2), given or ScanParameters(), MIN_ANGLE)


def test_what_is_measured_is_true(cloud: PointCloud) -> None:
    around = measure_site(cloud, on_edge(1.2), ScanParameters(), MIN_ANGLE).around
    assert around.section_radius == pytest.approx(30.0, rel=0.03)
    assert around.angle == pytest.approx(TORUS.angle, abs=np.radians(0.5))
    assert around.fillet_radius == pytest.approx(1.0, abs=0.2)
    assert around.probe_radius == 1.0
    assert around.cloud_pitch == pytest.approx(PITCH, rel=0.25)
    assert around.noise_level == pytest.approx(NOISE, rel=0.1)
    assert around.convex


def test_a_click_gets_every_value_and_its_reason(cloud: PointCloud) -> None:
    parameters, reasons, start = click(cloud)
    optional = {"chord_height", "tangent", "steering", "compensation", "safeguards"}
    assert set(parameters.given()) == set(vars(parameters)) - optional
    assert set(reasons) == set(parameters.given())
    assert all(reasons.values())
    assert parameters.degree == 2
    assert parameters.line_pitch >= 1.5 * parameters.cloud_pitch
    assert parameters.prehit_distance == pytest.approx(4.0 * parameters.cloud_pitch)
    # the first line starts half an amplitude along the surface from the edge
    centre = np.array([60.0 * np.cos(1.2), 60.0 * np.sin(1.2), 0.0])
    gap = np.linalg.norm(start.point - cloud.points, axis=1).min()
    assert gap == 0.0
    assert np.linalg.norm(start.point - on_edge(1.2)) == pytest.approx(
        0.5 * parameters.amplitude, rel=0.2
    )
    assert start.across @ (on_edge(1.2) - start.point) > 0.0
    assert abs(start.along @ centre) / 60.0 < 0.05


def test_what_is_given_is_kept(cloud: PointCloud) -> None:
    parameters, reasons, _ = click(cloud, GIVEN)
    for name, value in GIVEN.given().items():
        assert getattr(parameters, name) == value
        assert reasons[name] == "given"


def test_a_scan_from_a_click_is_as_good_as_expected(cloud: PointCloud) -> None:
    site = measure_site(cloud, on_edge(1.2), ScanParameters(), MIN_ANGLE)
    expected = rules.choose_for_site(site, ScanParameters()).expected
    edge = scan_edge(cloud, on_edge(1.2), gate=on_edge(1.5), method="probe")
    error = np.hypot(np.hypot(*edge.points[:, :2].T) - 60.0, edge.points[:, 2] + 30.0)
    assert len(edge) > 20
    assert np.sqrt(np.mean(error**2)) < 2.0 * expected.total
    assert expected.total < 0.05


def test_nothing_is_measured_when_nothing_is_missing(
    cloud: PointCloud, monkeypatch: pytest.MonkeyPatch
) -> None:
    def measured(*_: object) -> None:
        raise AssertionError("the cloud was measured")

    monkeypatch.setattr(rules, "measure_site", measured)
    bare = PointCloud(cloud.points[:2000], 1.0, (0, 0, -1))
    start = Start(*TORUS.start(12.0))
    parameters, reasons, same = choose_probe_parameters(bare, start, GIVEN, MIN_ANGLE)
    assert same is start
    assert not {"tree", "pitch", "noise"} & set(vars(bare))
    assert parameters.probe_radius == 1.0
    assert parameters.approach == (0.0, 0.0, -1.0)
    assert parameters.prehit_distance == pytest.approx(1.6)
    assert parameters.search_distance == 30.0
    assert set(reasons) == set(parameters.given())


def test_planes_are_scanned_with_lines_and_bent_surfaces_with_quadratics() -> None:
    rng = np.random.default_rng(1)
    flat = rng.uniform([-20.0, 0.0], [20.0, 20.0], (8000, 2))
    turn = np.radians(80.0)
    one = np.column_stack([flat[:, 0], flat[:, 1], 0.02 * rng.standard_normal(8000)])
    other = np.column_stack([flat[:, 0], flat[:, 1], 0.02 * rng.standard_normal(8000)])
    way, normal = [0.0, -np.cos(turn), -np.sin(turn)], [0.0, -np.sin(turn), np.cos(turn)]
    other = other[:, :1] * [1, 0, 0] + other[:, 1:2] * way + other[:, 2:] * normal
    wedge = PointCloud(np.vstack([one, other]))
    parameters, reasons, _ = choose_probe_parameters(
        wedge, (0.0, 0.0, 0.0), ScanParameters(), MIN_ANGLE
    )
    assert parameters.degree == 1
    assert "quadratic" in reasons["degree"]
    # without an approach the probe comes from outside the smaller wedge
    assert np.asarray(parameters.approach) @ [0.0, 1.0 - np.cos(turn), -np.sin(turn)] > 0.5


def test_points_are_told_from_the_rounding_by_a_narrow_tolerance(cloud: PointCloud) -> None:
    """The printed guideline counts what projection adds; it is kept where points are projected."""
    wide = click(cloud, ScanParameters.literal())[0]
    narrow = click(cloud)[0]
    assert NOISE < narrow.tolerance < 3.0 * NOISE
    assert wide.tolerance > NOISE + PITCH * np.sin(np.radians(10.0))


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"line_pitch": 0.2, "cloud_pitch": 0.4}, "line pitch of 0.2 mm is below"),
        ({"amplitude": 4.0, "line_pitch": 1.0}, "degree 2 needs more than 3"),
    ],
)
def test_the_impossible_is_refused_before_anything_is_touched(
    cloud: PointCloud, values: dict[str, float], words: str
) -> None:
    start = Start(*TORUS.start(12.0))
    with pytest.raises(ScanError, match=words):
        choose_probe_parameters(cloud, start, replace(GIVEN, **values), MIN_ANGLE)  # type: ignore[arg-type]


class Machine:
    """What `complete_for_cmm` asks of a machine."""

    probe_radius = 1.5
    approach = np.array([0.0, 0.0, -1.0])


def test_a_machine_needs_the_amplitude_only() -> None:
    with pytest.raises(ScanError, match="needs the amplitude"):
        complete_for_cmm(Machine(), ScanParameters())  # type: ignore[arg-type]
    parameters, reasons = complete_for_cmm(Machine(), ScanParameters(amplitude=16.0, degree=1))  # type: ignore[arg-type]
    assert (parameters.line_pitch, parameters.edge_pitch) == (1.0, 1.0)
    assert (parameters.tolerance, parameters.degree) == (0.32, 1)
    assert (parameters.prehit_distance, parameters.search_distance) == (2.0, 30.0)
    assert (parameters.probe_radius, parameters.approach) == (1.5, (0.0, 0.0, -1.0))
    assert set(reasons) == set(parameters.given())
    assert reasons["amplitude"] == "given"
