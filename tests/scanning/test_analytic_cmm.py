# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine on the torus object: contacts on its faces, and whole scans without a cloud."""

import numpy as np
import pytest

from freecad_edgescan.cloud import TorusObject
from freecad_edgescan.scanning import (
    AnalyticCmm,
    Cmm,
    Gate,
    ScanError,
    ScanParameters,
    Start,
    Stop,
    scan_edge,
)

TORUS = TorusObject(20.0, 100.0, np.radians(110.0), 1.0, 0.5)


def off_its_faces(torus, points):
    """Distance of probe centres from the nearest of the three tori, each taken whole."""
    rho = np.hypot(points[:, 0], points[:, 1])
    gaps = [
        np.abs(
            np.hypot(rho - face.major_radius, points[:, 2] - face.centre_height)
            - face.section_radius
        )
        for face in torus.faces(5.0)
    ]
    return np.min(gaps, axis=0)


def test_it_is_a_machine():
    machine = AnalyticCmm(TORUS)
    assert isinstance(machine, Cmm)
    assert machine.probe_radius == 0.5
    assert machine.approach == pytest.approx([0, 0, -1])


def test_contacts_lie_on_the_faces_first_in_the_way():
    machine, rng = AnalyticCmm(TORUS), np.random.default_rng(1)
    met = 0
    for _ in range(200):
        azimuth = rng.uniform(0.2, 2.9)
        aim = np.array(
            [*(100.0 + rng.uniform(-6, 6)) * np.array([np.cos(azimuth), np.sin(azimuth)])]
        )
        start = np.array([*aim, 5.0])
        contact = machine.touch(start, np.array([0.0, 0.0, -1.0]), 2.0, 40.0)
        if contact is None:
            continue
        met += 1
        assert off_its_faces(TORUS, contact[None])[0] < 1e-7
        # A march down the same line meets nothing before.
        steps = np.linspace(0.0, start[2] - contact[2] - 1e-3, 500)
        way = start - steps[:, None] * np.array([0.0, 0.0, 1.0])
        rho = np.hypot(way[:, 0], way[:, 1])
        for face in TORUS.faces(5.0):
            off = np.hypot(rho - face.major_radius, way[:, 2] - face.centre_height)
            v = np.arctan2(way[:, 2] - face.centre_height, rho - face.major_radius)
            inside = ((v - face.v0) % (2 * np.pi)) < face.v1 - face.v0
            crossed = np.sign(off[:-1] - face.section_radius) != np.sign(
                off[1:] - face.section_radius
            )
            assert not np.any(crossed & inside[:-1] & inside[1:])
    assert met > 150


def test_the_object_ends_where_it_ends():
    machine = AnalyticCmm(TORUS)
    down = np.array([0.0, 0.0, -1.0])
    for azimuth, there in ((0.5, True), (-0.09, True), (-0.2, False), (np.pi + 0.2, False)):
        start = np.array([104.0 * np.cos(azimuth), 104.0 * np.sin(azimuth), 0.0])
        assert (machine.touch(start, down, 1.0, 40.0) is not None) is there


def test_a_search_is_given_up_behind_its_search_distance():
    machine = AnalyticCmm(TORUS)
    start, down = np.array([0.0, 102.0, 0.0]), np.array([0.0, 0.0, -1.0])
    depth = -machine.touch(start, down, 1.0, 40.0)[2]
    assert machine.touch(start, down, 1.0, depth - 1.1) is None
    assert machine.touch(start, down, 1.0, depth - 0.9) is not None


def test_a_movement_through_the_part_collides_and_one_in_the_air_does_not():
    machine = AnalyticCmm(TORUS)
    above, below = np.array([0.0, 103.0, -10.0]), np.array([0.0, 103.0, -30.0])
    collision = machine.move(above, below)
    assert off_its_faces(TORUS, collision[None])[0] < 1e-7
    assert machine.move(above, above + np.array([0.0, -5.0, 1.0])) is None
    assert machine.move(collision, above) is None
    assert machine.move(above, above) is None


def test_noise_stays_within_its_level_and_can_be_repeated():
    start, down = np.array([0.0, 103.0, 0.0]), np.array([0.0, 0.0, -1.0])
    exact = AnalyticCmm(TORUS).touch(start, down, 1.0, 40.0)
    noisy = AnalyticCmm(TORUS, noise=0.1, seed=7)
    errors = np.array([noisy.touch(start, down, 1.0, 40.0) - exact for _ in range(300)])
    assert np.abs(errors).max() <= 0.1
    assert errors.std(axis=0) == pytest.approx(0.1 / np.sqrt(3.0), rel=0.15)
    again = AnalyticCmm(TORUS, noise=0.1, seed=7)
    assert again.touch(start, down, 1.0, 40.0) - exact == pytest.approx(errors[0])


@pytest.mark.parametrize("noise", [-0.1, np.nan, "much"])
def test_a_noise_that_is_no_length_is_refused(noise):
    with pytest.raises(ScanError, match="noise"):
        AnalyticCmm(TORUS, noise=noise)


def test_only_the_torus_object_is_touched():
    with pytest.raises(ScanError, match="ndarray"):
        AnalyticCmm(np.zeros((5, 3)))


@pytest.mark.parametrize("pattern", ["square", "zigzag"])
def test_an_edge_is_scanned_without_a_cloud(pattern):
    amplitude = 10.0
    edge = scan_edge(
        AnalyticCmm(TORUS),
        at=Start(*TORUS.start(amplitude)),
        gate=Gate(*TORUS.gate(amplitude, azimuth=0.6)),
        parameters=ScanParameters(
            amplitude=amplitude, line_pitch=0.5, edge_pitch=1.0, tolerance=0.02, pattern=pattern
        ),
    )
    assert edge.stops[1] is Stop.GATE
    rho = np.hypot(edge.points[:, 0], edge.points[:, 1])
    error = np.hypot(rho - 100.0, edge.points[:, 2] + 20.0)
    assert error.max() < 0.05
    assert np.degrees(edge.angle).mean() == pytest.approx(110.0, abs=2.0)
