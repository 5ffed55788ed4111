# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sub-command accuracy: known edges of simulated scans, found and compared."""

from __future__ import annotations

import argparse
from typing import Any

from freecad_edgescan.terminal_progress import TerminalProgress, exit_code

__all__ = ["measure"]


def measure(options: argparse.Namespace) -> int:
    """Print the tables that are asked for, and answer the exit code."""
    if options.wedges is not None:
        return _wedges(options)
    if options.sharp:
        raise ValueError("--sharp belongs to --wedges; give it, or leave --sharp out.")
    if not options.parts:
        code = _simple_parts(options)
        if code:
            return code
        print()
    elif options.peers:
        raise ValueError("--peers are asked about the simple parts; leave --parts out.")
    return _parts(options)


def _simple_parts(options: argparse.Namespace) -> int:
    from freecad_edgescan.document.accuracy_table import measure_simple_parts, simple_table
    from freecad_edgescan.experiments.peers import PEERS, missing_peers

    if options.seeds < 1:
        raise ValueError(f"--seeds is {options.seeds}; give 1 or more.")
    if options.peers and missing_peers():
        raise ValueError(
            f"--peers needs {' and '.join(missing_peers())} from PyPI; ./edgescan installs them."
        )
    with TerminalProgress("simple parts") as progress:
        rows = measure_simple_parts(options.seeds, list(PEERS) if options.peers else (), progress)
    if rows:
        print(simple_table(rows))
    return exit_code(progress, bool(rows))


def _parts(options: argparse.Namespace) -> int:
    from freecad_edgescan.document.known_parts import block_with_bore, filleted, sharp_part
    from freecad_edgescan.document.part_report import read_part, report_part

    parts: list[tuple[str, Any]] = [(file.name, read_part(file)) for file in options.parts]
    for number, (name, shape) in enumerate(parts or [("block with bore", block_with_bore())]):
        part = sharp_part(name, shape)
        if options.fillet:
            part = filleted(name, shape, options.fillet, options.pitch)
        with TerminalProgress(part.name) as progress:
            report = report_part(
                part,
                options.pitch,
                options.noise,
                options.probe_radius,
                options.seed,
                progress,
            )
        print(("\n" if number else "") + report.text())
        if options.fillet:
            print(_under_fillets(report, options))
        if progress.cancelled:
            return exit_code(progress)
    return 0


def _under_fillets(report: Any, options: argparse.Namespace) -> str:
    allowed = options.noise + 0.02 * options.fillet
    good = sum(row.rms <= allowed for row in report.rows)
    return (
        f"{good} of {len(report.rows)} sharp edges under fillets of {options.fillet:g} mm found "
        f"with an rms of at most {allowed:.3g} mm (noise and 2 % of the radius)."
    )


def _wedges(options: argparse.Namespace) -> int:
    from freecad_edgescan.experiments.wedge_search import search, wedge_table

    for given, word in ((options.parts, "parts"), (options.peers, "peers")):
        if given:
            raise ValueError(f"--wedges are scanned instead of parts; leave --{word} out.")
    if options.wedges < 1:
        raise ValueError(f"--wedges is {options.wedges}; give 1 or more.")
    with TerminalProgress("wedges") as progress:
        found = search(options.wedges, not options.sharp, 100_000 * options.seed, progress=progress)
    print(wedge_table(found))
    return exit_code(progress, bool(found))
