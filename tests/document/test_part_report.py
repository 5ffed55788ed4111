# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of CAD parts in simulated scans: found from one click each, and reported honestly."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan.__main__ import main  # noqa: E402
from freecad_edgescan.document.part_report import (  # noqa: E402
    block_with_bore,
    read_part,
    report_part,
)


@pytest.fixture(scope="module")
def report():
    return report_part(Part.makeBox(20.0, 20.0, 10.0), "small block", pitch=0.5, noise=0.02)


def test_every_edge_of_a_block_is_traced_from_one_click_at_its_middle(report) -> None:
    assert len(report.rows) == 12
    assert len(report.traced) == 12
    assert max(row.rms for row in report.rows) < 0.03
    assert sum(row.wandering for row in report.rows) == 0


def test_the_text_has_a_row_for_each_edge_and_sums_up(report) -> None:
    lines = report.text().splitlines()
    assert sum(line.startswith("Edge") and "CORNER" in line for line in lines) == 12
    assert "12 of them traced along at least 90%" in report.text()


def test_a_cancelled_report_keeps_the_edges_so_far() -> None:
    class Stopper:
        def update(self, fraction: float, so_far: object) -> bool:
            return fraction < 0.2

    part = report_part(Part.makeBox(20, 20, 10), "block", 0.5, 0.02, progress=Stopper())
    assert len(part.rows) == 3


@pytest.mark.slow
def test_the_block_with_a_bore_meets_the_promise_at_thirteen_edges_of_fourteen() -> None:
    report = report_part(block_with_bore(), "block with bore", pitch=0.6, noise=0.12)
    assert len(report.rows) == 14
    good = [row for row in report.traced if row.rms <= 0.15]
    assert len(good) >= 13
    assert sum(row.wandering for row in report.rows) == 0


def test_the_command_reads_a_part_from_a_file(tmp_path: Path, capsys) -> None:
    file = tmp_path / "block.step"
    Part.makeBox(20.0, 20.0, 10.0).exportStep(str(file))
    words = ["accuracy", "--parts", str(file), "--pitch", "0.5", "--noise", "0.02"]
    assert main(words) == 0
    said = capsys.readouterr().out
    assert "block.step" in said
    assert "12 sharp edges" in said


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("part.xyz", "0 0 0", "unknown ending"),
        ("missing.step", None, "no file"),
        ("broken.step", "this is not a STEP file", "broken.step"),
    ],
)
def test_bad_parts_are_one_sentence(
    tmp_path: Path, name: str, content: str | None, said: str
) -> None:
    file = tmp_path / name
    if content is not None:
        file.write_text(content)
    with pytest.raises(ValueError, match=said):
        read_part(file)


def test_truth_and_scan_share_their_frame(report) -> None:
    low, high = report.cloud.bounds
    np.testing.assert_allclose(low, (0, 0, 0), atol=0.1)
    np.testing.assert_allclose(high, (20, 20, 10), atol=0.1)
