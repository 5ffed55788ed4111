# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be written after ``edgescan doe``."""

from __future__ import annotations

import argparse
import re
from pathlib import Path

__all__ = ["DOE_TEXT", "add_doe_options", "refuse_run_options"]

FIGURES = (
    *("5.2", "5.3", "5.4", "5.5", "5.6", "5.7", "5.8", "5.9"),
    *("5.37", "5.38", "D.9", "D.10", "D.11", "D.12"),
)
CHOICES = ("compensation", "tangent", "model")

# What only the experiments themselves take, not a figure or a comparison.
_OF_RUNS = {
    "experiments": tuple(range(1, 13)),
    "patterns": ("zigzag", "square"),
    "degrees": (1, 2),
    "seeds": None,
    "csv": Path("doe.csv"),
    "plot": None,
}

DOE_TEXT = """Simulates the 192 objects of K. Schreve's experiments (appendix E of the
dissertation of 2001, whose numbers the figures have), scans each in two patterns and two
degrees, and compares the errors with the published ones. docs/experiments.md tells more. Prints
  effects   how much each of 11 parameters changes the error, beside the published effect
  failures  the runs that did not reach the gate, with what may have caused that
  ratios    our error over the published one, geometric mean over what both completed

figures:  5.2-5.5, D.9-D.12  the error a probed scan has without noise; 5 quadratic, D line
          5.6-5.9            the same beside scans of noisy clouds
          5.37, 5.38         what a scan costs with the amplitude, and with the cloud's size
examples:
  edgescan doe                                     all 768 scans; the table goes to doe.csv
  edgescan doe --experiments 1-3,8 --degrees 2     some of them
  edgescan doe --method patch --plot pictures      192 scans with all points, and drawings
  edgescan doe --figure 5.6 -o noise.png
  edgescan doe --compare compensation
"""


def add_doe_options(doe: argparse.ArgumentParser) -> None:
    """Declare the options of ``edgescan doe``."""
    doe.add_argument(
        "--experiments", type=_numbers, default=_OF_RUNS["experiments"], metavar="1-12",
        help="which, such as 3 or 1-4,8 (default: all)",
    )  # fmt: skip
    doe.add_argument(
        "--patterns", type=_words, default=_OF_RUNS["patterns"], metavar="zigzag,square",
        help="how the scan lines follow each other (default: both)",
    )  # fmt: skip
    doe.add_argument(
        "--degrees", type=_numbers, default=_OF_RUNS["degrees"], metavar="1,2",
        help="of the curve through a side's points: 1 line, 2 quadratic, 3 cubic (default: 1,2)",
    )  # fmt: skip
    doe.add_argument(
        "--method", choices=("probe", "patch"), default="probe",
        help="probe: scan lines, as published (default); patch: all points near the edge",
    )  # fmt: skip
    seeds = doe.add_mutually_exclusive_group()
    seeds.add_argument("--seed", type=int, default=0, metavar="K", help="of the noise (default: 0)")
    seeds.add_argument("--seeds", type=int, metavar="N", help="do it with the seeds 0 … N-1")
    doe.add_argument(
        "--jobs", type=int, default=2, metavar="N", help="processes at a time (default: 2)"
    )
    doe.add_argument(
        "--literal", action="store_true", help="the algorithm as printed, without what was added"
    )
    doe.add_argument(
        "--csv", type=Path, default=_OF_RUNS["csv"], metavar="FILE.csv",
        help="where the table of all runs goes (default: doe.csv)",
    )  # fmt: skip
    doe.add_argument(
        "--plot", type=Path, metavar="FOLDER",
        help="draw the effects of each experiment and the ratio of every test",
    )  # fmt: skip
    other = doe.add_mutually_exclusive_group()
    other.add_argument(
        "--figure", choices=FIGURES, metavar="NUMBER",
        help="instead: a figure of the publication, as numbers and as a picture",
    )  # fmt: skip
    other.add_argument(
        "--compare", choices=CHOICES,
        help="instead: ways to take the probe radius off or to find the edge's direction, or an "
        "exact machine's scans beside the analytical error",
    )  # fmt: skip
    doe.add_argument(
        "-o", "--output", type=Path, metavar="FILE.png",
        help="picture of --figure or --compare (default: figure-NUMBER.png, CHOICE.png)",
    )  # fmt: skip


def refuse_run_options(options: argparse.Namespace) -> None:
    """Raise ValueError when an option was given that a figure or a comparison would not heed."""
    given = [name for name, default in _OF_RUNS.items() if getattr(options, name) != default]
    if given:
        instead = "--compare" if options.compare else "--figure"
        raise ValueError(
            f"--{given[0]} is not for {instead}, which has runs of its own; leave it out."
        )


def _numbers(text: str) -> tuple[int, ...]:
    """1-3,8 as 1, 2, 3, 8."""
    numbers: list[int] = []
    for part in text.split(","):
        found = re.fullmatch(r"\s*(\d+)(?:-(\d+))?\s*", part)
        if found is None or (found[2] and int(found[2]) < int(found[1])):
            raise argparse.ArgumentTypeError(
                f"{text!r} are not whole numbers; write them such as 3 or 1-4,8"
            )
        numbers += range(int(found[1]), int(found[2] or found[1]) + 1)
    return tuple(numbers)


def _words(text: str) -> tuple[str, ...]:
    return tuple(word.strip() for word in text.split(","))
