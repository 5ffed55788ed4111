# SPDX-License-Identifier: LGPL-2.1-or-later
"""``edgescan bench --parts``: all edges of known parts in their whole clouds."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Mapping
from contextlib import ExitStack
from typing import TYPE_CHECKING

from freecad_edgescan.terminal_progress import TerminalProgress, exit_code

if TYPE_CHECKING:
    from freecad_edgescan.document.network_bench import Labels

__all__ = ["bench_parts"]


def bench_parts(options: argparse.Namespace) -> int:
    """Print the table and answer the exit code."""
    from freecad_edgescan.document.network_bench import NOISE, bench_part, parts_to_bench
    from freecad_edgescan.experiments.network_report import ROOM, NetworkReport

    for fillet in options.fillet:
        if not fillet > 0.0:
            raise ValueError(f"--fillet is {fillet:g}; give a positive number of pitches.")
    code = 0
    with ExitStack() as until_done:
        peers = _peers(until_done) if options.peers else {}
        for part, pitch in parts_to_bench(options.parts, options.fillet):
            with TerminalProgress(part.name) as progress:
                bench = bench_part(part, pitch, options.seed, peers, progress)
            first = bench.reports[0]
            print(
                f"{part.name}: {first.points} points, pitch {pitch:.3g} mm, noise "
                f"{NOISE * pitch:.3g} mm; {first.length[0]:.0f} mm of sharp edges with {ROOM:g} "
                f"pitches of room and {first.corners[0]} vertices of three of them are sought; "
                f"{first.length[1]:.0f} mm of edges and {first.corners[1]} corners were found."
            )
            print(NetworkReport.HEADER)
            for report in bench.reports:
                print(report.text())
            print(f"rms of find_edges: {first.rms / (NOISE * pitch):.2f} times the noise")
            print(f"{bench.regions.text()}.\n" if bench.regions else "")
            if code := exit_code(progress):
                break
    return code


def _peers(until_done: ExitStack) -> Mapping[str, Labels]:
    """Those whom the same clouds are shown; what is missing is said.

    Raises
    ------
    ValueError: jakteristics is missing, which the launcher installs.
    """
    from freecad_edgescan.experiments.peers import missing_peers, whole_cloud_labels
    from freecad_edgescan.experiments.voronoi_peer import VoronoiPeer

    folder = os.environ.get("EDGESCAN_PEERS")
    if folder and folder not in sys.path:
        sys.path.append(folder)
    if "jakteristics" in missing_peers():
        raise ValueError("--peers needs jakteristics from PyPI; ./edgescan installs it.")
    peers: dict[str, Labels] = {"surface variation": whole_cloud_labels}
    try:
        voronoi = until_done.enter_context(VoronoiPeer())
    except ValueError as missing:
        print(f"Without CGAL beside it. {missing}\n")
    else:
        peers["CGAL's VCM"] = lambda cloud, _: voronoi.labelled(cloud)
    return peers
