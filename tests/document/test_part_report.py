# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of CAD parts in simulated scans: found from one click each, and reported honestly."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

from freecad_edgescan.__main__ import main  # noqa: E402
from freecad_edgescan.document.known_parts import (  # noqa: E402
    block_with_bore,
    filleted,
    sharp_part,
    simple_parts,
)
from freecad_edgescan.document.part_report import read_part, report_part  # noqa: E402


@pytest.fixture(scope="module")
def report():
    return report_part(
        sharp_part("small block", Part.makeBox(20.0, 20.0, 10.0)), pitch=0.5, noise=0.02
    )


def test_every_edge_of_a_block_is_traced_from_one_click_at_its_middle(report) -> None:
    assert len(report.rows) == 12
    assert len(report.traced) == 12
    assert max(row.rms for row in report.rows) < 0.03
    assert sum(row.wandering for row in report.rows) == 0


def test_the_text_has_a_row_for_each_edge_and_sums_up(report) -> None:
    lines = report.text().splitlines()
    assert sum(line.startswith("Edge") and "CORNER" in line for line in lines) == 12
    assert "12 of them traced along at least 90%" in report.text()
    before = np.concatenate([row.unsmoothed_in_sigmas for row in report.rows])
    middle, most = np.percentile(before, [50, 95])
    assert f"of one section by itself {middle:.2f}, {most:.2f} (true ones" in report.text()
    alone = np.concatenate([row.edge.reserve * row.in_sigmas for row in report.traced])
    middle, most = np.percentile(alone, [50, 95])
    assert f"without what short edges add {middle:.2f}, {most:.2f}; of one" in report.text()


def test_edges_with_little_room_are_counted_by_themselves(report) -> None:
    rows = report.rows
    lost = replace(rows[0], traced=0.5)
    wide = replace(report, rows=(lost, *rows[1:]))
    middle = np.median([row.rms for row in rows[1:]])
    said = "With 5 pitches of room and more, and 12 of length: 11 of 12 found"
    assert (
        f"{said}, with an rms error of at most 0.25 pitches (median {middle:.4f} mm)."
        in wide.text()
    )
    assert "With less" not in wide.text()
    # The same edges, were the points as far apart as a quarter of the part.
    coarse = replace(wide, pitch=5.0)
    assert "With less: 11 of 12 found" in coarse.text()
    astray = replace(wide, rows=(lost, replace(rows[1], wandering=1), *rows[2:]))
    assert "10 of 12 found" in astray.text()


def test_a_cancelled_report_keeps_the_edges_so_far() -> None:
    class Stopper:
        def update(self, fraction: float, so_far: object) -> bool:
            return fraction < 0.2

    part = report_part(sharp_part("block", Part.makeBox(20, 20, 10)), 0.5, 0.02, progress=Stopper())
    assert len(part.rows) == 3


@pytest.mark.slow
def test_the_block_with_a_bore_meets_the_promise_at_thirteen_edges_of_fourteen() -> None:
    report = report_part(sharp_part("block with bore", block_with_bore()), pitch=0.6, noise=0.12)
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
        ("broken.step", "this is not a STEP file", "broken.step cannot be read as CAD .Error in"),
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


def test_the_sharp_edges_are_found_under_fillets() -> None:
    """To the noise and a fiftieth of the radius."""
    part = filleted("block", Part.makeBox(40.0, 40.0, 30.0), radius=1.5, pitch=0.5)
    report = report_part(part, 0.5, 0.1)
    good = [row for row in report.rows if row.rms <= 0.1 + 0.02 * 1.5]
    assert len(report.rows) == 12
    assert len(good) >= 11
    assert sum(row.wandering for row in report.rows) == 0
    said = f"Under fillets of 1.5 mm: {len(good)} of 12 with an rms error of at most one noise"
    assert said in report.text()
    assert "(0.13 mm); of those with 5 pitches of side between" in report.text()
    # Sides of 30 mm between two fillets of 1.5 mm, all along.
    np.testing.assert_allclose(min(part.side_left(edge).min() for edge in part.edges), 27.0)


def test_a_fillet_too_large_for_every_edge_is_one_sentence() -> None:
    with pytest.raises(ValueError, match="No edge of block can be rounded"):
        filleted("block", Part.makeBox(5.0, 5.0, 5.0), radius=4.0, pitch=0.5)


def test_the_simple_parts_have_one_edge_each_which_is_theirs() -> None:
    planes, rounded, rim = simple_parts()
    for part in (planes, rounded):
        np.testing.assert_allclose(part.edges[0].distance([[30.0, 0.0, 30.0]]), 0.0, atol=1e-9)
        assert not part.edges[0].closed
    assert rounded.shape.Volume < planes.shape.Volume
    radius = np.hypot(*rim.edges[0].points[:, :2].T)
    np.testing.assert_allclose(radius, 20.0, atol=1e-4)
