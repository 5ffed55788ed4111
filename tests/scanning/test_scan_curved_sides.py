# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sides that bend strongly and begin far from the edge, with little of them beside a rounding."""

import numpy as np
import pytest

from freecad_edgescan.experiments.doe_design import trial
from freecad_edgescan.experiments.doe_result import PATCH
from freecad_edgescan.experiments.doe_scan import edge_errors, scan_trial, trial_cloud
from freecad_edgescan.scanning import Stop


@pytest.mark.parametrize("seed", [1, 2, 9])
def test_tubes_of_five_times_the_rounding_meet_where_their_sides_say(seed):
    """Published object 3.13: they curl apart by half a radian, as no two faces of a plate do."""
    row = trial(3, 13)
    edge = scan_trial(row, trial_cloud(row, seed), PATCH, "patch")
    errors = edge_errors(row, edge.points)
    assert edge.stops[1] is Stop.GATE
    assert len(edge) >= 0.95 * row.nominal_points
    assert errors.mean() < 0.75 * row.noise
    assert np.median(edge.sigma) < row.noise
    assert np.degrees(edge.angle) == pytest.approx(np.degrees(row.angle), abs=3.0)
    assert np.median(errors / edge.sigma) < 2.5
