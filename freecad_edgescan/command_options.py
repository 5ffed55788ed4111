# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be written on the command line: sub-commands, their options, and help."""

from __future__ import annotations

import argparse
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NoReturn

from freecad_edgescan.doe_options import DOE_TEXT, add_doe_options
from freecad_edgescan.file_unit import UNITS

__all__ = ["given_parameters", "read_options"]

PROBED = ("line_pitch", "tolerance", "prehit_distance", "search_distance", "degree", "pattern")

Vector = tuple[float, float, float]

SCAN_EXAMPLES = """examples:
  edgescan scan part.ply --at 12.5,-3,40 -o edge.step
  edgescan scan part.xyz --at 1,2,3 --at 4,5,6 -o edges.csv -o edges.step --picture edges.png
  edgescan scan part.ply --at 12.5,-3,40 --inside 15,0,42 -o face.step
  edgescan scan probed.asc --probe-radius 1 --approach 0,0,-1 --at 10,0,5 --gate 90,0,5 -o rim.step
  edgescan scan part.ply --start 0,-5,0 --across 0,1,0 --along 1,0,0 \\
                         --gate 80,-5,0 --gate-across 0,1,0 --amplitude 10
"""

FIND_TEXT = """Prints one row for each edge: where it starts and ends (a corner, or why not),
its mean standard deviation, the turn between its sides, and the radius of its rounding.

examples:
  edgescan find part.ply -o edges.step --csv edges.csv --picture net.png
  edgescan find part.ply --min-angle 30 --low 0,0,0 --high 50,50,20
"""

ACCURACY_TEXT = """Simulates a scan of each part, clicks every sharp edge at its middle, and
compares what is found with the part's own edges. Without --parts also two planes, the same
under a fillet, and a cylinder's rim (pitch 0.5, noise 0.02, edge points 0.75 mm apart), with
and without 5 % outliers.
  length   of the true edge           room    smallest distance to another edge
  traced   share of it found within one pitch
  rms max  distance of the edge points from it
  sigma    mean standard deviation that the scan states itself

examples:
  edgescan accuracy --peers
  edgescan accuracy --parts part.step --pitch 0.3 --noise 0.06
  edgescan accuracy --peers --parts part.step --report docs/accuracy.md
"""


class _Parser(argparse.ArgumentParser):
    """Says what is wrong in one sentence instead of printing the whole usage."""

    def error(self, message: str) -> NoReturn:
        self.exit(2, f"{self.prog}: {message}; {self.prog} --help tells more.\n")


def read_options(words: Sequence[str]) -> argparse.Namespace:
    """What the words of a command line ask for; a wrong one is a sentence and exit code 2."""
    parser = _parser()
    options, unknown = parser.parse_known_args(_bind_negative_values(words))
    if unknown:
        parser.prog += f" {options.command}"
        word = unknown[0]
        if word.startswith("-"):
            parser.error(f"{options.command} has no option {word}")
        if hasattr(options, "file"):
            parser.error(f"{options.command} takes one file, but was also given {word!r}")
        parser.error(f"{options.command} does not take {word!r}")
    return options


SWEEP_TEXT = """\
Edges are scanned from one click each, as by scan. Along one rail the profile turns as little as it
can and keeps its size; the surface is held against the cloud as it is. Along two rails it turns
and scales with them, and is fitted to the cloud in both models, of which the better one is kept.

examples:
  edgescan sweep part.ply --rail 0,10,5 --profile 40,8,0 --distance 0.5 --picture deviation.png
  edgescan sweep pipe.ply --rail 9,0,4 --rail 9,8,4 -o pipe.step -o deviation.csv
"""

SURFACES_TEXT = """\
Prints the extension of appendix H and the edge of test 2S1.11 by way of surfaces (appendix I)
beside the published figures, and how long fits and projections take beside FITPACK and FreeCAD."""

