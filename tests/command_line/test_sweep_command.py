# SPDX-License-Identifier: LGPL-2.1-or-later
"""edgescan sweep makes surfaces of scanned edges, and says how far the cloud is from them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.stats import norm

from freecad_edgescan.__main__ import main

LENGTH, WIDTH, DEPTH = 40.0, 16.0, 6.0
NOISE = 0.01


def trough() -> np.ndarray:
    """A flat-bottomed trough along x in a plate, with a face across its end at x = 0."""
    random = np.random.default_rng(2)

    def patch(origin, u, v, count):
        s, t = random.uniform(size=(2, count))
        return np.array(origin) + s[:, None] * np.array(u) + t[:, None] * np.array(v)

    half = WIDTH / 2
    sides = [
        patch((0, half, 0), (LENGTH, 0, 0), (0, 10, 0), 6000),
        patch((0, -half, 0), (LENGTH, 0, 0), (0, -10, 0), 6000),
        patch((0, half, 0), (LENGTH, 0, 0), (0, 0, -DEPTH), 4000),
        patch((0, -half, 0), (LENGTH, 0, 0), (0, 0, -DEPTH), 4000),
        patch((0, -half, -DEPTH), (LENGTH, 0, 0), (0, WIDTH, 0), 9000),
    ]
    return np.vstack(sides) + random.normal(0, NOISE, (sum(map(len, sides)), 3))


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("trough") / "trough.xyz"
    np.savetxt(path, trough())
    return path


def test_two_rails_give_a_surface_fitted_to_the_cloud(
    file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table = tmp_path / "deviation.csv"
    rails = ["--rail", f"20,{WIDTH / 2},{-DEPTH}", "--rail", f"20,{-WIDTH / 2},{-DEPTH}"]
    assert main(["sweep", str(file), *rails, "--distance", "0.5", "-o", str(table)]) == 0
    said = capsys.readouterr().out
    assert "of the fitted sweep" in said and f"Wrote {table}" in said
    average = float(said.split("average")[1].split()[0])
    rows = np.loadtxt(table, delimiter=",", skiprows=1)
    inside = rows[:, 4] == 0
    assert np.abs(rows[inside, 3]).mean() == pytest.approx(average, abs=1e-4)
    # points at the foot of the walls are as near, and pull at the rim: the typical one tells
    assert inside.sum() > 8000
    assert np.median(np.abs(rows[inside, 3])) < 1.2 * NOISE * norm.ppf(0.75)


def test_what_cannot_be_swept_is_one_sentence(
    file: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    rail = ["--rail", f"20,{WIDTH / 2},0"]
    for words, sentence in (
        ([], "takes one or two --rail X,Y,Z"),
        (rail, "Along one --rail a --profile X,Y,Z is swept"),
        ([*rail, *rail, "--distance", "0"], "--distance is 0 mm"),
        ([*rail, *rail, "-o", "sweep.txt"], "unknown ending"),
        ([*rail, *rail], "The two rails meet"),
    ):
        assert main(["sweep", str(file), *words]) == 2
        said = capsys.readouterr().err.strip().splitlines()
        assert sentence in said[-1]
