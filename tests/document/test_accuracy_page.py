# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page about accuracy holds the results' own numbers, and says what is not reached."""

from __future__ import annotations

import signal
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")
pytest.importorskip("matplotlib")

import freecad_edgescan.accuracy_command as accuracy_command  # noqa: E402
from freecad_edgescan.__main__ import main  # noqa: E402
from freecad_edgescan.document.accuracy_page import (  # noqa: E402
    Accuracy,
    picture_paths,
    write_page,
)
from freecad_edgescan.document.accuracy_table import SimpleAccuracy, simple_table  # noqa: E402
from freecad_edgescan.document.known_parts import KnownPart, sharp_part  # noqa: E402
from freecad_edgescan.document.part_report import PartReport, report_part  # noqa: E402
from freecad_edgescan.experiments.doe_published import published_counterparts  # noqa: E402
from freecad_edgescan.experiments.doe_result import PATCH, DoeResult  # noqa: E402
from freecad_edgescan.experiments.doe_tables import experiments_table  # noqa: E402
from freecad_edgescan.experiments.rims_and_bends import (  # noqa: E402
    BEND,
    BOX,
    ROUNDED_BOX,
    ExactEdge,
    exact_edge_table,
)


@pytest.fixture(scope="module")
def report() -> PartReport:
    """Two edges of a block."""
    block = sharp_part("block", Part.makeBox(20.0, 20.0, 10.0))
    return report_part(KnownPart("block", block.shape, block.edges[:2], block.edges[2:]), 0.5, 0.02)


@pytest.fixture(scope="module")
def experiments() -> DoeResult:
    """A tenth of the published errors, the largest at a fifth."""
    return DoeResult(
        tuple(
            replace(
                run,
                pattern="patch",
                degree=0,
                completed=True,
                avg_error=run.avg_error / 10.0,
                max_error=run.max_error / 5.0,
                rms_error=0.03,
                bound=0.06,
                mahalanobis=(1.0, 1.2, 2.77),
                unsmoothed_rms=0.05,
                unsmoothed_mahalanobis=(0.9, 1.4, 3.0),
            )
            for run in published_counterparts(PATCH).values()
        )
    )


def simple(report: PartReport, among_outliers: float = 0.006) -> SimpleAccuracy:
    ones = np.ones(40)
    return SimpleAccuracy(
        "two planes",
        report.rows[0],
        0.005 * ones,
        1.11 * ones,
        0.009 * ones,
        1.33 * ones,
        among_outliers * ones,
        {},
    )


def exact(error: float = 0.01, radius: float = 0.82, bias: float = 0.002) -> list[ExactEdge]:
    """Two rims of each box, of which the first is exact, and a bend."""
    errors, sigmas = np.array([0.5, 1.5]), np.array([0.004, 0.004])
    return [
        ExactEdge(BOX, "rim 1", 0.0 * errors, sigmas, np.nan, np.nan),
        ExactEdge(BOX, "rim 2", error * errors, sigmas, np.nan, np.nan),
        ExactEdge(ROUNDED_BOX, "rim 1", 0.0 * errors, sigmas, np.nan, 0.8),
        ExactEdge(ROUNDED_BOX, "rim 2", 2.0 * error * errors, sigmas, np.nan, radius),
        ExactEdge(BEND, "90°", 0.005 * errors, sigmas, bias, np.nan),
    ]


@pytest.fixture
def measured(report, experiments) -> Accuracy:
    return Accuracy(
        "./edgescan accuracy --report page.md",
        [simple(report)],
        exact(),
        "./edgescan accuracy",
        [(report, "./edgescan accuracy --parts block.step")],
        experiments,
        "./edgescan doe --method patch",
    )


def rows_of(text: str, name: str) -> list[list[str]]:
    """Cells of the Markdown rows that begin with a name."""
    lines = [line for line in text.splitlines() if line.startswith(f"| {name}")]
    return [[cell.strip() for cell in line.strip("|").split("|")][1:] for line in lines]


