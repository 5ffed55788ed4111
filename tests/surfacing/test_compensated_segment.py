# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which points are well inside a surface's rim."""

import numpy as np

from freecad_edgescan.geometry import Circle
from freecad_edgescan.geometry.exact_surfaces import circular_arc, extruded_surface
from freecad_edgescan.surfacing.compensated_segment import _off_the_rim


def test_feet_nearer_to_the_rim_than_the_room_are_left_out(flat):
    rng = np.random.default_rng(1)
    u, v = rng.uniform(0.0, 1.0, (2, 2000))
    x, y, _ = flat.evaluate(u, v).T
    to_rim = np.min([x, 80.0 - x, y, 50.0 - y], axis=0)
    assert np.array_equal(_off_the_rim(flat, u, v, 2.0), to_rim > 2.0)
    # Without room only those on the rim itself.
    ends = np.array([0.0, 0.5, 1.0])
    assert _off_the_rim(flat, ends, np.full(3, 0.5), 0.0).tolist() == [False, True, False]


def test_a_closed_surface_has_no_rim_at_its_seam():
    around = Circle(np.zeros(3), np.array([1.0, 0, 0]), 10.0, np.array([0, 1.0, 0]))
    tube = extruded_surface(circular_arc(around), [40.0, 0, 0])
    (first, last), (low, high) = tube.parameter_range
    u, middle = np.linspace(first, last, 9), 0.5 * (low + high)
    assert _off_the_rim(tube, u, np.full(9, middle), 1.0).all()
    assert not _off_the_rim(tube, u, np.full(9, low), 1.0).any()
