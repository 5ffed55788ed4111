# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options that several commands take, and how the value of an option is read."""

from __future__ import annotations

import argparse
import re

from freecad_edgescan.cloud_file import UNITS

__all__ = ["Vector", "add_file", "add_probe", "number", "vector", "whole_number"]

Vector = tuple[float, float, float]


def add_file(command: argparse.ArgumentParser) -> None:
    """The cloud's file, its unit, and the part of it that is read."""
    command.add_argument("file", help=".xyz .txt .asc .csv .ply .pcd")
    command.add_argument(
        "--unit", choices=UNITS, help="of the file (default: mm); all the rest is mm"
    )
    command.add_argument(
        "--region", type=vector, nargs=2, metavar="X,Y,Z",
        help="lowest and highest corner of a box; only points in it are read, however large the "
        "file is",
    )  # fmt: skip


def add_probe(command: argparse.ArgumentParser) -> None:
    """The probe whose centres the cloud holds."""
    command.add_argument(
        "--probe-radius", type=number, default=0.0, metavar="MM",
        help="the cloud holds centres of a ball of this radius",
    )  # fmt: skip
    command.add_argument(
        "--approach", type=vector, metavar="DX,DY,DZ", help="direction the probe came along"
    )


def vector(text: str) -> Vector:
    """A value such as 1.5,-2,30."""
    text = text.strip()
    try:
        x, y, z = (float(part) for part in re.split(r"[,;\s]+", text))
    except ValueError:
        words = f"{text!r} is not three numbers"
        way = "write them with commas and without blanks, such as 1.5,-2,30"
        raise argparse.ArgumentTypeError(f"{words}; {way}") from None
    return x, y, z


def number(text: str) -> float:
    """A value such as 2.5."""
    try:
        return float(text)
    except ValueError:
        words = f"{text!r} is not a number such as 2.5"
        raise argparse.ArgumentTypeError(words) from None


def whole_number(text: str) -> int:
    """A value such as 1000."""
    try:
        return int(text)
    except ValueError:
        words = f"{text!r} is not a whole number such as 1000"
        raise argparse.ArgumentTypeError(words) from None
