# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be written on the command line: sub-commands, their options, and help.

Options of a command stand in the file of its name, such as ``scan_options``; those of commands with
hardly any stand here.
"""

from __future__ import annotations

import argparse
import re
from collections.abc import Sequence
from pathlib import Path
from textwrap import fill
from typing import Any, NoReturn

from freecad_edgescan import __version__
from freecad_edgescan.accuracy_options import ACCURACY_TEXT, add_accuracy_options
from freecad_edgescan.bench_options import add_bench_options
from freecad_edgescan.doe_options import DOE_TEXT, add_doe_options
from freecad_edgescan.find_options import FIND_TEXT, add_find_options
from freecad_edgescan.scan_options import SCAN_EXAMPLES, add_recommend_options, add_scan_options
from freecad_edgescan.shared_options import add_file, number
from freecad_edgescan.sweep_options import SWEEP_TEXT, add_sweep_options

__all__ = ["read_options"]

BENCH_SUMMARY = (
    "how fast this machine is; with --parts, how much of all edges of known parts is found, how "
    "much of what is found is true, and how exactly"
)

SURFACES_TEXT = """\
Prints two examples of K. Schreve's dissertation (2001) beside the figures printed there, and how
long fits and projections take beside FITPACK and FreeCAD:
  appendix H    a surface that is extended over its side, beside two other ways to extend it
  test 2S1.11   one of its simulated scans, of an edge of radius 35 mm: the edge in which the two
                surfaces fitted to its sides meet (printed in appendix I), beside scanning it"""

CASESTUDY_TEXT = """\
The core box of the published case study, from its raster of probe centres to swept surfaces: its
four rims are scanned and become rails, profiles stand at their ends, base surfaces cut the cloud,
and sweeps are fitted in both models (blend: as published; rotate: the profile turns with the rails)
to the 5 mm grid that was used and to the whole cloud. Prints the deviations beside the published
ones and the time of each step beside the published minutes."""


class _Parser(argparse.ArgumentParser):
    """Says what is wrong in one sentence instead of printing the whole usage."""

    def error(self, message: str) -> NoReturn:
        self.exit(2, f"{self.prog}: {message}; {self.prog} --help tells more.\n")


def read_options(words: Sequence[str]) -> argparse.Namespace:
    """What the words of a command line ask for; a wrong one is a sentence and exit code 2."""
    parser = _parser()
    options, unknown = parser.parse_known_args(_as_values(words))
    if unknown:
        parser.prog += f" {options.command}"
        word = unknown[0].strip()
        if word.startswith("-"):
            parser.error(f"{options.command} has no option {word}")
        if hasattr(options, "file"):
            parser.error(f"{options.command} takes one file, but was also given {word!r}")
        parser.error(f"{options.command} does not take {word!r}")
    return options


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog="edgescan", description="True sharp edges from scanned point clouds.")
    parser.add_argument("--version", action="version", version=f"EdgeScan {__version__}")
    commands = parser.add_subparsers(required=True, metavar="COMMAND", dest="command")

    add_scan_options(_add_command(commands, "scan", "scan edges of a cloud", SCAN_EXAMPLES))
    add_find_options(
        _add_command(commands, "find", "find all edges of a cloud, without a click", FIND_TEXT)
    )
    add_sweep_options(
        _add_command(
            commands, "sweep", "sweep scanned edges along others, fitted to the cloud", SWEEP_TEXT
        )
    )
    add_recommend_options(
        _add_command(commands, "recommend", "how to scan an edge, and the error to expect of it")
    )

    info = _add_command(commands, "info", "what is in a cloud file")
    add_file(info)
    info.add_argument(
        "--picture", type=Path, metavar="FILE.png",
        help="the cloud from three sides with its coordinates, to read places for scan --at from",
    )  # fmt: skip

    add_bench_options(_add_command(commands, "bench", BENCH_SUMMARY))
    add_accuracy_options(
        _add_command(
            commands, "accuracy", "how exactly edges of CAD parts are found", ACCURACY_TEXT
        )
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
        "--pitch", type=number, default=0.5, metavar="MM",
        help="of the simulated scan (default: 0.5, as published)",
    )  # fmt: skip
    return parser


def _add_command(
    commands: Any, name: str, summary: str, epilog: str | None = None
) -> argparse.ArgumentParser:
    parser: argparse.ArgumentParser = commands.add_parser(
        name,
        help=summary,
        description=fill(summary[0].upper() + summary[1:] + ". Lengths are mm.", 98),
        epilog=epilog,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--debug", action="store_true", help="show where an error came from")
    return parser


def _as_values(words: Sequence[str]) -> list[str]:
    """Put a blank before ``-1,2,3``, which argparse would take for an option without it."""
    return [f" {word}" if re.fullmatch(r"-\.?\d[-+\d.,;eE]*", word) else word for word in words]
