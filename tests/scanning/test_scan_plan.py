# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a probed scan is made with, before anything is touched."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from freecad_edgescan.cloud import PointCloud, TorusObject
from freecad_edgescan.scanning import (
    PointCloudCmm,
    ScanError,
    ScanParameters,
    Start,
    recommended,
)
from freecad_edgescan.scanning.automatic import MIN_ANGLE
from freecad_edgescan.scanning.scan_plan import ScanPlan, plan_for_cloud, plan_for_cmm

TORUS = TorusObject(30.0, 60.0, np.radians(110.0), fillet_radius=1.0, probe_radius=1.0)
PITCH, NOISE = 0.4, 0.02
START = Start(*TORUS.start(12.0))
GIVEN = ScanParameters(
    amplitude=12.0, line_pitch=0.7, edge_pitch=0.9, tolerance=0.1, degree=2, cloud_pitch=0.4
)


@pytest.fixture(scope="module")
def cloud() -> PointCloud:
    return TORUS.cloud(PITCH, 24.0, NOISE, seed=3)


def on_edge(azimuth: float) -> np.ndarray:
    return np.array([60.0 * np.cos(azimuth), 60.0 * np.sin(azimuth), -30.0])


def click(cloud: PointCloud, given: ScanParameters | None = None) -> ScanPlan:
    return plan_for_cloud(cloud, on_edge(1.2), given or ScanParameters(), MIN_ANGLE)


def test_a_click_gets_every_value_and_its_reason(cloud: PointCloud) -> None:
    plan = click(cloud)
    parameters, reasons, start = plan.parameters, plan.reasons, plan.start
    optional = {"chord_height", "safeguards"}
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
    plan = click(cloud, GIVEN)
    parameters, reasons = plan.parameters, plan.reasons
    for name, value in GIVEN.given().items():
        assert getattr(parameters, name) == value
        assert reasons[name] == "given"


def test_nothing_is_measured_when_nothing_is_missing(
    cloud: PointCloud, monkeypatch: pytest.MonkeyPatch
) -> None:
    def measured(*_: object) -> None:
        raise AssertionError("the cloud was measured")

    monkeypatch.setattr(recommended, "measure_site", measured)
    bare = PointCloud(cloud.points[:2000], 1.0, (0, 0, -1))
    plan = plan_for_cloud(bare, START, GIVEN, MIN_ANGLE)
    parameters, reasons = plan.parameters, plan.reasons
    assert plan.start is START
    assert not {"tree", "pitch", "noise"} & set(vars(bare))
    assert parameters.probe_radius == 1.0
    assert parameters.approach == (0.0, 0.0, -1.0)
    assert parameters.prehit_distance == pytest.approx(1.6)
    assert parameters.search_distance == 30.0
    assert set(reasons) == set(parameters.given())


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
    with pytest.raises(ScanError, match=words):
        plan_for_cloud(cloud, START, replace(GIVEN, **values), MIN_ANGLE)  # type: ignore[arg-type]


class Machine:
    """What `plan_for_cmm` asks of a machine."""

    probe_radius = 1.5
    approach = np.array([0.0, 0.0, -1.0])


def test_a_machine_needs_the_amplitude_only() -> None:
    with pytest.raises(ScanError, match="needs the amplitude"):
        plan_for_cmm(Machine(), START, ScanParameters())  # type: ignore[arg-type]
    plan = plan_for_cmm(Machine(), START, ScanParameters(amplitude=16.0, degree=1))  # type: ignore[arg-type]
    parameters, reasons = plan.parameters, plan.reasons
    assert (parameters.line_pitch, parameters.edge_pitch) == (1.0, 1.0)
    assert (parameters.tolerance, parameters.degree) == (0.32, 1)
    assert (parameters.prehit_distance, parameters.search_distance) == (3.5, 30.0)
    assert (parameters.probe_radius, parameters.approach) == (1.5, (0.0, 0.0, -1.0))
    assert set(reasons) == set(parameters.given())
    assert reasons["amplitude"] == "given"


def test_a_virtual_machine_brings_its_own_pitch(cloud: PointCloud) -> None:
    plan = plan_for_cmm(PointCloudCmm(cloud, pitch=0.5), START, ScanParameters(amplitude=16.0))
    assert plan.parameters.cloud_pitch == 0.5
    assert plan.parameters.prehit_distance == 2.0  # four pitches
    assert plan.reasons["cloud_pitch"] == "the machine's own"
    assert plan.air_known
    with pytest.raises(ScanError, match=r"line pitch of 0.3 mm is below the cloud"):
        plan_for_cmm(
            PointCloudCmm(cloud, pitch=0.5), START, ScanParameters(amplitude=16.0, line_pitch=0.3)
        )