CASESTUDY_TEXT = """\
The core box of the published case study, from its raster of probe centres to swept surfaces: its
four rims are scanned and become rails, profiles stand at their ends, base surfaces cut the cloud,
and sweeps are fitted in both models (blend: as published; rotate: the profile turns with the rails)
to the 5 mm grid that was used and to the whole cloud. Prints the deviations beside the published
ones and the time of each step beside the published minutes."""


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog="edgescan", description="True sharp edges from scanned point clouds.")
    commands = parser.add_subparsers(required=True, metavar="COMMAND", dest="command")

    scan = _add_command(commands, "scan", "scan edges of a cloud", SCAN_EXAMPLES)
    _add_file(scan)
    scan.add_argument(
        "--at", type=_vector, action="append", default=[], metavar="X,Y,Z",
        help="a point near an edge, mm; repeat for more edges",
    )  # fmt: skip
    scan.add_argument(
        "--inside", type=_vector, metavar="X,Y,Z",
        help="a point on a face beside the edge at --at: scan all edges round this face",
    )  # fmt: skip
    scan.add_argument("--start", type=_vector, metavar="X,Y,Z", help="first point, on one side")
    scan.add_argument("--across", type=_vector, metavar="DX,DY,DZ", help="from it over the edge")
    scan.add_argument("--along", type=_vector, metavar="DX,DY,DZ", help="from it along the edge")
    scan.add_argument(
        "--gate", type=_vector, metavar="X,Y,Z",
        help="walk towards this point and end there; with --gate-across the gate's first end",
    )  # fmt: skip
    scan.add_argument(
        "--gate-across", type=_vector, metavar="DX,DY,DZ", help="from the gate over the edge"
    )
    _add_method(scan, "patch")
    _add_sizes(scan)
    _add_probed(scan)
    _add_probe(scan)
    scan.add_argument(
        "-o", "--output", type=Path, action="append", default=[], metavar="FILE",
        help=".step for CAD (needs FreeCAD), .csv for edge points with sigma; repeatable. Several "
        "--at, or --inside, with one .csv write name-1.csv, name-2.csv and so on, numbered by --at "
        "or round the face",
    )  # fmt: skip
    scan.add_argument("--picture", type=Path, metavar="FILE.png", help="cloud and edges, drawn")
    scan.add_argument(
        "--view", type=_vector, metavar="DX,DY,DZ",
        help="direction from the part to the viewer of the picture (default: the edges' air side)",
    )  # fmt: skip
    scan.add_argument(
        "--section", type=Path, metavar="FILE.png",
        help="the section of the first edge where it was clicked, drawn",
    )  # fmt: skip

    find = _add_command(commands, "find", "find all edges of a cloud, without a click", FIND_TEXT)
    _add_file(find)
    find.add_argument(
        "--min-angle", type=_number, default=15.0, metavar="DEG",
        help="least turn between the two sides (default: 15)",
    )  # fmt: skip
    find.add_argument(
        "--min-length", type=_number, metavar="MM",
        help="of an edge (default: eight times the cloud's pitch)",
    )  # fmt: skip
    find.add_argument("--low", type=_vector, metavar="X,Y,Z", help="lowest corner of a box ...")
    find.add_argument("--high", type=_vector, metavar="X,Y,Z", help="... in which to look only")
    find.add_argument(
        "-o", "--output", type=Path, metavar="FILE.step", help="edges for CAD (needs FreeCAD)"
    )
    find.add_argument("--csv", type=Path, metavar="FILE.csv", help="all edge points with sigma")
    find.add_argument("--picture", type=Path, metavar="FILE.png", help="cloud and edges, drawn")
    find.add_argument(
        "--view", type=_vector, metavar="DX,DY,DZ",
        help="direction from the part to the viewer of the picture",
    )  # fmt: skip

    sweep = _add_command(
        commands,
        "sweep",
        "sweep scanned edges along others, fitted to the cloud",
        SWEEP_TEXT,
    )
    _add_file(sweep)
    for option, text in (
        ("rail", "a point near an edge along which is swept; once or twice"),
        ("profile", "a point near an edge across the rails that is swept; with two rails and none "
         "sections of the cloud at the rails' ends"),
    ):  # fmt: skip
        sweep.add_argument(
            f"--{option}", type=_vector, action="append", default=[], metavar="X,Y,Z", help=text
        )
    sweep.add_argument(
        "--distance", type=_number, default=3.0, metavar="MM",
        help="points nearer to the sweep than this belong to it (default: 3)",
    )  # fmt: skip
    sweep.add_argument(
        "--poles", type=_whole_number, nargs=2, default=(14, 7), metavar="N",
        help="control points of each fitted rail and of each fitted profile (default: 14 7)",
    )  # fmt: skip
    _add_probe(sweep)
    sweep.add_argument(
        "-o", "--output", type=Path, action="append", default=[], metavar="FILE",
        help=".step of the surface (needs FreeCAD), .csv of the points' deviations; repeatable",
    )  # fmt: skip
    sweep.add_argument("--picture", type=Path, metavar="FILE.png", help="deviations, in colour")
    sweep.add_argument(
        "--view", type=_vector, metavar="DX,DY,DZ",
        help="direction from the part to the viewer of the picture (default: 0,0,1)",
    )  # fmt: skip

    recommend = _add_command(
        commands, "recommend", "how to scan an edge, and the error to expect of it"
    )
    _add_file(recommend)
    recommend.add_argument(
        "--at", type=_vector, action="append", default=[], metavar="X,Y,Z",
        help="a point near an edge, mm; repeat for more edges",
    )  # fmt: skip
    _add_method(recommend, "probe")
    _add_sizes(recommend)
    _add_probed(recommend)
    _add_probe(recommend)

    info = _add_command(commands, "info", "what is in a cloud file")
    _add_file(info)
    info.add_argument(
        "--picture", type=Path, metavar="FILE.png",
        help="the cloud from three sides with its coordinates, to read places for scan --at from",
    )  # fmt: skip

    bench = _add_command(commands, "bench", "how fast this machine is")
    bench.add_argument(
        "--points", type=_whole_number, default=1_000_000, metavar="N", help="cloud size"
    )

    bench.add_argument(
        "--parts", nargs="*", type=Path, metavar="FILE",
        help="instead: find all edges in simulated scans of these parts (.step .iges .brep; "
        "none: six parts of its own), and compare them with the parts' own",
    )  # fmt: skip
    bench.add_argument(
        "--fillet", nargs="+", type=_number, default=[], metavar="PITCHES",
        help="of --parts, with their straight convex edges rounded; radii in pitches of the scan",
    )  # fmt: skip
    bench.add_argument(
        "--peers",
        action="store_true",
        help="of --parts, beside what surface variation and CGAL's VCM label",
    )
    bench.add_argument(
        "--seed", type=_whole_number, default=0, metavar="N", help="of the random numbers"
    )

    accuracy = _add_command(
        commands, "accuracy", "how exactly edges of CAD parts are found", ACCURACY_TEXT
    )
    accuracy.add_argument(
        "--parts", nargs="+", type=Path, default=[], metavar="FILE",
        help=".step .iges .brep; default: a block with a blind bore",
    )  # fmt: skip
    for option, value, text in (
        ("--pitch", 0.6, "of the simulated scan"),
        ("--noise", 0.12, "of the simulated scan, standard deviation along the normal"),
        ("--probe-radius", 0.0, "simulate centres of a ball of this radius"),
    ):
        accuracy.add_argument(
            option, type=_number, default=value, metavar="MM", help=f"{text} (default: {value:g})"
        )
    accuracy.add_argument(
        "--fillet", type=_number, default=0.0, metavar="MM",
        help="first round the parts' straight convex edges; the sharp ones are sought",
    )  # fmt: skip
    accuracy.add_argument(
        "--peers", action="store_true",
        help="beside what RANSAC planes and surface variation make of the simple parts' clouds",
    )  # fmt: skip
    accuracy.add_argument(
        "--seeds", type=_whole_number, metavar="N",
        help="clouds of each simple part (default: 5)",
    )  # fmt: skip
    accuracy.add_argument(
        "--report", type=Path, metavar="FILE.md",
        help="write all about accuracy as a page with pictures: simple parts, the block, --parts, "
        "and the published experiments (doe --method patch), in about four minutes",
    )  # fmt: skip
    accuracy.add_argument(
        "--wedges", type=_whole_number, metavar="N",
        help="instead of parts: N wedges at random, spoilt at random; lists wrong edges",
    )  # fmt: skip
    accuracy.add_argument(
        "--sharp", action="store_true", help="of --wedges, only such without a rounding"
    )
    accuracy.add_argument(
        "--seed", type=_whole_number, default=0, metavar="N", help="of the random numbers"
    )

    add_doe_options(_add_command(commands, "doe", "the published experiments, again", DOE_TEXT))

    demo = _add_command(commands, "demo", "scan the edges of a simulated core box, sweep and loft")
    demo.add_argument(
        "-o", "--output", type=Path, default=Path("demo"), metavar="FOLDER",
        help="where the document, STEP, table and pictures go (default: demo)",
    )  # fmt: skip

    _add_command(
        commands, "surfaces", "published surfaces again, and how fast surfaces are", SURFACES_TEXT
    )

    study = _add_command(
        commands, "casestudy", "fit swept surfaces to the pipes of a core box", CASESTUDY_TEXT
    )
    study.add_argument(
        "-o", "--output", type=Path, default=Path("casestudy"), metavar="FOLDER",
        help="where the document, STEP, table and pictures go (default: casestudy)",
    )  # fmt: skip
    study.add_argument(
        "--pitch", type=_number, default=0.5, metavar="MM",
        help="of the simulated scan (default: 0.5, as published)",
    )  # fmt: skip
    return parser


