# SPDX-License-Identifier: LGPL-2.1-or-later
"""One object of each published experiment in all patterns and degrees, as `edgescan doe` does.

Tests 3 and 12 in turn are a fixed spread, with both levels of most parameters. All 768 scans are
made by `edgescan doe`.
"""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.experiments import DoeResult, run_doe
from freecad_edgescan.experiments.doe_comparison import compare_all, compare_group
from freecad_edgescan.experiments.doe_design import EXPERIMENTS, coded_levels

pytestmark = pytest.mark.slow

SPREAD = (3, 12)
GROUPS = [("zigzag", 1), ("zigzag", 2), ("square", 1), ("square", 2)]


@pytest.fixture(scope="module")
def result() -> DoeResult:
    odd, even = (
        run_doe(experiments=EXPERIMENTS[first::2], tests=[test], seed=0, jobs=2)
        for first, test in enumerate(SPREAD)
    )
    return DoeResult((*odd, *even), seed=0)


def test_the_spread_holds_both_levels_of_most_parameters() -> None:
    first, second = (coded_levels()[test - 1] for test in SPREAD)
    assert np.count_nonzero(first != second) > len(first) / 2


def test_every_scan_completes(result: DoeResult) -> None:
    assert len(result) == len(EXPERIMENTS) * len(GROUPS)
    assert [run.name for run in result if not run.completed] == []
    assert {run.stop for run in result} == {"GATE"}


def test_every_pattern_and_degree_has_as_many_edge_points_as_it_should(result: DoeResult) -> None:
    for group in GROUPS:
        assert compare_group(result, group).nominal_points == pytest.approx(1.0, abs=0.05)
    assert compare_all(result).published_points == pytest.approx(1.0, abs=0.1)


@pytest.mark.parametrize("group", GROUPS)
def test_edge_points_are_better_than_the_published_ones(
    result: DoeResult, group: tuple[str, int]
) -> None:
    """Geometric means over the objects that both completed."""
    found = compare_group(result, group)
    assert found.tests >= 10
    assert found.avg_ratio <= {1: 1.0, 2: 0.75}[group[1]]
    assert found.max_ratio <= 1.0
