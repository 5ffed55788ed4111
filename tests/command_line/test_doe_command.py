# SPDX-License-Identifier: LGPL-2.1-or-later
"""``edgescan doe``: what it prints and writes, and what it refuses."""

from __future__ import annotations

import csv
import signal
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import freecad_edgescan.doe_command as doe_command
from freecad_edgescan.__main__ import main
from freecad_edgescan.command_options import read_options
from freecad_edgescan.experiments.doe_published import published_result
from freecad_edgescan.experiments.doe_result import DoeResult


@pytest.fixture
def asked(monkeypatch, tmp_path: Path) -> list[dict]:
    """What is asked of the experiments, which here give the published results at once."""
    calls: list[dict] = []

    def answer(experiments, patterns, degrees, method, seed, jobs, literal, progress) -> DoeResult:
        calls.append({"seed": seed, "experiments": experiments, "method": method, "jobs": jobs})
        runs = tuple(
            run
            for run in published_result()
            if run.experiment in experiments and run.pattern in patterns and run.degree in degrees
        )
        lost = replace(runs[seed], completed=False)
        return DoeResult((*runs[:seed], lost, *runs[seed + 1 :]), seed)

    monkeypatch.setattr(doe_command, "run_doe", answer)
    monkeypatch.chdir(tmp_path)
    return calls


def test_tables_are_printed_and_the_runs_written(asked, capsys, tmp_path: Path) -> None:
    assert main(["doe", "--experiments", "1,6-7"]) == 0
    said = capsys.readouterr().out
    assert asked == [{"seed": 0, "experiments": (1, 6, 7), "method": "probe", "jobs": 2}]
    total = next(line for line in said.splitlines() if line.startswith("all "))
    assert total.split()[:4] == ["all", "192", "185", "186"]  # of, ours, published
    assert "experiment 6" in said
    assert "experiment 5" not in said
    assert "1Z1.1 " in said
    with (tmp_path / "doe.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 192
    assert {row["experiment"] for row in rows} == {"1", "6", "7"}


def test_some_patterns_and_degrees_of_another_seed(asked, capsys) -> None:
    words = ["--patterns", "square", "--degrees", "2", "--seed", "3", "--csv", "mine.csv"]
    assert main(["doe", *words, "--jobs", "1"]) == 0
    said = capsys.readouterr().out
    assert "S2" in said
    assert "Z1" not in said
    assert (asked[0]["seed"], asked[0]["jobs"]) == (3, 1)
    assert Path("mine.csv").read_text(encoding="utf-8").splitlines()[1].startswith("3,1,1,square,2")


def test_several_seeds_are_compared_and_share_a_table(asked, capsys) -> None:
    assert main(["doe", "--experiments", "6", "--seeds", "3"]) == 0
    said = capsys.readouterr().out
    assert [call["seed"] for call in asked] == [0, 1, 2]
    assert "differ by 0 completed runs, fewer than 3" in said
    assert len(Path("doe.csv").read_text(encoding="utf-8").splitlines()) == 1 + 3 * 64


def test_pictures_go_into_their_folder(asked, capsys) -> None:
    pytest.importorskip("matplotlib")
    assert main(["doe", "--experiments", "6", "--plot", "made/pictures"]) == 0
    names = {path.name for path in Path("made/pictures").iterdir()}
    assert names == {"ratios.png", "effects-6.png", "effects.csv"}
    assert "3 files into made/pictures" in capsys.readouterr().out


def test_a_figure_is_printed_and_drawn(monkeypatch, capsys, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    assert main(["doe", "--figure", "D.9"]) == 0
    rows = [line.split() for line in capsys.readouterr().out.splitlines()[3:-1]]
    table = np.array(rows, dtype=float)
    # Schreve appendix D, table 1: a twelfth of a circle, s/r = π/6, largest deviation at its ends
    printed = np.hypot(1 - 1.022225, 0.004723)
    assert np.interp(np.pi / 6, *table.T) == pytest.approx(printed, rel=0.01)
    assert Path("figure-D.9.png").stat().st_size > 10_000


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--experiments", "3-1"], "'3-1' are not whole numbers"),
        (["--experiments", "13"], "13; choose from 1 to 12"),
        (["--patterns", "spiral"], "spiral"),
        (["--seeds", "0"], "--seeds is 0"),
        (["--seed", "1", "--seeds", "2"], "not allowed with"),
        (["--figure", "5.1"], "5.1"),
        (["--figure", "5.6", "--compare", "tangent"], "not allowed with"),
        (["--figure", "5.6", "--experiments", "3"], "--experiments is not for --figure"),
        (["--compare", "tangent", "--seeds", "2"], "--seeds is not for --compare"),
        (["-o", "picture.png"], "--figure or --compare"),
        (["--csv", "doe.txt"], "unknown ending"),
        (["--csv", "nowhere/doe.csv"], "no folder nowhere"),
        (["--figure", "5.2", "-o", "figure.xyz"], "unknown ending"),
        (["--plot", "a-file"], "a-file is a file"),
        (["--method", "patch", "--literal"], "as printed"),
        (["--jobs", "0"], "0 jobs"),
    ],
)
def test_what_cannot_work_is_one_sentence(
    words: list[str], said: str, capsys, monkeypatch, tmp_path: Path
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("a-file").write_text("")
    try:
        code = main(["doe", *words])
    except SystemExit as stopped:
        code = stopped.code
    error = capsys.readouterr().err
    assert code == 2
    assert said in error
    assert len(error.strip().splitlines()) == 1
    assert not Path("doe.csv").exists()


def test_a_comparison_stopped_before_its_first_part_says_that_nothing_is_there(
    monkeypatch, capsys, tmp_path: Path
) -> None:
    monkeypatch.chdir(tmp_path)

    def interrupted(choice, seed, jobs, progress):
        signal.raise_signal(signal.SIGINT)
        assert not progress.update(0.1, "part 1 of 4")
        return ()

    monkeypatch.setattr("freecad_edgescan.experiments.doe_choices.compare_choices", interrupted)
    assert main(["doe", "--compare", "compensation"]) == 130
    said = capsys.readouterr()
    assert said.out == ""
    assert "nothing was complete yet" in said.err
    assert not list(tmp_path.iterdir())


def test_options_are_read_without_loading_numbers() -> None:
    options = read_options(["doe", "--experiments", "1-3,8", "--patterns", "square", "--literal"])
    assert options.experiments == (1, 2, 3, 8)
    assert options.patterns == ("square",)
    assert options.literal