def _add_command(
    commands: Any, name: str, summary: str, epilog: str | None = None
) -> argparse.ArgumentParser:
    parser: argparse.ArgumentParser = commands.add_parser(
        name,
        help=summary,
        description=summary[0].upper() + summary[1:] + ". Lengths are mm.",
        epilog=epilog,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--debug", action="store_true", help="show where an error came from")
    return parser


def _add_file(command: argparse.ArgumentParser) -> None:
    command.add_argument("file", help=".xyz .txt .asc .csv .ply .pcd")
    command.add_argument(
        "--unit", choices=UNITS, help="of the file (default: mm); all the rest is mm"
    )


def _add_method(command: argparse.ArgumentParser, default: str) -> None:
    command.add_argument(
        "--method", choices=("patch", "probe"), default=default,
        help="patch: all points on both sides; probe: line by line like a measuring machine "
        f"(default: {default})",
    )  # fmt: skip


def _add_probed(command: argparse.ArgumentParser) -> None:
    group = command.add_argument_group("probed scan", "what is not given is chosen, with a reason")
    for option, text in (
        ("line-pitch", "distance of the points on a scan line"),
        ("tolerance", "scanning tolerance of a line section"),
        ("prehit-distance", "from where a search begins to where the part is expected"),
        ("search-distance", "to go on behind that"),
    ):
        group.add_argument(f"--{option}", type=_number, metavar="MM", help=text)
    group.add_argument(
        "--degree", type=_whole_number, metavar="1|2|3", help="of the curve through a side's points"
    )
    group.add_argument(
        "--pattern", metavar="square|zigzag", help="how the scan lines follow each other"
    )


def given_parameters(options: argparse.Namespace) -> dict[str, Any]:
    """The scan parameters among the options of scan and recommend, by their Python names."""
    names = ("amplitude", "edge_pitch", *PROBED)
    return {name: getattr(options, name) for name in names}


def _add_sizes(command: argparse.ArgumentParser) -> None:
    command.add_argument("--amplitude", type=_number, metavar="MM", help="both sides together")
    command.add_argument("--edge-pitch", type=_number, metavar="MM", help="distance of edge points")


def _add_probe(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--probe-radius", type=_number, default=0.0, metavar="MM",
        help="the cloud holds centres of a ball of this radius",
    )  # fmt: skip
    command.add_argument(
        "--approach", type=_vector, metavar="DX,DY,DZ", help="direction the probe came along"
    )


def _bind_negative_values(words: Sequence[str]) -> list[str]:
    """Write ``--at -1,2,3`` as ``--at=-1,2,3``, which argparse would take for an option."""
    bound: list[str] = []
    for word in words:
        if bound and re.match(r"-\.?\d", word) and re.fullmatch(r"--[a-z-]+", bound[-1]):
            bound[-1] += f"={word}"
        else:
            bound.append(word)
    return bound


def _vector(text: str) -> Vector:
    try:
        x, y, z = (float(number) for number in re.split(r"[,;\s]+", text.strip()))
    except ValueError:
        words = f"{text!r} is not three numbers"
        way = "write them with commas and without blanks, such as 1.5,-2,30"
        raise argparse.ArgumentTypeError(f"{words}; {way}") from None
    return x, y, z


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        words = f"{text!r} is not a number such as 2.5"
        raise argparse.ArgumentTypeError(words) from None


def _whole_number(text: str) -> int:
    try:
        return int(text)
    except ValueError:
        words = f"{text!r} is not a whole number such as 1000"
        raise argparse.ArgumentTypeError(words) from None
