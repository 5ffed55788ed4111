# SPDX-License-Identifier: LGPL-2.1-or-later
"""`bench --sizes`: what it prints, and what it refuses."""

from __future__ import annotations

import dataclasses

import pytest

from freecad_edgescan.__main__ import main
from freecad_edgescan.experiments import cloud_sizes
from freecad_edgescan.experiments.cloud_sizes import SizeCost


def test_what_does_not_go_together_in_bench_is_said(capsys) -> None:
    assert main(["bench", "--sizes", "--parts"]) == 2
    assert "give one at a time" in capsys.readouterr().err
    assert main(["bench", "--sizes", "7"]) == 2
    assert "take 20000 or more" in capsys.readouterr().err


def test_bench_prints_a_row_for_every_size_and_the_slope(
    capsys, monkeypatch: pytest.MonkeyPatch
) -> None:
    cost = SizeCost(100_000, 10**6, 0.1, 10**7, 0.2, 0.1, 0.1, 0.5, 0.1, 1.1, 10**7, 400, 0.002)
    larger = dataclasses.replace(cost, points=1_000_000, scanning=0.8)
    monkeypatch.setattr(cloud_sizes, "measure_sizes", lambda *_: iter([cost, larger]))
    assert main(["bench", "--sizes"]) == 0
    *_, small, large, said = capsys.readouterr().out.splitlines()
    assert [small, large] == [cost.text(), larger.text()]
    assert "10 times as many" in said
    assert said.endswith("factor 1.60: slope 0.204.")  # lg 1.6
