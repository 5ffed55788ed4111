# SPDX-License-Identifier: LGPL-2.1-or-later
"""``edgescan scan``: from options to edges, files and a table."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from freecad_edgescan.cloud import PointCloud
from freecad_edgescan.cloud_file import cloud_of
from freecad_edgescan.cut_by_region import cut_by_region, outside_region
from freecad_edgescan.edge_table import edge_table
from freecad_edgescan.output_files import PICTURES, check_not_the_scan, check_output
from freecad_edgescan.place_in_unit import place_in_unit
from freecad_edgescan.scan_options import given_parameters
from freecad_edgescan.scanning import (
    Gate,
    ScannedEdge,
    ScanParameters,
    Start,
    scan_boundary,
    scan_edge,
)
from freecad_edgescan.terminal_progress import TerminalProgress, exit_code, tell
from freecad_edgescan.told_besides import told_besides

__all__ = ["scan_file"]

_MOST_EDGES = 99  # round a face, whose tables must not be written over the scan


def scan_file(options: argparse.Namespace) -> int:
    """Scan, write, print; answer the exit code."""
    targets = _targets(options)
    _check_outputs(options, len(targets))
    parameters = ScanParameters(**given_parameters(options))
    cloud = cloud_of(options)
    if options.inside is None:
        edges, code = _scan_targets(cloud, targets, parameters, options)
    else:
        edges, code = _scan_boundary(cloud, targets[0][0], parameters, options)
        targets = targets * len(edges)
    if not edges:
        return code
    written: list[Path] = []
    try:  # files first: who reads what is printed may go away
        for path in _write(options, cloud, targets, edges):
            written.append(path)
    finally:
        print(edge_table(edges))
        if cut := cut_by_region(edges, options.region):
            print(cut)
        for path in written:
            print(f"Wrote {path}")
    return code


def _write(
    options: argparse.Namespace,
    cloud: PointCloud,
    targets: Sequence[tuple[Any, Any]],
    edges: dict[int, ScannedEdge],
) -> Iterator[Path]:
    """Write what was asked for, and name each file when it is written."""
    for path in options.output:
        if path.suffix.lower() == ".csv":
            for number, edge in edges.items():
                edge.to_csv(file := _numbered(path, number, len(targets)))
                yield file
        else:
            _write_step(edges, path)
            yield path
    if options.picture:
        from freecad_edgescan.experiments import draw_edges

        names = [f"edge {number}" for number in edges]
        draw_edges(cloud, list(edges.values()), options.picture, options.view, names)
        yield options.picture
    if options.section:
        from freecad_edgescan.experiments import draw_section

        number, edge = next(iter(edges.items()))
        at = targets[number - 1][0]
        draw_section(edge, getattr(at, "point", at), options.section)
        yield options.section


def _numbered(path: Path, number: int, of: int) -> Path:
    """The table of one click of several: name-1.csv, name-2.csv and so on."""
    return path if of == 1 else path.with_stem(f"{path.stem}-{number}")


def _write_step(edges: dict[int, ScannedEdge], path: Path) -> None:
    try:
        from freecad_edgescan.document import export_step
    except ImportError as error:
        raise ValueError(
            f"{path} needs FreeCAD, which did not load ({error}); write .csv instead."
        ) from error
    export_step(list(edges.values()), path)


def _targets(options: argparse.Namespace) -> list[tuple[Any, Any]]:
    """What to scan from and to: pairs of a click or Start, and a point, Gate or None."""
    gate: Any = options.gate
    if options.inside is not None:
        _check_inside(options)
    if options.gate_across is not None:
        if gate is None:
            raise ValueError("--gate-across needs --gate, the gate's first end; give both.")
        gate = Gate(gate, options.gate_across)
    if options.start is None:
        if options.across is not None or options.along is not None:
            raise ValueError("--across and --along belong to --start; give it, or leave them out.")
        if not options.at:
            raise ValueError(
                "scan needs a place: give --at X,Y,Z, a point near an edge; "
                "edgescan info FILE --picture part.png draws where that is."
            )
        if gate is not None and len(options.at) > 1:
            raise ValueError(
                f"one --gate cannot end {len(options.at)} edges; give one --at with it."
            )
        return [(at, gate) for at in options.at]
    if options.at:
        raise ValueError("--at and --start both say where to begin; give one of them.")
    if options.across is None or options.along is None:
        raise ValueError("--start needs --across and --along; give these two directions.")
    return [(Start(options.start, options.across, options.along), gate)]


def _check_inside(options: argparse.Namespace) -> None:
    """Refuse what does not go with the edges round a face."""
    if len(options.at) != 1:
        raise ValueError("--inside needs one --at, a point near an edge of that face; give both.")
    if options.gate is not None:
        raise ValueError("--inside goes round the whole face; leave --gate out.")
    if options.method != "patch":
        raise ValueError("--inside is for the patch method; leave --method out.")


def _check_outputs(options: argparse.Namespace, clicks: int) -> None:
    """Refuse, before anything is read, what cannot be written or would write over the scan."""
    for path in options.output:
        check_output(path, (".step", ".stp", ".csv"), options.file)
        if path.suffix.lower() == ".csv":
            for number in range(1, (clicks if options.inside is None else _MOST_EDGES) + 1):
                check_not_the_scan(_numbered(path, number, clicks), options.file)
    for picture in (options.picture, options.section):
        if picture:
            check_output(picture, PICTURES, options.file)


def _scan_targets(
    cloud: PointCloud,
    targets: Sequence[tuple[Any, Any]],
    parameters: ScanParameters,
    options: argparse.Namespace,
) -> tuple[dict[int, ScannedEdge], int]:
    """Edges by their number, and the exit code: 2 after a failure, 130 after Ctrl-C.

    A target that fails is told and leaves the others alone.
    """
    edges: dict[int, ScannedEdge] = {}
    for number, (at, gate) in enumerate(targets, 1):
        with TerminalProgress(f"edge {number} of {len(targets)}") as progress:
            try:
                place = getattr(at, "point", at)
                with told_besides(
                    outside_region(place, options.region),
                    place_in_unit(place, cloud, options.unit),
                ):
                    edges[number] = scan_edge(
                        cloud, at, gate, parameters, options.method, progress=progress
                    )
            except ValueError as error:
                progress.clear()
                tell(f"edge {number}: {error}")
        if progress.cancelled:
            return edges, exit_code(progress)
    return edges, 0 if len(edges) == len(targets) else 2


def _scan_boundary(
    cloud: PointCloud, at: Any, parameters: ScanParameters, options: argparse.Namespace
) -> tuple[dict[int, ScannedEdge], int]:
    """Edges round a face by their number, and the exit code."""
    with TerminalProgress("edges round the face") as progress:
        try:
            with told_besides(
                outside_region(at, options.region), place_in_unit(at, cloud, options.unit)
            ):
                found = scan_boundary(cloud, at, options.inside, parameters, progress=progress)
        except ValueError as error:
            progress.clear()
            tell(str(error))
            return {}, 2
    edges = dict(enumerate(found, 1))
    return edges, exit_code(progress) if progress.cancelled else 0
