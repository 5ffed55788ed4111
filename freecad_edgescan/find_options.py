# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be written after ``edgescan find``."""

from __future__ import annotations

import argparse
from pathlib import Path

from freecad_edgescan.shared_options import add_file, number, vector

__all__ = ["FIND_TEXT", "add_find_options"]

FIND_TEXT = """Prints one row for each edge: where it starts and ends (a corner, or why not),
its mean standard deviation, the turn between its sides, and the radius of its rounding. The
numbers are those of the tables and the picture. The exit code is 2 where no edge is found.

examples:
  edgescan find part.ply -o edges.step --csv edges.csv --picture net.png
  edgescan find part.ply --min-angle 30 --region 0,0,0 50,50,20
"""


def add_find_options(find: argparse.ArgumentParser) -> None:
    """Declare the options of ``edgescan find``."""
    add_file(find)
    find.add_argument(
        "--min-angle", type=number, default=15.0, metavar="DEG",
        help="least turn between the two sides (default: 15)",
    )  # fmt: skip
    find.add_argument(
        "--min-length", type=number, metavar="MM",
        help="of an edge (default: eight times the cloud's pitch)",
    )  # fmt: skip
    find.add_argument(
        "-o", "--output", type=Path, metavar="FILE.step",
        help="edges for CAD in the order of the table (needs FreeCAD)",
    )  # fmt: skip
    find.add_argument("--csv", type=Path, metavar="FILE.csv", help="all edge points with sigma")
    find.add_argument(
        "--corners", type=Path, metavar="FILE.csv",
        help="the corners with sigma, and the numbers of the edges that meet in each",
    )  # fmt: skip
    find.add_argument(
        "--picture", type=Path, metavar="FILE.png", help="cloud and edges with their numbers"
    )
    find.add_argument(
        "--view", type=vector, metavar="DX,DY,DZ",
        help="direction from the part to the viewer of the picture",
    )  # fmt: skip
