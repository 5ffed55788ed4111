# SPDX-License-Identifier: LGPL-2.1-or-later
"""A decision that sees far less of a side than its neighbours is one of a rounding."""

import numpy as np
import pytest

from freecad_edgescan.experiments.doe_design import trial
from freecad_edgescan.experiments.doe_result import PATCH
from freecad_edgescan.experiments.doe_scan import edge_errors, scan_trial, trial_cloud
from freecad_edgescan.scanning.pooling import _without_strays


@pytest.mark.parametrize("where", [0, 4, 9])
@pytest.mark.parametrize("closed", [False, True])
def test_a_short_stretch_among_long_ones_is_corrected(where, closed):
    stretch = np.tile([5, 13], (10, 2, 1))
    stretch[where, 1] = [2, 5]
    assert np.array_equal(_without_strays(stretch, closed), np.tile([5, 13], (10, 2, 1)))


def test_short_stretches_that_agree_stay_and_so_do_small_differences():
    stretch = np.tile([5, 13], (12, 2, 1))
    stretch[4:8, 0] = [3, 6]  # a land that is narrow for a while
    stretch[2, 1] = [6, 13]
    assert np.array_equal(_without_strays(stretch, False), stretch)


def test_few_decisions_are_taken_as_they_are():
    assert np.array_equal(_without_strays(np.array([[[2, 5], [3, 9]]]), False)[0, 1], [3, 9])


@pytest.mark.parametrize(("experiment", "test", "seed"), [(5, 6, 0), (7, 1, 4)])
def test_no_edge_point_of_a_published_object_is_millimetres_off(experiment, test, seed):
    """Clouds in which a stretch on the rounding once passed for the side."""
    row = trial(experiment, test)
    edge = scan_trial(row, trial_cloud(row, seed), PATCH, "patch")
    assert edge_errors(row, edge.points).max() < 3.0 * row.noise
