# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine whose tolerance nobody has given does not take a ball's way round an edge for it."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_edgescan.cloud import TorusObject
from freecad_edgescan.scanning import AnalyticCmm, Gate, ScanParameters, Start, scan_edge

ANGLE = np.radians(100.0)
AMPLITUDE = 12.0


def scanned(torus, noise, degree=2, **values):
    return scan_edge(
        AnalyticCmm(torus, noise=noise, seed=4),
        at=Start(*torus.start(AMPLITUDE, azimuth=0.1)),
        gate=Gate(*torus.gate(AMPLITUDE, azimuth=0.5)),
        parameters=ScanParameters(amplitude=AMPLITUDE, degree=degree, **values),
    )


def off(torus, edge):
    x, y, z = edge.points.T
    return np.hypot(np.hypot(x, y) - torus.edge_radius, z + torus.section_radius)


@pytest.mark.parametrize("noise", [0.0, 0.0005, 0.005])
@pytest.mark.parametrize("fillet", [0.0, 1.0, 2.0])
def test_the_first_line_tells_the_tolerance(fillet, noise):
    """Twice a curve's leverage of the noise at the edge, and what quadratics are off from arcs."""
    torus = TorusObject(100.0, 60.0, ANGLE, fillet, 0.5)
    edge = scanned(torus, noise)
    tolerance = edge.parameters.tolerance
    assert edge.reasons["tolerance"].startswith("four times")
    assert 1e-4 * AMPLITUDE <= tolerance < 8.0 * noise + 0.002
    rms = np.sqrt(np.mean(np.square(off(torus, edge)[1:-1])))
    assert rms < 3.0 * noise + 5e-4


def test_a_rounding_passes_a_tolerance_that_is_given_too_large():
    """What the default was: a fiftieth of the amplitude, with which a sigma says nothing."""
    torus = TorusObject(100.0, 60.0, ANGLE, 2.0, 0.5)
    learned, given = scanned(torus, 0.0), scanned(torus, 0.0, tolerance=AMPLITUDE / 50.0)
    assert given.reasons["tolerance"] == "given"
    assert off(torus, learned).mean() < 0.5 * off(torus, given).mean()


def test_a_given_probe_radius_that_is_not_the_machine_s_is_told():
    torus = TorusObject(100.0, 60.0, ANGLE, 0.0, 0.5)
    assert "its own is 0.5 mm" in scanned(torus, 0.0, probe_radius=1.0).message
    assert "its own" not in scanned(torus, 0.0, probe_radius=0.5).message
    assert "its own" not in scanned(torus, 0.0).message
