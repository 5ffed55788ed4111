# SPDX-License-Identifier: LGPL-2.1-or-later
"""``edgescan doe``: the published experiments, scanned again and compared."""

from __future__ import annotations

import argparse
from pathlib import Path

from freecad_edgescan.doe_options import refuse_run_options
from freecad_edgescan.experiments import run_doe
from freecad_edgescan.experiments.doe_curves import Curves, draw_curves
from freecad_edgescan.experiments.doe_result import DoeResult, write_csv
from freecad_edgescan.experiments.doe_tables import comparison_table, seeds_table, summary
from freecad_edgescan.experiments.figures import can_draw
from freecad_edgescan.output_files import PICTURES, check_output
from freecad_edgescan.terminal_progress import TerminalProgress, exit_code, tell

__all__ = ["scan_experiments"]


def scan_experiments(options: argparse.Namespace) -> int:
    """Scan, write, print; answer the exit code."""
    if options.figure or options.compare:
        return _figure(options)
    if options.output:
        raise ValueError("-o names the picture of --figure or --compare; give one, or --plot.")
    check_output(options.csv, (".csv",))
    _check_plot(options.plot)
    results, code = _run(options)
    if not any(results):
        return code
    write_csv(results, options.csv)  # before anything is printed: its reader may go away
    drawn = _plot(options.plot, results[0]) if options.plot else []
    if len(results) == 1:
        print(summary(results[0]))
    else:
        for result in results:
            print(f"Seed {result.seed}\n{comparison_table(result)}\n")
        print(seeds_table(results))
    print(f"Wrote {options.csv}")
    if drawn:
        print(f"Wrote {len(drawn)} files into {options.plot}: {drawn[0].name} and so on")
    return code


class _RunProgress(TerminalProgress):
    """Counts runs instead of edge points."""

    def update(self, fraction: float, so_far: object) -> bool:
        if isinstance(so_far, DoeResult):
            so_far = f"{len(so_far)} runs, {so_far.completed} completed"
        return super().update(fraction, so_far)


def _run(options: argparse.Namespace) -> tuple[list[DoeResult], int]:
    """The results of each seed, and the exit code; after Ctrl-C what there is so far."""
    if options.seeds is not None and options.seeds < 1:
        raise ValueError(f"--seeds is {options.seeds}; give the number of seeds, 1 or more.")
    seeds = [options.seed] if options.seeds is None else range(options.seeds)
    results: list[DoeResult] = []
    for seed in seeds:
        task = "doe" if len(seeds) == 1 else f"doe, seed {seed}"
        with _RunProgress(task) as progress:
            result = run_doe(
                options.experiments,
                options.patterns,
                options.degrees,
                options.method,
                seed,
                options.jobs,
                options.literal,
                progress=progress,
            )
        results += [result] if result.runs else []
        if progress.cancelled:
            return results, exit_code(progress, bool(results))
    return results, 0


def _plot(folder: Path, result: DoeResult) -> list[Path]:
    from freecad_edgescan.experiments.doe_pictures import draw_doe

    folder.mkdir(parents=True, exist_ok=True)
    return draw_doe(result, folder)


def _check_plot(folder: Path | None) -> None:
    if folder is None:
        return
    if folder.exists() and not folder.is_dir():
        raise ValueError(f"{folder} is a file; give --plot a folder, which is made if need be.")
    if not can_draw():
        raise ValueError("--plot needs matplotlib (Debian: python3-matplotlib); leave it out.")


def _figure(options: argparse.Namespace) -> int:
    refuse_run_options(options)
    name = options.compare or f"figure-{options.figure}"
    path = options.output or Path(f"{name}.png")
    check_output(path, PICTURES)
    if options.output and not can_draw():
        raise ValueError(
            f"The picture {path} needs matplotlib (Debian: python3-matplotlib); "
            "install it, or leave -o out for the numbers alone."
        )
    with TerminalProgress(name) as progress:
        if options.compare:
            from freecad_edgescan.experiments.doe_choices import compare_choices

            found = compare_choices(options.compare, options.seed, options.jobs, progress)
        else:
            from freecad_edgescan.experiments.doe_figures import make_figure

            found = make_figure(
                options.figure,
                options.seed,
                options.jobs,
                options.method,
                options.literal,
                progress,
            )
    _show(found, path)
    return exit_code(progress, bool(found))


def _show(found: tuple[Curves, ...], path: Path) -> None:
    if not found:
        return
    if drawn := can_draw():
        draw_curves(found, path)
    print("\n\n".join(curves.table() for curves in found))
    if drawn:
        print(f"Wrote {path}")
    else:
        tell("the picture needs matplotlib (Debian: python3-matplotlib); the numbers are above.")
