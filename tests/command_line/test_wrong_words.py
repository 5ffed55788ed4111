# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a user gets wrong on the command line is one sentence, and nothing is lost."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from .roof import PITCH, complaint, roof


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
