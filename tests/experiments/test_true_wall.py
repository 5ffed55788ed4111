# SPDX-License-Identifier: LGPL-2.1-or-later
"""The true wall of a half-pipe is where its ball touches."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.cloud import CoreBox
from freecad_edgescan.cloud.half_pipe import HalfPipe
from freecad_edgescan.experiments.true_wall import deviation_from_wall


@pytest.mark.parametrize("box", [CoreBox.small(probe_radius=0.0), CoreBox(probe_radius=0.0)])
def test_the_true_wall_of_a_pipe_is_where_its_ball_touches(box):
    cloud = box.cloud(1.0, noise=0.0)
    for number, pipe in enumerate(box.pipes, 1):
        on_wall = cloud.points[cloud.labels == number]
        assert deviation_from_wall(pipe, on_wall).max() < 1e-3
        inside = on_wall[on_wall[:, 2] < -2.0] + (0.0, 0.0, 0.5)
        assert np.all(deviation_from_wall(pipe, inside) <= 0.5 + 1e-3)


def test_a_straight_pipe_is_a_cylinder():
    pipe = HalfPipe([(x, 0.0, 5.0) for x in range(0, 60, 10)])
    rng = np.random.default_rng(0)
    places = rng.uniform((10, -6, -6), (40, 6, 0), (500, 3))
    exact = np.abs(np.hypot(places[:, 1], places[:, 2]) - 5.0)
    assert np.allclose(deviation_from_wall(pipe, places), exact, atol=1e-3)
