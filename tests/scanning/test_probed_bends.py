# SPDX-License-Identifier: LGPL-2.1-or-later
"""Steps along edges that bend: the height of a chord, the edge pitch, and both ways of steering."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.cloud import TorusObject
from freecad_edgescan.scanning import Stop

from .exact_torus import ANGLE, BEGIN, azimuths, off_the_circle, scanned, steps


def chord_heights(points: np.ndarray) -> np.ndarray:
    """Distance of each inner point from the line through its neighbours (Schreve 4.4.4.1), mm."""
    chord = points[2:] - points[:-2]
    twice = np.linalg.norm(np.cross(points[1:-1] - points[:-2], chord), axis=1)
    return twice / np.linalg.norm(chord, axis=1)


@pytest.mark.parametrize("steering", ["tangent", "curvature"])
@pytest.mark.parametrize("height", [0.01, 0.05])
def test_the_chord_between_two_edge_points_has_the_height_asked_for(height, steering):
    """Steps √(8xh) = 2.8 and 6.3 mm hold it exactly; both lie between the limits of the pitch."""
    torus = TorusObject(50.0, 100.0, ANGLE)
    turn = 22.0 * np.sqrt(8.0 * height / torus.edge_radius)
    edge = scanned(
        torus, turn=turn, edge_pitch=4.0, side=5.0, chord_height=height, steering=steering
    )
    assert edge.stops[1] is Stop.GATE
    over_two_steps = chord_heights(edge.points)[9:-1]  # the pitch has settled
    assert len(over_two_steps) >= 8
    assert over_two_steps / 4.0 == pytest.approx(height, rel=0.06)


def test_the_edge_pitch_grows_to_three_times_its_start_and_no_further():
    """A height of 0.5 mm would be held by steps of 20 mm."""
    torus = TorusObject(50.0, 100.0, ANGLE)
    edge = scanned(torus, turn=0.9, edge_pitch=2.0, side=5.0, chord_height=0.5)
    assert edge.stops[1] is Stop.GATE
    assert steps(edge.points)[3:] == pytest.approx(6.0, rel=0.02)
    assert chord_heights(edge.points)[4:] == pytest.approx(6.0**2 / 200.0, rel=0.05)


@pytest.mark.parametrize("pattern", ["square", "zigzag"])
@pytest.mark.parametrize("radius", [15.0, 40.0])
def test_steering_by_curvature_follows_a_bend_to_its_gate(radius, pattern):
    """Each line is laid on the circle of the last points: steps are chords of the edge pitch."""
    torus = TorusObject(50.0, radius, ANGLE)
    turn = min(np.pi - 0.2, 40.0 / radius)
    edge = scanned(
        torus,
        turn=turn,
        edge_pitch=2.0,
        side=4.0,
        tolerance=0.02,
        steering="curvature",
        pattern=pattern,
    )
    assert edge.stops[1] is Stop.GATE
    sagitta = 2.0**2 / (2.0 * radius)
    assert np.hypot(*off_the_circle(torus, edge.points).T).max() < 0.05 * sagitta
    chord = 2.0 * radius * np.sin(1.0 / radius)
    allowed = 0.01 if pattern == "square" else 0.04
    assert steps(edge.points)[4:] == pytest.approx(chord, rel=allowed)
    assert azimuths(edge.points)[-1] >= BEGIN + turn


def test_steering_by_curvature_reaches_a_gate_in_steps_of_a_fifth_of_the_radius():
    """A tangent, which lags behind, would lead half a step and more aside there."""
    torus = TorusObject(20.0, 10.0, ANGLE)
    edge = scanned(
        torus, turn=np.pi - 0.2, edge_pitch=2.0, side=4.0, tolerance=0.03, steering="curvature"
    )
    assert edge.stops[1] is Stop.GATE
    assert np.hypot(*off_the_circle(torus, edge.points).T).max() < 0.05 * 2.0**2 / 20.0
