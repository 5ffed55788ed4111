# SPDX-License-Identifier: LGPL-2.1-or-later
"""The speed measurement: it measures a scan that is right."""

from __future__ import annotations

import pytest

from freecad_edgescan.experiments import measure_speed
from freecad_edgescan.experiments.speed import simulated_cloud


def test_the_simulated_cloud_has_about_the_points_that_were_asked_for() -> None:
    assert len(simulated_cloud(50_000)) == pytest.approx(50_000, rel=0.1)


def test_the_edge_that_is_timed_lies_on_the_true_edge() -> None:
    speed = measure_speed(points=60_000)
    assert speed is not None
    assert speed.edge_points > 100
    assert speed.mean_error < 0.05
    assert set(speed.reading) == {".xyz", ".ply"}
    assert speed.indexing_ratio > 0
    assert 50 < speed.slab_points < 200
    # Both are parts of the scan, and neither is missed by looking for another name.
    assert 0.0 < speed.in_tree < speed.in_fits < 1.0


@pytest.mark.parametrize("asked", range(5))
def test_it_stops_when_it_is_told_to(asked: int) -> None:
    class Stopper:
        left = asked

        def update(self, fraction: float, so_far: object) -> bool:
            self.left -= 1
            return self.left >= 0

    assert measure_speed(points=20_000, progress=Stopper()) is None


def test_too_few_points_are_refused_with_their_number() -> None:
    with pytest.raises(ValueError, match="500"):
        measure_speed(points=500)
