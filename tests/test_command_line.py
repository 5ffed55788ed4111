# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: what a user gets wrong is one sentence, and nothing is lost."""

from __future__ import annotations

import dataclasses
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
from freecad_edgescan.experiments import cloud_sizes
from freecad_edgescan.experiments.cloud_sizes import SizeCost
from freecad_edgescan.terminal_progress import TerminalProgress

CHECKOUT = Path(__file__).resolve().parents[1]
PITCH = 0.5  # mm


def roof(noise: float = 0.01) -> np.ndarray:
    """Two planes that meet at a right angle in the x axis, 40 mm long, 8 mm to each side."""
    along, away = np.meshgrid(np.arange(-20, 20, PITCH), np.arange(PITCH / 2, 8, PITCH))
    sides = []
    for direction in ((0, 1, -1), (0, -1, -1)):
        unit = np.array(direction) / np.sqrt(2)
        sides.append(np.outer(along.ravel(), (1, 0, 0)) + np.outer(away.ravel(), unit))
    points = np.vstack(sides)
    return points + np.random.default_rng(5).normal(0, noise, points.shape)


@pytest.fixture
def roof_file(tmp_path: Path) -> Path:
    path = tmp_path / "roof.xyz"
    np.savetxt(path, roof())
    return path


def edge_points(table: Path) -> np.ndarray:
    """Points (m, 3) of a table of edge points."""
    lines = table.read_text().splitlines()
    rows = [line.split(",") for line in lines if line.startswith(tuple("-0123456789"))]
    return np.array([[float(word) for word in row[:3]] for row in rows])


def complaint(capsys: pytest.CaptureFixture[str], *words: str | Path) -> str:
    """The one sentence a failing command says."""
    code: object
    try:
        code = main([str(word) for word in words])
    except SystemExit as stopped:
        code = stopped.code
    said = capsys.readouterr()
    assert code == 2
    assert "Traceback" not in said.err
    assert len(said.err.strip().splitlines()) == 1, said.err
    return said.err


# ---------------------------------------------------------------- what works


def test_info_tells_points_size_pitch_and_noise(capsys, roof_file: Path) -> None:
    assert main(["info", str(roof_file)]) == 0
    said = capsys.readouterr().out
    assert "2560" in said
    pitch = float(said.split("pitch")[1].split()[0])
    noise = float(said.split("noise")[1].split()[0])
    assert pitch == pytest.approx(PITCH, rel=0.15)
    assert noise == pytest.approx(0.01, rel=0.25)


def test_info_counts_rows_with_nan(capsys, tmp_path: Path) -> None:
    points = roof()
    points[5, 1] = np.nan
    np.savetxt(tmp_path / "holes.xyz", points)
    assert main(["info", str(tmp_path / "holes.xyz")]) == 0
    assert "dropped  1 " in capsys.readouterr().out


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


def test_info_draws_the_cloud_from_three_sides(capsys, roof_file: Path) -> None:
    pytest.importorskip("matplotlib")
    file = roof_file.parent / "roof.png"
    assert main(["info", str(roof_file), "--picture", str(file)]) == 0
    assert file.read_bytes().startswith(b"\x89PNG")
    assert f"Wrote {file}" in capsys.readouterr().out


@pytest.mark.parametrize(("unit", "length"), [("m", 1000.0), ("inch", 25.4)])
def test_a_cloud_in_another_unit_is_read_in_mm(
    capsys, tmp_path: Path, unit: str, length: float
) -> None:
    file = tmp_path / "roof.xyz"
    np.savetxt(file, roof() / length)
    assert main(["scan", str(file), "--at", "-1,0.2,0", "--unit", unit]) == 0
    said = capsys.readouterr()
    assert float(said.out.splitlines()[2].split()[2]) == pytest.approx(40, abs=2 * PITCH)
    assert said.err == ""


def test_only_a_region_of_the_cloud_is_read(capsys, roof_file: Path) -> None:
    """Its corners may be negative, and stand where they like among the words."""
    region = ["--region", "-5,-5,-50", "-1.5e0,5,50"]
    for words in (["info", *region, str(roof_file)], ["info", str(roof_file), *region]):
        assert main(words) == 0
        rows = capsys.readouterr().out.splitlines()
        low, high = (float(rows[2].split()[column]) for column in (1, 3))
        assert -5.0 <= low < -4.0
        assert -2.5 < high <= -1.5


