# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest

from freecad_edgescan.scanning.edge_path import path_along
from freecad_edgescan.scanning.section import Station, frames_from_sides
from freecad_edgescan.scanning.stop import Stop
from freecad_edgescan.scanning.trace import Trace

OPEN, CLOSED = (Stop.CLOUD_END, Stop.CORNER), (Stop.CLOSED, Stop.CLOSED)


def stations_on(curve, parameters, noise=0.0):
    """Stations on points = curve(parameters), with sides upright and aside."""
    rng = np.random.default_rng(6)
    tangent = curve(parameters + 1e-6) - curve(parameters - 1e-6)
    up = np.tile([0.0, 0.0, 1.0], (len(parameters), 1))
    sides = np.stack([np.cross(tangent, up), -up], axis=1)
    points = curve(parameters) + noise * rng.normal(size=tangent.shape)
    frames = frames_from_sides(points, tangent, sides)
    return [Station(frames[j], max(noise, 1e-3), noise, (0.0, 0.0)) for j in range(len(frames))]


def circle(a, radius=10.0):
    return radius * np.column_stack([np.cos(a), np.sin(a), np.zeros_like(a)])


def helix(a):
    return np.column_stack([10 * np.cos(a), 10 * np.sin(a), 3 * a])


def ellipse(a):
    return np.column_stack([20 * np.cos(a), 8 * np.sin(a), np.zeros_like(a)])


@pytest.mark.parametrize("curve", [circle, helix])
def test_sections_stand_on_the_edge_one_pitch_apart(curve):
    a = np.linspace(0.1, 4, 50)
    path = path_along(Trace(stations_on(curve, a), OPEN), 0.5)
    rise = 0.0 if curve is circle else 3.0
    size = np.hypot(10, rise)
    where = np.arctan2(path.frames.origin[:, 1], path.frames.origin[:, 0]) % (2 * np.pi)
    assert path.frames.origin == pytest.approx(curve(where), abs=3e-3)
    assert np.diff(path.at) == pytest.approx(np.full(len(path) - 1, 0.5), rel=0.02)
    assert path.length == pytest.approx(3.9 * size, rel=1e-3)
    assert path.at[-1] == pytest.approx(path.length)
    inner = slice(5, -5)
    wanted = np.column_stack([-10 * np.sin(where), 10 * np.cos(where), np.full(len(path), rise)])
    assert path.frames.tangent[inner] == pytest.approx(wanted[inner] / size, abs=5e-3)
    inward = -np.column_stack([np.cos(where), np.sin(where), np.zeros(len(path))])
    assert path.frames.bend[inner] == pytest.approx(10 / size**2 * inward[inner], abs=0.015)


def test_a_noisy_walk_is_smoothed_within_its_noise():
    a = np.linspace(0, 4, 80)
    path = path_along(Trace(stations_on(circle, a, 0.03), OPEN), 0.5)
    away = np.hypot(path.frames.origin[:, 0], path.frames.origin[:, 1]) - 10.0
    assert np.hypot(away, path.frames.origin[:, 2]).max() < 0.09


def test_a_closed_edge_has_even_sections_across_its_seam():
    a = np.linspace(0, 2 * np.pi, 60, endpoint=False)
    path = path_along(Trace(stations_on(circle, a), CLOSED), 0.8)
    origin = path.frames.origin
    steps = np.linalg.norm(np.roll(origin, -1, axis=0) - origin, axis=1)
    assert steps == pytest.approx(np.full(len(path), steps.mean()), rel=0.02)
    assert path.length == pytest.approx(20 * np.pi, rel=1e-3)
    for step in (1, 3, -2):
        assert path.ahead(step) == pytest.approx(np.full(len(path), step * steps.mean()), rel=0.02)


def test_beyond_the_ends_of_an_open_edge_there_is_nothing():
    path = path_along(Trace(stations_on(circle, np.linspace(0, 2, 30)), OPEN), 0.5)
    assert np.isnan(path.ahead(2)).nonzero()[0].tolist() == [len(path) - 2, len(path) - 1]
    assert np.isnan(path.ahead(-1)).nonzero()[0].tolist() == [0]
    assert path.ahead(2)[0] == pytest.approx(path.at[2])


def test_with_a_chord_height_sections_lie_dense_where_the_edge_bends():
    """The chord between two sections deviates by the chord height, within the limits of pitch."""
    a = np.linspace(0, 2 * np.pi, 120, endpoint=False)
    path = path_along(Trace(stations_on(ellipse, a), CLOSED), 1.5, chord_height=0.05)
    steps = np.diff(path.at)
    where = np.arctan2(path.frames.origin[:, 1] / 8, path.frames.origin[:, 0] / 20)
    bend = 160 / np.hypot(20 * np.sin(where), 8 * np.cos(where)) ** 3
    middle = np.sqrt(bend[1:] * bend[:-1])
    wanted = np.clip(np.sqrt(8 * 0.05 / middle), 0.75, 4.5)
    assert steps == pytest.approx(wanted, rel=0.12)
    assert (steps**2 * middle / 8).max() < 1.15 * 0.05


def test_sections_never_lie_nearer_than_the_least_pitch():
    a = np.linspace(0, 2 * np.pi, 120, endpoint=False)
    path = path_along(
        Trace(stations_on(ellipse, a), CLOSED), 1.5, least_pitch=1.2, chord_height=0.01
    )
    assert np.diff(path.at).min() > 1.15


def test_a_walk_of_a_few_steps_keeps_its_sections():
    stations = stations_on(circle, np.linspace(0, 0.3, 4))
    path = path_along(Trace(stations, OPEN), 0.5)
    assert len(path) == 4
    assert path.frames.origin == pytest.approx(circle(np.linspace(0, 0.3, 4)))
    assert path.at[0] == 0.0 and path.at[-1] == path.length
