# SPDX-License-Identifier: LGPL-2.1-or-later
"""``edgescan bench``: how fast this machine is, how cost grows with a cloud, all edges of parts."""

from __future__ import annotations

import argparse
import os
import sys

from freecad_edgescan.terminal_progress import TerminalProgress, exit_code

__all__ = ["bench"]


def bench(options: argparse.Namespace) -> int:
    """Print what was asked for, as it is measured; answer the exit code."""
    if options.parts is None and (options.fillet or options.peers):
        raise ValueError("--fillet and --peers belong to --parts; give it, or leave them out.")
    if options.parts is not None and options.sizes is not None:
        raise ValueError("--parts and --sizes are two measurements; give one at a time.")
    if options.parts is not None:
        return _bench_parts(options)
    if options.sizes is not None:
        return _bench_sizes(options)
    return _bench_speed(options)


def _bench_speed(options: argparse.Namespace) -> int:
    """How fast a cloud is read, indexed and scanned."""
    from freecad_edgescan.experiments import measure_speed

    with TerminalProgress("bench") as progress:
        speed = measure_speed(options.points, progress)
    if speed is None:
        return exit_code(progress, found=False)
    print(f"cloud              {speed.points} points")
    for ending, seconds in speed.reading.items():
        ratio = seconds / speed.bare_indexing
        print(
            f"reading {ending}       {speed.per_million(seconds):.2f} s per million points "
            f"({ratio:.1f} x SciPy's bare KD-tree)"
        )
    print(
        f"indexing           {speed.per_million(speed.indexing):.2f} s per million points "
        f"({speed.indexing_ratio:.2f} x SciPy's bare KD-tree, "
        f"{speed.per_million(speed.bare_indexing):.2f} s)"
    )
    print(
        f"scanning           {speed.edge_points_per_second:.0f} edge points per second "
        f"({speed.edge_points} in {speed.scanning:.2f} s, {speed.slab_points:.0f} cloud points for "
        f"each, mean error {speed.mean_error:.4f} mm)\n"
        f"                   {100 * speed.in_tree:.0f} % of its time in queries of the KD-tree, "
        f"{100 * speed.in_fits:.0f} % in fits and intersections"
    )
    return 0


def _bench_sizes(options: argparse.Namespace) -> int:
    """One edge in clouds of several sizes."""
    from freecad_edgescan.experiments.cloud_sizes import SIZES, SizeCost, measure_sizes, slope

    costs: list[SizeCost] = []
    with TerminalProgress("bench") as progress:
        for cost in measure_sizes(options.sizes or SIZES, progress):
            progress.clear()
            if not costs:
                print(SizeCost.HEADER)
            print(cost.text(), flush=True)
            costs.append(cost)
    if len(costs) > 1:
        first, last = costs[0], costs[-1]
        print(
            f"From {first.points} to {last.points} points, {last.points / first.points:.3g} times "
            f"as many, the scan's time changes by the factor {last.scanning / first.scanning:.2f}: "
            f"slope {slope(costs):.3f}."
        )
    return exit_code(progress, found=bool(costs))


def _bench_parts(options: argparse.Namespace) -> int:
    """All edges of known parts in their whole clouds."""
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
