# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sub-command accuracy: known edges of simulated scans, found and compared."""

from __future__ import annotations

import argparse
import math
import os
import shlex
import sys
from pathlib import Path
from typing import Any

from freecad_edgescan.output_files import check_output
from freecad_edgescan.terminal_progress import TerminalProgress, exit_code, tell

__all__ = ["measure"]

_SEEDS = 5  # clouds of each simple part


def measure(options: argparse.Namespace) -> int:
    """Print the tables that are asked for, write the page about them, and answer the exit code."""
    _check_numbers(options)
    if options.wedges is not None or options.steps is not None:
        return _at_random(options)
    if options.sharp:
        raise ValueError("--sharp belongs to --wedges; give it, or leave --sharp out.")
    if options.report is not None:
        _check_report(options)
        return _report(options)
    for given, word in ((options.peers, "peers"), (options.seeds is not None, "seeds")):
        if given and options.parts:
            raise ValueError(f"--{word} belongs to the simple parts; leave --parts out.")
    if not options.parts:
        for measured in (_simple_parts, _rims_and_bends):
            _, code = measured(options)
            if code:
                return code
            print()
    return _parts(options, _shapes(options) or [_block()])[1]


def _check_numbers(options: argparse.Namespace) -> None:
    """Refuse numbers that cannot be before anything is measured."""
    if not 0.0 < options.pitch < math.inf:
        raise ValueError(f"--pitch is {options.pitch:g}; give a positive length in mm.")
    for word, what in (("noise", "noise"), ("probe_radius", "radius"), ("fillet", "radius")):
        value = getattr(options, word)
        if not 0.0 <= value < math.inf:
            option = word.replace("_", "-")
            raise ValueError(f"--{option} is {value:g}; give 0 or a positive {what} in mm.")
    if options.seed < 0:
        raise ValueError(f"--seed is {options.seed}; give 0 or more.")


# ---------------------------------------------------------------- tables


def _simple_parts(options: argparse.Namespace) -> tuple[list[Any], int]:
    from freecad_edgescan.document.accuracy_table import measure_simple_parts, simple_table
    from freecad_edgescan.experiments.peers import PEERS, missing_peers

    seeds = _SEEDS if options.seeds is None else options.seeds
    if seeds < 1:
        raise ValueError(f"--seeds is {seeds}; give 1 or more.")
    if options.peers:
        _reach_peers()
    if options.peers and missing_peers():
        raise ValueError(
            f"--peers needs {' and '.join(missing_peers())} from PyPI; ./edgescan installs them."
        )
    with TerminalProgress("simple parts") as progress:
        rows = measure_simple_parts(seeds, list(PEERS) if options.peers else (), progress)
    if rows:
        print(simple_table(rows))
    return rows, exit_code(progress, bool(rows))


def _rims_and_bends(options: argparse.Namespace) -> tuple[list[Any], int]:
    from freecad_edgescan.experiments.rims_and_bends import exact_edge_table, measure_exact_edges

    with TerminalProgress("rims and bends") as progress:
        edges = measure_exact_edges(progress=progress)
    if edges:
        print(exact_edge_table(edges))
    return edges, exit_code(progress, bool(edges))


def _reach_peers() -> None:
    """Add the folder into which ./edgescan installs the peers, behind everything else.

    NumPy and SciPy come along with them, and would be others than the scans are made with.
    """
    folder = os.environ.get("EDGESCAN_PEERS")
    if folder and folder not in sys.path:
        sys.path.append(folder)


def _shapes(options: argparse.Namespace) -> list[tuple[str, Any]]:
    from freecad_edgescan.document.part_report import read_part

    return [(file.name, read_part(file)) for file in options.parts]


def _block() -> tuple[str, Any]:
    from freecad_edgescan.document.known_parts import block_with_bore

    return "block with bore", block_with_bore()


def _parts(options: argparse.Namespace, shapes: list[tuple[str, Any]]) -> tuple[list[Any], int]:
    from freecad_edgescan.document.known_parts import filleted, sharp_part
    from freecad_edgescan.document.part_report import report_part

    reports: list[Any] = []
    for name, shape in shapes:
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
        print(("\n" if reports else "") + report.text())
        if options.fillet:
            print(_under_fillets(report, options))
        reports.append(report)
        if progress.cancelled:
            return reports, exit_code(progress)
    return reports, 0


def _under_fillets(report: Any, options: argparse.Namespace) -> str:
    allowed = options.noise + 0.02 * options.fillet
    good = sum(row.rms <= allowed for row in report.rows)
    return (
        f"{good} of {len(report.rows)} sharp edges under fillets of {options.fillet:g} mm found "
        f"with an rms of at most {allowed:.3g} mm (noise and 2 % of the radius)."
    )


