# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a probed scan takes for the values nobody gave."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.cloud import PointCloud, TorusObject
from freecad_edgescan.scanning import ScanParameters, scan_edge
from freecad_edgescan.scanning import recommended as rules
from freecad_edgescan.scanning.automatic import MIN_ANGLE
from freecad_edgescan.scanning.edge_site import measure_site
from freecad_edgescan.scanning.recommended import measure_and_choose

TORUS = TorusObject(30.0, 60.0, np.radians(110.0), fillet_radius=1.0, probe_radius=1.0)
PITCH, NOISE = 0.4, 0.02


@pytest.fixture(scope="module")
def cloud() -> PointCloud:
    return TORUS.cloud(PITCH, 24.0, NOISE, seed=3)


def on_edge(azimuth: float) -> np.ndarray:
    return np.array([60.0 * np.cos(azimuth), 60.0 * np.sin(azimuth), -30.0])


def test_what_is_measured_is_true(cloud: PointCloud) -> None:
    around = measure_site(cloud, on_edge(1.2), ScanParameters(), MIN_ANGLE).around
    assert around.section_radius == pytest.approx(30.0, rel=0.03)
    assert around.angle == pytest.approx(TORUS.angle, abs=np.radians(0.5))
    assert around.fillet_radius == pytest.approx(1.0, abs=0.2)
    assert around.probe_radius == 1.0
    assert around.cloud_pitch == pytest.approx(PITCH, rel=0.25)
    assert around.noise_level == pytest.approx(NOISE, rel=0.1)
    assert around.convex


def test_a_scan_from_a_click_is_as_good_as_expected(cloud: PointCloud) -> None:
    site = measure_site(cloud, on_edge(1.2), ScanParameters(), MIN_ANGLE)
    expected = rules.choose_for_site(site, ScanParameters()).expected
    edge = scan_edge(cloud, on_edge(1.2), gate=on_edge(1.5), method="probe")
    error = np.hypot(np.hypot(*edge.points[:, :2].T) - 60.0, edge.points[:, 2] + 30.0)
    assert len(edge) > 20
    assert np.sqrt(np.mean(error**2)) < 2.0 * expected.total
    assert expected.total < 0.05


def test_planes_are_scanned_with_lines_and_bent_surfaces_with_quadratics() -> None:
    rng = np.random.default_rng(1)
    flat = rng.uniform([-20.0, 0.0], [20.0, 20.0], (8000, 2))
    turn = np.radians(80.0)
    one = np.column_stack([flat[:, 0], flat[:, 1], 0.02 * rng.standard_normal(8000)])
    other = np.column_stack([flat[:, 0], flat[:, 1], 0.02 * rng.standard_normal(8000)])
    way, normal = [0.0, -np.cos(turn), -np.sin(turn)], [0.0, -np.sin(turn), np.cos(turn)]
    other = other[:, :1] * [1, 0, 0] + other[:, 1:2] * way + other[:, 2:] * normal
    wedge = PointCloud(np.vstack([one, other]))
    choice = measure_and_choose(wedge, (0.0, 0.0, 0.0), ScanParameters(), MIN_ANGLE)[1]
    parameters, reasons = choice.parameters, choice.reasons
    assert parameters.degree == 1
    assert "quadratic" in reasons["degree"]
    # without an approach the probe comes from outside the smaller wedge
    assert np.asarray(parameters.approach) @ [0.0, 1.0 - np.cos(turn), -np.sin(turn)] > 0.5


def test_points_are_told_from_the_rounding_by_a_narrow_tolerance(cloud: PointCloud) -> None:
    """The printed guideline counts what projection adds; it is kept where points are projected."""
    wide, narrow = (
        measure_and_choose(cloud, on_edge(1.2), given, MIN_ANGLE)[1].parameters
        for given in (ScanParameters.literal(), ScanParameters())
    )
    assert NOISE < narrow.tolerance < 3.0 * NOISE
    assert wide.tolerance > NOISE + PITCH * np.sin(np.radians(10.0))
