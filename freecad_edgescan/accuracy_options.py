# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be written after ``edgescan accuracy``."""

from __future__ import annotations

import argparse
from pathlib import Path

from freecad_edgescan.shared_options import number, whole_number

__all__ = ["ACCURACY_TEXT", "add_accuracy_options"]

ACCURACY_TEXT = """Simulates a scan of each part, clicks every sharp edge at its middle, and
compares what is found with the part's own edges. Without --parts also two planes, the same
under a fillet, and a cylinder's rim (pitch 0.5, noise 0.02, edge points 0.75 mm apart), with
and without 5 % outliers, and the rims of a core box, sharp and rounded, and tight bends.
  length   of the true edge           room    smallest distance to another edge
  traced   share of it found within one pitch
  rms max  distance of the edge points from it
  sigma    mean standard deviation that the scan states itself

examples:
  edgescan accuracy --peers
  edgescan accuracy --parts part.step --pitch 0.3 --noise 0.06
  edgescan accuracy --peers --parts part.step --report docs/accuracy.md
"""


def add_accuracy_options(accuracy: argparse.ArgumentParser) -> None:
    """Declare the options of ``edgescan accuracy``."""
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
            option, type=number, default=value, metavar="MM", help=f"{text} (default: {value:g})"
        )
    accuracy.add_argument(
        "--fillet", type=number, default=0.0, metavar="MM",
        help="first round the parts' straight convex edges; the sharp ones are sought",
    )  # fmt: skip
    accuracy.add_argument(
        "--peers", action="store_true",
        help="beside what RANSAC planes and surface variation make of the simple parts' clouds",
    )  # fmt: skip
    accuracy.add_argument(
        "--seeds", type=whole_number, metavar="N",
        help="clouds of each simple part (default: 5)",
    )  # fmt: skip
    accuracy.add_argument(
        "--report", type=Path, metavar="FILE.md",
        help="write all about accuracy as a page with pictures: simple parts, rims, bends, the "
        "block, --parts, and the published experiments (doe --method patch), in about seven "
        "minutes",
    )  # fmt: skip
    accuracy.add_argument(
        "--wedges", type=whole_number, metavar="N",
        help="instead of parts: N wedges at random, spoilt at random; lists wrong edges",
    )  # fmt: skip
    accuracy.add_argument(
        "--sharp", action="store_true", help="of --wedges, only such without a rounding"
    )
    accuracy.add_argument(
        "--steps", type=whole_number, metavar="N",
        help="the same with N steps: two edges, sharp or rounded, a narrow land between them",
    )  # fmt: skip
    accuracy.add_argument(
        "--seed", type=whole_number, default=0, metavar="N", help="of the random numbers"
    )
