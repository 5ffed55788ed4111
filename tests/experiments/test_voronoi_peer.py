# SPDX-License-Identifier: LGPL-2.1-or-later
"""CGAL's program is built when it can be, and else it is said how to get it."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

import freecad_edgescan as es
from freecad_edgescan.experiments.voronoi_peer import VoronoiPeer

HAS_CGAL = shutil.which("g++") and Path("/usr/include/CGAL/vcm_estimate_edges.h").exists()


def test_without_a_compiler_it_is_said_how_to_get_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "which", lambda _: None)
    with pytest.raises(ValueError, match="apt-get install g"), VoronoiPeer():
        pass


@pytest.mark.slow
@pytest.mark.skipif(not HAS_CGAL, reason="CGAL is not installed")
def test_it_labels_points_beside_a_ridge_and_none_far_from_it() -> None:
    x, y = np.random.default_rng(0).uniform(-10.0, 10.0, (2, 1600))
    cloud = es.PointCloud(np.column_stack([x, y, -np.abs(x)]))
    with VoronoiPeer() as peer:
        labelled = peer.labelled(cloud)
    inner = labelled[np.abs(labelled[:, 1]) < 6.0]
    inner = inner[np.abs(inner[:, 0]) < 6.0]
    assert len(inner) > 20 and np.abs(inner[:, 0]).max() < 6.0 * cloud.pitch
