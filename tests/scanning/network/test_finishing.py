# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walks that went round a corner are parted there."""

from __future__ import annotations

import numpy as np

from freecad_edgescan.scanning.network.finishing import parted_at_bend
from freecad_edgescan.scanning.section import Station, frames_from_sides
from freecad_edgescan.scanning.stop import Stop
from freecad_edgescan.scanning.trace import Trace

PITCH, LENGTH = 0.5, 30


def trace_along(points: np.ndarray) -> Trace:
    tangents = np.gradient(points, axis=0)
    sides = np.array([[[0.0, 0.0, 1.0], [0.3, 0.3, 1.0]]] * len(points))
    frames = frames_from_sides(points, tangents, sides)
    stations = [Station(frames[k]) for k in range(len(points))]
    return Trace(stations, (Stop.LOST, Stop.CLOUD_END))


def round_a_corner(radius: float) -> np.ndarray:
    """Two legs at right angles and the arc between them, a point for each pitch and a half."""
    arc = np.linspace(0.0, 0.5 * np.pi, max(2, round(radius * np.pi / 3.0 / PITCH)))
    leg = 1.5 * PITCH * np.arange(LENGTH)
    first = np.column_stack([leg - leg[-1] - PITCH, -radius + 0.0 * leg])
    bend = radius * np.column_stack([np.sin(arc), -np.cos(arc)])
    second = np.column_stack([radius + 0.0 * leg, leg + PITCH])
    flat = np.vstack([first, bend, second])
    return np.column_stack([flat, np.zeros(len(flat))])


def test_a_walk_round_a_rounded_corner_becomes_two_that_end_before_it() -> None:
    points = round_a_corner(3.0 * PITCH)
    first, second = parted_at_bend(trace_along(points), PITCH)
    assert first.stops == (Stop.LOST, Stop.CORNER)
    assert second.stops == (Stop.CORNER, Stop.CLOUD_END)
    corner = np.array([3.0, -3.0, 0.0]) * PITCH
    for part in (first, second):
        places = np.array([station.frame.origin[0] for station in part.stations])
        assert np.linalg.norm(places - corner, axis=1).min() > 2.0 * PITCH
        assert len(part.stations) > 0.8 * LENGTH


def test_a_straight_walk_and_a_wide_bend_stay_whole() -> None:
    straight = np.column_stack([PITCH * np.arange(40.0), np.zeros(40), np.zeros(40)])
    assert parted_at_bend(trace_along(straight), PITCH) == []
    assert parted_at_bend(trace_along(round_a_corner(40.0 * PITCH)), PITCH) == []