def test_the_page_holds_what_the_results_say_below_the_commands(measured, tmp_path) -> None:
    page = tmp_path / "page.md"
    written = write_page(measured, page)
    text = page.read_text(encoding="utf-8")
    ((report, call),) = measured.parts
    for command, table in (
        (measured.simple_call, simple_table(measured.simple)),
        (measured.simple_call, exact_edge_table(measured.exact)),
        (call, report.text()),
        (measured.experiments_call, experiments_table(measured.experiments)),
    ):
        assert f"    {command}\n\n```\n{table}\n```" in text
    assert rows_of(text, "two planes: rms error ") == [
        ["at most 0.006 mm", "0.0050 mm", "yes"],
        ["at most 1.5", "1.200", "yes"],
    ]
    assert rows_of(text, "core box") == [
        ["at most 0.015 mm", "0.0100 mm", "yes"],
        ["at most 0.06 mm", "0.0150 mm", "yes"],
        ["at most 0.025 mm", "0.0200 mm", "yes"],
        ["at most 0.1 mm", "0.0300 mm", "yes"],
        ["at most 0.15", "0.025", "yes"],
    ]
    assert rows_of(text, "bends: bias") == [["at most 1", "0.500", "yes"]]
    assert rows_of(text, "average error") == [["at most 0.18", "0.100", "yes"]]
    assert rows_of(text, "maximum error") == [["at most 0.3", "0.200", "yes"]]
    assert rows_of(text, "scans completed") == [["192 of 192", "192", "yes"]]
    assert rows_of(text, "rms error over the smallest possible, one section") == [
        ["at most 1.1", "0.833", "yes"],
        ["at most 1.6", "0.833", "yes"],
    ]
    assert rows_of(text, "rms error over the smallest possible, edge") == [
        ["at most 0.8", "0.500", "yes"]
    ]
    assert rows_of(text, "distance in stated sigma, median") == [
        ["0.95 to 1.5", "1.20 to 1.20", "yes"]
    ]
    assert rows_of(text, "experiments") == [["1.20", "2.77", "2.77", "1.40", "3.00", "3.00"]]
    assert "All that is wanted is reached." in text
    assert str(tmp_path) not in text
    assert written == [page, *picture_paths(page).values()]
    for picture in written[1:]:
        assert f"](pictures/{picture.name})" in text
        assert picture.stat().st_size > 5000


def test_what_is_not_reached_is_said_first_and_in_its_table(measured, report, tmp_path) -> None:
    page = tmp_path / "page.md"
    runs = measured.experiments.runs
    failed = (replace(runs[0], completed=False), *runs[1:])
    lost = replace(report.rows[0], traced=0.3, wandering=2)
    worse = replace(
        measured,
        simple=[simple(report, among_outliers=0.008)],
        parts=[(replace(report, rows=(lost, report.rows[1])), "call")],
        experiments=replace(measured.experiments, runs=failed),
    )
    write_page(worse, page)
    top, _, rest = page.read_text(encoding="utf-8").partition("\n## ")
    assert top.count("\n- ") == 3 + 4  # what words mean, then what is not reached
    assert "rms error with outliers over without: 1.600, wanted at most 1.5." in top
    assert "block: edges found along 90 % of their length" in top
    assert "block: edge points farther than 3 pitches from every true edge: 2, wanted 0." in top
    assert "scans completed: 191, wanted 192 of 192." in top
    assert rest.count("| **no** |") == 4


def test_rims_and_bends_that_are_off_are_not_reached(measured, tmp_path) -> None:
    """A rounding whose radius is not stated is not found."""
    page = tmp_path / "page.md"
    write_page(replace(measured, exact=exact(0.07, np.nan, 0.005)), page)
    text = page.read_text(encoding="utf-8")
    assert [row[2] for row in rows_of(text, "core box")] == ["**no**"] * 5
    assert rows_of(text, "core box rounded: share") == [["at most 0.15", "nan", "**no**"]]
    assert rows_of(text, "bends: bias") == [["at most 1", "1.250", "**no**"]]


def test_sigmas_of_one_experiment_that_are_not_true_are_not_reached(measured, tmp_path) -> None:
    """Too large ones are as untrue as too small ones."""
    page = tmp_path / "page.md"
    runs = tuple(
        replace(run, mahalanobis={3: (0.4, 0.5), 4: (1.2, 4.0)}.get(run.experiment, (1.1, 1.3)))
        for run in measured.experiments.runs
    )
    write_page(replace(measured, experiments=replace(measured.experiments, runs=runs)), page)
    text = page.read_text(encoding="utf-8")
    assert rows_of(text, "distance in stated sigma, median") == [
        ["0.95 to 1.5", "0.45 to 2.60", "**no**"]
    ]
    assert rows_of(text, "distance in stated sigma, 95 %") == [["at most 3.2", "4.000", "**no**"]]


def test_no_edge_at_all_is_not_reached_either(measured, report, tmp_path) -> None:
    none = np.zeros(0)
    refused = replace(
        report.rows[0],
        edge=None,
        refusal="nothing here",
        traced=0.0,
        **dict.fromkeys(("errors", "in_sigmas", "unsmoothed", "unsmoothed_in_sigmas"), none),
    )
    row = SimpleAccuracy("two planes", refused, none, none, none, none, none, {})
    parts = [(replace(report, rows=(refused,)), "call")]
    page = tmp_path / "page.md"
    write_page(replace(measured, simple=[row], parts=parts), page)
    assert rows_of(page.read_text(encoding="utf-8"), "two planes: rms error ") == [
        ["at most 0.006 mm", "nan mm", "**no**"],
        ["at most 1.5", "nan", "**no**"],
    ]


# ---------------------------------------------------------------- the command


