# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be written after ``edgescan scan`` and ``edgescan recommend``."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from freecad_edgescan.shared_options import add_file, add_probe, number, vector, whole_number

__all__ = ["SCAN_EXAMPLES", "add_recommend_options", "add_scan_options", "given_parameters"]

PROBED = ("line_pitch", "tolerance", "prehit_distance", "search_distance", "degree", "pattern")

SCAN_EXAMPLES = """examples:
  edgescan scan part.ply --at 12.5,-3,40 -o edge.step
  edgescan scan part.xyz --at 1,2,3 --at 4,5,6 -o edges.csv -o edges.step --picture edges.png
  edgescan scan part.ply --at 12.5,-3,40 --inside 15,0,42 -o face.step
  edgescan scan probed.asc --probe-radius 1 --approach 0,0,-1 --at 10,0,5 --gate 90,0,5 -o rim.step
  edgescan scan part.ply --start 0,-5,0 --across 0,1,0 --along 1,0,0 \\
                         --gate 80,-5,0 --gate-across 0,1,0 --amplitude 10
"""


def add_scan_options(scan: argparse.ArgumentParser) -> None:
    """Declare the options of ``edgescan scan``."""
    add_file(scan)
    scan.add_argument(
        "--at", type=vector, action="append", default=[], metavar="X,Y,Z",
        help="a point near an edge, mm; repeat for more edges",
    )  # fmt: skip
    scan.add_argument(
        "--inside", type=vector, metavar="X,Y,Z",
        help="a point on a face beside the edge at --at: scan all edges round this face",
    )  # fmt: skip
    scan.add_argument("--start", type=vector, metavar="X,Y,Z", help="first point, on one side")
    scan.add_argument("--across", type=vector, metavar="DX,DY,DZ", help="from it over the edge")
    scan.add_argument("--along", type=vector, metavar="DX,DY,DZ", help="from it along the edge")
    scan.add_argument(
        "--gate", type=vector, metavar="X,Y,Z",
        help="walk towards this point and end there; with --gate-across the gate's first end",
    )  # fmt: skip
    scan.add_argument(
        "--gate-across", type=vector, metavar="DX,DY,DZ", help="from the gate over the edge"
    )
    _add_method(scan, "patch")
    _add_sizes(scan)
    _add_probed(scan)
    add_probe(scan)
    scan.add_argument(
        "-o", "--output", type=Path, action="append", default=[], metavar="FILE",
        help=".step for CAD (needs FreeCAD), .csv for edge points with sigma; repeatable. Several "
        "--at, or --inside, with one .csv write name-1.csv, name-2.csv and so on, numbered by --at "
        "or round the face",
    )  # fmt: skip
    scan.add_argument("--picture", type=Path, metavar="FILE.png", help="cloud and edges, drawn")
    scan.add_argument(
        "--view", type=vector, metavar="DX,DY,DZ",
        help="direction from the part to the viewer of the picture (default: the edges' air side)",
    )  # fmt: skip
    scan.add_argument(
        "--section", type=Path, metavar="FILE.png",
        help="the section of the first edge where it was clicked, drawn",
    )  # fmt: skip


def add_recommend_options(recommend: argparse.ArgumentParser) -> None:
    """Declare the options of ``edgescan recommend``."""
    add_file(recommend)
    recommend.add_argument(
        "--at", type=vector, action="append", default=[], metavar="X,Y,Z",
        help="a point near an edge, mm; repeat for more edges",
    )  # fmt: skip
    _add_method(recommend, "probe")
    _add_sizes(recommend)
    _add_probed(recommend)
    add_probe(recommend)


def given_parameters(options: argparse.Namespace) -> dict[str, Any]:
    """The scan parameters among the options of scan and recommend, by their Python names."""
    names = ("amplitude", "edge_pitch", *PROBED)
    return {name: getattr(options, name) for name in names}


def _add_method(command: argparse.ArgumentParser, default: str) -> None:
    command.add_argument(
        "--method", choices=("patch", "probe"), default=default,
        help="patch: all points on both sides; probe: line by line like a measuring machine "
        f"(default: {default})",
    )  # fmt: skip


def _add_sizes(command: argparse.ArgumentParser) -> None:
    command.add_argument("--amplitude", type=number, metavar="MM", help="both sides together")
    command.add_argument("--edge-pitch", type=number, metavar="MM", help="distance of edge points")


def _add_probed(command: argparse.ArgumentParser) -> None:
    group = command.add_argument_group("probed scan", "what is not given is chosen, with a reason")
    for option, text in (
        ("line-pitch", "distance of the points on a scan line"),
        ("tolerance", "scanning tolerance of a line section"),
        ("prehit-distance", "from where a search begins to where the part is expected"),
        ("search-distance", "to go on behind that"),
    ):
        group.add_argument(f"--{option}", type=number, metavar="MM", help=text)
    group.add_argument(
        "--degree", type=whole_number, metavar="1|2|3", help="of the curve through a side's points"
    )
    group.add_argument(
        "--pattern", metavar="square|zigzag", help="how the scan lines follow each other"
    )