def test_a_virtual_machine_does_not_guess_where_the_air_is(cloud: PointCloud) -> None:
    amplitude = ScanParameters(amplitude=16.0)
    bare = PointCloud(cloud.points)
    assert not plan_for_cmm(PointCloudCmm(bare), START, amplitude).air_known
    assert plan_for_cmm(PointCloudCmm(bare, "ball"), START, amplitude).air_known
    with pytest.raises(ScanError, match="nothing tells along which direction"):
        plan_for_cmm(PointCloudCmm(PointCloud(cloud.points, 1.0)), START, amplitude)


def test_a_given_value_outside_a_guideline_is_scanned_with_and_told(cloud: PointCloud) -> None:
    assert click(cloud).warnings == ()
    close = replace(GIVEN, line_pitch=0.5, edge_pitch=0.5)
    for plan in (click(cloud, close), plan_for_cloud(cloud, START, close, MIN_ANGLE)):
        told = [words for words in plan.warnings if "below the guideline of 0.6 mm" in words]
        assert [words.split(" of ")[0] for words in told] == ["The line pitch", "The edge pitch"]
    wide = click(cloud, ScanParameters(amplitude=45.0)).warnings
    assert any(words.startswith("The amplitude of 45 mm is above the guideline") for words in wide)


def test_points_strewn_at_random_get_a_pitch_without_gaps() -> None:
    """One place in 25 is farther than a pitch from its nearest point, so that probes fall through.

    For points strewn at random exp(-π r²/ρc²) of all places have no point within r. The gap that
    all but one place in 1000 keep rests on a few holes only, which differ by a seventh or so.
    """
    rng = np.random.default_rng(4)
    grid = np.stack(np.meshgrid(np.arange(-20.0, 20.0, 0.5), np.arange(0.0, 20.0, 0.5)), -1)
    strewn = rng.uniform([-20.0, 0.0], [20.0, 20.0], (3200, 2))
    found = {}
    for name, flat in (("grid", grid.reshape(-1, 2)), ("strewn", strewn)):
        one = np.column_stack([flat, 0.01 * rng.standard_normal(len(flat))])
        other = one[:, [0, 2, 1]] * [1.0, 1.0, -1.0]
        wedge = PointCloud(np.vstack([one, other]))
        plan = plan_for_cloud(wedge, (0.0, 0.0, 0.0), ScanParameters(), MIN_ANGLE)
        found[name] = plan.parameters.cloud_pitch
    assert found["grid"] == pytest.approx(0.5, rel=0.1)
    assert found["strewn"] == pytest.approx(0.5 * np.sqrt(np.log(1000.0) / np.pi), rel=0.15)


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("probe_radius", None, "probe_radius is None"),
        ("probe_radius", -1.0, "probe_radius is -1.0"),
        ("approach", None, "approach is None"),
        ("approach", "down", "approach is 'down'"),
        ("approach", (0, 0, 0), "not all zero"),
    ],
)
def test_a_machine_has_to_say_what_its_probe_is(name: str, value: object, words: str) -> None:
    machine = Machine()
    setattr(machine, name, value)
    with pytest.raises(ScanError, match=words):
        plan_for_cmm(machine, START, ScanParameters(amplitude=16.0))  # type: ignore[arg-type]


def test_sides_too_short_for_scan_lines_are_refused_with_a_way_out() -> None:
    """A plate of four pitches: patches can do with it, lines cannot."""
    rng = np.random.default_rng(3)
    faces = []
    for low, high in (
        ([0, 0, 0], [40, 20, 0]),
        ([0, 0, -2], [40, 20, -2]),
        ([0, 0, -2], [40, 0, 0]),
    ):
        area = np.prod([b - a for a, b in zip(low, high, strict=True) if b > a])
        faces.append(rng.uniform(low, high, (int(area / 0.25), 3)))
    plate = PointCloud(np.vstack(faces) + rng.normal(0.0, 0.02, (sum(map(len, faces)), 3)))
    with pytest.raises(ScanError, match="method='patch'"):
        plan_for_cloud(plate, (20.0, 0.0, 0.0), ScanParameters(), MIN_ANGLE)
