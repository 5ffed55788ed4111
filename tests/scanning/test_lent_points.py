# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edge points that rest on their neighbours, and why they do."""

from __future__ import annotations

import numpy as np

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.scanning import ScannedEdge, scan_edge

PITCH = 0.4  # mm
SENTENCE = (
    "edge points rest on their neighbours: the cloud has a gap there, or too little of a side "
    "looks smooth."
)


def roof(rng: np.random.Generator) -> np.ndarray:
    """A right angle with its edge on the x axis, 50 mm long, 12 mm to each side."""
    cell = np.indices((125, 30)).reshape(2, -1).T + 0.5
    sides = []
    for way in (1.0, -1.0):
        along, away = PITCH * (cell + rng.uniform(-0.35, 0.35, cell.shape)).T
        sides.append(np.column_stack([along, way * away, -away * np.ones_like(away)]))
    return np.vstack(sides) / [1.0, np.sqrt(2.0), np.sqrt(2.0)]


def scanned(points: np.ndarray) -> ScannedEdge:
    return scan_edge(PointCloud(points), at=(25.0, 0.2, -0.3))


def test_a_gap_in_the_cloud_is_told() -> None:
    rng = np.random.default_rng(1)
    points = roof(rng)
    points = points[(points[:, 1] < 0.0) | (np.abs(points[:, 0] - 12.0) > 1.2)]
    edge = scanned(points + rng.normal(scale=0.02, size=points.shape))
    lent = ~edge.supported
    assert 1 <= lent.sum() < 6
    assert np.abs(edge.points[lent, 0] - 12.0).max() < 2.0
    assert f"{lent.sum()} of {len(edge)} {SENTENCE}" in edge.message


def test_of_a_cloud_without_gaps_no_gap_is_claimed() -> None:
    """Noise that is alike over a millimetre bends a side more than its scatter allows."""
    told = []
    for seed in range(6):
        rng = np.random.default_rng(seed)
        points = roof(rng)
        waves, phases = rng.normal(size=(200, 3)), rng.uniform(0.0, 2.0 * np.pi, 200)
        noise = np.cos(points @ waves.T + phases) @ rng.normal(size=(200, 3)) / 10.0
        edge = scanned(points + 0.05 * noise + rng.normal(scale=0.01, size=points.shape))
        if not edge.supported.all():
            told.append(edge.message)
    assert told
    assert all(SENTENCE in message for message in told)
    assert not any("bridge" in message for message in told)
