# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simple parts: as near to the truth as promised, also among outliers, and said in one table."""

from __future__ import annotations

import sys
from importlib.machinery import PathFinder
from importlib.util import find_spec
from types import SimpleNamespace

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")

from freecad_edgescan.__main__ import main  # noqa: E402
from freecad_edgescan.accuracy_command import _reach_peers  # noqa: E402
from freecad_edgescan.document.accuracy_table import (  # noqa: E402
    measure_simple_parts,
    simple_table,
    with_outliers,
)
from freecad_edgescan.document.known_parts import simple_parts  # noqa: E402
from freecad_edgescan.document.simulated_shape import simulate_cloud  # noqa: E402
from freecad_edgescan.experiments.edge_report import root_mean_square  # noqa: E402
from freecad_edgescan.experiments.peers import plane_pair, variation_labels  # noqa: E402


@pytest.fixture(scope="module")
def rows():
    return measure_simple_parts(3)  # the command takes five


def test_edge_points_are_as_near_as_promised(rows) -> None:
    wanted = {"two planes": 0.006, "two planes, fillet 2 mm": 0.012, "cylinder rim": 0.008}
    assert [row.name for row in rows] == list(wanted)
    for row in rows:
        assert root_mean_square(row.errors) <= wanted[row.name], row.name
        assert root_mean_square(row.errors) < root_mean_square(row.unsmoothed)
        assert 0.6 < np.median(row.in_sigmas) < 1.5
        assert np.percentile(row.in_sigmas, 95) < 3.2


@pytest.mark.parametrize("number", [0, 1, 2])
def test_outliers_worsen_them_by_less_than_a_half(rows, number) -> None:
    row = rows[number]
    assert root_mean_square(row.among_outliers) < 1.5 * root_mean_square(row.errors), row.name


def test_outliers_lie_within_twenty_pitches() -> None:
    cloud = simulate_cloud(simple_parts()[0].shape, 1.0, 0.02)
    spoilt = with_outliers(cloud, 0)
    assert len(spoilt) == len(cloud) + round(0.05 * len(cloud))
    away = cloud.tree.query(spoilt.points)[0]
    assert 5.0 < away.max() <= 10.0
    assert np.count_nonzero(away) > 0.045 * len(cloud)


def test_the_table_names_parts_and_peers(rows) -> None:
    text = simple_table(rows)
    assert all(row.name in text for row in rows)
    assert "planes   variation" not in text
    for line, row in zip(text.splitlines()[2:], rows, strict=True):
        distances = [float(word) for word in line.split()[-4:]]
        smoothed, single = row.in_sigmas, row.unsmoothed_in_sigmas
        both = [*np.percentile(smoothed, [50, 95]), *np.percentile(single, [50, 95])]
        np.testing.assert_allclose(distances, both, atol=5.1e-3)
        # Smoothing makes errors smaller, and sigma as much smaller.
        assert abs(np.median(smoothed) - np.median(single)) < 0.3


def test_the_first_cloud_is_kept_for_a_picture(rows) -> None:
    for row in rows:
        first = row.first.errors
        np.testing.assert_array_equal(first, row.errors[: len(first)])
        assert len(first) < len(row.errors)


def test_a_cancelled_measurement_keeps_whole_parts() -> None:
    stop = SimpleNamespace(update=lambda fraction, so_far: fraction < 0.2)
    assert measure_simple_parts(1, progress=stop)[0].name == "two planes"


def test_two_planes_meet_in_the_edge_and_labels_lie_beside_it(monkeypatch) -> None:
    """With stand-ins for what installs from PyPI: a plane of its points, a plain variation."""
    part = simple_parts()[0]
    cloud, (truth,) = simulate_cloud(part.shape, 0.5, 0.02), part.edges

    class Plane:
        def fit(self, points, thresh, maxIteration):
            level = 30.0 if np.median(points[:, 1]) > 0.5 else None
            off = points[:, 1] if level is None else points[:, 2] - level
            return SimpleNamespace(inliers=np.flatnonzero(np.abs(off) < thresh))

    def compute_features(points, search_radius, feature_names):
        assert feature_names == ["surface_variation"]
        return -truth.distance(points)[:, None]

    monkeypatch.setitem(sys.modules, "pyransac3d", SimpleNamespace(Plane=Plane))
    monkeypatch.setitem(
        sys.modules, "jakteristics", SimpleNamespace(compute_features=compute_features)
    )
    assert truth.distance(plane_pair(cloud, truth, 0.02)).max() < 0.01
    labels = variation_labels(cloud, truth, 0.02)
    assert len(labels) == int(truth.length / cloud.pitch)
    assert truth.distance(labels).max() < 1.0


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--peers", "--parts", "x.step"], "leave --parts out"),
        (["--peers", "--wedges", "3"], "leave --peers out"),
        (["--seeds", "0"], "give 1 or more"),
        (["--seeds", "3", "--parts", "x.step"], "leave --parts out"),
        (["--fillet", "1", "--wedges", "3"], "leave --fillet out"),
        (["--fillet", "-1"], "give 0 or a positive radius"),
        (["--sharp"], "belongs to --wedges"),
        (["--steps", "3", "--sharp"], "belongs to --wedges"),
        (["--steps", "0"], "--steps is 0; give 1 or more"),
        (["--steps", "3", "--wedges", "3"], "give one of them"),
    ],
)
def test_options_that_do_not_go_together_are_one_sentence(capsys, words, said) -> None:
    assert main(["accuracy", *words]) == 2
    assert said in capsys.readouterr().err


def test_peers_that_are_not_installed_are_named(capsys, monkeypatch) -> None:
    monkeypatch.setattr("freecad_edgescan.experiments.peers.find_spec", lambda name: None)
    assert main(["accuracy", "--peers"]) == 2
    assert "pyransac3d and jakteristics" in capsys.readouterr().err


def test_peers_are_reached_behind_the_packages_of_the_system(monkeypatch, tmp_path) -> None:
    """What came along with them, such as another NumPy, must not take the system's place."""
    (tmp_path / "numpy.py").write_text("")
    (tmp_path / "only_here.py").write_text("")
    monkeypatch.setattr(sys, "path", list(sys.path))
    monkeypatch.setenv("EDGESCAN_PEERS", str(tmp_path))
    _reach_peers()
    assert find_spec("only_here").origin.startswith(str(tmp_path))
    assert not PathFinder.find_spec("numpy").origin.startswith(str(tmp_path))
