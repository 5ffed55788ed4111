# SPDX-License-Identifier: LGPL-2.1-or-later
"""edgescan recommend prints what to scan an edge with."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from freecad_edgescan.__main__ import main


@pytest.fixture(scope="module")
def roof_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two planes that meet at a right angle in the x axis."""
    along, away = np.meshgrid(np.arange(-12.0, 12.0, 0.4), np.arange(0.2, 9.0, 0.4))
    sides = [
        np.outer(along.ravel(), (1.0, 0.0, 0.0)) + np.outer(away.ravel(), np.array(way) / 2**0.5)
        for way in ((0.0, 1.0, -1.0), (0.0, -1.0, -1.0))
    ]
    points = np.vstack(sides) + np.random.default_rng(5).normal(0.0, 0.01, (2 * along.size, 3))
    path = tmp_path_factory.mktemp("roof") / "roof.xyz"
    np.savetxt(path, points)
    return path


@pytest.mark.parametrize("method", ["probe", "patch"])
def test_an_edge_is_measured_and_explained(
    capsys: pytest.CaptureFixture[str], roof_file: Path, method: str
) -> None:
    assert main(["recommend", str(roof_file), "--at", "-1,0.2,0", "--method", method]) == 0
    said = capsys.readouterr().out
    assert float(said.split("angle")[1].split()[0]) == pytest.approx(90.0, abs=1.0)
    amplitude = float(said.split("amplitude")[1].split()[0])
    assert 4.0 < amplitude < 20.0
    error = float(said.split("Error to expect:")[1].split()[0])
    assert 0.0 < error < 0.05


def test_given_values_and_several_places(
    capsys: pytest.CaptureFixture[str], roof_file: Path
) -> None:
    words = ["--at", "-1,0.2,0", "--at", "4,0,0", "--amplitude", "9", "--edge-pitch", "1.5"]
    assert main(["recommend", str(roof_file), *words]) == 0
    said = capsys.readouterr().out
    assert said.count("Error to expect") == 2
    assert "9 mm             given" in said
    assert "1.5 mm           given" in said


def test_without_a_place_it_says_what_to_give(
    capsys: pytest.CaptureFixture[str], roof_file: Path
) -> None:
    assert main(["recommend", str(roof_file)]) == 2
    assert "--at X,Y,Z" in capsys.readouterr().err
