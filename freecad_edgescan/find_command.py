# SPDX-License-Identifier: LGPL-2.1-or-later
"""``edgescan find``: all edges of a cloud, without a click."""

from __future__ import annotations

import argparse
import csv
import math
from pathlib import Path

import numpy as np

from freecad_edgescan.cloud_file import cloud_of
from freecad_edgescan.cut_by_region import cut_by_region
from freecad_edgescan.edge_table import sigma_text
from freecad_edgescan.geometry.plain_number import plain
from freecad_edgescan.output_files import PICTURES, check_output
from freecad_edgescan.scanning import EdgeNetwork, Stop, find_edges
from freecad_edgescan.scanning.edge_point_table import COLUMNS, edge_point_rows
from freecad_edgescan.terminal_progress import TerminalProgress, exit_code, tell

__all__ = ["find_in_file"]


def find_in_file(options: argparse.Namespace) -> int:
    """Find, write, print; answer the exit code."""
    if options.output:
        check_output(options.output, (".step", ".stp"), options.file)
    if options.csv:
        check_output(options.csv, (".csv",), options.file)
    if options.corners:
        check_output(options.corners, (".csv",), options.file)
    if options.picture:
        check_output(options.picture, PICTURES, options.file)
    if not 0.0 < options.min_angle < 180.0:
        raise ValueError(
            f"--min-angle is {options.min_angle:g}°; give an angle above 0 and below 180 degrees."
        )
    cloud = cloud_of(options)
    with TerminalProgress("edges") as progress:
        network = find_edges(cloud, math.radians(options.min_angle), options.min_length, progress)
    if not len(network):
        return _tell_of_nothing(options, network, progress)
    written: list[Path] = []
    try:
        _write(options, network, written)
    finally:
        print(network_table(network))
        if cut := cut_by_region(dict(enumerate(network.edges, 1)), options.region):
            print(cut)
        for path in written:
            print(f"Wrote {path}")
    return exit_code(progress) if network.cancelled else 0


def _tell_of_nothing(
    options: argparse.Namespace, network: EdgeNetwork, progress: TerminalProgress
) -> int:
    if network.cancelled:
        return exit_code(progress, found=False)
    files = (options.output, options.csv, options.corners, options.picture)
    unwritten = ", ".join(str(path) for path in files if path)
    tell(network.message + (f" Nothing was written into {unwritten}." if unwritten else ""))
    return 2


def network_table(network: EdgeNetwork) -> str:
    """One row for each edge, and what there is to say about all of them."""
    lines = [
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
            f"{sigma_text(np.mean(edge.sigma)):>7}  {turn:5.1f}  {radius}"
        )
    if any(end is Stop.CORNER for ends in network.ends for end in ends):
        lines += [
            f"{Stop.CORNER.name}: the edge turns sharply or meets a third side there, and no "
            "corner with a number could be measured."
        ]
    if count := len(network.corners):
        lines += [
            f"{count} corner{'s' * (count != 1)}, from which the edges' own vertices differ by "
            f"{plain(float(np.median(network.corner_misclosure)), 2)} mm (median)."
        ]
    return "\n".join([*lines, network.message])


def _end(end: int | Stop) -> str:
    return end.name if isinstance(end, Stop) else f"corner {end + 1}"


def _write(options: argparse.Namespace, network: EdgeNetwork, written: list[Path]) -> None:
    if options.csv:
        write_table(network, options.csv)
        written.append(options.csv)
    if options.corners:
        write_corners(network, options.corners)
        written.append(options.corners)
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
        draw_edges(network.cloud, list(network.edges), options.picture, options.view, names, True)
        written.append(options.picture)


def write_corners(network: EdgeNetwork, path: Path) -> None:
    """One row for each corner: its number, position, sigma, misclosure, and its edges' numbers."""
    header = ["corner", "x_mm", "y_mm", "z_mm", "sigma_mm", "misclosure_mm", "edges"]
    sigma = np.sqrt(np.linalg.eigvalsh(network.corner_covariance)[:, -1])
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(header)
        for k, point in enumerate(network.corners):
            row = [f"{value:.6f}" for value in (*point, sigma[k], network.corner_misclosure[k])]
            edges = " ".join(str(number + 1) for number in network.edges_at(k))
            writer.writerow([k + 1, *row, edges])


def write_table(network: EdgeNetwork, path: Path) -> None:
    """One row for each edge point: the edge's number, and what is known of the point."""
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["edge", *COLUMNS])
        for number, edge in enumerate(network.edges, 1):
            writer.writerows([number, *row] for row in edge_point_rows(edge))
