# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sigma answers for an edge as a whole, however few independent errors it has."""

import numpy as np
import pytest

from freecad_edgescan.scanning import scan_edge
from freecad_edgescan.scanning.whole_edge import reserve

EDGES = 1_000_000


@pytest.mark.parametrize("independent", [1, 2, 4])
def test_one_edge_in_ten_thousand_is_farther_off_as_a_whole(independent):
    rng = np.random.default_rng(independent)
    errors = rng.normal(size=(EDGES, independent, 2)) / reserve(independent)
    off = np.sqrt(np.mean(np.sum(np.square(errors), axis=2), axis=1)) > 2.5
    assert 60 <= off.sum() <= 140


def test_of_many_errors_nothing_is_added():
    added = [reserve(independent) for independent in (1.0, 1.5, 2.0, 3.0, 5.0, 7.0, 100.0)]
    assert added == sorted(added, reverse=True)
    assert added[0] > 1.7
    assert added[4] > 1.0
    assert added[5:] == [1.0, 1.0]


def test_a_short_edge_states_more_and_a_long_one_what_its_points_scatter(wedge):
    short, long = (
        scan_edge(part.cloud, part.at(0.1, 0.4))
        for part in (wedge(90.0, 0.6, 0.03, length=length, width=8.0) for length in (12.0, 200.0))
    )
    assert short.reserve > 1.2
    assert short.own_sigma * short.reserve == pytest.approx(short.sigma)
    assert long.reserve == 1.0
    assert short.unsmoothed.reserve == 1.0
    assert short.reversed().reserve == short.reserve
