# SPDX-License-Identifier: LGPL-2.1-or-later
"""``edgescan find``: all edges of a cloud, without a click."""

from __future__ import annotations

import argparse
import csv
import math
from pathlib import Path

import numpy as np

from freecad_edgescan.cloud_file import cloud_of
from freecad_edgescan.output_files import PICTURES, check_output
from freecad_edgescan.scanning import EdgeNetwork, Stop, find_edges
from freecad_edgescan.terminal_progress import TerminalProgress, exit_code

__all__ = ["find_in_file"]


def find_in_file(options: argparse.Namespace) -> int:
    """Find, write, print; answer the exit code."""
    if options.output:
        check_output(options.output, (".step", ".stp"), options.file)
    if options.csv:
        check_output(options.csv, (".csv",), options.file)
    if options.picture:
        check_output(options.picture, PICTURES, options.file)
    cloud = cloud_of(options)
    with TerminalProgress("edges") as progress:
        network = find_edges(cloud, math.radians(options.min_angle), options.min_length, progress)
    written: list[Path] = []
    try:
        if len(network):
            _write(options, network, written)
    finally:
        print(network_table(network))
        for path in written:
            print(f"Wrote {path}")
    return exit_code(progress) if network.cancelled else 0


def network_table(network: EdgeNetwork) -> str:
    """One row for each edge, and what there is to say about all of them."""
    lines = []
    if len(network):
        lines += [
            "edge  points     length  from          to              sigma   turn   fillet",
            "                     mm                              mean mm    deg  radius mm",
        ]
    for number, (edge, ends) in enumerate(zip(network.edges, network.ends, strict=True), 1):
        radii = edge.fillet_radius[np.isfinite(edge.fillet_radius)]
        radius = f"{np.median(radii):9.3f}" if len(radii) else "        -"
        start, end = ("closed", "closed") if edge.closed else (_end(ends[0]), _end(ends[1]))
        turn = 180.0 - np.degrees(np.median(edge.angle))
        lines.append(
            f"{number:4d}  {len(edge):6d}  {edge.length:9.3f}  {start:<12}  {end:<12}  "
            f"{np.mean(edge.sigma):7.4f}  {turn:5.1f}  {radius}"
        )
    if len(network.corners):
        lines += [
            f"{len(network.corners)} corners; their edges' own vertices differ from them by "
            f"{np.median(network.corner_misclosure):.2g} mm (median)."
        ]
    return "\n".join([*lines, network.message])


def _end(end: int | Stop) -> str:
    return end.name if isinstance(end, Stop) else f"corner {end + 1}"


def _write(options: argparse.Namespace, network: EdgeNetwork, written: list[Path]) -> None:
    if options.csv:
        write_table(network, options.csv)
        written.append(options.csv)
    if options.output:
        try:
            from freecad_edgescan.document import export_step
            from freecad_edgescan.document.edge_network_shape import network_shape
        except ImportError as error:
            raise ValueError(
                f"{options.output} needs FreeCAD, which did not load ({error}); write .csv instead."
            ) from error
        export_step([network_shape(network)], options.output)
        written.append(options.output)
    if options.picture:
        from freecad_edgescan.experiments import draw_edges

        names = [f"edge {number}" for number in range(1, len(network) + 1)]
        draw_edges(network.cloud, list(network.edges), options.picture, options.view, names)
        written.append(options.picture)


def write_table(network: EdgeNetwork, path: Path) -> None:
    """One row for each edge point: the edge's number, position, sigma, tangent, turn, radius."""
    header = ["edge", "x_mm", "y_mm", "z_mm", "sigma_mm", "tangent_x", "tangent_y", "tangent_z"]
    header += ["angle_deg", "fillet_radius_mm", "supported"]
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(header)
        for number, edge in enumerate(network.edges, 1):
            for j in range(len(edge)):
                row = [*edge.points[j], edge.sigma[j], *edge.tangents[j]]
                row += [np.degrees(edge.angle[j]), edge.fillet_radius[j]]
                rounded = [f"{value:.6f}" for value in row]
                writer.writerow([number, *rounded, int(edge.supported[j])])