def _at_random(options: argparse.Namespace) -> int:
    """Scan wedges or steps at random, and those that are wrong again."""
    from freecad_edgescan.experiments.wedge_search import (
        by_chance,
        scanned_again,
        search,
        wedge_table,
    )

    word = "steps" if options.wedges is None else "wedges"
    for other in ("parts", "peers", "fillet", "seeds", "report"):
        if getattr(options, other):
            raise ValueError(f"--{word} are scanned instead of parts; leave --{other} out.")
    if options.wedges is not None and options.steps is not None:
        raise ValueError("--wedges and --steps are two searches; give one of them.")
    count = getattr(options, word)
    if count < 1:
        raise ValueError(f"--{word} is {count}; give 1 or more.")
    if options.sharp and word == "steps":
        raise ValueError("--sharp belongs to --wedges; leave it out.")
    kind = "sharp wedges" if options.sharp else word
    with TerminalProgress(kind) as progress:
        found = search(count, kind, 100_000 * options.seed, progress=progress)
    print(wedge_table(found, kind))
    wrong = [judged for judged in found if judged.wrong]
    if wrong and len(found) == count:
        with TerminalProgress("again") as progress:
            again = scanned_again(wrong, kind, progress=progress)
        print(by_chance(again, kind))
    return exit_code(progress, bool(found))


# ---------------------------------------------------------------- page


def _check_report(options: argparse.Namespace) -> None:
    """Refuse before anything is measured what could not be written after minutes of it."""
    from freecad_edgescan.document.accuracy_page import picture_paths
    from freecad_edgescan.experiments.figures import can_draw

    page: Path = options.report
    if options.fillet:
        raise ValueError("--report is about sharp edges; leave --fillet or --report out.")
    if not can_draw():
        raise ValueError("--report needs matplotlib (Debian: python3-matplotlib); leave it out.")
    check_output(page, (".md",))
    for picture in picture_paths(page).values():
        if picture.parent.exists() and not picture.parent.is_dir():
            raise ValueError(f"{picture.parent} is a file, where the pictures' folder is to be.")


def _report(options: argparse.Namespace) -> int:
    """Measure everything, and write the page when nothing is missing."""
    from freecad_edgescan.document.accuracy_page import write_page

    shapes = [_block(), *_shapes(options)]
    simple, code = _simple_parts(options)
    if not code:
        print()
        exact, code = _rims_and_bends(options)
    if not code:
        print()
        parts, code = _parts(options, shapes)
    if not code:
        experiments, code = _experiments(options)
    if code:
        tell(f"{options.report} is written only when nothing is missing, and was left alone.")
        return code
    written = write_page(_measured(options, simple, exact, parts, experiments), options.report)
    print(f"\nWrote {written[0]} and {len(written) - 1} pictures into {written[1].parent}")
    return 0


def _experiments(options: argparse.Namespace) -> tuple[Any, int]:
    from freecad_edgescan.experiments import run_doe
    from freecad_edgescan.experiments.doe_tables import experiments_table

    with TerminalProgress("published experiments") as progress:
        result = run_doe(method="patch", seed=options.seed, progress=progress)
    if result.runs:
        print("\n" + experiments_table(result))
    return result, exit_code(progress, bool(result.runs))


def _measured(
    options: argparse.Namespace,
    simple: list[Any],
    exact: list[Any],
    parts: list[Any],
    experiments: Any,
) -> Any:
    """The results, each with the command line that prints it."""
    from freecad_edgescan.document.accuracy_page import Accuracy

    simple_words = ["--peers"] if options.peers else []
    simple_words += [] if options.seeds is None else ["--seeds", str(options.seeds)]
    seed = ["--seed", str(options.seed)] if options.seed else []
    cloud = ["--pitch", f"{options.pitch:g}", "--noise", f"{options.noise:g}"]
    if options.probe_radius:
        cloud += ["--probe-radius", f"{options.probe_radius:g}"]
    cloud += seed
    files = [file.name for file in options.parts]
    given = ["--parts", *files] if files else []
    page: Path = options.report
    name = page.name if page.is_absolute() else str(page)  # where it lies is nobody's business
    return Accuracy(
        call=_call("accuracy", *simple_words, *given, *cloud, "--report", name),
        simple=simple,
        exact=exact,
        simple_call=_call("accuracy", *simple_words),
        parts=[
            (report, _call("accuracy", *words, *cloud))
            for report, words in zip(parts, [[], *(["--parts", f] for f in files)], strict=True)
        ],
        experiments=experiments,
        experiments_call=_call("doe", "--method", "patch", *seed),
    )


def _call(*words: str) -> str:
    return "./edgescan " + shlex.join(words)