@pytest.mark.parametrize("command", ["info", "find", "scan --at 0,0,0", "recommend --at 0,0,0"])
def test_a_region_beside_the_cloud_is_one_sentence_with_the_clouds_box(
    capsys, roof_file: Path, command: str
) -> None:
    words = [*command.split(), "--region", "900,900,900", "901,901,901", str(roof_file)]
    assert main(words) == 2
    assert re.fullmatch(
        r"edgescan: No point of .*, which reaches from \(.*\) to \(.*\), lies in the region "
        r"\(900, 900, 900\) to \(901, 901, 901\)\. Take a region that overlaps the cloud\.\n",
        capsys.readouterr().err,
    )


@pytest.mark.parametrize(
    ("region", "said"),
    [
        (["1,1,1", "0,0,0"], "is no box"),
        (["1,1,1"], "expected 2 arguments"),
        (["1,1", "-2,2,2"], "'1,1' is not three numbers"),
        (["1,1,1", "-2,x,2"], "expected 2 arguments"),
    ],
)
def test_what_is_no_region_is_said(capsys, roof_file: Path, region: list[str], said: str) -> None:
    try:
        code = main(["info", str(roof_file), "--region", *region])
    except SystemExit as stopped:
        code = stopped.code
    assert code == 2
    assert said in capsys.readouterr().err


def test_an_edge_that_the_region_cuts_is_said_to_go_on(capsys, roof_file: Path) -> None:
    words = ["scan", str(roof_file), "--at", "-1,0.2,0", "--region"]
    assert main([*words, "-10,-20,-20", "10,20,20"]) == 0
    assert "Edge 1 may go on" in capsys.readouterr().out
    assert main([*words, "-50,-50,-50", "50,50,50"]) == 0  # all of the part is in it
    assert "--region" not in capsys.readouterr().out


@pytest.mark.parametrize("command", ["scan", "recommend"])
def test_a_click_that_the_region_leaves_out_is_said(capsys, roof_file: Path, command: str) -> None:
    words = (command, roof_file, "--at", "15,0,0", "--region", "-10,-20,-20", "0,20,20")
    said = complaint(capsys, *words)
    assert "lies outside the --region (-10, -20, -20) to (0, 20, 20)" in said


def test_a_small_region_of_a_part_is_no_sign_of_metres(capsys, roof_file: Path) -> None:
    main(["info", str(roof_file), "--region", "0,0,-0.9", "0.9,0.9,0"])
    said = capsys.readouterr()
    assert "points" in said.out and "metres" not in said.err


def test_what_to_give_is_an_option_on_the_command_line_and_an_argument_in_python(
    capsys, tmp_path: Path
) -> None:
    from freecad_edgescan.cloud import PointCloud
    from freecad_edgescan.scanning import ScanError, recommend_parameters

    narrow = roof()[np.abs(roof()[:, 1]) < 3 * PITCH]
    np.savetxt(tmp_path / "narrow.xyz", narrow)
    said = complaint(capsys, "recommend", tmp_path / "narrow.xyz", "--at", "-1,0.2,0")
    assert "Take --method patch, which" in said
    with pytest.raises(ScanError, match="Take method='patch', which"):
        recommend_parameters(PointCloud(narrow), (-1.0, 0.2, 0.0), method="probe")


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


def test_a_cloud_that_looks_like_metres_is_remarked_on(capsys, tmp_path: Path) -> None:
    np.savetxt(tmp_path / "roof.xyz", roof() / 1000)
    assert main(["info", str(tmp_path / "roof.xyz")]) == 0
    assert "--unit m" in capsys.readouterr().err


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


# ---------------------------------------------------------------- bad input


@pytest.mark.parametrize("option", ["-o", "--picture", "--section"])
def test_the_scan_itself_is_never_overwritten(capsys, tmp_path: Path, option: str) -> None:
    scan = tmp_path / "roof.csv"
    np.savetxt(scan, roof(), delimiter=",")
    before = scan.read_bytes()
    (tmp_path / "folder").mkdir()
    again = tmp_path / "folder" / ".." / "roof.csv"
    assert "itself" in complaint(capsys, "scan", scan, "--at", "-1,0.2,0", option, again)
    assert scan.read_bytes() == before


