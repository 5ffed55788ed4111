# SPDX-License-Identifier: LGPL-2.1-or-later
"""What one edge costs in clouds of several sizes: the same edge, and a cost of this size."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from freecad_edgescan.experiments.cloud_sizes import SizeCost, measure_sizes, slope
from freecad_edgescan.experiments.peak_memory import memory_now, peak_memory

SMALL, LARGE = 20_000, 200_000


@pytest.fixture(scope="module")
def costs() -> list[SizeCost]:
    return list(measure_sizes([SMALL, LARGE]))


def test_clouds_have_about_the_points_that_were_asked_for(costs: list[SizeCost]) -> None:
    for cost, points in zip(costs, (SMALL, LARGE), strict=True):
        assert cost.points == pytest.approx(points, rel=0.2)
        assert 12 * cost.points < cost.file_bytes < 12 * cost.points + 200


def test_it_is_the_same_edge_in_every_size_and_a_true_one(costs: list[SizeCost]) -> None:
    assert costs[0].edge_points == costs[1].edge_points > 100
    assert costs[1].mean_error == pytest.approx(costs[0].mean_error, rel=0.1)
    assert costs[0].mean_error < 0.05


def test_every_step_was_measured(costs: list[SizeCost]) -> None:
    for cost in costs:
        steps = (cost.cropping, cost.reading, cost.indexing, cost.searching, cost.curve)
        assert min(*steps, cost.scanning, cost.file_to_curve) > 0.0
        # its points and their tree, at least
        assert cost.peak > 30 * cost.points


def test_a_row_stands_below_its_header(costs: list[SizeCost]) -> None:
    assert all(len(line) == len(costs[0].text()) for line in SizeCost.HEADER.splitlines())
    assert costs[0].text().split()[0] == str(costs[0].points)


def test_the_slope_is_the_exponent_of_the_number_of_points(costs: list[SizeCost]) -> None:
    rows = [replace(costs[0], points=n, scanning=0.3 * n**0.7) for n in (1000, 20_000, 300_000)]
    assert slope(rows) == pytest.approx(0.7)
    assert math.isnan(slope(rows[:1]))


@pytest.mark.parametrize("asked", range(3))
def test_it_can_be_stopped(asked: int) -> None:
    class Stopper:
        left = asked

        def update(self, fraction: float, so_far: object) -> bool:
            self.left -= 1
            return self.left >= 0

    assert list(measure_sizes([SMALL], Stopper())) == []


def test_too_few_points_are_refused_with_their_number() -> None:
    with pytest.raises(ValueError, match="from 100 points"):
        next(measure_sizes([SMALL, 100]))


def test_the_peak_of_memory_remembers_what_was_given_back() -> None:
    before = memory_now()
    held = np.ones(20_000_000)
    assert memory_now() > before + 0.9 * held.nbytes
    most, size = peak_memory(), held.nbytes
    del held
    assert most >= before + 0.9 * size
    assert peak_memory() == pytest.approx(most, rel=0.01)  # Linux counts in some pages at a time
