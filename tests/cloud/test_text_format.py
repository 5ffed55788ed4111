# SPDX-License-Identifier: LGPL-2.1-or-later
from __future__ import annotations

import pytest

from freecad_edgescan.cloud import read_cloud

POINTS = [[1.5, -2.25, 3.0], [4.0, 5.125, -6e-3], [7e2, 8.0, 9.0]]


def read(folder, text: str | bytes, name: str = "cloud.xyz", **options):
    path = folder / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return read_cloud(path, **options)


ROWS = "1.5 -2.25 3\n4.0 5.125 -6e-3\n7e2 8 9\n"
COMMAS = ROWS.replace(" ", ",")


@pytest.mark.parametrize(
    "text",
    [
        ROWS,
        ROWS.rstrip("\n"),
        ROWS.replace("\n", "\r\n"),
        ROWS.replace(" ", "\t"),
        ROWS.replace(" ", "    "),
        "   " + ROWS.replace("\n", "  \n   ") + "\n",
        "\n\n" + ROWS.replace("\n", "\n\n"),
        COMMAS,
        ROWS.replace(" ", ", "),
        ROWS.replace(" ", ";"),
        ROWS.replace(" ", " ; ").replace("\n", ";\n"),
        ROWS.replace(" ", ";").replace(".", ","),
        ROWS.replace(".", ","),
        ROWS.replace(" ", "\t").replace(".", ","),
        ROWS.replace("\n", " 255 128 0 0.1 0.2 0.3\n"),
        COMMAS.replace("\n", ",255,128,0,0.1,0.2,0.3\n"),
        COMMAS.replace("\n", ",some text\n"),
        "3\n" + ROWS,
        "# made by a scanner\n" + ROWS,
        "//X Y Z\n3\n" + ROWS,
        "% x y z\n" + ROWS,
        "x y z\n" + ROWS,
        "x,y,z\n" + COMMAS,
        '"X";"Y";"Z"\n' + ROWS.replace(" ", ";").replace(".", ","),
        "Scan of the part, in mm\n\n" + ROWS,
        ROWS.replace("\n", "\n# a remark\n"),
        ROWS.replace("\n", "\n// a remark\n"),
        ROWS.replace("\n", "\n% a remark\n", 1),
        ROWS.replace("\n", " # a remark\n"),
    ],
)
def test_text_is_read_however_its_numbers_are_written(tmp_path, text):
    assert read(tmp_path, text).points.tolist() == POINTS


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16", "latin-1"])
def test_text_is_read_in_the_encodings_programs_write(tmp_path, encoding):
    text = "Größe x y z\n" + ROWS
    assert read(tmp_path, text.encode(encoding)).points.tolist() == POINTS


def test_columns_named_x_y_z_are_taken_wherever_they_stand(tmp_path):
    text = "Point ID;X;Y;Z;I\n1;1,5;-2,25;3;0\n2;4,0;5,125;-0,006;0\n3;700;8;9;1\n"
    assert read(tmp_path, text, "cloud.csv").points.tolist() == POINTS


def test_missing_measurements_are_left_out_and_counted(tmp_path):
    with pytest.warns(UserWarning, match="1 of 4 points"):
        cloud = read(tmp_path, ROWS + "nan nan nan\n")
    assert cloud.points.tolist() == POINTS
    assert cloud.dropped == 1


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (ROWS + "1 2 three\n", r"Line 4 .*'three'.*'1 2 three'"),
        (
            "1.5 2.5 3.5\n" * 99 + "1,5 2,5 3,5\n",
            r"Line 100 .*'1,5' \(a decimal comma\).*Write it with a decimal point",
        ),
        (COMMAS + "1,,3\n", r"Line 4 .*'' where a number should be.*'1,,3'"),
        (ROWS + "1 2\n", r"Line 4 .* 2 columns.*'1 2'"),
        ("x y z\n\n" + ROWS + "\n# end\noops\n", r"Line 8 .* 1 column,.*'oops'"),
        ("1 2\n3 4\n", r"Line 1 .* 2 columns"),
        ("1.5\n2\n3\n", r"Line 1 .* 1 column,"),
        ("Dear Sir,\nno points today.\n", "no line of numbers.*Dear Sir"),
        ("# only\n# remarks\n", "no line of numbers"),
        ("x,y,z\n", "no line of numbers"),
        (b"1 2 3\n\x00\x01\x02", "binary"),
    ],
)
def test_text_that_holds_no_points_is_refused_with_line_and_text(tmp_path, text, said):
    with pytest.raises(ValueError, match=said):
        read(tmp_path, text, "cloud.txt")


def test_a_fault_deep_in_a_long_file_is_named_by_its_line(tmp_path):
    lines = ["1.0 2.0 3.0"] * 250_000
    lines[234_567] = "1.0 2.0 3.0.0"
    with pytest.raises(ValueError, match=r"Line 234568 .*'3\.0\.0'"):
        read(tmp_path, "\n".join(lines))


class Watcher:
    def __init__(self, stop_after: int = 99) -> None:
        self.stop_after = stop_after
        self.told: list[float] = []

    def update(self, fraction, so_far) -> bool:
        self.told.append(fraction)
        self.so_far = so_far
        return len(self.told) < self.stop_after


def test_a_long_file_tells_how_far_it_is_and_can_be_cancelled(tmp_path):
    text = "1.0 2.0 3.0\n" * 250_000
    watcher = Watcher()
    cloud = read(tmp_path, text, progress=watcher)
    assert len(cloud) == 250_000
    assert watcher.told == sorted(watcher.told)
    assert 0 < watcher.told[0] < 1
    assert watcher.told[-1] == 1.0
    assert watcher.so_far is cloud
    assert len(read(tmp_path, text, progress=Watcher(stop_after=2))) == 200_000
