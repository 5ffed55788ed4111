# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be written after ``edgescan bench``."""

from __future__ import annotations

import argparse
from pathlib import Path

from freecad_edgescan.shared_options import number, whole_number

__all__ = ["add_bench_options"]


def add_bench_options(bench: argparse.ArgumentParser) -> None:
    """Declare the options of ``edgescan bench``."""
    bench.add_argument(
        "--points", type=whole_number, default=1_000_000, metavar="N", help="cloud size"
    )
    bench.add_argument(
        "--sizes", nargs="*", type=whole_number, metavar="N",
        help="instead: one edge from file to curve in clouds of so many points, seconds and bytes "
        "(none: from 100000 to 10000000, in about a minute)",
    )  # fmt: skip
    bench.add_argument(
        "--parts", nargs="*", type=Path, metavar="FILE",
        help="instead: find all edges in simulated scans of these parts (.step .iges .brep; "
        "none: a block with a blind bore), and compare them with the parts' own",
    )  # fmt: skip
    bench.add_argument(
        "--fillet", nargs="+", type=number, default=[], metavar="PITCHES",
        help="of --parts, with their straight convex edges rounded; radii in pitches of the scan",
    )  # fmt: skip
    bench.add_argument(
        "--peers", action="store_true", help="of --parts, beside what surface variation labels"
    )
    bench.add_argument(
        "--seed", type=whole_number, default=0, metavar="N", help="of the random numbers"
    )