@pytest.fixture
def quick(monkeypatch, tmp_path, report, experiments):
    """The command in an empty folder, with results that are there at once."""
    monkeypatch.chdir(tmp_path)
    Path("docs").mkdir()
    Part.makeBox(20.0, 20.0, 10.0).exportStep("block.step")
    monkeypatch.setattr(
        "freecad_edgescan.document.accuracy_table.measure_simple_parts",
        lambda seeds, peers, progress: [simple(report)],
    )
    monkeypatch.setattr(
        "freecad_edgescan.experiments.rims_and_bends.measure_exact_edges",
        lambda progress: exact(),
    )
    monkeypatch.setattr(
        "freecad_edgescan.document.part_report.report_part",
        lambda part, *rest: replace(report, part=part),
    )
    scanned = SimpleNamespace(result=experiments, interrupts=False)

    def run_doe(method, seed, progress):
        assert method == "patch"
        if scanned.interrupts:
            signal.raise_signal(signal.SIGINT)
            assert not progress.update(0.3, scanned.result)
        return scanned.result

    monkeypatch.setattr("freecad_edgescan.experiments.run_doe", run_doe)
    return scanned


def test_the_command_writes_the_page_with_the_block_and_the_parts_given(quick, capsys) -> None:
    file = Path("block.step").resolve()
    words = ["--parts", str(file), "--seeds", "3", "--noise", "0.1", "--report", "docs/a.md"]
    assert main(["accuracy", *words]) == 0
    said = capsys.readouterr().out
    assert "Wrote docs/a.md and 3 pictures into docs/pictures" in said
    assert "block.step: " in said
    text = Path("docs/a.md").read_text(encoding="utf-8")
    cloud = "--pitch 0.6 --noise 0.1"
    for call in (
        f"accuracy --seeds 3 --parts block.step {cloud} --report docs/a.md",
        "accuracy --seeds 3",
        f"accuracy {cloud}",
        f"accuracy --parts block.step {cloud}",
        "doe --method patch",
    ):
        assert f"\n    ./edgescan {call}\n" in text
    assert text.index("### block with bore") < text.index("### block.step")
    assert str(file.parent) not in text


def test_a_command_that_is_stopped_leaves_the_old_page_alone_and_says_so(quick, capsys) -> None:
    Path("docs/a.md").write_text("as it was")
    quick.interrupts = True
    assert main(["accuracy", "--report", "docs/a.md"]) == 130
    said = capsys.readouterr()
    assert "two planes" in said.out  # what was measured
    assert "docs/a.md is written only when nothing is missing, and was left alone." in said.err
    assert Path("docs/a.md").read_text() == "as it was"
    assert not Path("docs/pictures").exists()


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--report", "a.txt"], "unknown ending"),
        (["--report", "nowhere/a.md"], "no folder nowhere"),
        (["--report", "a.md", "--fillet", "1"], "leave --fillet or --report out"),
        (["--report", "a.md", "--seed", "-1"], "--seed is -1; give 0 or more"),
        (["--wedges", "5", "--seed", "-1"], "--seed is -1; give 0 or more"),
        (["--pitch", "0"], "--pitch is 0; give a positive length"),
        (["--pitch", "nan"], "--pitch is nan"),
        (["--noise", "-1"], "--noise is -1; give 0 or a positive noise"),
        (["--fillet", "nan"], "--fillet is nan; give 0 or a positive radius"),
        (["--probe-radius", "inf"], "--probe-radius is inf"),
        (["--report", "a.md", "--seeds", "0"], "give 1 or more"),
        (["--report", "a.md", "--wedges", "3"], "leave --report out"),
        (["--report", "a.md", "--parts", "missing.step"], "no file missing.step"),
        (["--report", "taken/a.md"], "pictures is a file"),
    ],
)
def test_a_page_that_cannot_be_is_refused_before_any_work(quick, capsys, words, said) -> None:
    Path("taken").mkdir()
    Path("taken/pictures").write_text("")
    assert main(["accuracy", *words]) == 2
    answer = capsys.readouterr()
    assert said in answer.err
    assert answer.out == ""
    assert not list(Path().rglob("*.md"))


def test_without_matplotlib_the_page_is_refused_in_one_sentence(quick, capsys, monkeypatch) -> None:
    monkeypatch.setattr("freecad_edgescan.experiments.figures.can_draw", lambda: False)
    assert main(["accuracy", "--report", "docs/a.md"]) == 2
    assert "--report needs matplotlib" in capsys.readouterr().err


def test_experiments_are_scanned_with_all_points(quick, monkeypatch) -> None:
    options = SimpleNamespace(seed=4)
    asked = {}
    monkeypatch.setattr(
        "freecad_edgescan.experiments.run_doe",
        lambda **words: asked.update(words) or quick.result,
    )
    assert accuracy_command._experiments(options)[0] is quick.result
    assert (asked["method"], asked["seed"]) == ("patch", 4)
