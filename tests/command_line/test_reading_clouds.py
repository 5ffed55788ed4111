# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the command line reads of a file and tells about it: units, regions, and `info`."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from freecad_edgescan.__main__ import main

from .roof import PITCH, complaint, roof


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


@pytest.mark.parametrize("unit", ["m", "inch"])
def test_a_place_in_the_unit_of_the_file_is_told_to_be_in_mm(
    capsys, tmp_path: Path, unit: str
) -> None:
    file = tmp_path / "far.xyz"
    np.savetxt(file, roof() / 1000 + [500.0, 4000.0, 0.1])
    here = "500,4000,0.1"
    for command, *words in (
        ("scan", "--at", here),
        ("recommend", "--at", here),
        ("sweep", "--rail", here, "--profile", here),
    ):
        assert main([command, str(file), *words, "--unit", unit]) == 2
        assert "Places are given in mm, whatever the --unit" in capsys.readouterr().err
    # Beside the cloud, but not as far as another unit puts it.
    assert main(["scan", str(file), "--at", "500000,4000030,100", "--unit", "m"]) == 2
    assert "whatever" not in capsys.readouterr().err


def test_places_far_from_the_origin_are_plain_decimals(capsys, tmp_path: Path) -> None:
    file = tmp_path / "far.xyz"
    np.savetxt(file, np.add(roof(), [500000.0, 4000000.0, 100.0]), fmt="%.4f")
    assert main(["info", str(file)]) == 0
    said = capsys.readouterr().out
    assert "e+" not in said
    low, high = (float(said.splitlines()[3].split()[column]) for column in (1, 3))
    assert 4000000.0 + roof()[:, 1].min() == pytest.approx(low, abs=0.01)
    assert 4000000.0 + roof()[:, 1].max() == pytest.approx(high, abs=0.01)
    assert main(["scan", str(file), "--at", "0,0,0"]) == 2
    told = capsys.readouterr().err
    assert "e+" not in told
    assert "(4999" in told.split("reaches from ")[1]


def test_a_cloud_that_looks_like_metres_is_remarked_on(capsys, tmp_path: Path) -> None:
    np.savetxt(tmp_path / "roof.xyz", roof() / 1000)
    assert main(["info", str(tmp_path / "roof.xyz")]) == 0
    assert "--unit m" in capsys.readouterr().err


@pytest.mark.parametrize("command", ["info", "scan --at 0,0,0", "find"])
def test_of_three_points_it_is_said_that_they_are_few_and_not_that_they_are_small(
    capsys, tmp_path: Path, command: str
) -> None:
    np.savetxt(tmp_path / "three.xyz", roof()[:3] / 1000)
    assert main([*command.split(), str(tmp_path / "three.xyz")]) == 2
    said = capsys.readouterr().err
    assert "holds 3 points" in said
    assert "metres" not in said


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
