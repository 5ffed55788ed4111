# SPDX-License-Identifier: LGPL-2.1-or-later
"""``edgescan bench --parts``: all edges of known parts in their whole clouds."""

from __future__ import annotations

import argparse
import os
import sys

from freecad_edgescan.terminal_progress import TerminalProgress, exit_code

__all__ = ["bench_parts"]


def bench_parts(options: argparse.Namespace) -> int:
    """Print the table and answer the exit code."""
    from freecad_edgescan.document.network_bench import NOISE, bench_part, parts_to_bench
    from freecad_edgescan.experiments.network_report import ROOM, NetworkReport
    from freecad_edgescan.experiments.peers import missing_peers

    if options.peers:
        folder = os.environ.get("EDGESCAN_PEERS")
        if folder and folder not in sys.path:
            sys.path.append(folder)
        if "jakteristics" in missing_peers():
            raise ValueError("--peers needs jakteristics from PyPI; ./edgescan installs it.")
    for fillet in options.fillet:
        if not fillet > 0.0:
            raise ValueError(f"--fillet is {fillet:g}; give a positive number of pitches.")
    code = 0
    for part, pitch in parts_to_bench(options.parts, options.fillet):
        with TerminalProgress(part.name) as progress:
            reports = bench_part(part, pitch, options.seed, options.peers, progress)
        first = reports[0]
        print(
            f"{part.name}: {first.points} points, pitch {pitch:.3g} mm, noise {NOISE * pitch:.3g} "
            f"mm; {first.length[0]:.0f} mm of sharp edges with {ROOM:g} pitches of room and "
            f"{first.corners[0]} vertices of three of them are sought; "
            f"{first.length[1]:.0f} mm of edges and {first.corners[1]} corners were found."
        )
        print(NetworkReport.HEADER)
        for report in reports:
            print(report.text())
        print(f"rms of find_edges: {first.rms / (NOISE * pitch):.2f} times the noise\n")
        if code := exit_code(progress):
            break
    return code
