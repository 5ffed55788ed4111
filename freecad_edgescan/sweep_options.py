# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be written after ``edgescan sweep``."""

from __future__ import annotations

import argparse
from pathlib import Path

from freecad_edgescan.shared_options import add_file, add_probe, number, vector, whole_number

__all__ = ["SWEEP_TEXT", "add_sweep_options"]

SWEEP_TEXT = """\
Edges are scanned from one click each, as by scan. Along one rail the profile turns as little as it
can and keeps its size; the surface is held against the cloud as it is. Along two rails it turns
and scales with them, and is fitted to the cloud in both models, of which the better one is kept.

examples:
  edgescan sweep part.ply --rail 0,10,5 --profile 40,8,0 --distance 0.5 --picture deviation.png
  edgescan sweep pipe.ply --rail 9,0,4 --rail 9,8,4 -o pipe.step -o deviation.csv
"""


def add_sweep_options(sweep: argparse.ArgumentParser) -> None:
    """Declare the options of ``edgescan sweep``."""
    add_file(sweep)
    for option, text in (
        ("rail", "a point near an edge along which is swept; once or twice"),
        ("profile", "a point near an edge across the rails that is swept; with two rails and none "
         "sections of the cloud at the rails' ends"),
    ):  # fmt: skip
        sweep.add_argument(
            f"--{option}", type=vector, action="append", default=[], metavar="X,Y,Z", help=text
        )
    sweep.add_argument(
        "--distance", type=number, default=3.0, metavar="MM",
        help="points nearer to the sweep than this belong to it (default: 3)",
    )  # fmt: skip
    sweep.add_argument(
        "--poles", type=whole_number, nargs=2, default=(14, 7), metavar="N",
        help="control points of each fitted rail and of each fitted profile (default: 14 7)",
    )  # fmt: skip
    add_probe(sweep)
    sweep.add_argument(
        "-o", "--output", type=Path, action="append", default=[], metavar="FILE",
        help=".step of the surface (needs FreeCAD), .csv of the points' deviations; repeatable",
    )  # fmt: skip
    sweep.add_argument("--picture", type=Path, metavar="FILE.png", help="deviations, in colour")
    sweep.add_argument(
        "--view", type=vector, metavar="DX,DY,DZ",
        help="direction from the part to the viewer of the picture (default: 0,0,1)",
    )  # fmt: skip
