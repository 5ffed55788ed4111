# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sub-command accuracy: known edges of simulated scans, found and compared."""

from __future__ import annotations

import argparse
from typing import Any

from freecad_edgescan.terminal_progress import TerminalProgress, exit_code

__all__ = ["measure"]

_SEEDS = 5  # clouds of each simple part


def measure(options: argparse.Namespace) -> int:
    """Print the tables that are asked for, and answer the exit code."""
    if options.wedges is not None:
        return _wedges(options)
    if options.sharp:
        raise ValueError("--sharp belongs to --wedges; give it, or leave --sharp out.")
    if options.fillet < 0.0:
        raise ValueError(f"--fillet is {options.fillet:g}; give a positive radius in mm.")
    for given, word in ((options.peers, "peers"), (options.seeds is not None, "seeds")):
        if given and options.parts:
            raise ValueError(f"--{word} belongs to the simple parts; leave --parts out.")
    if not options.parts:
        code = _simple_parts(options)
        if code:
            return code
        print()
    return _parts(options)


def _simple_parts(options: argparse.Namespace) -> int:
    from freecad_edgescan.document.accuracy_table import measure_simple_parts, simple_table
    from freecad_edgescan.experiments.peers import PEERS, missing_peers

    seeds = _SEEDS if options.seeds is None else options.seeds
    if seeds < 1:
        raise ValueError(f"--seeds is {seeds}; give 1 or more.")
    if options.peers and missing_peers():
        raise ValueError(
            f"--peers needs {' and '.join(missing_peers())} from PyPI; ./edgescan installs them."
        )
    with TerminalProgress("simple parts") as progress:
        rows = measure_simple_parts(seeds, list(PEERS) if options.peers else (), progress)
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

    others = ("parts", "peers", "fillet", "seeds")
    for given, word in ((getattr(options, name), name) for name in others):
        if given:
            raise ValueError(f"--wedges are scanned instead of parts; leave --{word} out.")
    if options.wedges < 1:
        raise ValueError(f"--wedges is {options.wedges}; give 1 or more.")
    with TerminalProgress("wedges") as progress:
        found = search(options.wedges, not options.sharp, 100_000 * options.seed, progress=progress)
    print(wedge_table(found))
    return exit_code(progress, bool(found))
