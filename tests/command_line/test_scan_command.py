# SPDX-License-Identifier: LGPL-2.1-or-later
"""`scan`: what it prints and writes, also when it is stopped or nobody reads."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import freecad_edgescan.scan_command as scan_command
from freecad_edgescan.__main__ import main
from freecad_edgescan.terminal_progress import TerminalProgress

from .roof import edge_points, roof

CHECKOUT = Path(__file__).resolve().parents[2]


def test_scan_prints_a_table_and_writes_edge_points(capsys, roof_file: Path) -> None:
    table = roof_file.parent / "edge.csv"
    assert main(["scan", str(roof_file), "--at", "-1,0.2,0", "-o", str(table)]) == 0
    assert "CLOUD_END / CLOUD_END" in capsys.readouterr().out
    points = edge_points(table)
    assert len(points) > 10
    assert np.hypot(points[:, 1], points[:, 2]).max() < 0.05


def test_scan_probes_line_by_line(capsys, roof_file: Path) -> None:
    table = roof_file.parent / "edge.csv"
    words = ["scan", str(roof_file), "--at", "-1,0.2,0", "--method", "probe", "-o", str(table)]
    assert main(words) == 0
    assert "OFF_OBJECT / OFF_OBJECT" in capsys.readouterr().out
    points = edge_points(table)
    assert len(points) > 10
    assert np.hypot(points[:, 1], points[:, 2]).mean() < 0.03


def test_scan_writes_native_edges_for_cad(capsys, roof_file: Path) -> None:
    pytest.importorskip("FreeCAD")
    file = roof_file.parent / "edge.step"
    assert main(["scan", str(roof_file), "--at", "-1,0.2,0", "-o", str(file)]) == 0
    assert "LINE(" in file.read_text()


def test_scan_draws_a_picture(capsys, roof_file: Path) -> None:
    pytest.importorskip("matplotlib")
    file = roof_file.parent / "edge.png"
    assert main(["scan", str(roof_file), "--at", "-1,0.2,0", "--picture", str(file)]) == 0
    assert file.read_bytes().startswith(b"\x89PNG")


def test_several_clicks_give_several_numbered_tables(capsys, roof_file: Path) -> None:
    words = ["--at", "-1,0.2,0", "--at", "3,0,0", "-o", str(roof_file.parent / "e.csv")]
    assert main(["scan", str(roof_file), *words]) == 0
    assert (roof_file.parent / "e-1.csv").is_file()
    assert (roof_file.parent / "e-2.csv").is_file()


def test_a_scan_from_start_to_gate_stops_at_the_gate(capsys, roof_file: Path) -> None:
    words = ["--start", "-10,-2,-2", "--across", "0,1,1", "--along", "1,0,0", "--gate", "10,-2,-2"]
    words += ["--gate-across", "0,1,0", "--amplitude", "6"]
    assert main(["scan", str(roof_file), *words]) == 0
    assert "START / GATE" in capsys.readouterr().out


def test_one_bad_click_leaves_the_other_edges_alone(capsys, roof_file: Path) -> None:
    table = roof_file.parent / "edge-2.csv"  # the click's own number
    words = ["--at", "500,0,0", "--at", "-1,0.2,0", "-o", str(roof_file.parent / "edge.csv")]
    assert main(["scan", str(roof_file), *words]) == 2
    said = capsys.readouterr()
    assert "edge 1" in said.err
    assert table.is_file()


def test_ctrl_c_keeps_what_was_found_and_leaves_out_the_rest(
    capsys, monkeypatch: pytest.MonkeyPatch, roof_file: Path
) -> None:
    class Interrupted(TerminalProgress):
        def update(self, fraction: float, so_far: object) -> bool:
            if len(so_far.points) >= 5:
                signal.raise_signal(signal.SIGINT)
            return super().update(fraction, so_far)

    output = str(roof_file.parent / "edge.csv")
    words = ["scan", str(roof_file), "--at", "-1,0.2,0", "--at", "3,0,0", "-o", output]
    monkeypatch.setattr(scan_command, "TerminalProgress", Interrupted)
    assert main(words) == 130
    said = capsys.readouterr()
    assert "CANCELLED" in said.out
    assert said.err.strip() == "edgescan: stopped; what was found so far is kept."
    points = edge_points(roof_file.parent / "edge-1.csv")
    assert 5 <= len(points) < 40
    assert np.hypot(points[:, 1], points[:, 2]).max() < 0.05


def test_files_are_complete_and_nothing_is_said_when_nobody_reads(roof_file: Path) -> None:
    table = roof_file.parent / "edge.csv"
    words = ["scan", str(roof_file), "--at", "-1,0.2,0", "-o", str(table)]
    reading, writing = os.pipe()
    os.close(reading)
    try:
        answer = subprocess.run(
            [sys.executable, "-m", "freecad_edgescan", *words],
            stdout=writing, stderr=subprocess.PIPE, cwd=CHECKOUT,
        )  # fmt: skip
    finally:
        os.close(writing)
    assert (answer.returncode, answer.stderr) == (141, b"")
    assert len(edge_points(table)) > 10


def test_how_far_a_probe_radius_moves_a_sharp_rim_is_said_and_true(capsys, roof_file: Path) -> None:
    """Points on the part itself, given a radius by mistake, look like a sharp inner edge."""
    table = roof_file.parent / "moved.csv"
    words = ["--at", "-1,0.2,0", "--probe-radius", "1", "-o", str(table)]
    assert main(["scan", str(roof_file), *words]) == 0
    said = capsys.readouterr().out
    away = np.linalg.norm(edge_points(table)[:, 1:], axis=1).mean()
    assert away == pytest.approx(np.sqrt(2.0), abs=0.02)  # of a right angle
    stated = re.search(r"the edge lies (\S+) mm off", said)
    assert stated is not None and float(stated[1]) == pytest.approx(away, abs=0.02)
    assert "If the points lie on the part itself, give no probe radius." in said


def test_help_that_nobody_reads_is_silent() -> None:
    reading, writing = os.pipe()
    os.close(reading)
    try:
        answer = subprocess.run(
            [sys.executable, "-m", "freecad_edgescan", "scan", "--help"],
            stdout=writing, stderr=subprocess.PIPE, cwd=CHECKOUT,
        )  # fmt: skip
    finally:
        os.close(writing)
    assert answer.stderr == b""


def test_a_sigma_of_some_nanometres_is_not_printed_as_zero(capsys, tmp_path: Path) -> None:
    np.savetxt(tmp_path / "exact.xyz", roof(noise=1e-6))
    assert main(["scan", str(tmp_path / "exact.xyz"), "--at", "-1,0.2,0"]) == 0
    row = capsys.readouterr().out.splitlines()[2].split()
    assert 0.0 < float(row[6]) < 1e-4


def test_scan_draws_a_picture_and_the_section_that_was_clicked(capsys, roof_file: Path) -> None:
    pytest.importorskip("matplotlib")
    folder = roof_file.parent
    words = ["scan", str(roof_file), "--at", "-1,0.2,0", "--picture", str(folder / "edge.png")]
    words += ["--view", "0,-1,1", "--section", str(folder / "section.png")]
    assert main(words) == 0
    assert (folder / "edge.png").is_file() and (folder / "section.png").is_file()