def test_a_numbered_table_never_overwrites_the_scan(capsys, tmp_path: Path) -> None:
    np.savetxt(tmp_path / "roof-2.csv", roof(), delimiter=",")
    words = ("--at", "-1,0.2,0", "--at", "3,0,0", "-o", tmp_path / "roof.csv")
    assert "itself" in complaint(capsys, "scan", tmp_path / "roof-2.csv", *words)


def test_a_missing_file_is_named(capsys, tmp_path: Path) -> None:
    assert "nowhere.ply" in complaint(capsys, "info", tmp_path / "nowhere.ply")


def test_an_empty_file_is_called_empty(capsys, tmp_path: Path) -> None:
    (tmp_path / "nothing.xyz").touch()
    said = complaint(capsys, "info", tmp_path / "nothing.xyz")
    assert "nothing.xyz" in said


def test_a_folder_is_no_cloud(capsys, tmp_path: Path) -> None:
    (tmp_path / "folder.xyz").mkdir()
    assert "folder.xyz" in complaint(capsys, "info", tmp_path / "folder.xyz")


def test_a_file_that_is_no_cloud_lists_what_is_readable(capsys, tmp_path: Path) -> None:
    (tmp_path / "part.doc").write_bytes(bytes(range(256)) * 20)
    said = complaint(capsys, "info", tmp_path / "part.doc")
    assert ".doc" in said
    assert ".ply" in said


@pytest.mark.parametrize("ending", ["xyz", "ply", "pcd"])
def test_a_wrongly_named_file_is_told(capsys, tmp_path: Path, ending: str) -> None:
    (tmp_path / f"part.{ending}").write_bytes(bytes(range(256)) * 20)
    assert f"part.{ending}" in complaint(capsys, "info", tmp_path / f"part.{ending}")


def test_text_among_the_numbers_is_told_with_its_line(capsys, tmp_path: Path) -> None:
    rows = ["1 2 3"] * 6 + ["1 two 3"] + ["4 5 6"] * 30
    (tmp_path / "typo.xyz").write_text("\n".join(rows))
    said = complaint(capsys, "info", tmp_path / "typo.xyz")
    assert "typo.xyz" in said
    assert "7" in said.replace(str(tmp_path), "")


def test_a_handful_of_points_is_no_surface(capsys, tmp_path: Path) -> None:
    np.savetxt(tmp_path / "few.xyz", roof()[:7])
    assert "7" in complaint(capsys, "info", tmp_path / "few.xyz").replace(str(tmp_path), "")
    assert "7" in complaint(capsys, "scan", tmp_path / "few.xyz", "--at", "0,0,0").replace(
        str(tmp_path), ""
    )


@pytest.mark.parametrize(
    "points",
    [
        np.ones((100, 3)),
        np.outer(np.arange(100.0), (1, 2, 3)),
        np.array([(x, y, 0.0) for x in range(20) for y in range(20)]),
    ],
    ids=["one place", "one line", "one plane"],
)
def test_a_cloud_without_an_edge_says_so(capsys, tmp_path: Path, points: np.ndarray) -> None:
    np.savetxt(tmp_path / "dull.xyz", points)
    complaint(capsys, "scan", tmp_path / "dull.xyz", "--at", "5,5,0")


@pytest.mark.parametrize("command", ["info", "find", "scan --at 5,5,5", "recommend --at 5,5,5"])
def test_points_that_are_there_many_times_are_said_to_be(
    capsys, tmp_path: Path, command: str
) -> None:
    places = np.random.default_rng(0).uniform(0.0, 10.0, (100, 3))
    np.savetxt(tmp_path / "again.xyz", np.repeat(places, 50, axis=0))
    said = complaint(capsys, *command.split(), tmp_path / "again.xyz")
    assert "there 50 times or more among its 5000 points" in said and "once" in said


def test_a_click_off_the_cloud_says_how_far(capsys, roof_file: Path) -> None:
    said = complaint(capsys, "scan", roof_file, "--at", "0,0,100")
    assert "100" in said


def test_a_click_on_a_flat_place_is_refused(capsys, tmp_path: Path) -> None:
    flat = np.array([(x, y, 0.0) for x in np.arange(0, 20, 0.5) for y in np.arange(0, 20, 0.5)])
    flat += np.random.default_rng(3).normal(0, 0.01, flat.shape)
    np.savetxt(tmp_path / "flat.xyz", flat)
    complaint(capsys, "scan", tmp_path / "flat.xyz", "--at", "10,10,0")


