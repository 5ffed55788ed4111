# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces that the tests of surfacing share."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.geometry import BSplineSurface, Circle
from freecad_edgescan.geometry.exact_surfaces import circular_arc, extruded_surface
from freecad_edgescan.geometry.knot_vectors import clamped_knots, greville


def wavy(height=6.0, poles=(9, 7), size=(80.0, 50.0)):
    """A bicubic surface like a wave of some mm over a rectangle."""
    knots = tuple(clamped_knots(np.linspace(0, 1, n - 2), 3) for n in poles)
    u, v = (greville(k, 3) for k in knots)
    x, y = size[0] * u[:, None], size[1] * v
    z = height * np.sin(x / 15) * np.cos(y / 12)
    return BSplineSurface(np.stack(np.broadcast_arrays(x, y, z), axis=-1), knots)


def half_pipe(radius=17.0, length=60.0):
    """Half a cylinder round the x axis, open upwards: u round, v along."""
    across = Circle(np.zeros(3), np.array([1.0, 0, 0]), radius, np.array([0, -1.0, 0]))
    return extruded_surface(circular_arc(across, 0.0, np.pi), [length, 0, 0])


@pytest.fixture
def wave():
    return wavy()


@pytest.fixture
def flat():
    return wavy(height=0.0)


@pytest.fixture
def pipe():
    return half_pipe()