def test_an_edge_pitch_below_the_cloud_pitch_is_refused(capsys, roof_file: Path) -> None:
    said = complaint(capsys, "scan", roof_file, "--at", "0,0,0", "--edge-pitch", "0.01")
    assert "0.01" in said


def test_a_negative_amplitude_is_refused_with_its_value(capsys, roof_file: Path) -> None:
    said = complaint(capsys, "scan", roof_file, "--at", "0,0,0", "--amplitude", "-3")
    assert "-3" in said


def test_a_probe_larger_than_the_part_is_refused(capsys, roof_file: Path) -> None:
    words = ("--at", "0,0,0", "--probe-radius", "80", "--approach", "0,0,-1")
    assert "80" in complaint(capsys, "scan", roof_file, *words)


@pytest.mark.parametrize("place", ["1,2", "1,2,x", "here"])
def test_a_place_that_is_not_three_numbers_is_quoted(capsys, place: str) -> None:
    assert repr(place) in complaint(capsys, "scan", "part.ply", "--at", place)


@pytest.mark.parametrize(
    ("words", "clue"),
    [
        ([], "--at"),
        (["--at", "0,0,0", "--start", "0,0,0"], "--start"),
        (["--start", "0,0,0"], "--across"),
        (["--across", "0,1,0"], "--start"),
        (["--at", "0,0,0", "--gate-across", "0,1,0"], "--gate"),
        (["--at", "0,0,0", "--at", "1,1,1", "--gate", "2,2,2"], "--gate"),
        (["--inside", "0,4,-4"], "--at"),
        (["--at", "0,0,0", "--inside", "0,4,-4", "--gate", "2,2,2"], "--gate"),
        (["--at", "0,0,0", "--inside", "0,4,-4", "--method", "probe"], "--method"),
    ],
)
def test_contradictory_options_are_told_apart(
    capsys, roof_file: Path, words: list[str], clue: str
) -> None:
    assert clue in complaint(capsys, "scan", roof_file, *words)


def test_an_output_that_cannot_be_written_is_told_before_scanning(capsys, roof_file: Path) -> None:
    said = complaint(capsys, "scan", roof_file, "--at", "0,0,0", "-o", "/nowhere/edge.csv")
    assert "/nowhere" in said
    said = complaint(capsys, "scan", roof_file, "--at", "0,0,0", "-o", "edge.iges")
    assert ".step" in said


def test_scan_draws_a_picture_and_the_section_that_was_clicked(capsys, roof_file: Path) -> None:
    pytest.importorskip("matplotlib")
    folder = roof_file.parent
    words = ["scan", str(roof_file), "--at", "-1,0.2,0", "--picture", str(folder / "edge.png")]
    words += ["--view", "0,-1,1", "--section", str(folder / "section.png")]
    assert main(words) == 0
    assert (folder / "edge.png").is_file() and (folder / "section.png").is_file()


def test_a_second_file_and_an_unknown_option_are_named(capsys) -> None:
    assert "info takes one file, but was also given 'b.ply'" in complaint(
        capsys, "info", "a.ply", "b.ply"
    )
    assert "info has no option --frob" in complaint(capsys, "info", "a.ply", "--frob")


def test_numbers_with_blanks_between_them_are_told_to_take_commas(capsys) -> None:
    assert "commas and without blanks" in complaint(capsys, "scan", "a.ply", "--at", "20", "0", "0")


@pytest.mark.parametrize(
    ("words", "clue"),
    [
        (("scan", "a.ply", "--amplitude", "2,5"), "'2,5' is not a number"),
        (("bench", "--points", "many"), "'many' is not a whole number"),
    ],
)
def test_a_word_that_is_no_number_is_quoted(capsys, words: tuple[str, ...], clue: str) -> None:
    assert clue in complaint(capsys, *words)


def test_a_scan_without_a_place_is_told_how_to_find_one(capsys, roof_file: Path) -> None:
    assert "info FILE --picture" in complaint(capsys, "scan", roof_file)


def test_a_demonstration_into_a_file_is_told_to_take_a_folder(capsys, roof_file: Path) -> None:
    pytest.importorskip("FreeCAD")
    assert "folder" in complaint(capsys, "demo", "-o", roof_file)
